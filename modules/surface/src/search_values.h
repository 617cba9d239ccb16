// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "cutter.h"

#include <pointmill/surface/contact.h>
#include <pointmill/surface/sorted_points.h>
#include <pointmill/surface/sweep.h>

#include <algorithm>
#include <cmath>
#include <limits>

// What single points are worth to a search, in double. ask() takes a point into
// account; mayBeat() says whether points up to `top` high, at least `distance` from the
// axis and all of them at `first` or behind, can change the result.
namespace pointmill {

/// Resting height on a point. Of points that give the same height, the first counts.
class DropValue {
public:
  DropValue(const SortedPoints& points, const Cutter& cutter)
      : points_(points), cutter_(cutter)
  {
  }
  void startAt(const Eigen::Vector2d& at)
  {
    at_ = at;
    tip_ = -std::numeric_limits<double>::infinity();
    point_ = -1;
  }

  void ask(std::size_t i)
  {
    const double dx = points_.x[i] - at_.x(), dy = points_.y[i] - at_.y();
    const double d2 = dx * dx + dy * dy;
    if (!(d2 <= cutter_.radius2()))
      return;
    const double tip = points_.z[i] - cutter_.profile2(d2);
    const auto point = static_cast<std::int64_t>(i);
    if (tip > tip_ || (tip == tip_ && point < point_)) {
      tip_ = tip;
      point_ = point;
    }
  }
  bool mayBeat(double top, double distance, std::size_t first) const
  {
    const double tip = top - cutter_.profile(distance);
    return tip > tip_ || (tip == tip_ && static_cast<std::int64_t>(first) < point_);
  }

  const SortedPoints& points() const { return points_; }
  double best() const { return tip_; }
  bool touches() const { return point_ >= 0; }
  std::int64_t point() const { return point_; }
  Contact contact() const
  {
    Contact contact;
    if (touches()) {
      contact.tip = tip_;
      contact.point = point_;
      contact.at = {points_.x[point_], points_.y[point_], points_.z[point_]};
    }
    return contact;
  }

private:
  const SortedPoints& points_;
  const Cutter& cutter_;
  Eigen::Vector2d at_{0, 0};
  double tip_ = -std::numeric_limits<double>::infinity();
  std::int64_t point_ = -1;
};

/// Height over which a level move is clear of a point.
class AlongValue {
public:
  AlongValue(const SortedPoints& points,
             const Cutter& cutter,
             const Eigen::Vector2d& a,
             const Eigen::Vector2d& b)
      : points_(points), cutter_(cutter), a_(a), b_(b)
  {
  }

  void ask(std::size_t i)
  {
    const double d2 =
        segmentDistance2(a_.x(), a_.y(), b_.x(), b_.y(), points_.x[i], points_.y[i]);
    if (d2 <= cutter_.radius2())
      best_ = std::max(best_, points_.z[i] - cutter_.profile2(d2));
  }
  bool mayBeat(double top, double distance, std::size_t) const
  {
    return top - cutter_.profile(distance) > best_;
  }
  const SortedPoints& points() const { return points_; }
  double best() const { return best_; }

private:
  const SortedPoints& points_;
  const Cutter& cutter_;
  Eigen::Vector2d a_, b_;
  double best_ = -std::numeric_limits<double>::infinity();
};

/// Depth of a point inside the cutter on a straight move; more than `tolerance` counts.
class GougeValue {
public:
  GougeValue(const SortedPoints& points,
             const Cutter& cutter,
             const Eigen::Vector3d& a,
             const Eigen::Vector3d& b,
             double tolerance)
      : points_(points), cutter_(cutter), a_(a), b_(b), lowest_(std::min(a.z(), b.z())),
        best_(tolerance)
  {
  }

  void ask(std::size_t i)
  {
    if (points_.z[i] > lowest_ + best_) // no deeper inside than below the surface
      best_ = std::max(
          best_,
          cutter_.penetration(a_, b_, {points_.x[i], points_.y[i], points_.z[i]}));
  }
  bool mayBeat(double top, double distance, std::size_t) const
  {
    return top - cutter_.profile(distance) > lowest_ + best_;
  }
  const SortedPoints& points() const { return points_; }
  double best() const { return best_; }

private:
  const SortedPoints& points_;
  const Cutter& cutter_;
  Eigen::Vector3d a_, b_;
  double lowest_, best_;
};

} // namespace pointmill
