// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/surface/point_index.h>
#include <pointmill/surface/sweep.h>

#include <algorithm>

namespace pointmill {
namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// Cells hold about this many points: few enough to skip most, enough to be worth a
/// look.
constexpr double kPointsPerCell = 6.0;
constexpr double kMostCells = 16e6;

} // namespace

PointIndex::PointIndex(std::vector<float> x, std::vector<float> y, std::vector<float> z)
{
  if (z.empty())
    throw DataError("no finite point to cut: the cloud is empty");
  if (x.size() != z.size() || y.size() != z.size())
    throw DataError("the points' x, y and z are not of one number");
  const auto finite = [](float v) { return std::isfinite(v); };
  for (const auto* axis : {&x, &y, &z})
    if (!std::all_of(axis->begin(), axis->end(), finite))
      throw DataError("a point of the index is not finite");
  if (z.size() > std::numeric_limits<std::uint32_t>::max())
    throw DataError("more than 4294967295 points: thin the scan");
  const auto [x0, x1] = std::minmax_element(x.begin(), x.end());
  const auto [y0, y1] = std::minmax_element(y.begin(), y.end());
  const auto [z0, z1] = std::minmax_element(z.begin(), z.end());
  min_ = {*x0, *y0, *z0};
  max_ = {*x1, *y1, *z1};
  const double width = max_.x() - min_.x(), depth = max_.y() - min_.y();
  const double longest = std::max({width, depth, 1e-3});
  const double cells =
      std::clamp(static_cast<double>(z.size()) / kPointsPerCell, 1.0, kMostCells);
  // A thin strip has little area; the second bound keeps its rows and columns
  // countable.
  cell_ = std::max(std::sqrt(width * depth / cells), longest / cells);
  columns_ = static_cast<int>(width / cell_) + 1;
  rows_ = static_cast<int>(depth / cell_) + 1;

  start_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  const auto cellOf = [&](std::size_t i) {
    return static_cast<std::size_t>(rowOf(y[i])) * columns_ + columnOf(x[i]);
  };
  for (std::size_t i = 0; i < z.size(); ++i)
    ++start_[cellOf(i) + 1];
  for (std::size_t c = 1; c < start_.size(); ++c)
    start_[c] += start_[c - 1];
  x_.resize(z.size()), y_.resize(z.size()), z_.resize(z.size());
  top_.assign(start_.size() - 1, -std::numeric_limits<float>::infinity());
  auto next = start_;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const std::size_t c = cellOf(i), at = next[c]++;
    x_[at] = x[i];
    y_[at] = y[i];
    z_[at] = z[i];
    top_[c] = std::max(top_[c], z[i]);
  }
}

int PointIndex::columnOf(double x) const
{
  const double c = std::floor((x - min_.x()) / cell_);
  return static_cast<int>(std::clamp(c, 0.0, columns_ - 1.0));
}

int PointIndex::rowOf(double y) const
{
  const double r = std::floor((y - min_.y()) / cell_);
  return static_cast<int>(std::clamp(r, 0.0, rows_ - 1.0));
}

// Calls visit(top of cell, least distance of the cell to the segment, first, last) for
// the non-empty cells within `radius` of the segment; the points of a cell are [first,
// last).
template <typename Visit>
void PointIndex::scan(
    double ax, double ay, double bx, double by, double radius, Visit&& visit) const
{
  const double x0 = std::min(ax, bx) - radius, x1 = std::max(ax, bx) + radius;
  const double y0 = std::min(ay, by) - radius, y1 = std::max(ay, by) + radius;
  // written so that NaN meets nothing
  if (!(x1 >= min_.x() && y1 >= min_.y() && x0 <= max_.x() && y0 <= max_.y()))
    return;
  const int c0 = columnOf(x0), c1 = columnOf(x1), r0 = rowOf(y0), r1 = rowOf(y1);
  const bool level = ay == by || ax == bx;
  const double half_diagonal = cell_ * std::sqrt(0.5);
  for (int r = r0; r <= r1; ++r) {
    const double low = min_.y() + r * cell_, high = low + cell_;
    const double oy = std::max({0.0, low - std::max(ay, by), std::min(ay, by) - high});
    for (int c = c0; c <= c1; ++c) {
      const std::size_t at = static_cast<std::size_t>(r) * columns_ + c;
      if (start_[at] == start_[at + 1])
        continue;
      const double left = min_.x() + c * cell_, right = left + cell_;
      double away;
      if (level) { // box to box is exact for a point or an axis-parallel segment
        const double ox =
            std::max({0.0, left - std::max(ax, bx), std::min(ax, bx) - right});
        away = std::sqrt(ox * ox + oy * oy);
      }
      else {
        away = std::sqrt(segmentDistance2(
                   ax, ay, bx, by, 0.5 * (left + right), 0.5 * (low + high))) -
               half_diagonal;
        away = std::max(0.0, away);
      }
      // float32 points may lie a hair outside the cell that they were sorted into
      away = std::max(0.0, away - 1e-5 * cell_ - 1e-9);
      if (away <= radius)
        visit(top_[at], away, start_[at], start_[at + 1]);
    }
  }
}

Contact PointIndex::drop(const Tool& tool, double x, double y) const
{
  Contact best;
  const double radius2 = tool.radius() * tool.radius();
  const CutterProfile cutter = tool.profile();
  const bool ball = cutter.isBall();
  const double r = cutter.radius();
  scan(
      x, y, x, y, r, [&](double top, double away, std::size_t first, std::size_t last) {
        if (top <= best.tip || top - cutter.height(std::min(away, r)) <= best.tip)
          return;
        for (std::size_t i = first; i < last; ++i) {
          const double dx = x_[i] - x, dy = y_[i] - y, d2 = dx * dx + dy * dy;
          if (d2 > radius2 || z_[i] <= best.tip)
            continue;
          const double tip = ball ? z_[i] - (r - std::sqrt(radius2 - d2))
                                  : z_[i] - cutter.height(std::sqrt(d2));
          if (tip > best.tip) {
            best.tip = tip;
            best.point = static_cast<std::int64_t>(i);
          }
        }
      });
  if (best.touches())
    best.at = point(static_cast<std::size_t>(best.point));
  return best;
}

void PointIndex::dropRow(const Tool& tool,
                         const Eigen::Vector2d& from,
                         const Eigen::Vector2d& step,
                         std::size_t count,
                         Contact* contacts) const
{
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d at = from + static_cast<double>(i) * step;
    contacts[i] = drop(tool, at.x(), at.y());
  }
}

double PointIndex::dropAlong(
    const Tool& tool, double ax, double ay, double bx, double by) const
{
  double best = kNothing;
  const CutterProfile cutter = tool.profile();
  const double radius2 = tool.radius() * tool.radius();
  scan(ax,
       ay,
       bx,
       by,
       tool.radius(),
       [&](double top, double away, std::size_t first, std::size_t last) {
         if (top - cutter.height(std::min(away, tool.radius())) <= best)
           return;
         for (std::size_t i = first; i < last; ++i) {
           if (z_[i] <= best)
             continue;
           const double d2 = segmentDistance2(ax, ay, bx, by, x_[i], y_[i]);
           if (d2 <= radius2)
             best = std::max(best, z_[i] - cutter.height(std::sqrt(d2)));
         }
       });
  return best;
}

double PointIndex::gouge(const Tool& tool,
                         const Eigen::Vector3d& a,
                         const Eigen::Vector3d& b,
                         double tolerance) const
{
  double worst = tolerance;
  const CutterProfile cutter = tool.profile();
  const double lowest = std::min(a.z(), b.z());
  scan(a.x(),
       a.y(),
       b.x(),
       b.y(),
       tool.radius() - tolerance,
       [&](double top, double away, std::size_t first, std::size_t last) {
         if (top <= lowest + cutter.height(std::min(away, tool.radius())) + worst)
           return;
         for (std::size_t i = first; i < last; ++i)
           if (z_[i] > lowest + worst)
             worst = std::max(worst, penetration(cutter, a, b, point(i)));
       });
  return worst > tolerance ? worst : 0.0;
}

} // namespace pointmill
