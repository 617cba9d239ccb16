// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "page_parts.h"

#include "finding_scene.h"
#include "print.h"

#include <pointmill/common/error.h>
#include <pointmill/page/deviation_chart.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace pointmill::page {
namespace {

std::string bytesOf(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw DataError(path + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A tick, an exclamation mark in a triangle, a cross in an octagon.
const char* signOf(Verdict verdict)
{
  switch (verdict) {
  case Verdict::Passed:
    return R"(<svg viewBox="0 0 40 40" aria-hidden="true"><circle cx="20" cy="20" r="19" fill="#00654b"/><path d="M10 21l7 7 13-15" fill="none" stroke="#fff" stroke-width="4.5"/></svg>)";
  case Verdict::Warned:
    return R"(<svg viewBox="0 0 40 40" aria-hidden="true"><path d="M20 2l19 35H1z" fill="#f0b429" stroke="#7a4d00" stroke-width="1.5"/><path d="M20 14v12m0 3v4" stroke="#1f2933" stroke-width="4"/></svg>)";
  case Verdict::Refused:
    break;
  }
  return R"(<svg viewBox="0 0 40 40" aria-hidden="true"><path d="M12 1h16l11 11v16L28 39H12L1 28V12z" fill="#a8180f"/><path d="M12 12l16 16m0-16L12 28" stroke="#fff" stroke-width="4.5"/></svg>)";
}

std::string counted(std::size_t count, const std::string& what)
{
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::size_t errorsIn(const Verification& v)
{
  return static_cast<std::size_t>(
      std::count_if(v.findings.begin(), v.findings.end(), [](const Finding& f) {
        return f.severity == Severity::Error;
      }));
}

std::string percent(std::size_t part, std::size_t whole)
{
  return print("%.2f %%",
               100.0 * double(part) / double(std::max<std::size_t>(1, whole)));
}

} // namespace

Html of(const PictureFile& file)
{
  return picture(bytesOf(file.path), file.alt, file.caption);
}

Html verdict(Verdict verdict, const std::string& words, const std::string& more)
{
  const char* const kind = verdict == Verdict::Passed   ? "passed"
                           : verdict == Verdict::Warned ? "warned"
                                                        : "refused";
  return element(std::string("div class=\"verdict ") + kind + "\"",
                 Html::markup(signOf(verdict)) +
                     element("div", Html(words) + element("small", more)));
}

Html verdictOf(const Verification& v)
{
  const std::size_t errors = errorsIn(v), warnings = v.findings.size() - errors;
  if (errors > 0)
    return verdict(Verdict::Refused,
                   "Refused: " + counted(errors, "error") +
                       (warnings > 0 ? ", " + counted(warnings, "warning") : ""),
                   "This program fails its verification. Do not run it.");
  const std::string read = "It was read back from its text and milled in simulation "
                           "against every point of the scan.";
  return warnings > 0 ? verdict(Verdict::Warned,
                                "Passed with " + counted(warnings, "warning"),
                                read)
                      : verdict(Verdict::Passed, "Passed its verification", read);
}

Html tiles(const std::vector<std::pair<std::string, std::string>>& figures)
{
  Html list;
  for (const auto& [figure, what] : figures)
    list += element("li", element("b", figure) + element("span", what));
  return element("ul class=\"tiles\"", list);
}

Html terms(const std::vector<std::pair<std::string, Html>>& list)
{
  Html html;
  for (const auto& [term, what] : list)
    html += element("dt", term) + element("dd", what);
  return element("dl", html);
}

Html findings(const Judgement& judgement,
              const Criteria& criteria,
              const std::string& scratch,
              const Html& overview)
{
  const auto& list = judgement.verification.findings;
  if (list.empty())
    return element("p", "Nothing was found.");
  const FindingPicture scene("", judgement, criteria);
  Html items;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Finding& f = list[i];
    const bool error = f.severity == Severity::Error;
    const FindingMark& mark = scene.scene().findings[i];
    std::string where = f.code;
    if (!mark.where.empty())
      where += ", " + mark.where;
    if (mark.place)
      where += print(", X%.3f Y%.3f Z%.3f", f.place.x(), f.place.y(), f.place.z());
    if (f.tool > 0)
      where += ", T" + std::to_string(f.tool);
    if (f.count > 1)
      where += print(", %zu places or moves, this is the worst", f.count);
    Html item =
        element("h3",
                element("span class=\"tag\"",
                        (error ? "error " : "warning ") + std::to_string(i + 1)) +
                    f.text) +
        element("p class=\"where\"", where);
    const bool told = list.size() == 1 && !overview.empty();
    if (!told && writeSection(scratch, scene.scene(), i))
      item += of({scratch,
                  "Section through the place of finding " + std::to_string(i + 1) +
                      ": part, stock and tool",
                  "Section through the place, one scale for both axes, in mm"});
    items += element(error ? "li class=\"error\"" : "li class=\"warning\"", item);
  }
  return element("ul class=\"findings\"", items) + overview;
}

std::vector<std::pair<std::string, std::string>> figuresOf(const Judgement& judgement,
                                                           const Criteria& criteria)
{
  const Verification& v = judgement.verification;
  std::vector<std::pair<std::string, std::string>> figures{
      {hoursAndMinutes(judgement.time.total.total() / 60), "of milling, estimated"},
      {print("%.4f mm", v.gouge),
       print("deepest gouge; %.4f mm would pass", criteria.gougeLimit())}};
  if (criteria.model)
    figures.back().second +=
        print(". Of the points as scanned, with their noise: %.3f mm", v.raw_gouge);
  figures.emplace_back(print("%.3f mm", v.residual.p95),
                       "left over at most on 95 % of the points, more than a perfect "
                       "pass leaves");
  return figures;
}

Html accuracy(const Judgement& judgement, const Criteria& criteria)
{
  const Verification& v = judgement.verification;
  const double tolerance = criteria.tolerance;
  const pcl::PointCloud<pcl::PointXYZI> reached = v.deviationsInReach();
  const DeviationShares shares(reached, tolerance);
  const bool noisy = criteria.model != nullptr;
  const auto row = [](const std::string& name, const Quantiles& q) {
    std::vector<Html> cells{name};
    for (const double value : {q.p50, q.p90, q.p95, q.p99})
      cells.emplace_back(std::isfinite(value) ? print("%.4f", value) : "-");
    return cells;
  };
  std::vector<std::vector<Html>> quantiles{
      row("left over, more than a perfect pass of the last tool leaves", v.residual),
      row(noisy ? "milled minus scan without its noise, points in reach"
                : "milled minus scan, points in reach",
          v.deviation)};
  if (noisy)
    quantiles.push_back(
        row("milled minus scan as scanned, points in reach", v.raw_deviation));
  const std::string scanned = noisy ? "scanned point" : "point of the scan";
  std::vector<std::vector<Html>> counts{
      {"below the " + scanned + print(" by more than %.3g mm vertically", tolerance) +
           (noisy ? ": the scan's noise counts here" : ""),
       std::to_string(shares.below),
       percent(shares.below, shares.cut)},
      {print("within \u00b1%.3g mm of it", tolerance),
       std::to_string(shares.within),
       percent(shares.within, shares.cut)},
      {print("above it by more than %.3g mm", tolerance),
       std::to_string(shares.over),
       percent(shares.over, shares.cut)}};
  return element("p",
                 "In reach are the points that the last tool comes to in a perfect "
                 "pass. Those under others, in corners narrower than the tool or "
                 "beside keep-out zones do not count. Half of the points have no more "
                 "than p50, 99 of 100 no more than p99.") +
         table("How near the milled part comes to the scan [mm]",
               {{"", false, ""},
                {"p50", true, "half"},
                {"p90", true, ""},
                {"p95", true, ""},
                {"p99", true, ""}},
               quantiles) +
         element("h3",
                 noisy ? "Milled surface minus each point, as scanned"
                       : "Milled surface minus each point") +
         element("p",
                 print("These are vertical distances at the %zu points in reach, of "
                       "%zu. On walls they are far more than the distance from the "
                       "wall",
                       shares.cut,
                       v.points) +
                     (noisy ? "; and the scan's noise is in them, as points lie to "
                              "both sides of the surface"
                            : "") +
                     ". They refuse no program. What does is the gouge, how deep a "
                     "point gets into a tool: " +
                     print("%.4f mm here, %.4f mm would pass.",
                           v.gouge,
                           criteria.gougeLimit())) +
         element("div class=\"sketch-room\"", deviationChart(reached, tolerance)) +
         table("Points in reach",
               {{"", false, ""}, {"points", true, ""}, {"share", true, ""}},
               counts);
}

Html timeBar(double minutes, double whole, const std::string& colour)
{
  const double share = whole > 0 ? std::clamp(100 * minutes / whole, 0.0, 100.0) : 0.0;
  return Html(hoursAndMinutes(minutes)) +
         Html::markup("<span class=\"bar-room\" aria-hidden=\"true\"><span "
                      "class=\"bar-fill\" style=\"width:" +
                      print("%.1f", share) + "%;background:" + colour +
                      "\"></span></span>");
}

Html swatch(const std::string& colour)
{
  return Html::markup(
      "<span class=\"swatch\" aria-hidden=\"true\" style=\"background:" + colour +
      "\"></span>");
}

} // namespace pointmill::page
