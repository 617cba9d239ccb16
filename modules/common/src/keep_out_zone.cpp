// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/common/keep_out_zone.h>
#include <pointmill/common/maximum.h>

#include <limits>
#include <locale>
#include <sstream>

namespace pointmill {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Parts of an outline that come so near to each other meet [mm].
constexpr double kTouch = 1e-9;

double cross(const Vector2d& u, const Vector2d& v)
{
  return u.x() * v.y() - u.y() * v.x();
}

double toSegment(const Vector2d& p, const Vector2d& c, const Vector2d& d)
{
  const Vector2d along = d - c;
  const double squared = along.squaredNorm();
  const double t =
      squared > 0 ? std::clamp((p - c).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (c + t * along - p).norm();
}

/// Whether the segments a b and c d cross; where they only touch, or lie in one line,
/// the distances of their ends tell.
bool crosses(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d)
{
  const double ca = cross(d - c, a - c), cb = cross(d - c, b - c);
  const double ac = cross(b - a, c - a), ad = cross(b - a, d - a);
  return ca * cb < 0 && ac * ad < 0;
}

double
between(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d)
{
  if (crosses(a, b, c, d))
    return 0;
  return std::min(
      {toSegment(a, c, d), toSegment(b, c, d), toSegment(c, a, b), toSegment(d, a, b)});
}

/// From one box to another.
double toBox(const Vector2d& low,
             const Vector2d& high,
             const Vector2d& first,
             const Vector2d& last)
{
  return (first - high).cwiseMax(low - last).cwiseMax(0.0).norm();
}

} // namespace

KeepOutZone::KeepOutZone(std::vector<Vector2d> corners, double radius, double top)
    : corners_(std::move(corners)), radius_(radius), top_(top),
      min_(Vector2d::Constant(kInfinity)), max_(Vector2d::Constant(-kInfinity))
{
  for (const auto& c : corners_) {
    min_ = min_.cwiseMin(c - Vector2d::Constant(radius_));
    max_ = max_.cwiseMax(c + Vector2d::Constant(radius_));
  }
}

KeepOutZone KeepOutZone::box(double x0, double y0, double x1, double y1, double top)
{
  return KeepOutZone({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, 0.0, top);
}

KeepOutZone KeepOutZone::cylinder(double x, double y, double radius, double top)
{
  return KeepOutZone({{x, y}}, radius, top);
}

template <typename F>
void KeepOutZone::forEachEdge(F&& f) const
{
  for (std::size_t i = 0, last = corners_.size() - 1; i < corners_.size(); last = i++)
    f(corners_[last], corners_[i]);
}

void KeepOutZone::validate() const
{
  const auto refuse = [&](const std::string& why) {
    throw ParameterError("keep-out zone, " + describe() + ": " + why);
  };
  bool finite = std::isfinite(top_) && std::isfinite(radius_);
  for (const auto& c : corners_)
    finite &= c.allFinite();
  if (!finite)
    refuse("all its numbers must be finite");
  if (isDisc() && radius_ > 0)
    return;
  if (isDisc())
    refuse("its radius must be greater than 0");
  if (corners_.size() < 3)
    refuse("a polygon has three corners or more");
  const std::size_t n = corners_.size();
  const auto corner = [&](std::size_t i) { return corners_[i % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d along = corner(i + 1) - corner(i),
                   next = corner(i + 2) - corner(i + 1);
    if (along.squaredNorm() == 0)
      refuse("two corners that follow each other are the same");
    if (cross(along, next) == 0 && along.dot(next) < 0)
      refuse("its outline goes back on itself");
    // All edges but this one and its neighbours.
    for (std::size_t k = i + 2; k < std::min(n, i + n - 1); ++k)
      if (between(corner(i), corner(i + 1), corner(k), corner(k + 1)) < kTouch)
        refuse("its outline meets itself");
  }
}

// Crossings of the ray towards +x, by the even-odd rule.
bool KeepOutZone::holds(double x, double y) const
{
  bool inside = false;
  forEachEdge([&](const Vector2d& c, const Vector2d& d) {
    if ((c.y() > y) != (d.y() > y) &&
        x < c.x() + (y - c.y()) / (d.y() - c.y()) * (d.x() - c.x()))
      inside = !inside;
  });
  return inside;
}

double KeepOutZone::distance(double x, double y) const
{
  const Vector2d p(x, y);
  if (holds(x, y))
    return 0;
  double nearest = kInfinity;
  forEachEdge([&](const Vector2d& c, const Vector2d& d) {
    nearest = std::min(nearest, toSegment(p, c, d));
  });
  return std::max(0.0, nearest - radius_);
}

double KeepOutZone::distanceAlong(double ax, double ay, double bx, double by) const
{
  const Vector2d a(ax, ay), b(bx, by);
  if (holds(ax, ay))
    return 0;
  double nearest = kInfinity;
  forEachEdge([&](const Vector2d& c, const Vector2d& d) {
    nearest = std::min(nearest, between(a, b, c, d));
  });
  return std::max(0.0, nearest - radius_);
}

double KeepOutZone::distanceOver(const Vector2d& low, const Vector2d& high) const
{
  const Vector2d corners[] = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  if (holds(low.x(), low.y()))
    return 0;
  double nearest = kInfinity;
  forEachEdge([&](const Vector2d& c, const Vector2d& d) {
    nearest = std::min(nearest, toBox(low, high, c, c));
    for (int k = 0; k < 4; ++k)
      nearest = std::min(nearest, between(corners[k], corners[(k + 1) % 4], c, d));
  });
  return std::max(0.0, nearest - radius_);
}

double KeepOutZone::depth(const CutterProfile& cutter,
                          const Vector3d& a,
                          const Vector3d& b,
                          double margin) const
{
  const double top = top_ + margin, grown = radius_ + margin;
  const double lowest = std::min(a.z(), b.z());
  if (lowest >= top)
    return lowest > top ? top - lowest : 0.0;
  const Vector2d from = a.head<2>(), along = (b - a).head<2>();
  // Nearly all moves are told to be clear by the boxes.
  const double off =
      toBox(min_, max_, from.cwiseMin(b.head<2>()), from.cwiseMax(b.head<2>())) -
      margin;
  if (off > cutter.radius())
    return cutter.radius() - off;
  const double rise = b.z() - a.z();
  // Of all of a zone's points at a distance, the highest is deepest inside.
  const auto depthAt = [&](double distance, double tip) {
    return cutter.depth(std::max(0.0, distance - grown), top - tip);
  };
  // Over the zone itself a move gets deepest where it crosses an edge, or at its ends.
  double deepest = -kInfinity;
  if (holds(a.x(), a.y()))
    deepest = std::max(deepest, depthAt(0.0, a.z()));
  if (holds(b.x(), b.y()))
    deepest = std::max(deepest, depthAt(0.0, b.z()));
  const bool vertical = along.squaredNorm() < 1e-24;
  forEachEdge([&](const Vector2d& c, const Vector2d& d) {
    const double bound = depthAt(
        vertical ? toSegment(from, c, d) : between(from, from + along, c, d), lowest);
    if (vertical || rise == 0 || bound <= std::max(0.0, deepest)) {
      deepest = std::max(deepest, bound);
      return;
    }
    // The distance to an edge is convex along the move, so the depth is concave.
    deepest =
        std::max(deepest, maximumOf(0.0, 1.0, [&](double t) {
                   return depthAt(toSegment(from + t * along, c, d), a.z() + t * rise);
                 }));
  });
  return deepest;
}

std::string KeepOutZone::describe() const
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  if (isDisc())
    text << "cylinder at (" << corners_[0].x() << ", " << corners_[0].y()
         << "), radius " << radius_;
  else
    text << "outline of " << corners_.size() << " corners from (" << min_.x() << ", "
         << min_.y() << ") to (" << max_.x() << ", " << max_.y() << ")";
  text << ", up to " << top_ << " mm";
  return text.str();
}

} // namespace pointmill
