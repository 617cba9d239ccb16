// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// The page beside a program: whole, harmless, and the same each time. What a browser
// makes of it is looked at by page_in_browser.cmake.
#include "mill_test.h"

#include <pointmill/page/html.h>

#include <nlohmann/json.hpp>

#include <regex>

using namespace mill_test;

namespace {

std::size_t count(const std::string& text, const std::string& what)
{
  std::size_t found = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++found;
  return found;
}

testing::AssertionResult holds(const std::string& text, const std::string& what)
{
  if (text.find(what) != std::string::npos)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << "no " << what;
}

/// What is between the scripts.
std::string withoutScripts(std::string page)
{
  for (auto at = page.find("<script"); at != std::string::npos;
       at = page.find("<script", at))
    page.erase(at, page.find("</script>", at) + 9 - at);
  return page;
}

nlohmann::json sceneOf(const std::string& page)
{
  const std::string begin = "id=\"scene\">";
  const auto at = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
}

MillOptions withZones()
{
  MillOptions options;
  options.stock_margin = 3;
  options.keep_out = KeepOut({KeepOutZone::cylinder(-20, 10, 4, 6)});
  options.finish.tool.stick_out = 25;
  options.finish.tool.holder_diameter = 20;
  return options;
}

std::string pageOf(const std::string& scan, const MillOptions& options = {})
{
  const TempDir folder;
  MillJob job(options);
  job.plan(scan);
  job.write((folder / "nc").string());
  return contents(folder / "nc/report.html");
}

} // namespace

TEST(Page, TextsAreEscaped)
{
  EXPECT_EQ(escaped("<a href=\"x\">'&'</a>"),
            "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
  EXPECT_EQ(Html("<b>").str(), "&lt;b&gt;");
  EXPECT_EQ(element("p class=\"x\"", "1 < 2").str(), "<p class=\"x\">1 &lt; 2</p>\n");
  EXPECT_EQ(escaped(std::string("a\0b", 3)),
            "a\xEF\xBF\xBD"
            "b");
}

TEST(Page, Base64IsThatOfTheStandard) // RFC 4648, section 10
{
  const char* const pairs[][2] = {{"", ""},
                                  {"f", "Zg=="},
                                  {"fo", "Zm8="},
                                  {"foo", "Zm9v"},
                                  {"foob", "Zm9vYg=="},
                                  {"fooba", "Zm9vYmE="},
                                  {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : pairs)
    EXPECT_EQ(base64(bytes), text);
  EXPECT_EQ(base64("\xfb\xff"), "+/8=");
}

TEST(Page, HoldsAllThatThereIsToSay)
{
  const TempDir folder;
  MillJob job(withZones());
  job.plan(data("stairs.pcd"));
  job.write((folder / "nc").string());
  const std::string page = contents(folder / "nc/report.html");
  EXPECT_TRUE(holds(page, "<h1>stairs.pcd</h1>"));
  EXPECT_TRUE(holds(page, "program.ngc"));
  EXPECT_TRUE(holds(page, "G54: set it to the datum"));
  EXPECT_TRUE(holds(page, "cylinder at (-20, 10), radius 4, up to 6 mm"));
  EXPECT_TRUE(holds(page, "as given 25"));
  for (const char* tool : {"T1", "T2", "T3"})
    EXPECT_TRUE(holds(page, std::string("<th scope=\"row\">") + tool + "</th>"));
  int number = 0;
  for (const auto& o : job.operations()) {
    const std::string row = std::to_string(++number) + "  " + o.operation.name;
    EXPECT_GE(count(page, row), 3u) << row << ": cutting data, figures and view";
  }
  // The preview, the deviation and three occupancy maps, and the findings.
  EXPECT_GE(count(page, "src=\"data:image/png;base64,iVBOR"), 5u);
  EXPECT_EQ(count(page, "<img "), count(page, "<img alt=\""));
  EXPECT_GE(count(page, "<svg class=\"sketch\""), 1u);
  EXPECT_GE(count(page, "<svg class=\"chart\""), 1u);
  EXPECT_TRUE(holds(page, "pointmill check program.ngc --dir . "));
  EXPECT_TRUE(holds(page, "The MIT License"));

  const auto scene = sceneOf(page);
  ASSERT_EQ(scene["paths"]["list"].size(), job.operations().size());
  EXPECT_NEAR(scene["paths"]["seconds"], 60 * job.minutes(), 1);
  EXPECT_EQ(scene["zones"].size(), 1u);
  EXPECT_EQ(scene["tools"].size(), 3u);
  for (const char* field : {"part", "milled", "deviation"})
    EXPECT_FALSE(scene["fields"][field]["values"].get<std::string>().empty()) << field;
}

TEST(Page, LayersAndTimesAreThoseOfTheVerification)
{
  const TempDir folder;
  MillJob job{MillOptions()};
  job.plan(data("stairs.pcd"));
  job.write((folder / "nc").string());
  const std::string page = contents(folder / "nc/report.html");
  const auto& sections = job.verification().sections;
  ASSERT_EQ(sections.size(), job.operations().size());
  for (const auto& s : sections) {
    char cell[64];
    std::snprintf(cell,
                  sizeof cell,
                  "data-head=\"thickest layer, verified, mm\">%.2f<",
                  s.axial_depth);
    EXPECT_TRUE(holds(page, cell)) << s.name;
  }
  // Operations, cutting data and head say a time in one way.
  for (const auto& o : job.operations()) {
    const auto minutes = static_cast<int>(o.figures.minutes + 0.5);
    const std::string time = minutes < 1 ? "under 1" : std::to_string(minutes);
    EXPECT_GE(count(page, "data-head=\"time\">" + time + " min<"), 2u)
        << o.operation.name;
  }
}

TEST(Page, OfASingleFindingShowsItsSectionOnce)
{
  const TempDir folder;
  MillOptions options;
  options.finish.allowance = 0.3;
  options.residual_limit = 0.05;
  MillJob job(options);
  EXPECT_THROW(job.plan(data("dome.pcd")), VerificationError);
  job.writeRefusal((folder / "nc").string());
  const std::string page = contents(folder / "nc/refused.html");
  ASSERT_EQ(job.verification().findings.size(), 1u);
  EXPECT_EQ(count(page, "Section through the place of finding"), 0u);
}

TEST(Page, LoadsNothing)
{
  const std::string page = pageOf(data("stairs.pcd"));
  const std::string html = withoutScripts(page);
  for (const char* what : {"http:", "https:", "@import", "url(h", "<iframe", "<object"})
    EXPECT_EQ(count(html, what), 0u) << what;
  EXPECT_EQ(count(page, "<script src"), 0u);
  EXPECT_EQ(count(html, "<link "), 1u);
  EXPECT_TRUE(holds(html, "<link rel=\"icon\" href=\"data:,\">"));
  const std::regex source("(src|href)=\"(?!data:)");
  EXPECT_FALSE(std::regex_search(html, source));
  EXPECT_TRUE(holds(html, "Content-Security-Policy"));
}

TEST(Page, OfAScanWithAnEvilNameIsHarmless)
{
  const TempDir folder;
  for (const char* name : {"<script>alert(1).pcd", "</script><img src=x>.pcd"}) {
    // No file's name holds a slash; a caller of the page may all the same.
    std::string file = name;
    file.erase(std::remove(file.begin(), file.end(), '/'), file.end());
    fs::copy_file(data("stairs.pcd"), folder / file);
    const std::string page = pageOf((folder / file).string());
    EXPECT_EQ(count(page, "<script>alert"), 0u);
    EXPECT_EQ(count(page, "<img src=x"), 0u);
    EXPECT_TRUE(holds(page, "<h1>&lt;"));
    EXPECT_EQ(count(page, "<script"), 4u); // the scene, two libraries, the view
    EXPECT_EQ(count(page, "</script>"), 4u);
  }
}

TEST(Page, OfTheSampleIsSmall)
{
  const std::string page = pageOf(data("sample_scan.pcd"));
  EXPECT_LT(page.size(), 5'000'000u);
  EXPECT_GT(page.size(), 1'000'000u);
}

TEST(Page, IsTheSameTwice)
{
  MillOptions options = withZones();
  options.threads = 1;
  const std::string one = pageOf(data("stairs.pcd"), options);
  options.threads = 3;
  EXPECT_TRUE(one == pageOf(data("stairs.pcd"), options));
}

TEST(Page, OfARefusalSaysWhyAndOfAForcedProgramThatItFails)
{
  const TempDir folder;
  MillOptions options;
  options.finish.allowance = 0.3;
  options.residual_limit = 0.05;
  MillJob refused(options);
  EXPECT_THROW(refused.plan(data("dome.pcd")), VerificationError);
  refused.writeRefusal((folder / "nc").string());
  const std::string why = contents(folder / "nc/refused.html");
  EXPECT_TRUE(holds(why, "Refused: no program was written"));
  EXPECT_TRUE(holds(why, "half of the points keep"));
  EXPECT_TRUE(holds(why, "none was written"));
  EXPECT_FALSE(holds(why, "pointmill check"));
  EXPECT_FALSE(fs::exists(folder / "nc/preview.png"));
  options.force = true;
  const std::string forced = pageOf(data("dome.pcd"), options);
  EXPECT_TRUE(holds(forced, "Forced: this program FAILS its verification"));
  EXPECT_TRUE(holds(forced, "half of the points keep"));
}
