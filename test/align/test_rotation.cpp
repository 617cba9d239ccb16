// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/align/rotation.h>
#include <pointmill_test/random.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

using namespace pointmill::align;

TEST(Rotation, TurnsEveryAxisToZ)
{
  pointmill_test::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d axis(random.normal(), random.normal(), random.normal());
    const Eigen::Matrix3d r = rotationToZ(axis);
    EXPECT_LT((r * axis - axis.norm() * Eigen::Vector3d::UnitZ()).norm(), 1e-13);
    EXPECT_LT((r * r.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR(r.determinant(), 1, 1e-14);
  }
  EXPECT_EQ(rotationToZ({0, 0, 7}), Eigen::Matrix3d::Identity());
}

TEST(Rotation, NoiseAboutAnAxisHardlyChangesIt)
{
  pointmill_test::Random random(2);
  for (int k = 0; k < 3; ++k)
    for (double sign : {-1.0, 1.0})
      for (int i = 0; i < 100; ++i) {
        const Eigen::Vector3d axis = sign * Eigen::Vector3d::Unit(k);
        const Eigen::Vector3d noise(random.normal(), random.normal(), random.normal());
        EXPECT_LT((rotationToZ(axis + 1e-6 * noise) - rotationToZ(axis)).norm(), 1e-4);
      }
}

TEST(Rotation, OrthonormalisedRemovesRoundingErrors)
{
  Eigen::Matrix3d r(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  r.array() += 1e-7;
  const Eigen::Matrix3d clean = orthonormalised(r);
  EXPECT_LT((clean - r).norm(), 1e-6);
  EXPECT_LT((clean * clean.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-15);
  EXPECT_NEAR(clean.determinant(), 1, 1e-15);
}
