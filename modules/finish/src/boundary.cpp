// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/finish/boundary.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace pointmill {
namespace {

using Eigen::Vector2d;

/// A line along an edge of the polygon counts as inside, whatever rounding says [mm].
constexpr double kRounding = 1e-9;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Line {
  Vector2d origin, direction;

  double along(const Vector2d& p) const { return (p - origin).dot(direction); }
  double beside(const Vector2d& p) const
  {
    const Vector2d d = p - origin;
    return direction.x() * d.y() - direction.y() * d.x();
  }
};

/// Where low <= offset + slope * t <= high.
Span slab(double offset, double slope, double low, double high)
{
  if (slope == 0)
    return offset < low || offset > high ? Span{kInfinity, -kInfinity}
                                         : Span{-kInfinity, kInfinity};
  const double a = (low - offset) / slope, b = (high - offset) / slope;
  return {std::min(a, b), std::max(a, b)};
}

/// The stretch of the line within `radius` of the edge a b, which is convex: the hull
/// of those in the discs round its ends and in the rectangle between.
std::optional<Span>
nearEdge(const Line& line, const Vector2d& a, const Vector2d& b, double radius)
{
  Span hull{kInfinity, -kInfinity};
  const auto add = [&](const Span& s) {
    if (s.first > s.last)
      return;
    hull = {std::min(hull.first, s.first), std::max(hull.last, s.last)};
  };
  for (const Vector2d* end : {&a, &b}) {
    const double d = line.beside(*end), t = line.along(*end);
    if (std::abs(d) <= radius) {
      const double half = std::sqrt((radius - d) * (radius + d));
      add({t - half, t + half});
    }
  }
  const double length = (b - a).norm();
  if (length > 0) {
    const Vector2d e = (b - a) / length, normal(-e.y(), e.x()), d = line.origin - a;
    const Span between = slab(d.dot(e), line.direction.dot(e), 0, length);
    const Span beside =
        slab(d.dot(normal), line.direction.dot(normal), -radius, radius);
    add({std::max(between.first, beside.first), std::min(between.last, beside.last)});
  }
  if (hull.first > hull.last)
    return std::nullopt;
  return hull;
}

std::vector<Span> unite(std::vector<Span> spans)
{
  std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) {
    return a.first < b.first;
  });
  std::vector<Span> united;
  for (const auto& s : spans)
    if (united.empty() || s.first > united.back().last)
      united.push_back(s);
    else
      united.back().last = std::max(united.back().last, s.last);
  return united;
}

/// What @p spans hold outside @p holes; both in order and disjoint.
std::vector<Span> subtract(const std::vector<Span>& spans,
                           const std::vector<Span>& holes)
{
  std::vector<Span> rest;
  for (Span s : spans) {
    for (const auto& h : holes) {
      if (h.last <= s.first || h.first >= s.last)
        continue;
      if (h.first > s.first)
        rest.push_back({s.first, h.first});
      s.first = h.last;
      if (s.first >= s.last)
        break;
    }
    if (s.first < s.last)
      rest.push_back(s);
  }
  return rest;
}

} // namespace

Boundary::Boundary(std::vector<Vector2d> polygon, double overhang)
    : polygon_(std::move(polygon)), overhang_(overhang)
{
  if (polygon_.size() < 3)
    throw ParameterError("a boundary needs three corners or more");
  for (const auto& p : polygon_)
    if (!p.allFinite())
      throw ParameterError("a corner of the boundary is not finite");
}

std::vector<Span> Boundary::inside(const Vector2d& origin,
                                   const Vector2d& direction) const
{
  const Line line{origin, direction};
  const bool grows = overhang_ >= 0;
  const double reach =
      grows ? overhang_ + kRounding : std::max(0.0, -overhang_ - kRounding);
  std::vector<double> crossings;
  std::vector<Span> edges;
  for (std::size_t i = 0; i < polygon_.size(); ++i) {
    const Vector2d &a = polygon_[i], &b = polygon_[(i + 1) % polygon_.size()];
    const double da = line.beside(a), db = line.beside(b);
    if ((da > 0) != (db > 0))
      crossings.push_back(line.along(a) +
                          (line.along(b) - line.along(a)) * da / (da - db));
    if (const auto near = nearEdge(line, a, b, reach))
      edges.push_back(*near);
  }
  std::sort(crossings.begin(), crossings.end());
  std::vector<Span> spans;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    spans.push_back({crossings[i], crossings[i + 1]});
  if (!grows)
    return subtract(unite(std::move(spans)), unite(std::move(edges)));
  spans.insert(spans.end(), edges.begin(), edges.end());
  return unite(std::move(spans));
}

Span Boundary::extent(const Vector2d& axis) const
{
  Span span{kInfinity, -kInfinity};
  for (const auto& p : polygon_) {
    span.first = std::min(span.first, p.dot(axis));
    span.last = std::max(span.last, p.dot(axis));
  }
  return {span.first - overhang_, span.last + overhang_};
}

} // namespace pointmill
