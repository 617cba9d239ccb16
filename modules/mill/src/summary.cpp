// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "print.h"

#include <pointmill/mill/summary.h>
#include <pointmill/slice/sink.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pointmill {
namespace {

/// Less than this under the floor holds no part [mm].
constexpr double kSkin = 0.2;
/// Less of a level than this is no place [mm2].
constexpr double kLittle = 1.0;

/// What the cutters rest on, and why.
std::string surfaceLine(const MillJob& job)
{
  const SurfaceFigures& surface = job.surfaceFigures();
  const Spacing& spacing = job.scanFigures().spacing;
  std::string text =
      print("scan       points %.3f mm apart (99 %% within %.3f), noise %.4f mm\n",
            spacing.median,
            spacing.p99,
            surface.noise);
  const double sink =
      sinkBetweenPoints(job.options().finish.tool, job.scanFigures().spacing.p99);
  if (!surface.smooth)
    return text + print("surface    the bare points; %s may sink %.4f mm between "
                        "them\n",
                        job.options().finish.tool.describe().c_str(),
                        sink);
  text += "surface    smooth between the points";
  if (surface.farthest > 0)
    text += print(", noise taken down to %.4f mm; no point of the scan was moved by "
                  "more than %.3f mm",
                  surface.noise_left,
                  surface.farthest);
  if (surface.noise_kept)
    text += "; the noise stays, as the points are too few to tell it from form "
            "(--surface smooth takes it off all the same)";
  return text + "\n";
}

bool notScanned(const GapRegion& gap)
{
  return gap.kind == GapKind::NotScanned;
}

double percent(std::size_t part, std::size_t whole)
{
  return 100.0 * double(part) / double(std::max<std::size_t>(1, whole));
}

/// What the roughing and what the zones leave standing.
std::vector<std::string> leftLines(const MillJob& job)
{
  std::vector<std::string> lines;
  for (const auto& o : job.idleOperations())
    lines.push_back(print("idle       %s, %s: there is nothing for it to cut\n",
                          o.operation.name.c_str(),
                          o.operation.tool.describe().c_str()));
  for (const auto* list : {&job.operations(), &job.idleOperations()})
    for (const auto& o : *list) {
      const double missed = o.report.get("missed_mm2");
      if (missed > kLittle)
        lines.push_back(
            print("not cleared by %s: %.0f mm2 of its levels, all together, "
                  "skins and crumbs where no pass was possible\n",
                  o.operation.name.c_str(),
                  missed));
      if (o.narrow.empty())
        continue;
      const NarrowPlace& largest = o.narrow.front();
      lines.push_back(print("too narrow %s does not get into %zu places, %.2f cm3; the "
                            "largest, %.0f mm2, is at X%.1f Y%.1f Z%.1f\n",
                            o.operation.tool.describe().c_str(),
                            o.narrow.size(),
                            o.report.get("narrow_mm3") / 1000,
                            largest.area,
                            largest.at.x(),
                            largest.at.y(),
                            largest.at.z()));
    }
  const KeepOut& zones = job.options().keep_out;
  double kept = 0; // each tool keeps out of some of what the ones before do
  for (const auto& o : job.operations())
    kept = std::max(kept, o.report.get("kept_out_mm3"));
  if (!zones.empty())
    lines.push_back(
        print("kept out   of %zu zones with a margin of %.1f mm: %.2f cm3 "
              "of stock and %zu points (%.1f %%) stay uncut\n",
              zones.zones().size(),
              zones.margin(),
              kept / 1000,
              job.verification().kept_out_points,
              percent(job.verification().kept_out_points, job.verification().points)));
  return lines;
}

/// What each operation does, a line each.
std::string operationsTable(const MillJob& job)
{
  std::string text = print("%-20s %-14s %9s %9s %5s %9s %8s %13s %6s %8s %8s %7s %6s\n",
                           "operation",
                           "tool",
                           "CL points",
                           "cut mm",
                           "air %",
                           "rapid mm",
                           "lifts",
                           "radial mm",
                           "axial",
                           "cut cm3",
                           "left cm3",
                           "min",
                           "s");
  for (const auto& o : job.operations()) {
    const PathFigures& f = o.figures;
    text += print("%-20s %-14s %9zu %9.0f %5.1f %9.0f %8zu %6.2f %6.2f %6.2f %8.2f "
                  "%8.2f %7.1f %6.2f\n",
                  o.operation.name.c_str(),
                  o.operation.tool.describe().c_str(),
                  f.cl_points,
                  f.cutting_length,
                  100 * f.cut.airShare(),
                  f.rapid_length,
                  f.retracts + static_cast<std::size_t>(o.report.get("link_lifts")),
                  f.cut.mean_radial,
                  f.cut.max_radial,
                  o.axial_depth,
                  f.cut.volume / 1000,
                  o.volume_left / 1000,
                  f.minutes,
                  o.seconds);
  }
  return text;
}

} // namespace

std::vector<std::string> warningsOf(const MillJob& job)
{
  std::vector<std::string> lines;
  if (job.floor() <= job.stock().min.z() + kSkin)
    lines.push_back(print("the part's surroundings are cut down to the bottom of the "
                          "stock, Z%.2f: --floor or --stock-bottom leave it a base",
                          job.floor()));
  const MillOptions& o = job.options();
  const Verification& v = job.verification();
  const SurfaceFigures& surface = job.surfaceFigures();
  const double sink =
      sinkBetweenPoints(o.finish.tool, job.scanFigures().spacing.p99, 45);
  if (sink > o.tolerance)
    lines.push_back(print(
        "the scan is sparse: on a slope of 45 degrees %s may sink %.3f mm between "
        "its bare points%s",
        o.finish.tool.describe().c_str(),
        sink,
        surface.smooth ? "; the smooth surface between them is the likeliest one, "
                         "on edges and steep flanks it may err by as much"
                       : ", below the true surface"));
  if (surface.farthest > o.tolerance)
    lines.push_back(
        print("the noise is large for the tolerance: points of the scan may lie up to "
              "%.3f mm inside the tool, and edges may be rounded by as much; --noise "
              "says what the scanner's is, if some of this is form",
              surface.farthest + o.tolerance));
  if (surface.noise_left > o.tolerance)
    lines.push_back(
        print("smoothing leaves %.3f mm of the noise, more than the tolerance",
              surface.noise_left));
  for (const auto& zone : o.keep_out.zones()) {
    const double reach = o.keep_out.margin() + o.rough.tool.diameter;
    if ((zone.min().array() - reach > job.stock().max.head<2>().array()).any() ||
        (zone.max().array() + reach < job.stock().min.head<2>().array()).any())
      lines.push_back("the " + zone.describe() +
                      " is nowhere near the stock: are its figures right?");
  }
  const Post& post = o.writer.getPost();
  if (o.writer.getCorners() == Corners::Control)
    lines.push_back("how far " + post.control +
                    " rounds corners is not known here, and not in the figures");
  else if (post.blend.empty() && post.form != ProgramForm::Grbl)
    lines.push_back(post.control + " cannot be told how far it may round corners: it "
                                   "stops at each (--corners control leaves it to it)");
  if (!o.boundary.empty())
    lines.push_back("what is left over counts the whole part, beyond the polygon too");
  for (const auto& line : findingLines(v, job.judgement().program))
    lines.push_back(line);
  for (const Tool& tool : job.tools()) {
    const auto tip = v.lowest_tip.find(tool.number);
    if (tip == v.lowest_tip.end() || tool.holder_diameter > 0)
      continue;
    const double reach = job.stock().top() - tip->second;
    if (reach > 6 * tool.diameter)
      lines.push_back(
          print("%s must reach %.0f mm below the top of the stock: check its "
                "stick-out; holder and shank are not known",
                tool.describe().c_str(),
                reach));
  }
  return lines;
}

std::string summaryOf(const MillJob& job, const std::string& directory)
{
  const Verification& v = job.verification();
  const MillOptions& o = job.options();
  const Eigen::Vector3d size = job.partSize();
  std::string text =
      print("part       %.2f x %.2f x %.2f mm, %zu points (%zu strays removed)\n",
            size.x(),
            size.y(),
            size.z(),
            job.part().size(),
            job.scanFigures().strays);
  for (const auto& line : job.setUp())
    text += "set-up     " + line + "\n";
  text += surfaceLine(job);
  text += operationsTable(job);
  text += print("verified   deepest gouge %.4f mm", v.gouge);
  if (job.surfaceFigures().farthest > 0)
    text += print(" of the points without noise, %.4f mm as scanned", v.raw_gouge);
  text += print(", %zu rapids in stock\n", v.rapids_in_stock);
  text +=
      print("left over  p50 %.4f p95 %.4f max %.3f mm more than a perfect pass of the "
            "last tool leaves\n",
            v.residual.p50,
            v.residual.p95,
            v.residual.max);
  const bool noisy = job.surfaceFigures().farthest > 0;
  const Quantiles& off = noisy ? v.raw_deviation : v.deviation;
  text +=
      print("deviation  p5 %+.4f p50 %+.4f p95 %+.4f mm, %.1f %% within %.3g mm, of "
            "the points in reach: vertical and with the scan's noise, while the gouge "
            "is along the tool",
            off.p5,
            off.p50,
            off.p95,
            100 * v.shareWithin(o.tolerance),
            o.tolerance);
  if (noisy)
    text += print("; of the points without noise p5 %+.4f p95 %+.4f mm",
                  v.deviation.p5,
                  v.deviation.p95);
  text += "\n";
  text +=
      print("not cut    %.1f %% of the points: out of reach, or covered by others\n",
            percent(v.unreachable_points, v.points));
  for (const auto& line : leftLines(job))
    text += line;
  text +=
      print("not seen   %zu gaps of the scan, %.0f mm2, and %.0f mm2 between points: "
            "%s\n",
            static_cast<std::size_t>(
                std::count_if(job.gaps().begin(), job.gaps().end(), notScanned)),
            job.gapArea(),
            job.bridgedArea(),
            job.options().gaps == GapPolicy::Mill ? "gaps are milled"
                                                  : "bridged and protected");
  for (const auto& gap : job.gaps())
    if (!notScanned(gap))
      text += print("hole       %.0f mm2 at X%.2f Y%.2f, milled to Z%.3f\n",
                    gap.area,
                    gap.centre.x(),
                    gap.centre.y(),
                    job.floor());
  text += "time       " + hoursAndMinutes(job.minutes()) + " of milling\n";
  for (const auto& line : warningsOf(job))
    text += "mind       " + line + "\n";
  const auto at = [&](const char* name) {
    return (std::filesystem::path(directory) / name).string() + "\n";
  };
  const GCodeWriter::Statistics& written = job.programFigures();
  text += print("blocks     %zu, %.2f MB, for %s; %zu moves were planned\n",
                written.lines,
                double(written.bytes) / 1e6,
                o.writer.getPost().control.c_str(),
                written.feed_moves + written.rapids);
  for (const auto& program : job.programs())
    text += "program    " + at(program.name.c_str());
  text += "picture    " + at("preview.png");
  text += "page       " + at("report.html");
  text += "report     " + at("report.json");
  return text;
}

} // namespace pointmill
