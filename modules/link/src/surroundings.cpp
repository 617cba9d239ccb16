// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "surroundings.h"

#include "steps.h"

#include <algorithm>
#include <limits>

namespace pointmill {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// More than what float32 and rounding take from a height that touches [mm].
constexpr double kRounding = 1e-6;

} // namespace

double Surroundings::certainRadius() const
{
  return stock ? std::max(0.0, tool.endDiameter() / 2 - 2 * stock->cellSize()) : 0.0;
}

double Surroundings::standing(const Vector3d& a, const Vector3d& b, double r) const
{
  return stock ? stock->highest(a.x(), a.y(), b.x(), b.y(), r) : -kInfinity;
}

double Surroundings::lowestOver(const Vector3d& a, const Vector3d& b) const
{
  if (!part)
    return kInfinity;
  return std::max(
      {floor,
       part->dropAlong(tool.grown(allowance), a.x(), a.y(), b.x(), b.y()) + allowance,
       keep_out.lowestAlong(tool, a.x(), a.y(), b.x(), b.y())});
}

bool Surroundings::isClear(const std::vector<Vector3d>& way) const
{
  for (std::size_t i = 1; i < way.size(); ++i)
    if (lowestOver(way[i - 1], way[i]) >
        std::min(way[i - 1].z(), way[i].z()) + kRounding)
      return false;
  return true; // without a part no height is low enough
}

double Surroundings::highestInBox(const Vector3d& a, const Vector3d& b) const
{
  // The box lies within half its shorter side of its longer middle line.
  const Vector2d low = a.head<2>().cwiseMin(b.head<2>());
  const Vector2d high = a.head<2>().cwiseMax(b.head<2>());
  const int along = high.x() - low.x() >= high.y() - low.y() ? 0 : 1;
  Vector2d first = low, last = high;
  first[1 - along] = last[1 - along] = (low[1 - along] + high[1 - along]) / 2;
  const double radius = (high[1 - along] - low[1 - along]) / 2 + tool.radius();

  double top = stock ? stock->highest(first.x(), first.y(), last.x(), last.y(), radius)
                     : -kInfinity;
  if (part)
    top = std::max(top,
                   part->dropAlong(Tool::flat(1, 2 * (radius + allowance)),
                                   first.x(),
                                   first.y(),
                                   last.x(),
                                   last.y()));
  return std::max(top, keep_out.highestTop(low, high, tool.radius()));
}

Cut Surroundings::cutOf(const std::vector<Vector3d>& way) const
{
  const StockField* field = nominal ? nominal : stock;
  return field ? field->probe(tool, way) : Cut();
}

bool Surroundings::isOpen(const Vector3d& at) const
{
  return standing(at, tool.radius()) <= at.z() + kNothing;
}

} // namespace pointmill
