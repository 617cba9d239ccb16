// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/align/rectangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pointmill {
namespace align {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double degree = pi / 180.0;
constexpr double box_tolerance = 1e-4;    // of the area
constexpr double square_tolerance = 0.01; // of the shorter side

// Twice the area of the triangle a b c, positive when it turns left.
double
turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Drops most points that are no corners of the hull: those that lie well inside the
// octagon of the outermost points in eight directions (Akl and Toussaint, 1978).
void dropInner(std::vector<Eigen::Vector2d>& points)
{
  const Eigen::Vector2d directions[] = {
      {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  std::array<Eigen::Vector2d, 8> corners; // counter-clockwise
  corners.fill(points.front());
  for (const auto& p : points)
    for (int k = 0; k < 8; ++k)
      if (p.dot(directions[k]) > corners[k].dot(directions[k]))
        corners[k] = p;
  const Eigen::Vector2d size(corners[0].x() - corners[4].x(),
                             corners[2].y() - corners[6].y());
  const double well = 1e-9 * size.squaredNorm(); // more than rounding
  if (!(well > 0))
    return;
  points.erase(std::remove_if(points.begin(),
                              points.end(),
                              [&](const Eigen::Vector2d& p) {
                                for (int k = 0; k < 8; ++k) {
                                  const auto& a = corners[k];
                                  const auto& b = corners[(k + 1) % 8];
                                  if (a != b && turn(a, b, p) <= well)
                                    return false;
                                }
                                return true;
                              }),
               points.end());
}

} // namespace

Polygon convexHull(std::vector<Eigen::Vector2d> points)
{
  if (points.size() > 1000)
    dropInner(points);
  // Andrew's monotone chain.
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3)
    return points;
  Polygon hull;
  const auto add = [&hull](const Eigen::Vector2d& p, std::size_t first) {
    while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0)
      hull.pop_back();
    hull.push_back(p);
  };
  for (const auto& p : points)
    add(p, 0);
  const std::size_t upper = hull.size() - 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p)
    add(*p, upper);
  hull.pop_back();
  return hull;
}

Rectangle boxAt(const Polygon& hull, double angle)
{
  const Eigen::Vector2d u(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d v(-u.y(), u.x());
  constexpr double far = std::numeric_limits<double>::max();
  Eigen::Vector2d low(far, far), high(-far, -far);
  for (const auto& p : hull) {
    const Eigen::Vector2d q(p.dot(u), p.dot(v));
    low = low.cwiseMin(q);
    high = high.cwiseMax(q);
  }
  Rectangle box{angle, high.x() - low.x(), high.y() - low.y()};
  if (box.length < box.width) {
    std::swap(box.length, box.width);
    box.angle += pi / 2;
  }
  box.angle = std::remainder(box.angle, pi);
  if (box.angle <= -pi / 2)
    box.angle += pi;
  return box;
}

Rectangle minimumRectangle(const Polygon& hull)
{
  const std::size_t n = hull.size();
  if (n < 2)
    return {};
  if (n == 2) {
    const Eigen::Vector2d d = hull[1] - hull[0];
    Rectangle line = boxAt(hull, std::atan2(d.y(), d.x()));
    line.width = 0.0;
    return line;
  }
  double best = std::numeric_limits<double>::max(), angle = 0.0;
  // Corners that touch the right, the far and the left side of the rectangle whose near
  // side is edge i. They only ever move on, so that all edges together cost O(n).
  std::size_t right = 1, far = 1, left = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d u = (hull[(i + 1) % n] - hull[i]).normalized();
    const Eigen::Vector2d v(-u.y(), u.x());
    const auto moveOn = [&](std::size_t& corner, const Eigen::Vector2d& towards) {
      while (hull[(corner + 1) % n].dot(towards) > hull[corner % n].dot(towards))
        ++corner;
    };
    right = std::max(right, i + 1);
    moveOn(right, u);
    far = std::max(far, right);
    moveOn(far, v);
    left = std::max(left, far);
    moveOn(left, -u);
    const double area =
        (hull[right % n] - hull[left % n]).dot(u) * (hull[far % n] - hull[i]).dot(v);
    if (area < best) {
      best = area;
      angle = std::atan2(u.y(), u.x());
    }
  }
  return boxAt(hull, angle);
}

double squaringAngle(const Polygon& hull)
{
  Rectangle rectangle = minimumRectangle(hull);
  const Rectangle present = boxAt(hull, 0.0);
  // The second term is for parts that are no wider than their rounding errors.
  const double noise = box_tolerance * rectangle.length * rectangle.width +
                       1e-6 * rectangle.length * rectangle.length;
  if (present.length * present.width <= rectangle.length * rectangle.width + noise)
    rectangle = present;
  if (rectangle.length <= (1.0 + square_tolerance) * rectangle.width)
    return std::remainder(-rectangle.angle, pi / 2);
  // A long side along Y turns by +90 degrees, and so does one that is there but for
  // noise.
  const double angle = -rectangle.angle;
  return angle <= -89.0 * degree ? angle + pi : angle;
}

} // namespace align
} // namespace pointmill
