// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// Compiled once for each instruction set: search.cpp includes this file into a
// namespace of its own for each, which has Floats, a vector of kLanes floats; within(),
// which says as bits where value >= limit and distance <= reach; and largest().

#include "sieve.inl"

#include "hunt.inl"

#include "drop_row.inl"

double dropAlong(const SearchSpace& space,
                 const Tool& tool,
                 const Eigen::Vector2d& a,
                 const Eigen::Vector2d& b)
{
  const Cutter cutter(tool);
  Exactly<AlongValue> value(space.points, cutter, a, b);
  const Move move{a.x(), a.y(), 0, b.x() - a.x(), b.y() - a.y(), 0};
  Hunt<true, Exactly<AlongValue>> hunt(space, move, tool.radius());
  if (hunt.startAt(a.x(), a.y(), value)) {
    const CutterUnderside underside(tool);
    hunt.all(hunt.seed(underside));
  }
  return value.best();
}

double gouge(const SearchSpace& space,
             const Tool& tool,
             const Eigen::Vector3d& a,
             const Eigen::Vector3d& b,
             double tolerance)
{
  const Cutter cutter(tool);
  Exactly<GougeValue> value(space.points, cutter, a, b, tolerance);
  const Move move{a.x(), a.y(), a.z(), b.x() - a.x(), b.y() - a.y(), b.z() - a.z()};
  Hunt<true, Exactly<GougeValue>> hunt(space, move, tool.radius());
  if (hunt.startAt(a.x(), a.y(), value)) {
    const CutterUnderside underside(tool);
    hunt.all(hunt.seed(underside));
  }
  return value.best() > tolerance ? value.best() : 0.0;
}
