// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "moves.h"
#include "perfect_pass.h"

#include <pointmill/common/watch.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

/// A point this far under a perfect pass of the last tool is out of its reach [mm]:
/// more than what noise lifts the tool off.
constexpr double kReach = 0.1;
/// A perfect pass that comes so near to a point is taken to reach it [mm].
constexpr double kClose = 0.01;

Quantiles quantiles(std::vector<float>& values)
{
  Quantiles q;
  if (values.empty())
    return q;
  const auto at = [&](double share) {
    const auto k = std::min(values.size() - 1,
                            static_cast<std::size_t>(share * double(values.size())));
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(k), values.end());
    return double(values[k]);
  };
  q.p1 = at(0.01);
  q.p5 = at(0.05);
  q.p50 = at(0.50);
  q.p90 = at(0.90);
  q.p95 = at(0.95);
  q.p99 = at(0.99);
  q.max = *std::max_element(values.begin(), values.end());
  return q;
}

/// What stands over points when all is done, and what a perfect pass would leave.
struct Heights {
  const PointIndex& points;
  std::vector<float> left, perfect;
  std::vector<float> free = {}; ///< what it would leave without zones, if there are any

  double z(std::size_t i) const { return points.point(i).z(); }
  double best(std::size_t i) const { return std::max<double>(z(i), perfect[i]); }
  /// Whether only zones keep it from the point.
  bool keptOut(std::size_t i) const
  {
    return !free.empty() && free[i] - z(i) <= kReach && perfect[i] > free[i] + kClose;
  }
  /// Right beside a zone a search in steps misses places that the program found.
  void takeWhatWasDone()
  {
    for (std::size_t i = 0; i < free.size(); ++i)
      if (perfect[i] > free[i] + kClose)
        perfect[i] = std::min(perfect[i], std::max(free[i], left[i]));
  }
  bool touched(std::size_t i) const { return std::isfinite(left[i]); }
  bool inReach(std::size_t i, double reach) const
  {
    return best(i) - z(i) <= reach && !keptOut(i);
  }
};

/// Surface minus point, over the points that a perfect pass reaches to `reach`.
Quantiles deviations(const Heights& heights, double reach)
{
  std::vector<float> off;
  for (std::size_t i = 0; i < heights.points.size(); ++i)
    if (heights.touched(i) && heights.inReach(i, reach))
      off.push_back(static_cast<float>(heights.left[i] - heights.z(i)));
  return quantiles(off);
}

pcl::PointCloud<pcl::PointXYZI> deviationCloud(const Heights& heights)
{
  pcl::PointCloud<pcl::PointXYZI> cloud;
  cloud.reserve(heights.points.size());
  for (std::size_t i = 0; i < heights.points.size(); ++i) {
    const Eigen::Vector3f p = heights.points.point(i).cast<float>();
    pcl::PointXYZI point(p.x(), p.y(), p.z(), std::numeric_limits<float>::quiet_NaN());
    if (heights.touched(i))
      point.intensity = static_cast<float>(heights.left[i] - heights.z(i));
    cloud.push_back(point);
  }
  return cloud;
}

std::vector<bool> inReach(const Heights& heights, double reach)
{
  std::vector<bool> in_reach(heights.points.size());
  for (std::size_t i = 0; i < in_reach.size(); ++i)
    in_reach[i] = heights.inReach(i, reach);
  return in_reach;
}

void note(const char* code, const Gouges& gouges, Findings& findings)
{
  if (gouges.count > 0)
    findings.add(code, gouges.depth, gouges.at, gouges.line, gouges.tool, gouges.count);
}

/// What is left over the points.
void judgeRest(const Heights& heights, Verification& result)
{
  std::vector<float> residual;
  residual.reserve(heights.points.size());
  for (std::size_t i = 0; i < heights.points.size(); ++i) {
    const bool kept_out = heights.keptOut(i);
    result.untouched_points += !heights.touched(i);
    result.unreachable_points += kept_out || heights.best(i) - heights.z(i) > kReach;
    result.kept_out_points += kept_out;
    // infinite where no tool comes by
    if (!kept_out)
      residual.push_back(
          std::max(0.f, static_cast<float>(heights.left[i] - heights.best(i))));
  }
  result.residual = quantiles(residual);
  result.deviation = deviations(heights, kReach);
}

} // namespace

void judgePoints(const PointIndex& surface,
                 const PointIndex* raw,
                 const std::vector<SweptMove>& moves,
                 const PointLimits& limits,
                 const KeepOut& keep_out,
                 unsigned threads,
                 Verification& result,
                 Findings& findings)
{
  // Sweeping takes most of the time; noisy scans are swept twice.
  const double swept = raw ? 0.4 : 0.7, all_swept = raw ? 0.8 : swept;
  Heights heights{surface, {}, {}};
  const Gouges gouges = [&] {
    const WorkStep step({0.0, swept});
    return sweepPoints(surface, moves, limits.tolerance, threads, heights.left);
  }();
  note("gouge", gouges, findings);
  result.points = surface.size();
  result.gouge = gouges.depth;
  result.gouge_at = gouges.at;
  result.gouge_line = gouges.line;
  result.gouged_points = gouges.count;
  if (!raw)
    result.deviations = deviationCloud(heights);
  Heights measured{raw ? *raw : surface, {}, {}};
  if (raw) {
    const WorkStep step({swept, all_swept});
    const Gouges deeper = sweepPoints(
        *raw, moves, limits.tolerance + limits.noise, threads, measured.left);
    note("scan_gouge", deeper, findings);
    result.raw_gouge = deeper.depth;
    result.raw_gouge_at = deeper.at;
    result.raw_gouge_line = deeper.line;
    result.raw_gouged_points = deeper.count;
    result.deviations = deviationCloud(measured);
  }
  const auto last = std::find_if(
      moves.rbegin(), moves.rend(), [](const SweptMove& m) { return !m.rapid; });
  if (last == moves.rend()) {
    const double all = std::numeric_limits<double>::infinity();
    result.residual = {all, all, all, all, all};
    result.untouched_points = surface.size();
    result.in_reach.assign(result.deviations.size(), true);
    return;
  }
  const double floor = std::max(surface.min().z(), limits.floor);
  const WorkStep rest({all_swept, 1.0});
  const PerfectPass perfect(surface, *last->tool, floor, threads, keep_out);
  heights.perfect = perfect.heightsOver(surface, kClose);
  if (!keep_out.empty()) {
    heights.free =
        PerfectPass(surface, *last->tool, floor, threads).heightsOver(surface, kClose);
    heights.takeWhatWasDone();
  }
  judgeRest(heights, result);
  if (!raw) {
    result.in_reach = inReach(heights, kReach);
    return;
  }

  // Noise puts points below the surface that the tool reaches all the same.
  const double reach = kReach + limits.noise;
  measured.perfect = perfect.heightsOver(*raw, reach);
  result.raw_deviation = deviations(measured, reach);
  result.in_reach = inReach(measured, reach);
  result.unreachable_points = static_cast<std::size_t>(
      std::count(result.in_reach.begin(), result.in_reach.end(), false));
}

} // namespace pointmill
