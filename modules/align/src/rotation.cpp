// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/align/rotation.h>

#include <Eigen/Geometry>

namespace pointmill {
namespace align {

Eigen::Matrix3d rotationToZ(const Eigen::Vector3d& axis)
{
  Eigen::Vector3d a = axis.stableNormalized();
  Eigen::Matrix3d first = Eigen::Matrix3d::Identity();
  // The shortest way is undefined at -Z. Wherever the switch is made it is a jump; at
  // -1/2 it is far from the axes and from the diagonals between them.
  if (a.z() < -0.5) {
    first.diagonal() << 1, -1, -1;
    a = first * a;
  }
  Eigen::Matrix3d cross; // [a x z]_x
  cross << 0, 0, -a.x(), 0, 0, -a.y(), a.x(), a.y(), 0;
  const Eigen::Matrix3d turn =
      Eigen::Matrix3d::Identity() + cross + cross * cross / (1.0 + a.z());
  return orthonormalised(turn * first);
}

Eigen::Matrix3d orthonormalised(const Eigen::Matrix3d& rotation)
{
  const Eigen::Vector3d z = rotation.row(2).transpose().normalized();
  const Eigen::Vector3d row = rotation.row(0).transpose();
  const Eigen::Vector3d x = (row - row.dot(z) * z).normalized();
  Eigen::Matrix3d result;
  result << x.transpose(), z.cross(x).transpose(), z.transpose();
  return result;
}

} // namespace align
} // namespace pointmill
