// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Posts from their descriptions in YAML.
#include <pointmill/gcode/post.h>

#include "post_keys.h"

#include <pointmill/common/error.h>
#include <pointmill/common/nearest_name.h>

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <utility>

namespace pointmill {

using namespace gcode;

namespace {

/// What a word of a description stands for.
template <typename T>
using Words = std::vector<std::pair<std::string, T>>;

const Words<ProgramForm> form_words{{"rs274", ProgramForm::Rs274},
                                    {"grbl", ProgramForm::Grbl},
                                    {"siemens", ProgramForm::Siemens},
                                    {"heidenhain-iso", ProgramForm::HeidenhainIso},
                                    {"klartext", ProgramForm::Klartext}};
const Words<ToolChange> tool_words{{"changer", ToolChange::Changer},
                                   {"pause", ToolChange::Pause},
                                   {"program", ToolChange::Program}};
const Words<Retract> retract_words{{"machine", Retract::Machine},
                                   {"home", Retract::Home},
                                   {"clearance", Retract::Clearance}};
const Words<ArcPlane> plane_words{
    {"XY", ArcPlane::XY}, {"ZX", ArcPlane::ZX}, {"YZ", ArcPlane::YZ}};
const Words<bool> bool_words{{"true", true}, {"false", false}};

/// Reads the values of one description; errors name it and the line.
class DescriptionReader {
public:
  explicit DescriptionReader(std::string source) : source_(std::move(source)) {}

  [[noreturn]] void refuse(const YAML::Mark& mark, const std::string& why) const
  {
    throw DataError(source_ + ":" + std::to_string(mark.line + 1) + ": " + why);
  }

  std::string scalar(const YAML::Node& node) const
  {
    if (!node.IsScalar())
      refuse(node.Mark(), "a single value is needed here");
    return node.Scalar();
  }

  void read(const YAML::Node& node, std::string& value) const { value = scalar(node); }
  void read(const YAML::Node& node, int& value) const { value = number<int>(node); }
  void read(const YAML::Node& node, double& value) const
  {
    value = number<double>(node);
  }
  void read(const YAML::Node& node, bool& value) const
  {
    value = word(node, bool_words);
  }
  void read(const YAML::Node& node, ProgramForm& value) const
  {
    value = word(node, form_words);
  }
  void read(const YAML::Node& node, ToolChange& value) const
  {
    value = word(node, tool_words);
  }
  void read(const YAML::Node& node, Retract& value) const
  {
    value = word(node, retract_words);
  }
  void read(const YAML::Node& node, std::vector<ArcPlane>& planes) const
  {
    planes.clear();
    for (const auto& item : list(node))
      planes.push_back(word(item, plane_words));
  }
  void read(const YAML::Node& node, Post::Lines& lines) const
  {
    lines.clear();
    std::istringstream text(scalar(node));
    for (std::string line; std::getline(text, line);)
      lines.push_back(line);
  }

private:
  YAML::Node list(const YAML::Node& node) const
  {
    if (!node.IsSequence())
      refuse(node.Mark(), "a list is needed here, as [XY, ZX]");
    return node;
  }

  template <typename T>
  T number(const YAML::Node& node) const
  {
    const std::string text = scalar(node);
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    T value{};
    if (!(in >> value) || in.peek() != std::istringstream::traits_type::eof())
      refuse(node.Mark(),
             "'" + text + "' is not " +
                 (std::is_integral_v<T> ? "an integer" : "a number"));
    return value;
  }

  template <typename T>
  T word(const YAML::Node& node, const Words<T>& words) const
  {
    const std::string text = scalar(node);
    std::string all;
    for (const auto& [spelling, value] : words) {
      if (spelling == text)
        return value;
      all += all.empty() ? "" : ", ";
      all += spelling;
    }
    refuse(node.Mark(), "'" + text + "' is none of " + all);
  }

  std::string source_;
};

std::vector<std::string> allKeys()
{
  Post post;
  std::vector<std::string> keys{"base"};
  visitKeys(post, [&keys](const char* key, auto&) { keys.emplace_back(key); });
  return keys;
}

void checkKeys(const YAML::Node& root, const DescriptionReader& reader)
{
  static const std::vector<std::string> known = allKeys();
  std::set<std::string> seen;
  for (const auto& entry : root) {
    const std::string key = reader.scalar(entry.first);
    if (std::find(known.begin(), known.end(), key) == known.end())
      reader.refuse(entry.first.Mark(),
                    "unknown key '" + key + "'; nearest is '" +
                        nearestName(key, known) + "'");
    if (!seen.insert(key).second)
      reader.refuse(entry.first.Mark(), "'" + key + "' stands here twice");
  }
}

Post describedBy(const YAML::Node& root, const DescriptionReader& reader)
{
  if (!root.IsMap())
    reader.refuse(root.Mark(), "a post is a list of 'key: value'");
  checkKeys(root, reader);
  Post post;
  if (const auto base = root["base"]) {
    try {
      post = Post::named(reader.scalar(base));
    }
    catch (const ParameterError& error) {
      reader.refuse(base.Mark(), error.what());
    }
  }
  visitKeys(post, [&](const char* key, auto& member) {
    if (const auto node = root[key])
      reader.read(node, member);
  });
  return post;
}

} // namespace

Post Post::fromText(const std::string& text, const std::string& source)
{
  const DescriptionReader reader(source);
  try {
    const YAML::Node root = YAML::Load(text);
    Post post = describedBy(root, reader);
    checkPost(post, [&](const std::string& key, const std::string& why) {
      const YAML::Node node = root[key];
      reader.refuse(node ? node.Mark() : root.Mark(), key + ": " + why);
    });
    return post;
  }
  catch (const YAML::Exception& error) {
    reader.refuse(error.mark, error.msg);
  }
}

Post Post::fromFile(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf()))
    throw DataError(path + ": the post's description cannot be read");
  return fromText(text.str(), path);
}

} // namespace pointmill
