// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "job_page.h"

#include "page_parts.h"
#include "print.h"
#include "setup_sheet.h"
#include "view_of.h"

#include <pointmill/common/version.h>
#include <pointmill/io/write_file.h>
#include <pointmill/mill/summary.h>
#include <pointmill/page/page.h>
#include <pointmill/visual/palette.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pointmill {
namespace {

using namespace page;

/// Of a list that may be long: the rest is in report.json.
constexpr std::size_t kMostRows = 20;

struct KnownPicture {
  const char *name, *alt, *caption;
};
constexpr KnownPicture kPictures[] = {
    {"preview.png",
     "Scan, tool paths and milled part side by side",
     "Scan, tool paths and milled part"},
    {"deviation.png",
     "Map of the deviations, seen from above",
     "Milled surface minus scan, seen from above: blue is left over, red is too deep"},
    {"findings.png",
     "What was found, and where",
     "All findings on the part, seen from above, and the worst of them"},
    {"refused.png",
     "Why the program was refused, and where",
     "All findings on the part, seen from above, and the worst of them"},
    {"occupancy_1.png",
     "Occupancy map a quarter down",
     "Occupancy map a quarter down: red is part, yellow is to be milled, blue-grey is "
     "a "
     "gap that is protected"},
    {"occupancy_2.png", "Occupancy map half way down", "Half way down"},
    {"occupancy_3.png", "Occupancy map three quarters down", "Three quarters down"}};

class JobPage {
public:
  JobPage(const MillJob& job,
          std::string scan,
          std::string folder,
          const std::vector<std::string>& pictures,
          bool written)
      : job_(job), scan_(std::move(scan)), folder_(std::move(folder)),
        pictures_(pictures), written_(written)
  {
  }

  Page make()
  {
    Page page;
    page.title = scan_ + (written_ ? " - report" : " - refused");
    page.body = head() + mind();
    page.body +=
        section("view-3d", "Part and tool paths", viewPlace() + take("preview.png"));
    page.body +=
        section("accuracy",
                "The milled part against the scan",
                accuracy(job_.judgement(), job_.criteria()) + take("deviation.png"));
    page.body += section("set-up",
                         written_ ? "Set-up sheet" : "Set-up sheet, as planned",
                         setupSheet(job_, written_));
    page.body += section("operations", "Operations", operations());
    page.body += section("not-cut", "Not cut, not scanned", notCut());
    page.body += section("scan", "Scan and tolerance", scan());
    if (written_)
      page.body += section("again", "To check it again", again());
    const Html more = rest();
    if (!more.empty())
      page.body +=
          section("pictures", "More pictures", element("div class=\"row\"", more));
    page.body += foot();
    page.scene = viewJson(viewOf(job_));
    return page;
  }

private:
  const Verification& verification() const { return job_.verification(); }
  bool forced() const { return written_ && !verification().good(); }

  Html head() const
  {
    const Post& post = job_.options().writer.getPost();
    std::string about = "For " + post.control;
    if (written_) {
      const auto& f = job_.programFigures();
      about += print(": %zu lines, %.2f MB in ", f.lines, double(f.bytes) / 1e6);
      for (std::size_t i = 0; i < job_.programs().size(); ++i)
        about += (i > 0 ? ", " : "") + job_.programs()[i].name;
    }
    about += std::string(". PointMill ") + version + ".";
    Html html = element("h1", scan_) + element("p class=\"about\"", about);
    if (forced())
      html += verdict(Verdict::Refused,
                      "Forced: this program FAILS its verification",
                      "It was written all the same, by --force. Do not run it before "
                      "each of the errors below is understood.");
    else if (!written_)
      html += verdict(Verdict::Refused,
                      "Refused: no program was written",
                      "What was planned fails its verification, for the errors below. "
                      "Figures and pictures are those of the program as planned.");
    else
      html += verdictOf(verification());
    const Eigen::Vector3d size = job_.partSize();
    auto figures = figuresOf(job_.judgement(), job_.criteria());
    figures.insert(figures.begin(),
                   {print("%.1f \u00d7 %.1f \u00d7 %.1f", size.x(), size.y(), size.z()),
                    "mm, the part"});
    const auto gaps = static_cast<std::size_t>(
        std::count_if(job_.gaps().begin(), job_.gaps().end(), [](const GapRegion& g) {
          return g.kind == GapKind::NotScanned;
        }));
    figures.emplace_back(
        print("%.1f mm\u00b2", job_.gapArea()),
        gaps == 0 ? "not scanned: no gaps"
                  : print("not scanned, %zu %s, ", gaps, gaps == 1 ? "gap" : "gaps") +
                        treatment());
    return element("header", html + tiles(figures));
  }

  std::string treatment() const
  {
    switch (job_.options().gaps) {
    case GapPolicy::Bridge:
      return "bridged and protected";
    case GapPolicy::Keep:
      return "stock is left standing there";
    case GapPolicy::Mill:
      break;
    }
    return "milled down";
  }

  Html mind()
  {
    Html html;
    const auto found = findingLines(verification(), job_.judgement().program);
    Html lines;
    for (const auto& line : warningsOf(job_))
      if (std::find(found.begin(), found.end(), line) == found.end())
        lines += element("li", line);
    if (!found.empty()) {
      const Html overview = take("findings.png") + take("refused.png");
      html += section(
          "findings",
          "Findings",
          findings(
              job_.judgement(), job_.criteria(), inFolder("section.png"), overview));
    }
    if (!lines.empty())
      html += section(
          "mind", "To mind before the start", element("ul class=\"mind\"", lines));
    return html;
  }

  /// What the verification says of each operation. Its sections are matched as those
  /// of the times are: where a post writes no names, the tool's figure stands for all.
  std::vector<double> thickestLayers() const
  {
    const auto& sections = verification().sections;
    std::vector<double> layers;
    for (std::size_t i = 0; i < sections.size(); ++i) {
      if (i == 0 || sections[i].name != sections[i - 1].name ||
          sections[i].tool != sections[i - 1].tool)
        layers.push_back(0);
      layers.back() = std::max(layers.back(), sections[i].axial_depth);
    }
    if (layers.size() == job_.operations().size())
      return layers;
    layers.clear();
    const auto& of_tools = verification().axial_depth;
    for (const auto& o : job_.operations()) {
      const auto at = of_tools.find(o.operation.tool.number);
      layers.push_back(at == of_tools.end() ? 0.0 : at->second);
    }
    return layers;
  }

  Html operations() const
  {
    std::vector<std::vector<Html>> rows;
    const std::vector<double> layers = thickestLayers();
    int number = 0;
    double cut = 0, rapid = 0, volume = 0;
    for (const auto& o : job_.operations()) {
      const PathFigures& f = o.figures;
      const std::string colour = operationColour(o.colour);
      rows.push_back(
          {swatch(colour) + print("%d  ", ++number) + o.operation.name,
           o.operation.tool.describe(),
           timeBar(f.minutes, job_.minutes(), colour),
           print("%.0f", f.cutting_length),
           print("%.1f", 100 * f.cut.airShare()),
           print("%.0f", f.rapid_length),
           print("%zu",
                 f.retracts + static_cast<std::size_t>(o.report.get("link_lifts"))),
           print("%.2f / %.2f", f.cut.mean_radial, f.cut.max_radial),
           print("%.2f", layers[rows.size()]),
           print("%.2f", f.cut.volume / 1000),
           print("%.2f", o.volume_left / 1000)});
      cut += f.cutting_length;
      rapid += f.rapid_length;
      volume += f.cut.volume;
    }
    rows.push_back({"all",
                    "",
                    hoursAndMinutes(job_.minutes()),
                    print("%.0f", cut),
                    "",
                    print("%.0f", rapid),
                    "",
                    "",
                    "",
                    print("%.2f", volume / 1000),
                    ""});
    Html html = table("What each operation does",
                      {{"operation", false, ""},
                       {"tool", false, ""},
                       {"time", true, ""},
                       {"cut", true, "mm"},
                       {"in air", true, "%"},
                       {"rapid", true, "mm"},
                       {"lifts", true, ""},
                       {"radial", true, "mean / max mm"},
                       {"thickest layer", true, "verified, mm"},
                       {"cut", true, "cm\u00b3"},
                       {"left", true, "cm\u00b3"}},
                      rows);
    html += element(
        "p",
        "Times know the machine's acceleration, corners and 15 s for each "
        "tool change, and are to the nearest minute. The thickest layer is what "
        "the verification finds a tool to take at once, as a check says it: "
        "narrower strips do not count. Left is the stock above the part after "
        "the operation.");
    for (const auto& o : job_.idleOperations())
      html +=
          element("p",
                  "Left out: " + o.operation.name + ", " + o.operation.tool.describe() +
                      ": there is nothing for it to cut.");
    return html;
  }

  Html notCut() const
  {
    const Verification& v = verification();
    const double points = double(std::max<std::size_t>(1, v.points));
    Html html = element(
        "p",
        print("%zu points (%.1f %%) are out of reach of the last tool, or covered by "
              "others; no tool passes over %zu (%.1f %%).",
              v.unreachable_points,
              100 * double(v.unreachable_points) / points,
              v.untouched_points,
              100 * v.untouchedShare()));
    if (!job_.options().keep_out.empty())
      html += element("p",
                      print("Because of the keep-out zones %zu points (%.1f %%) stay "
                            "uncut.",
                            v.kept_out_points,
                            100 * double(v.kept_out_points) / points));
    html += narrowTable();
    html += gapsTable();
    return html;
  }

  static Html more(std::size_t all)
  {
    return all > kMostRows
               ? element("p",
                         print("These are the %zu largest of %zu.", kMostRows, all))
               : Html();
  }

  Html narrowTable() const
  {
    std::vector<std::pair<const Operation*, NarrowPlace>> places;
    for (const auto* list : {&job_.operations(), &job_.idleOperations()})
      for (const auto& o : *list)
        for (const auto& place : o.narrow)
          places.emplace_back(&o.operation, place);
    if (places.empty())
      return {};
    std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
      return a.second.area > b.second.area;
    });
    std::vector<std::vector<Html>> rows;
    for (std::size_t i = 0; i < std::min(places.size(), kMostRows); ++i) {
      const auto& [operation, place] = places[i];
      rows.push_back(
          {operation->tool.describe(),
           print("X%.1f Y%.1f Z%.1f", place.at.x(), place.at.y(), place.at.z()),
           print("%.0f", place.area),
           print("%.2f", place.volume / 1000)});
    }
    return table("Too narrow for a roughing tool",
                 {{"tool", false, ""},
                  {"widest at", false, ""},
                  {"area", true, "mm\u00b2"},
                  {"volume", true, "cm\u00b3"}},
                 rows) +
           more(places.size());
  }

  Html gapsTable() const
  {
    if (job_.gaps().empty())
      return element("p", "The scan has no gaps.");
    std::vector<std::vector<Html>> rows;
    for (std::size_t i = 0; i < std::min(job_.gaps().size(), kMostRows); ++i) {
      const GapRegion& gap = job_.gaps()[i];
      rows.push_back({print("X%.1f Y%.1f", gap.centre.x(), gap.centre.y()),
                      print("X%.1f to %.1f, Y%.1f to %.1f",
                            gap.min.x(),
                            gap.max.x(),
                            gap.min.y(),
                            gap.max.y()),
                      print("%.1f", gap.area),
                      std::isfinite(gap.rim_low)
                          ? print("%.2f to %.2f", gap.rim_low, gap.rim_high)
                          : std::string("-"),
                      gap.kind == GapKind::ThroughHole ? "hole through the part, milled"
                      : gap.treatment == GapPolicy::Bridge ? "bridged, protected"
                      : gap.treatment == GapPolicy::Keep   ? "stock stays"
                                                           : "milled"});
    }
    return table("Gaps: what the scanner did not see",
                 {{"centre", false, ""},
                  {"reaches over", false, ""},
                  {"area", true, "mm\u00b2"},
                  {"rim", true, "Z mm"},
                  {"what becomes of it", false, ""}},
                 rows) +
           more(job_.gaps().size()) +
           element("p",
                   print("Besides, %.1f mm\u00b2 that only lie between points are "
                         "bridged.",
                         job_.bridgedArea()));
  }

  Html scan() const
  {
    const ScanFigures& s = job_.scanFigures();
    const SurfaceFigures& surface = job_.surfaceFigures();
    std::string model =
        surface.smooth ? "smooth between the points" : "the bare points";
    if (surface.farthest > 0)
      model += print(", noise taken down to %.4f mm; no point was moved by more than "
                     "%.3f mm",
                     surface.noise_left,
                     surface.farthest);
    const MillOptions& o = job_.options();
    const ErrorBudget budget = ErrorBudget::of(o.tolerance);
    const auto share = [&](const char* what, double value) {
      return std::vector<Html>{
          what, print("%.4f", value), print("%.1f", 100 * value / o.tolerance)};
    };
    return terms({{"Scan",
                   print("%s, %zu points, %zu strays removed, %.6g mm per unit",
                         s.format.c_str(),
                         job_.part().size(),
                         s.strays,
                         s.scale)},
                  {"Spacing",
                   print("%.3f mm, of 99 %% of the points within %.3f mm",
                         s.spacing.median,
                         s.spacing.p99)},
                  {"Noise", print("%.4f mm, one standard deviation", surface.noise)},
                  {"Surface", model},
                  {"Scallops",
                   print("%.4g mm after finishing, %.4g mm after semi-finishing",
                         o.scallop,
                         o.semi_scallop)}}) +
           table("How the tolerance is spent",
                 {{"on", false, ""}, {"up to", true, "mm"}, {"share", true, "%"}},
                 {share("chords against the true cutter-location curve", budget.chord),
                  share("arcs and longer lines against these chords", budget.arcs),
                  share("the control's rounding of corners", budget.blend),
                  share("rounding to decimals", budget.rounding),
                  share("all together", o.tolerance)});
  }

  Html again() const
  {
    std::string command = "pointmill check";
    for (const auto& program : job_.programs())
      command += " " + program.name;
    return element(
               "p",
               "In the directory of this page. Any other program for the same part, "
               "stock and tools can be checked in the same way.") +
           element("pre", element("code", command + " --dir . --picture findings.png"));
  }

  static Html foot()
  {
    return element(
        "footer",
        "All lengths are millimetres in the part frame. The same figures, and "
        "more, are in report.json. The 3D view is drawn by three.js, whose "
        "licence stands in the source of this page.");
  }

  std::string inFolder(const std::string& name) const
  {
    return (std::filesystem::path(folder_) / name).string();
  }

  /// A picture that is there, once.
  Html take(const std::string& name)
  {
    const auto at = std::find(pictures_.begin(), pictures_.end(), name);
    if (at == pictures_.end())
      return {};
    pictures_.erase(at);
    const std::string path = inFolder(name);
    const auto known =
        std::find_if(std::begin(kPictures),
                     std::end(kPictures),
                     [&](const KnownPicture& p) { return name == p.name; });
    return known == std::end(kPictures)
               ? of(PictureFile{path, name, name})
               : of(PictureFile{path, known->alt, known->caption});
  }

  Html rest()
  {
    Html html;
    while (!pictures_.empty())
      html += take(std::string(pictures_.front()));
    return html;
  }

  const MillJob& job_;
  std::string scan_, folder_;
  std::vector<std::string> pictures_;
  bool written_;
};

} // namespace

void writeJobPage(const std::string& path,
                  const MillJob& job,
                  const std::string& scan_name,
                  const std::vector<std::string>& pictures,
                  bool written)
{
  const Page page = JobPage(job,
                            scan_name,
                            std::filesystem::path(path).parent_path().string(),
                            pictures,
                            written)
                        .make();
  writeFileAtomically(path, [&](std::ostream& out) { writePage(out, page); });
}

} // namespace pointmill
