// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "sample_faces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

// The samples are the points of a square grid, cast onto the faces along the axis that
// a face looks at most. The grid belongs to the axis, not to the face: it runs on from
// triangle to triangle, so that the slivers of a CAD mesh get what a whole plane would.
// Where a face is inclined, the grid's image is stretched; then a share of the centres
// of its cells joins, just as large as the area has grown.
namespace pointmill::detail {

namespace {

Eigen::Vector3d crossOf(const std::vector<Eigen::Vector3d>& points,
                        const Triangle& face)
{
  const Eigen::Vector3d& a = points[face[0]];
  return (points[face[1]] - a).cross(points[face[2]] - a);
}

// Well-mixed bits (SplitMix64).
std::uint64_t mix(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// In [0, 1).
double unit(std::uint64_t x)
{
  return static_cast<double>(x >> 11) * 0x1p-53;
}

// Evenly spread over the grid for every share of its points: the R2 sequence of Roberts
// in two indices, in fixed point.
double rank(std::int64_t i, std::int64_t j)
{
  return unit(static_cast<std::uint64_t>(i) * 0xc13fa9a902a6328fu +
              static_cast<std::uint64_t>(j) * 0x91e10da5c79e7b1du);
}

// Where the edge from p to q crosses the height y; the same for q to p, so that a
// grid point on a common edge belongs to one face only.
double crossing(Eigen::Vector2d p, Eigen::Vector2d q, double y)
{
  if (std::make_pair(q.y(), q.x()) < std::make_pair(p.y(), p.x()))
    std::swap(p, q);
  return p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
}

// Calls visit(i, j) for each point with whole coordinates in the triangle.
template <typename Visit>
void eachGridPoint(const std::array<Eigen::Vector2d, 3>& corner, Visit visit)
{
  const auto [low, high] = std::minmax({corner[0].y(), corner[1].y(), corner[2].y()});
  for (auto j = static_cast<std::int64_t>(std::ceil(low)); double(j) < high; ++j) {
    const auto y = static_cast<double>(j);
    double ends[2] = {0, 0};
    int count = 0;
    for (int k = 0; k < 3 && count < 2; ++k) {
      const Eigen::Vector2d &p = corner[k], &q = corner[(k + 1) % 3];
      if ((p.y() <= y) != (q.y() <= y))
        ends[count++] = crossing(p, q, y);
    }
    const auto [left, right] = std::minmax(ends[0], ends[1]);
    for (auto i = static_cast<std::int64_t>(std::ceil(left)); double(i) < right; ++i)
      visit(i, j);
  }
}

} // namespace

double areaOf(const std::vector<Eigen::Vector3d>& points,
              const std::vector<Triangle>& faces)
{
  double area = 0;
  for (const Triangle& face : faces)
    area += crossOf(points, face).norm() / 2;
  return area;
}

std::vector<Eigen::Vector3d> sampleFaces(const std::vector<Eigen::Vector3d>& points,
                                         const std::vector<Triangle>& faces,
                                         double density,
                                         std::uint32_t seed)
{
  // Turned by the golden slope: no row of the grid runs along an edge that is parallel
  // to an axis or a diagonal, and narrow faces are met at even distances.
  const double angle = std::atan((std::sqrt(5.0) - 1) / 2);
  const Eigen::Matrix2d turn =
      std::sqrt(density) * Eigen::Rotation2Dd(angle).toRotationMatrix();
  std::vector<Eigen::Vector3d> samples;
  for (const Triangle& face : faces) {
    const Eigen::Vector3d cross = crossOf(points, face);
    // Z before Y before X where they are about equal: on a 45 degree chamfer rounding
    // must not turn one triangle to another grid than the next.
    int axis = 0;
    (cross.cwiseAbs().array() * Eigen::Array3d(0.98, 0.99, 1.0)).maxCoeff(&axis);
    if (!(std::abs(cross[axis]) > 0.0))
      continue;
    const double stretch = cross.norm() / std::abs(cross[axis]); // 1 .. 1.76
    const std::uint64_t random = mix(std::uint64_t(seed) * 3 + axis);
    const Eigen::Vector2d origin(unit(random), unit(mix(random)));
    std::array<Eigen::Vector2d, 3> corner;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d& p = points[face[k]];
      corner[k] = turn * Eigen::Vector2d(p[(axis + 1) % 3], p[(axis + 2) % 3]) + origin;
    }
    const Eigen::Vector3d& a = points[face[0]];
    Eigen::Matrix2d edges;
    edges << corner[1] - corner[0], corner[2] - corner[0];
    const Eigen::Matrix2d inverse = edges.inverse();
    const auto place = [&](const Eigen::Vector2d& from_a) {
      const Eigen::Vector2d uv = inverse * from_a;
      // Rounding must not carry a sample of a sliver off it.
      const double u = std::clamp(uv.x(), 0.0, 1.0);
      const double v = std::clamp(uv.y(), 0.0, 1.0 - u);
      samples.push_back(a + u * (points[face[1]] - a) + v * (points[face[2]] - a));
    };
    eachGridPoint(corner, [&](std::int64_t i, std::int64_t j) {
      place(Eigen::Vector2d(double(i), double(j)) - corner[0]);
    });
    const double share = stretch - 1;
    if (share <= 0.0)
      continue;
    for (auto& c : corner)
      c.array() -= 0.5;
    eachGridPoint(corner, [&](std::int64_t i, std::int64_t j) {
      if (rank(i, j) < share)
        place(Eigen::Vector2d(double(i), double(j)) - corner[0]);
    });
  }
  return samples;
}

} // namespace pointmill::detail
