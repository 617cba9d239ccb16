// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/common/parameters.h>
#include <pointmill/surface/stock_field.h>
#include <pointmill/surface/sweep.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

/// Cells of a row that are passed over at once where nothing can happen to them.
constexpr int kRun = 8;
/// More than what rounding takes from lengths and heights [mm].
constexpr double kRounding = 1e-9;
/// More than what float32 takes from a height [mm].
constexpr double kStored = 1e-4;

} // namespace

StockField::StockField(const Stock& stock, double cell, Bound bound)
    : stock_(stock), cell_(cell), bound_(bound)
{
  checkRange("StockField", "cell", cell, "mm", {0.01, 1000});
  const Eigen::Vector3d size = stock.max - stock.min;
  if (!(size.minCoeff() > 0))
    throw ParameterError("StockField: the stock box has no volume");
  if ((size.x() / cell + 1) * (size.y() / cell + 1) > 100e6)
    throw ParameterError("StockField: more than 100 million cells: choose larger ones");
  columns_ = std::max(1, static_cast<int>(std::ceil(size.x() / cell - 1e-9)));
  rows_ = std::max(1, static_cast<int>(std::ceil(size.y() / cell - 1e-9)));
  height_.assign(static_cast<std::size_t>(columns_) * rows_,
                 static_cast<float>(stock.max.z()));
  if (bound == Bound::Upper && height_.front() < stock.max.z()) // rounded down
    std::fill(height_.begin(),
              height_.end(),
              std::nextafter(height_.front(), std::numeric_limits<float>::infinity()));
  runs_ = (columns_ + kRun - 1) / kRun;
  top_.assign(static_cast<std::size_t>(runs_) * rows_, height_.front());
}

void StockField::lowerTo(const std::function<double(double, double)>& height)
{
  for (int row = 0; row < rows_; ++row) {
    float* line = &height_[static_cast<std::size_t>(row) * columns_];
    for (int column = 0; column < columns_; ++column) {
      const double z = height(x(column), y(row));
      float stored = static_cast<float>(z);
      if (bound_ == Bound::Upper && stored < z) // rounded down
        stored = std::nextafter(stored, std::numeric_limits<float>::infinity());
      line[column] = std::min(line[column], stored);
    }
    for (int run = 0; run < runs_; ++run)
      updateTop(row, run);
  }
}

int StockField::rowOf(double y) const
{
  const double row = std::floor((y - stock_.min.y()) / cell_);
  return static_cast<int>(std::clamp(row, 0.0, rows_ - 1.0));
}

StockField::Window StockField::under(double radius,
                                     const Eigen::Vector3d& low,
                                     const Eigen::Vector3d& high) const
{
  const auto index = [&](double v, double origin) {
    return static_cast<int>(
        std::clamp((v - origin) / cell_ - 0.5, -1e9, 1e9)); // towards zero: wide enough
  };
  return {std::max(0, index(low.x() - radius, stock_.min.x())),
          std::min(columns_ - 1, index(high.x() + radius, stock_.min.x()) + 1),
          std::max(0, index(low.y() - radius, stock_.min.y())),
          std::min(rows_ - 1, index(high.y() + radius, stock_.min.y()) + 1)};
}

namespace {

/// The box of a move in XY, seen from cells: how far these are at least from the axis.
class MoveBox {
public:
  MoveBox(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
      : left_(std::min(a.x(), b.x())), right_(std::max(a.x(), b.x())),
        near_(std::min(a.y(), b.y())), far_(std::max(a.y(), b.y()))
  {
  }
  double away2(double y) const { return square(std::max({0.0, near_ - y, y - far_})); }
  /// Of all places with x0 <= x <= x1, along X only.
  double aside2(double x0, double x1) const
  {
    return square(std::max({0.0, left_ - x1, x0 - right_}));
  }

private:
  static double square(double v) { return v * v; }
  double left_, right_, near_, far_;
};

} // namespace

/// Calls body(row, run, first column, last column) for all runs in which a move can
/// meet stock. No cell is met lower than `lowest`, the lowest place of the tip, and
/// floor(squared distance from the axis) above that.
template <typename Box, typename Floor, typename Body>
void StockField::forRuns(const Window& window,
                         const Box& box,
                         double lowest,
                         const Floor& floor,
                         const Body& body) const
{
  const int run0 = window.c0 / kRun, run1 = window.c1 / kRun;
  for (int row = window.r0; row <= window.r1 && window.c0 <= window.c1; ++row) {
    const float* tops = &top_[static_cast<std::size_t>(row) * runs_];
    const double away2 = box.away2(y(row));
    // Most rows of a finishing move are low already, all along.
    if (*std::max_element(tops + run0, tops + run1 + 1) <= lowest + floor(away2))
      continue;
    for (int run = run0; run <= run1; ++run) {
      if (tops[run] <= lowest)
        continue;
      const int first = run * kRun, last = std::min(columns_, first + kRun) - 1;
      if (tops[run] > lowest + floor(away2 + box.aside2(x(first), x(last))))
        body(row, run, std::max(window.c0, first), std::min(window.c1, last));
    }
  }
}

Cut StockField::cut(const Tool& tool,
                    const Eigen::Vector3d& a,
                    const Eigen::Vector3d& b,
                    int row0,
                    int row1,
                    std::vector<LoweredCell>* lowered)
{
  const CutterProfile cutter = tool.profile();
  const double r = tool.radius();
  Window window = under(r, a.cwiseMin(b), a.cwiseMax(b));
  window.r0 = std::max(row0, window.r0);
  window.r1 = std::min(row1 - 1, window.r1);
  const double guard = bound_ == Bound::Upper ? cell_ * std::sqrt(0.5) : 0.0;
  const double lowest = std::min(a.z(), b.z());
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), len2 = dx * dx + dy * dy;
  Cut taken;
  long begun = 0; // cells that count for the area
  const double per_length = len2 > 0 ? 1 / std::sqrt(len2) : 0.0;
  const auto countCell = [&](double before, double after, double cx, double cy) {
    taken.depth = std::max(taken.depth, before - after);
    taken.volume += (before - after) * cell_ * cell_;
    if (bound_ == Bound::Upper)
      return;
    // The cutter cut here before if its surface lay on the ground at the beginning.
    const double ax = cx - a.x(), ay = cy - a.y(), ad2 = ax * ax + ay * ay;
    if (ad2 <= r * r && a.z() + cutter.height(std::sqrt(ad2)) <= before + kStored)
      return;
    double all = before - after;
    if (ax * dx + ay * dy > 0) { // goes on to be cut
      const double off = std::abs(ax * dy - ay * dx) * per_length;
      all = std::max(all, before - b.z() - cutter.height(off));
    }
    begun += all > Cut::kSwarf;
    taken.axial = std::max(taken.axial, all);
  };
  const MoveBox box(a, b);
  const auto floor = [&](double away2) {
    const double away = std::sqrt(away2) - kRounding;
    return cutter.height(std::max(0.0, away)) - kRounding;
  };
  const auto cutCell = [&](float& cell, int column, int row, double cx, double cy) {
    if (cell <= lowest)
      return;
    double h;
    if (guard > 0) {
      // From the place nearest to the cell the whole cell is under the cutter, or it
      // is left as it stands; the outermost part of the cell counts for its height.
      double t = len2 > 0 ? ((cx - a.x()) * dx + (cy - a.y()) * dy) / len2
                          : double(b.z() < a.z());
      t = std::clamp(t, 0.0, 1.0);
      const double ex = a.x() + t * dx - cx, ey = a.y() + t * dy - cy;
      const double d = std::sqrt(ex * ex + ey * ey) + guard;
      if (d > r)
        return;
      h = a.z() + t * (b.z() - a.z()) + cutter.height(d);
    }
    else if (lowest + floor(box.away2(cy) + box.aside2(cx, cx)) >= cell)
      return;
    else
      h = sweptHeight(cutter, a, b, cx, cy);
    if (h < cell) {
      countCell(cell, h, cx, cy);
      if (lowered)
        lowered->push_back({column, row, cell - h});
      // float32 must not round an upper bound down
      float stored = static_cast<float>(h);
      if (guard > 0 && stored < h)
        stored = std::nextafter(stored, std::numeric_limits<float>::infinity());
      cell = stored;
    }
  };
  forRuns(window, box, lowest, floor, [&](int row, int run, int first, int last) {
    float* line = &height_[static_cast<std::size_t>(row) * columns_];
    for (int column = first; column <= last; ++column)
      cutCell(line[column], column, row, x(column), y(row));
    updateTop(row, run);
  });
  taken.area = static_cast<double>(begun) * cell_ * cell_;
  taken.axial = std::max(taken.axial, taken.depth);
  return taken;
}

Cut StockField::cut(const SweptCutter& cutter,
                    const Eigen::Vector3d& a,
                    const Eigen::Vector3d& b,
                    int row0,
                    int row1,
                    std::vector<LoweredCell>* lowered)
{
  if (bound_ == Bound::Upper)
    throw ParameterError("StockField: quick cuts are for nominal heights");
  Window window = under(cutter.radius(), a.cwiseMin(b), a.cwiseMax(b));
  window.r0 = std::max(row0, window.r0);
  window.r1 = std::min(row1 - 1, window.r1);
  const double lowest = std::min(a.z(), b.z());
  const MoveBox box(a, b);
  const auto floor = [&](double away2) { return cutter.floor(away2) - kRounding; };
  Cut taken;
  double sum = 0;
  forRuns(window, box, lowest, floor, [&](int row, int run, int first, int last) {
    float* line = &height_[static_cast<std::size_t>(row) * columns_];
    const double cy = y(row), away2 = box.away2(cy);
    bool changed = false;
    for (int column = first; column <= last; ++column) {
      float& cell = line[column];
      const double cx = x(column);
      if (cell <= lowest + floor(away2 + box.aside2(cx, cx)))
        continue;
      const double h = sweptHeight(cutter.profile(), a, b, cx, cy);
      if (!(h < cell))
        continue;
      const double depth = cell - h;
      taken.depth = std::max(taken.depth, depth);
      sum += depth;
      if (lowered)
        lowered->push_back({column, row, depth});
      cell = static_cast<float>(h);
      changed = true;
    }
    if (changed)
      updateTop(row, run);
  });
  taken.volume = sum * cell_ * cell_;
  return taken;
}

double StockField::depthAlong(const SweptCutter& cutter,
                              const Eigen::Vector3d& a,
                              const Eigen::Vector3d& b,
                              int row0,
                              int row1) const
{
  Window window = under(cutter.radius(), a.cwiseMin(b), a.cwiseMax(b));
  window.r0 = std::max(row0, window.r0);
  window.r1 = std::min(row1 - 1, window.r1);
  double deepest = 0;
  const auto floor = [&](double away2) { return cutter.floor(away2) - kRounding; };
  forRuns(window,
          MoveBox(a, b),
          std::min(a.z(), b.z()),
          floor,
          [&](int row, int, int first, int last) {
            for (int column = first; column <= last; ++column)
              deepest =
                  std::max(deepest,
                           height(column, row) -
                               sweptHeight(cutter.profile(), a, b, x(column), y(row)));
          });
  return deepest;
}

double StockField::highestIn(int row0, int row1) const
{
  const auto begin = top_.begin() + static_cast<std::ptrdiff_t>(row0) * runs_;
  return *std::max_element(begin,
                           begin + static_cast<std::ptrdiff_t>(row1 - row0) * runs_);
}

void StockField::updateTop(int row, int run)
{
  const float* line = &height_[static_cast<std::size_t>(row) * columns_];
  top_[static_cast<std::size_t>(row) * runs_ + run] =
      *std::max_element(line + run * kRun, line + std::min(columns_, (run + 1) * kRun));
}

Cut StockField::probe(const Tool& tool, const std::vector<Eigen::Vector3d>& way) const
{
  Cut taken;
  if (way.size() < 2)
    return taken;
  const CutterProfile cutter = tool.profile();
  Eigen::Vector3d low = way.front(), high = low;
  for (const auto& p : way) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Window window = under(tool.radius(), low, high);
  const auto probeCell = [&](double cell, double cx, double cy) {
    double h = cell;
    for (std::size_t i = 1; cell > low.z() && i < way.size(); ++i)
      h = std::min(h, sweptHeight(cutter, way[i - 1], way[i], cx, cy));
    taken.depth = std::max(taken.depth, cell - h);
    taken.volume += (cell - h) * cell_ * cell_;
  };
  for (int row = window.r0; row <= window.r1; ++row)
    for (int run = window.c0 / kRun; run * kRun <= window.c1; ++run) {
      if (top_[static_cast<std::size_t>(row) * runs_ + run] <= low.z())
        continue;
      const int last = std::min(window.c1, run * kRun + kRun - 1);
      for (int column = std::max(window.c0, run * kRun); column <= last; ++column)
        probeCell(height(column, row), x(column), y(row));
    }
  return taken;
}

double StockField::depthIn(const Tool& tool,
                           const Eigen::Vector3d& low,
                           const Eigen::Vector3d& high,
                           int row0,
                           int row1) const
{
  const CutterProfile cutter = tool.profile();
  const double r = cutter.radius();
  const auto cellAt = [&](double v, double origin, int count) {
    return static_cast<int>(std::clamp((v - origin) / cell_, 0.0, count - 1.0));
  };
  const int c0 = cellAt(low.x() - r, stock_.min.x(), columns_);
  const int c1 = cellAt(high.x() + r, stock_.min.x(), columns_);
  const int r0 = std::max(row0, cellAt(low.y() - r, stock_.min.y(), rows_));
  const int r1 = std::min(row1 - 1, cellAt(high.y() + r, stock_.min.y(), rows_));
  double deepest = 0;
  for (int row = r0; row <= r1; ++row) {
    const double oy = std::max({0.0, low.y() - y(row), y(row) - high.y()});
    for (int run = c0 / kRun; run * kRun <= c1; ++run) {
      if (top_[static_cast<std::size_t>(row) * runs_ + run] - low.z() <= deepest)
        continue;
      const int first = std::max(c0, run * kRun);
      const int last = std::min(c1, run * kRun + kRun - 1);
      for (int column = first; column <= last; ++column) {
        const double ox = std::max({0.0, low.x() - x(column), x(column) - high.x()});
        const double d2 = ox * ox + oy * oy;
        if (d2 <= r * r)
          deepest = std::max(
              deepest, height(column, row) - low.z() - cutter.height(std::sqrt(d2)));
      }
    }
  }
  return deepest;
}

double
StockField::highest(double ax, double ay, double bx, double by, double radius) const
{
  double best = -std::numeric_limits<double>::infinity();
  const double reach = radius + cell_ * std::sqrt(0.5);
  const auto low = [&](double v, double origin) {
    return static_cast<int>(
        std::clamp(std::floor((v - reach - origin) / cell_), -1e9, 1e9));
  };
  const auto high = [&](double v, double origin) {
    return static_cast<int>(
        std::clamp(std::floor((v + reach - origin) / cell_), -1e9, 1e9));
  };
  const int c0 = std::max(0, low(std::min(ax, bx), stock_.min.x()));
  const int c1 = std::min(columns_ - 1, high(std::max(ax, bx), stock_.min.x()));
  const int r0 = std::max(0, low(std::min(ay, by), stock_.min.y()));
  const int r1 = std::min(rows_ - 1, high(std::max(ay, by), stock_.min.y()));
  for (int row = r0; row <= r1; ++row)
    for (int run = c0 / kRun; run * kRun <= c1; ++run) {
      if (top_[static_cast<std::size_t>(row) * runs_ + run] <= best)
        continue;
      const int first = std::max(c0, run * kRun);
      const int last = std::min(c1, run * kRun + kRun - 1);
      for (int column = first; column <= last; ++column) {
        const double h = height(column, row);
        if (h > best &&
            segmentDistance2(ax, ay, bx, by, x(column), y(row)) <= reach * reach)
          best = h;
      }
    }
  return best;
}

CellCloud StockField::toCloud() const
{
  CellCloud cloud;
  cloud.resize(height_.size());
  cloud.width = static_cast<std::uint32_t>(columns_);
  cloud.height = static_cast<std::uint32_t>(rows_);
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      auto& cell = cloud.at(column, row);
      cell.x = static_cast<float>(x(column));
      cell.y = static_cast<float>(y(row));
      cell.z = static_cast<float>(height(column, row));
      cell.setState(CellState::Occupied);
    }
  return cloud;
}

} // namespace pointmill
