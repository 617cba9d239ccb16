// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "page_parts.h"
#include "print.h"
#include "view_of.h"

#include <pointmill/common/version.h>
#include <pointmill/io/write_file.h>
#include <pointmill/page/page.h>
#include <pointmill/visual/deviation_picture.h>
#include <pointmill/visual/palette.h>

#include <filesystem>

namespace pointmill {
namespace {

using namespace page;

/// A file beside the page that is gone when this is.
class Scratch {
public:
  explicit Scratch(std::string path) : path_(std::move(path)) {}
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch()
  {
    std::error_code ignored; // it may never have been written
    std::filesystem::remove(path_, ignored);
  }
  const std::string& path() const { return path_; }

private:
  std::string path_;
};

Html sectionsTable(const Judgement& judgement, const ViewScene& view)
{
  const auto& sections = judgement.verification.sections;
  const double whole = judgement.time.total.total() / 60;
  std::vector<std::vector<Html>> rows;
  std::size_t path = 0;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const SectionFigures& s = sections[i];
    while (path + 1 < view.paths.size() && i < judgement.program.sections.size() &&
           view.paths[path + 1].first <= judgement.program.sections[i].move)
      ++path;
    const std::string colour =
        operationColour(view.paths.empty() ? 0 : view.paths[path].colour);
    const bool timed = i < judgement.time.sections.size();
    rows.push_back(
        {swatch(colour) + (s.name.empty() ? print("line %zu", s.line) : s.name),
         "T" + std::to_string(s.tool),
         timeBar(timed ? judgement.time.sections[i].total() / 60 : 0.0, whole, colour),
         print("%.0f", s.feed_length),
         print("%.0f", s.rapid_length),
         print("%.2f", s.volume / 1000),
         print("%.2f", s.axial_depth)});
  }
  return table("What each section of the program does",
               {{"section", false, ""},
                {"tool", false, ""},
                {"time", true, ""},
                {"cut", true, "mm"},
                {"rapid", true, "mm"},
                {"cut", true, "cm\u00b3"},
                {"thickest layer", true, "at once, mm"}},
               rows);
}

} // namespace

void writeCheckPage(const std::string& path,
                    const std::string& title,
                    const Judgement& judgement,
                    const Criteria& criteria)
{
  const Verification& v = judgement.verification;
  const Scratch scratch(path + ".png.part");
  const ViewScene view = viewOf(judgement, criteria);
  Page page;
  page.title = title + " - check";
  page.body = element(
      "header",
      element("h1", title) +
          element("p class=\"about\"",
                  print("%zu lines, checked by PointMill ", judgement.program.lines) +
                      version + ".") +
          verdictOf(v) + tiles(figuresOf(judgement, criteria)));
  Html overview;
  if (!v.findings.empty()) {
    writeFindings(scratch.path(), title, judgement, criteria);
    overview = of(PictureFile{scratch.path(),
                              "What was found, and where",
                              "All findings on the part, seen from above, and the "
                              "worst of them"});
  }
  page.body += section(
      "findings", "Findings", findings(judgement, criteria, scratch.path(), overview));
  page.body += section("view-3d", "Part and tool paths", viewPlace());
  page.body +=
      section("operations", "Sections of the program", sectionsTable(judgement, view));
  writeDeviation(scratch.path(), v.deviations, criteria.tolerance, v.in_reach);
  page.body += section("accuracy",
                       "The milled part against the scan",
                       accuracy(judgement, criteria) +
                           of(PictureFile{scratch.path(),
                                          "Map of the deviations, seen from above",
                                          "Milled surface minus scan: blue is left "
                                          "over, red is too deep"}));
  page.body += element("footer",
                       "All lengths are millimetres in the part frame. The 3D view is "
                       "drawn by three.js, whose licence stands in the source of this "
                       "page.");
  page.scene = viewJson(view);
  writeFileAtomically(path, [&](std::ostream& out) { writePage(out, page); });
}

} // namespace pointmill
