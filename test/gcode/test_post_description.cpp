// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "post_keys.h"
#include "two_tools.h"

#include <pointmill/common/error.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using pointmill::ArcPlane;
using pointmill::Post;
using pointmill::Retract;
using pointmill::ToolChange;

namespace {

std::string refusal(const std::string& text)
{
  try {
    Post::fromText(text, "my.yaml");
  }
  catch (const pointmill::DataError& error) {
    return error.what();
  }
  return "accepted";
}

std::string page()
{
  std::ifstream in(POINTMILL_SOURCE_DIR "/doc/posts.md");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The block of doc/posts.md that is marked as YAML.
std::string exampleOfThePage()
{
  const std::string text = page(), mark = "```yaml\n";
  const auto begin = text.find(mark);
  EXPECT_NE(begin, std::string::npos);
  const auto from = begin + mark.size();
  return text.substr(from, text.find("```", from) - from);
}

} // namespace

TEST(PostDescription, TakesWhatDiffersFromItsBase)
{
  const Post post = Post::fromText("base: grbl\n"
                                   "name: router\n"
                                   "decimals_mm: 4\n"
                                   "arc_planes: [XY]\n"
                                   "tools: pause\n"
                                   "retract: machine\n"
                                   "leading_zero: false\n"
                                   "coolant_on: M7\n"
                                   "setup: |\n"
                                   "  G17 {unit} G90\n"
                                   "  G94\n",
                                   "my.yaml");
  const Post grbl = Post::named("grbl");
  EXPECT_EQ(post.name, "router");
  EXPECT_EQ(post.control, grbl.control);
  EXPECT_EQ(post.decimals_mm, 4);
  EXPECT_EQ(post.decimals_inch, grbl.decimals_inch);
  EXPECT_EQ(post.arc_planes, std::vector<ArcPlane>{ArcPlane::XY});
  EXPECT_FALSE(post.takesArcs(ArcPlane::ZX));
  EXPECT_FALSE(post.takesHelices(ArcPlane::ZX));
  EXPECT_TRUE(post.takesHelices(ArcPlane::XY));
  EXPECT_EQ(post.tools, ToolChange::Pause);
  EXPECT_EQ(post.retract, Retract::Machine);
  EXPECT_FALSE(post.leading_zero);
  EXPECT_EQ(post.coolant_on, Post::Lines{"M7"});
  EXPECT_EQ(post.setup, (Post::Lines{"G17 {unit} G90", "G94"}));
  EXPECT_EQ(post.end, grbl.end);
}

TEST(PostDescription, EmptyTemplatesAreNone)
{
  EXPECT_TRUE(Post::fromText("base: linuxcnc\nblend: ''\n", "my.yaml").blend.empty());
}

TEST(PostDescription, IsReadFromAFile)
{
  const auto path = std::filesystem::temp_directory_path() /
                    ("pointmill-post-" + std::to_string(::getpid()) + ".yaml");
  std::ofstream(path) << "base: fanuc\nname: mill 3\n";
  EXPECT_EQ(Post::fromFile(path.string()).name, "mill 3");
  std::ofstream(path) << "base: fanuc\n\nnam: mill 3\n";
  try {
    Post::fromFile(path.string());
    ADD_FAILURE();
  }
  catch (const pointmill::DataError& error) {
    EXPECT_EQ(std::string(error.what()),
              path.string() + ":3: unknown key 'nam'; nearest is 'name'");
  }
  std::filesystem::remove(path);
  EXPECT_THROW(Post::fromFile(path.string()), pointmill::DataError);
}

TEST(PostDescription, RefusesWithLineAndReason)
{
  const std::string base = "base: linuxcnc\n";
  EXPECT_EQ(refusal(base + "coolent_on: M8\n"),
            "my.yaml:2: unknown key 'coolent_on'; nearest is 'coolant_on'");
  EXPECT_EQ(
      refusal("base: linuxnc\n"),
      "my.yaml:1: unknown post 'linuxnc'; nearest is 'linuxcnc' of linuxcnc, grbl, "
      "mach, fanuc, haas, siemens, heidenhain, heidenhain-iso");
  EXPECT_EQ(refusal(base + "name: a\nname: b\n"),
            "my.yaml:3: 'name' stands here twice");
  EXPECT_EQ(refusal(base + "decimals_mm: three\n"),
            "my.yaml:2: 'three' is not an integer");
  EXPECT_EQ(refusal(base + "decimals_mm: 3.5\n"), "my.yaml:2: '3.5' is not an integer");
  EXPECT_EQ(refusal(base + "largest_sweep: 90,5\n"),
            "my.yaml:2: '90,5' is not a number");
  EXPECT_EQ(refusal(base + "upper_case: yes\n"),
            "my.yaml:2: 'yes' is none of true, false");
  EXPECT_EQ(refusal(base + "tools: robot\n"),
            "my.yaml:2: 'robot' is none of changer, pause, program");
  EXPECT_EQ(refusal(base + "arc_planes: XY\n"),
            "my.yaml:2: a list is needed here, as [XY, ZX]");
  EXPECT_EQ(refusal(base + "stop: [M5, M9]\n"),
            "my.yaml:2: a single value is needed here");
  EXPECT_EQ(
      refusal(base + "\nend: M30 {tool}\n"),
      "my.yaml:3: end: 'M30 {tool}': {tool} is not known here; known are program, "
      "number, unit, control");
  EXPECT_EQ(refusal(base + "tool_change: T{tool M6\n"),
            "my.yaml:2: tool_change: 'T{tool M6': a brace has no other one");
  EXPECT_EQ(refusal(base + "tool_change: T{2} M6\n"),
            "my.yaml:2: tool_change: 'T{2} M6': {2} is not a place such as {tool}");
  EXPECT_EQ(refusal(base + "setup: |\n  G17\n\n  G21\n"),
            "my.yaml:2: setup: a line is empty");
  EXPECT_EQ(refusal(base + "setup: G17 \xC2\xB5\n"),
            "my.yaml:2: setup: 'G17 \xC2\xB5' is not printable ASCII");
  EXPECT_EQ(refusal(base + "line_limit: 40\nsetup: " + std::string(41, 'G') + "\n"),
            "my.yaml:3: setup: '" + std::string(41, 'G') +
                "' is longer than line_limit, 40");
  EXPECT_NE(refusal(base + "decimals_mm: 2\n").find("my.yaml:2: decimals_mm: "),
            std::string::npos);
  EXPECT_EQ(refusal(base + "number_max: 100\nnumber_start: 95\n"),
            "my.yaml:2: number_max: is below the second number");
  EXPECT_EQ(refusal("name: bare\n"), "my.yaml:1: control: must be given");
  EXPECT_EQ(refusal(base + "retract: home\nretract_home: ''\n"),
            "my.yaml:3: retract_home: must be given");
  EXPECT_EQ(refusal("just words\n"), "my.yaml:1: a post is a list of 'key: value'");
  EXPECT_EQ(refusal(base + "stop: [M5\n").find("my.yaml:"), 0u);
}

TEST(PostDescription, NamesTheNearestPost)
{
  try {
    Post::named("heidenhein");
    ADD_FAILURE();
  }
  catch (const pointmill::ParameterError& error) {
    EXPECT_NE(std::string(error.what()).find("nearest is 'heidenhain'"),
              std::string::npos);
  }
}

TEST(PostDescription, BuiltInPostsAreDescriptionsThemselves)
{
  for (const auto& name : Post::names())
    EXPECT_EQ(refusal(Post::description(name)), "accepted") << name;
}

TEST(PostDescription, TheExampleOfThePageIsWholeAndWrites)
{
  const Post post = Post::fromText(exampleOfThePage(), "doc/posts.md");
  const auto text =
      sample::files(sample::writerFor(post), sample::twoTools()).begin()->second.str();
  EXPECT_NE(text.find("\nG0 Z10\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\nM6 T2\n"), std::string::npos) << text;
  EXPECT_EQ(text.substr(text.size() - 4), "\nM2\n");
}

TEST(PostDescription, ThePageNamesAllKeysAndPlaces)
{
  std::istringstream in(page());
  std::map<std::string, std::string> rows; // by each key of their first column
  for (std::string line; std::getline(in, line);) {
    if (line.compare(0, 3, "| `") != 0)
      continue;
    std::istringstream keys(line.substr(0, line.find(" | ")));
    for (std::string key; keys >> key;)
      if (key.size() > 2)
        rows[key.substr(1, key.size() - 2)] = line;
  }
  Post post;
  pointmill::gcode::visitKeys(
      post, [&rows](const char* key, auto&) { EXPECT_EQ(rows.count(key), 1u) << key; });
  pointmill::gcode::visitTemplates(
      post, [&rows](const char* key, auto&, const char* places) {
        std::istringstream names(places);
        for (std::string name; names >> name;)
          EXPECT_TRUE(rows[key].find("{" + name + "}") != std::string::npos ||
                      rows[key].find("the same |") != std::string::npos)
              << key << " " << name;
      });
}

TEST(PostDescription, WidthsPadWithZeros)
{
  const Post post = Post::fromText("base: linuxcnc\n"
                                   "tool_change: T{tool:2}{tool:2} S{rpm:1} M6\n",
                                   "my.yaml");
  const auto text =
      sample::files(sample::writerFor(post), sample::twoTools()).begin()->second.str();
  EXPECT_NE(text.find("\nT0202 S18000 M6\n"), std::string::npos) << text;
}
