// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/surface/point_index.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <vector>

namespace pointmill {

/// @brief The points within some distance of a place, relative to it [mm].
struct Neighbourhood {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0;
  std::vector<double> x, y, z; ///< the first size() of each

  std::size_t size() const { return count_; }

  /// @brief Gathers about @p wanted points round @p place: more than half as many and
  /// less than three times, unless the points are spread so unevenly that no radius
  /// gives that.
  void
  gather(const PointIndex& points, const Eigen::Vector3d& place, std::size_t wanted);

  /// @brief Normal [up, unit] of the plane nearest to the points.
  Eigen::Vector3d planeNormal() const;

private:
  void gatherWithin(const PointIndex& points, double distance);

  std::size_t count_ = 0;
};

/// @brief A piece of smooth surface: the quadric
/// `w = c0 + c1 s + c2 t + c3 s^2 + c4 s t + c5 t^2` over the plane through `origin`
/// with the axes `s`, `t` (tangents) and `w` (normal), fitted to a neighbourhood by
/// least squares.
class Patch {
public:
  static constexpr int kTerms = 6;
  using Terms = Eigen::Matrix<double, kTerms, 1>;

  /// @brief Fits @p points in the frame with @p normal; only those that @p keep marks,
  /// where it is given.
  /// @return false where they do not determine a quadric; the patch is not to be used
  /// then
  bool fit(const Neighbourhood& points,
           const Eigen::Vector3d& normal,
           const std::vector<unsigned char>* keep = nullptr);

  /// @brief Place of the patch over (s, t) of its plane [mm].
  Eigen::Vector3d at(double s, double t) const
  {
    return origin_ + s * s_ + t * t_ + height(s, t) * normal_;
  }
  /// @brief Coordinates of @p place in the patch's plane [mm].
  Eigen::Vector2d project(const Eigen::Vector3d& place) const
  {
    const Eigen::Vector3d d = place - origin_;
    return {d.dot(s_), d.dot(t_)};
  }
  /// @brief Unit normal over (s, t).
  Eigen::Vector3d normalAt(double s, double t) const;
  /// @brief Distance of the patch from its plane over (s, t) [mm].
  double height(double s, double t) const;

  /// @brief First and second derivatives of the height by s and t.
  struct Slopes {
    double s, t, ss, st, tt;
  };
  Slopes slopes(double s, double t) const;
  /// @brief Standard deviation of the second derivatives `ss` and `tt` [1/mm], the
  /// larger, as the residual tells the points' noise.
  double bendDeviation() const;

  const Eigen::Vector3d& origin() const { return origin_; }
  const Eigen::Vector3d& normal() const { return normal_; }
  const Eigen::Vector3d& tangentS() const { return s_; }
  const Eigen::Vector3d& tangentT() const { return t_; }
  double radius() const { return radius_; }
  /// @brief Standard deviation of the points from the patch [mm], for the points less
  /// the terms.
  double residual() const { return residual_; }
  /// @brief Variance of the height over the origin, for points of variance 1.
  double variance() const { return solver_.solve(Terms::Unit(0))[0]; }

  /// @brief Whether (s, t) lies between the points, not beyond their border: no half
  /// of the directions from there is without a point.
  bool isBetween(const Neighbourhood& points, double s, double t) const;

private:
  Eigen::Vector3d origin_, s_, t_, normal_;
  Terms c_ = Terms::Zero(); // of s and t over the radius
  Eigen::LDLT<Eigen::Matrix<double, kTerms, kTerms>> solver_;
  double radius_ = 1, residual_ = 0;
};

} // namespace pointmill
