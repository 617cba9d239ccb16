// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "void_climb.h"

#include <pointmill/common/error.h>
#include <pointmill/common/parallel.h>
#include <pointmill/slice/distance_field.h>
#include <pointmill/slice/spacing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace pointmill {
namespace {

// Voids of a square grid of edge 1: that of half of the places, and of 99 %.
constexpr double kMedianVoid = 0.39894, kP99Void = 0.65776;
constexpr double kWorthIt = 0.9; // of the largest void, to look for a larger one
constexpr std::size_t kPlaces = 200'000, kLookouts = 1000;
constexpr double kReachPerView = 1.5;
constexpr double kMostViews = 100; // mean spacings that are looked across
constexpr int kBucketsPerCell = 6; // along an edge, by default
constexpr double kRim = 1.5;       // buckets; half one's diagonal, and as much of doubt
constexpr double kFewBuckets = 1e6, kBucketsPerPoint = 4, kMostCells = 200e6;

double uniform(std::mt19937& random)
{
  return random() / 4294967296.0;
}

/// Distance at which the points about `from` have filled all eighths of the circle.
double viewAllRound(const PointBuckets& buckets, const Eigen::Vector3f& from)
{
  const double most = kMostViews * buckets.grid().cell;
  std::array<double, 9> nearest; // three by three, as on a compass
  nearest.fill(most * most);
  nearest[4] = 0; // the point itself
  const auto farthest = [&] {
    return *std::max_element(nearest.begin(), nearest.end());
  };
  // -1, 0 or 1: the part of a vector is 0 within 22.5 degrees of the other axis.
  const double eighth = std::sqrt(2.0) - 1;
  const auto side = [&](double part, double other) {
    return std::abs(part) <= eighth * std::abs(other) ? 0 : part < 0 ? -1 : 1;
  };
  buckets.walk(
      from.x(),
      from.y(),
      [&](double reached) { return reached * reached < farthest(); },
      [&](const Eigen::Vector3f& p, std::uint32_t) {
        const double dx = p.x() - from.x(), dy = p.y() - from.y();
        double& d =
            nearest[static_cast<std::size_t>(4 + side(dx, dy) + 3 * side(dy, dx))];
        d = std::min(d, dx * dx + dy * dy);
      });
  return std::sqrt(farthest());
}

double typicalReach(const PointBuckets& buckets, std::mt19937& random)
{
  std::vector<Eigen::Vector3f> lookouts(kLookouts);
  for (auto& from : lookouts)
    from = buckets.points()[random() % buckets.points().size()];
  std::vector<double> views(kLookouts);
  parallelFor(kLookouts, 0, [&](std::size_t i) {
    views[i] = viewAllRound(buckets, lookouts[i]);
  });
  std::nth_element(views.begin(), views.begin() + kLookouts / 2, views.end());
  return kReachPerView * views[kLookouts / 2];
}

/// 1 for the buckets that are covered: nowhere within reach of a place that has no
/// point within reach. Those on the outline, partly covered, are not.
std::vector<unsigned char> coveredBuckets(const PointBuckets& buckets, double reach)
{
  const CellGrid& grid = buckets.grid();
  const double margin = std::ceil(reach / grid.cell) + 2;
  if ((grid.columns + 2 * margin) * (grid.rows + 2 * margin) > kMostCells)
    throw ParameterError("mapSpacing: the reach is too far for that many points");
  const int pad = static_cast<int>(margin);
  CellGrid wide = grid;
  wide.x0 -= pad * grid.cell;
  wide.y0 -= pad * grid.cell;
  wide.columns += 2 * pad;
  wide.rows += 2 * pad;
  const auto forRows = [&](auto&& work) {
    parallelFor(static_cast<std::size_t>(wide.rows), 0, [&](std::size_t r) {
      for (int column = 0; column < wide.columns; ++column)
        work(column, static_cast<int>(r), wide.index(column, static_cast<int>(r)));
    });
  };
  std::vector<unsigned char> held(wide.size()), lonely(wide.size());
  forRows([&](int column, int row, std::size_t at) {
    held[at] = buckets.count(row - pad, column - pad, column - pad) > 0;
  });
  // Somewhere in its bucket a point is up to half the diagonal nearer or farther.
  const auto to_held = distanceField(held, wide.columns, wide.rows);
  const double doubt = std::sqrt(0.5) * grid.cell;
  forRows([&](int column, int row, std::size_t at) {
    const double about = to_held[at] * grid.cell;
    lonely[at] = about > reach + doubt ||
                 (about >= reach - doubt &&
                  std::isinf(buckets.distance(wide.x(column), wide.y(row), reach)));
  });
  const auto to_lonely = distanceField(lonely, wide.columns, wide.rows);
  std::vector<unsigned char> covered(grid.size());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      covered[grid.index(column, row)] =
          to_lonely[wide.index(column + pad, row + pad)] > reach / grid.cell + kRim;
  return covered;
}

/// The voids at 4 x 4 places in a bucket.
class BucketVoids {
public:
  BucketVoids(const PointBuckets& buckets, double most) : buckets_(buckets), most_(most)
  {
    const auto step = static_cast<float>(buckets.grid().cell / kAlong);
    for (int i = 0; i < kAlong * kAlong; ++i) {
      x_[i] = (static_cast<float>(i % kAlong) - 0.5f * (kAlong - 1)) * step;
      y_[i] = (static_cast<float>(i / kAlong) - 0.5f * (kAlong - 1)) * step;
    }
  }

  /// Adds those of a radius of `least` or more.
  void addTo(std::vector<Void>& voids, int column, int row, double least) const
  {
    const CellGrid& grid = buckets_.grid();
    const double x = grid.x(column), y = grid.y(row);
    Places squared = Places::Constant(std::numeric_limits<float>::infinity());
    buckets_.visitBlock(column, row, [&](const Eigen::Vector3f& p) {
      const auto px = static_cast<float>(p.x() - x), py = static_cast<float>(p.y() - y);
      squared = squared.min((x_ - px).square() + (y_ - py).square());
    });
    if (squared.maxCoeff() < least * least)
      return;
    if (std::isinf(squared[0])) { // a void so large that one place will do
      voids.push_back({{x, y}, std::min(most_, buckets_.distance(x, y, most_))});
      return;
    }
    for (int i = 0; i < kAlong * kAlong; ++i) {
      if (squared[i] < least * least)
        continue;
      Void v{{x + x_[i], y + y_[i]}, std::sqrt(static_cast<double>(squared[i]))};
      if (v.radius > grid.cell) // farther than the block of buckets surely reaches
        v.radius = std::min(most_, buckets_.distance(v.at.x(), v.at.y(), most_));
      voids.push_back(v);
    }
  }

private:
  static constexpr int kAlong = 4;
  using Places = Eigen::Array<float, kAlong * kAlong, 1>;

  const PointBuckets& buckets_;
  double most_;
  Places x_, y_; // from the bucket's middle
};

/// The largest voids in the cells of `side` x `side` buckets each: those that grow from
/// the cell's emptiest places.
class VoidSearch {
public:
  VoidSearch(const PointBuckets& buckets,
             const std::vector<unsigned char>& covered,
             int side,
             double reach)
      : buckets_(buckets), covered_(covered), side_(side),
        in_bucket_(buckets, reach + buckets.grid().cell)
  {
  }

  /// The largest in a cell; of radius 0 where none of it is covered.
  Void operator()(int column, int row) const
  {
    const CellGrid& grid = buckets_.grid();
    std::vector<Void> places;
    double emptiest = 0;
    for (int r = row * side_; r < (row + 1) * side_; ++r)
      for (int c = column * side_; c < (column + 1) * side_; ++c) {
        if (!covered_[grid.index(c, r)])
          continue;
        const std::size_t before = places.size();
        in_bucket_.addTo(places, c, r, kWorthIt * emptiest);
        for (std::size_t i = before; i < places.size(); ++i)
          emptiest = std::max(emptiest, places[i].radius);
      }
    std::sort(places.begin(), places.end(), [](const Void& a, const Void& b) {
      return a.radius > b.radius;
    });
    return growLargest(places);
  }

private:
  Void growLargest(std::vector<Void>& places) const
  {
    Void largest;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Void& place = places[k];
      if (place.radius < kWorthIt * largest.radius)
        break;
      const Void grown =
          climbVoid(buckets_, place.at, [&](const auto& at) { return isCovered(at); });
      if (grown.radius > largest.radius)
        largest = grown;
      // What lies in this void would most likely grow into it again.
      places.erase(std::remove_if(places.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                                  places.end(),
                                  [&](const Void& v) {
                                    return (v.at - grown.at).norm() < grown.radius;
                                  }),
                   places.end());
    }
    return largest;
  }

  bool isCovered(const Eigen::Vector2d& at) const
  {
    const CellGrid& grid = buckets_.grid();
    const int c = grid.columnOf(at.x()), r = grid.rowOf(at.y());
    return grid.has(c, r) && covered_[grid.index(c, r)];
  }

  const PointBuckets& buckets_;
  const std::vector<unsigned char>& covered_;
  int side_;
  BucketVoids in_bucket_;
};

/// Voids at random places of what is covered, ascending; one place in each of equal
/// parts of the grid, so that they are spread evenly.
std::vector<double> sampledVoids(const PointBuckets& buckets,
                                 const std::vector<unsigned char>& covered,
                                 double reach,
                                 std::mt19937& random)
{
  const CellGrid& grid = buckets.grid();
  std::vector<Eigen::Vector2d> places;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    const double at = (static_cast<double>(i) + uniform(random)) / kPlaces;
    const auto bucket = static_cast<std::size_t>(at * static_cast<double>(grid.size()));
    const double u = uniform(random), v = uniform(random);
    if (covered[bucket])
      places.emplace_back(
          grid.x0 + (static_cast<double>(bucket % grid.columns) + u) * grid.cell,
          grid.y0 + (static_cast<double>(bucket / grid.columns) + v) * grid.cell);
  }
  std::vector<double> voids(places.size());
  parallelFor(places.size(), 0, [&](std::size_t i) {
    const double most = reach + grid.cell;
    voids[i] = std::min(most, buckets.distance(places[i].x(), places[i].y(), most));
  });
  std::sort(voids.begin(), voids.end());
  return voids;
}

/// The grid of the buckets, `side` of which go along an edge of a cell: as large as
/// the points want them, but not too many.
CellGrid bucketGrid(const CellGrid& cells, double edge, std::size_t points, int& side)
{
  const double most = std::max(kFewBuckets, kBucketsPerPoint * double(points));
  const double most_along = std::sqrt(most / static_cast<double>(cells.size()));
  side = static_cast<int>(
      std::max(1.0, std::min(std::ceil(cells.cell / edge), std::floor(most_along))));
  CellGrid grid = cells;
  grid.cell /= side;
  grid.columns *= side;
  grid.rows *= side;
  return grid;
}

} // namespace

SpacingField mapSpacing(std::vector<Eigen::Vector3f> points,
                        double cell,
                        double reach,
                        std::uint32_t seed)
{
  if (points.empty())
    throw DataError("the spacing of no points was asked for");
  if (!(reach >= 0))
    throw ParameterError("mapSpacing: the reach must not be below 0");
  const PlanBox box(points);
  const double edge = PointBuckets::naturalGrid(points).cell;
  SpacingField field;
  field.grid =
      CellGrid::covering(box.low, box.high, cell == 0 ? kBucketsPerCell * edge : cell);
  int side = 1;
  const CellGrid grid = bucketGrid(field.grid, edge, points.size(), side);
  const PointBuckets buckets(std::move(points), grid);

  std::mt19937 random(seed);
  Spacing& figures = field.figures;
  figures.reach = reach > 0 ? reach : typicalReach(buckets, random);
  const auto covered = coveredBuckets(buckets, figures.reach);
  const auto sampled = sampledVoids(buckets, covered, figures.reach, random);
  if (sampled.empty())
    throw DataError("the points cover no area: they lie on a line, or farther apart "
                    "than the reach");
  figures.median = sampled[sampled.size() / 2] / kMedianVoid;

  const VoidSearch largestVoid(buckets, covered, side, figures.reach);
  std::vector<Void> voids(field.grid.size());
  parallelFor(static_cast<std::size_t>(field.grid.rows), 0, [&](std::size_t row) {
    for (int column = 0; column < field.grid.columns; ++column)
      voids[field.grid.index(column, static_cast<int>(row))] =
          largestVoid(column, static_cast<int>(row));
  });
  field.spacing.resize(voids.size());
  field.count.resize(voids.size());
  for (std::size_t at = 0; at < voids.size(); ++at) {
    const double spacing = std::sqrt(2.0) * voids[at].radius;
    field.spacing[at] = voids[at].radius > 0 ? static_cast<float>(spacing)
                                             : std::numeric_limits<float>::quiet_NaN();
    if (voids[at].radius > 0 && spacing > figures.worst) {
      figures.worst = spacing;
      figures.worst_at = voids[at].at;
    }
    const int first = static_cast<int>(at % field.grid.columns) * side;
    const int row = static_cast<int>(at / field.grid.columns) * side;
    for (int r = row; r < row + side; ++r)
      field.count[at] +=
          static_cast<std::uint32_t>(buckets.count(r, first, first + side - 1));
  }
  // Among lines of points more places are far from any than among those of a grid.
  figures.p99 = std::min(figures.worst, sampled[sampled.size() * 99 / 100] / kP99Void);
  return field;
}

Spacing measureSpacing(const pcl::PointCloud<pcl::PointXYZ>& cloud, std::uint32_t seed)
{
  std::vector<Eigen::Vector3f> points;
  points.reserve(cloud.size());
  for (const auto& p : cloud)
    if (p.getVector3fMap().allFinite())
      points.push_back(p.getVector3fMap());
  return mapSpacing(std::move(points), 0, 0, seed).figures;
}

} // namespace pointmill
