// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/align/z_alignment.h>
#include <pointmill_test/random.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <limits>
#include <string>

using namespace pointmill;
using pointmill_test::Random;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double degree = 3.14159265358979323846 / 180;

// A plate of 80 x 50 with two bosses of different heights, from above.
Cloud::Ptr part(const Eigen::Affine3d& where, double noise = 0.01, int count = 10000)
{
  Cloud::Ptr cloud(new Cloud);
  Random random(7);
  for (int i = 0; i < count; ++i) {
    const double x = i < 4 ? 80.0 * (i % 2) : random.uniform(0, 80);
    const double y = i < 4 ? 50.0 * (i / 2) : random.uniform(0, 50);
    double z = noise * random.normal();
    if (std::abs(x - 20) < 8 && std::abs(y - 25) < 12)
      z += 6;
    else if (std::abs(x - 60) < 10 && std::abs(y - 15) < 5)
      z += 12;
    const Eigen::Vector3d p = where * Eigen::Vector3d(x, y, z);
    cloud->push_back(pcl::PointXYZ(static_cast<float>(p.x()),
                                   static_cast<float>(p.y()),
                                   static_cast<float>(p.z())));
  }
  return cloud;
}

Eigen::Affine3d pose(double angle, const Eigen::Vector3d& axis)
{
  return Eigen::Translation3d(210, -85, 37) *
         Eigen::AngleAxisd(angle * degree, axis.normalized());
}

template <typename PointT>
Eigen::Vector3d position(const PointT& p)
{
  return Eigen::Vector3d(p.x, p.y, p.z);
}

double largestMove(const Cloud& a, const Cloud& b)
{
  double move = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    move = std::max(move, (position(a[i]) - position(b[i])).norm());
  return move;
}

Cloud aligned(ZAlignment<pcl::PointXYZ>& stage, const Cloud::ConstPtr& cloud)
{
  stage.setInputCloud(cloud);
  Cloud out;
  stage.filter(out);
  return out;
}

const std::vector<Up> every_up = {
    Up::X, Up::MinusX, Up::Y, Up::MinusY, Up::Z, Up::MinusZ, Up::Plane, Up::Pca};

} // namespace

TEST(ZAlignment, IsARigidMotion)
{
  Random random(1);
  for (const Up up : every_up)
    for (int round = 0; round < 5; ++round) {
      Cloud::Ptr cloud(new Cloud);
      for (int i = 0; i < 300; ++i)
        cloud->push_back(pcl::PointXYZ(static_cast<float>(10 * random.normal()),
                                       static_cast<float>(8 * random.normal()),
                                       static_cast<float>(3 * random.normal())));
      ZAlignment<pcl::PointXYZ> stage;
      stage.setUp(up);
      stage.setPlaneShare(0);
      const Cloud out = aligned(stage, cloud);
      ASSERT_EQ(out.size(), cloud->size());
      const Eigen::Matrix4d t = stage.getTransform();
      const Eigen::Matrix3d r = t.topLeftCorner<3, 3>();
      EXPECT_LT((r * r.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
      EXPECT_NEAR(r.determinant(), 1, 1e-14);
      EXPECT_EQ(t.row(3), Eigen::RowVector4d(0, 0, 0, 1));
      for (std::size_t i = 0; i < out.size(); ++i) {
        const std::size_t j = (7 * i + 1) % out.size();
        EXPECT_NEAR((position(out[i]) - position(out[j])).norm(),
                    (position((*cloud)[i]) - position((*cloud)[j])).norm(),
                    1e-5);
        const Eigen::Vector4d p = t * position((*cloud)[i]).homogeneous();
        EXPECT_LT((p.head<3>() - position(out[i])).norm(), 1e-5);
      }
    }
}

TEST(ZAlignment, EachAxisTurnsUp)
{
  for (int which = 0; which < 6; ++which) {
    const Eigen::Vector3d axis =
        (which % 2 ? -1.0 : 1.0) * Eigen::Vector3d::Unit(which / 2);
    const Eigen::Affine3d where = pose(0, axis) * Eigen::Quaterniond::FromTwoVectors(
                                                      Eigen::Vector3d::UnitZ(), axis);
    ZAlignment<pcl::PointXYZ> stage;
    stage.setUp(static_cast<Up>(which));
    aligned(stage, part(where, 0));
    const Eigen::Matrix3d r = stage.getTransform().topLeftCorner<3, 3>();
    EXPECT_LT((r * axis - Eigen::Vector3d::UnitZ()).norm(), 1e-14);
    EXPECT_LT((stage.getExtents() - Eigen::Vector3d(80, 50, 12)).norm(), 1e-4) << which;

    ZAlignment<pcl::PointXYZ> own;
    own.setUpAxis(3 * axis);
    aligned(own, part(where, 0));
    EXPECT_EQ(own.getTransform(), stage.getTransform());
  }
}

TEST(ZAlignment, FindsTheBaseOfATiltedPlate)
{
  for (double tilt : {3.0, 35.0, 90.0, 150.0, 180.0}) {
    const Eigen::Affine3d where = pose(tilt, {1, 0.4, 0.1});
    ZAlignment<pcl::PointXYZ> stage;
    stage.setUp(Up::Plane);
    aligned(stage, part(where));
    const Eigen::Vector3d up = stage.getTransform().topLeftCorner<3, 3>() *
                               where.linear() * Eigen::Vector3d::UnitZ();
    EXPECT_LT(std::acos(std::min(1.0, up.z())), 0.003 * degree) << tilt;
    // The noise at the edges is all that the box may be larger by.
    EXPECT_LT((stage.getExtents() - Eigen::Vector3d(80, 50, 12)).norm(), 0.12) << tilt;
    EXPECT_GT(stage.getReport().get("base_share"), 0.8);
    EXPECT_GT(stage.getReport().get("up_evidence"), 0.9);
  }
}

TEST(ZAlignment, FindsTheThinnestDirectionOfATiltedPlate)
{
  const Eigen::Affine3d where = pose(40, {1, -0.3, 0.2});
  ZAlignment<pcl::PointXYZ> stage;
  stage.setUp(Up::Pca);
  aligned(stage, part(where));
  const Eigen::Vector3d up = stage.getTransform().topLeftCorner<3, 3>() *
                             where.linear() * Eigen::Vector3d::UnitZ();
  EXPECT_LT(std::acos(up.z()), 5 * degree);
}

TEST(ZAlignment, AligningTwiceMovesNothing)
{
  for (const Up up : {Up::Z, Up::Plane, Up::Pca})
    for (double turn : {0.0, 7.0, 45.0, 88.0, 91.0, 160.0})
      for (const DatumXY datum : {DatumXY::Corner, DatumXY::Centre}) {
        ZAlignment<pcl::PointXYZ> stage;
        stage.setUp(up);
        stage.setDatumXY(datum);
        const Cloud once = aligned(stage, part(pose(turn, {0.02, 0.03, 1})));
        const Cloud twice = aligned(stage, once.makeShared());
        EXPECT_LT(largestMove(once, twice), 1e-4) << turn;
        EXPECT_EQ(stage.getReport().get("tilt_deg"), 0);
        EXPECT_EQ(stage.getReport().get("angle_deg"), 0);
      }
}

TEST(ZAlignment, DiscsAndSquaresStayToo)
{
  Random random(3);
  Cloud::Ptr disc(new Cloud);
  while (disc->size() < 5000) {
    const double x = random.uniform(-30, 30), y = random.uniform(-30, 30);
    if (x * x + y * y < 900)
      disc->push_back(pcl::PointXYZ(float(x), float(y), float(random.normal())));
  }
  ZAlignment<pcl::PointXYZ> stage;
  const Cloud once = aligned(stage, disc);
  EXPECT_LE(std::abs(stage.getReport().get("angle_deg")), 45);
  EXPECT_LT(largestMove(once, aligned(stage, once.makeShared())), 1e-4);
}

TEST(ZAlignment, PutsTheDatumWhereItIsAsked)
{
  const Cloud::Ptr cloud = part(pose(7, {0, 0, 1}));
  for (const DatumXY xy : {DatumXY::Corner, DatumXY::Centre})
    for (const DatumZ z : {DatumZ::Top, DatumZ::Bottom}) {
      ZAlignment<pcl::PointXYZ> stage;
      stage.setDatumXY(xy);
      stage.setDatumZ(z);
      const Cloud out = aligned(stage, cloud);
      Eigen::Vector3d low = position(out[0]), high = low;
      for (const auto& p : out) {
        low = low.cwiseMin(position(p));
        high = high.cwiseMax(position(p));
      }
      EXPECT_LT((low - stage.getMin()).norm(), 1e-5);
      EXPECT_LT((high - stage.getMax()).norm(), 1e-5);
      if (xy == DatumXY::Corner)
        EXPECT_EQ(low.head<2>(), Eigen::Vector2d::Zero());
      else
        EXPECT_LT((low + high).head<2>().norm(), 1e-5);
      EXPECT_EQ(z == DatumZ::Top ? high.z() : low.z(), 0);
    }
}

TEST(ZAlignment, SquaringCanBeSwitchedOff)
{
  ZAlignment<pcl::PointXYZ> stage;
  stage.setSquareToX(false);
  aligned(stage, part(pose(30, {0, 0, 1})));
  EXPECT_EQ(stage.getTransform().block(0, 0, 3, 3), Eigen::Matrix3d::Identity());
  stage.setSquareToX(true);
  aligned(stage, part(pose(30, {0, 0, 1})));
  EXPECT_NEAR(stage.getReport().get("angle_deg"), -30, 0.05);
}

TEST(ZAlignment, AFarCloudLosesNothingFurther)
{
  // Coordinates of a map's grid in steps that a float still holds there.
  Cloud::Ptr far(new Cloud);
  Random random(5);
  const Eigen::Vector3d origin(612000, 5400000, 700);
  for (int i = 0; i < 2000; ++i) {
    const auto x = std::floor(static_cast<float>(random.uniform(0, 90)));
    const auto y = std::floor(static_cast<float>(random.uniform(0, 60)));
    const float step = x < 20 ? 9.f : 0.f;
    far->push_back(pcl::PointXYZ(612000 + x, 5400000 + y, 700 + y / 2 + step));
  }
  Cloud::Ptr near(new Cloud(*far));
  for (auto& p : *near)
    p.getVector3fMap() = (position(p) - origin).cast<float>();
  ZAlignment<pcl::PointXYZ> stage;
  for (const Up up : {Up::X, Up::Z, Up::Plane, Up::Pca}) {
    stage.setUp(up);
    const Cloud a = aligned(stage, far);
    const Eigen::Matrix4d t = stage.getTransform();
    const Cloud b = aligned(stage, near);
    EXPECT_LT(largestMove(a, b), 1e-5);
    const Eigen::Vector4d p = t * position((*far)[9]).homogeneous();
    EXPECT_LT((p.head<3>() - position(a[9])).norm(), 1e-5);
  }
}

TEST(ZAlignment, ReadsOnlyItsIndicesAndDropsNaN)
{
  Cloud::Ptr cloud = part(pose(7, {0, 0, 1}));
  ZAlignment<pcl::PointXYZ> stage;
  const Cloud all = aligned(stage, cloud);
  const pcl::IndicesPtr indices(new pcl::Indices);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    indices->push_back(static_cast<pcl::index_t>(i));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  cloud->push_back(pcl::PointXYZ(900, 900, 900)); // not selected
  for (const auto& bad :
       {pcl::PointXYZ(nan, 0, 0),
        pcl::PointXYZ(0, std::numeric_limits<float>::infinity(), 0)}) {
    indices->push_back(static_cast<pcl::index_t>(cloud->size()));
    cloud->push_back(bad);
  }
  cloud->is_dense = false;
  cloud->header.frame_id = "scanner";
  stage.setInputCloud(cloud);
  stage.setIndices(indices);
  Cloud out;
  stage.filter(out);
  ASSERT_EQ(out.size(), all.size());
  EXPECT_EQ(largestMove(out, all), 0);
  EXPECT_TRUE(out.is_dense);
  EXPECT_EQ(out.height, 1u);
  EXPECT_EQ(out.header.frame_id, "scanner");
  EXPECT_EQ(stage.getReport().get("nan_points"), 2);
  EXPECT_EQ(stage.getReport().get("points"), static_cast<double>(all.size()));
}

TEST(ZAlignment, TheSameScanYieldsTheSameBits)
{
  for (const Up up : every_up) {
    ZAlignment<pcl::PointXYZ> one, other;
    one.setUp(up);
    other.setUp(up);
    const Cloud::Ptr cloud = part(pose(25, {1, 2, 3}), 0.01, 30000);
    EXPECT_EQ(largestMove(aligned(one, cloud), aligned(other, cloud)), 0);
    EXPECT_EQ(one.getTransform(), other.getTransform());
  }
}

TEST(ZAlignment, NormalsTurnWithThePoints)
{
  const Eigen::Affine3d where = pose(35, {1, 0.4, 0.1});
  pcl::PointCloud<pcl::PointNormal>::Ptr cloud(new pcl::PointCloud<pcl::PointNormal>);
  // A flat plate: its normals are what tells its upper side.
  const Cloud::Ptr bare = part(where, 0);
  for (const auto& xyz : *bare)
    if (std::abs((where.inverse() * position(xyz)).z()) < 1) {
      pcl::PointNormal p;
      p.getVector3fMap() = xyz.getVector3fMap();
      p.getNormalVector3fMap() = -where.linear().col(2).cast<float>();
      p.curvature = 0.25f;
      cloud->push_back(p);
    }
  for (const Up up : {Up::Plane, Up::Pca}) {
    ZAlignment<pcl::PointNormal> stage;
    stage.setUp(up);
    stage.setInputCloud(cloud);
    pcl::PointCloud<pcl::PointNormal> out;
    stage.filter(out);
    for (const auto& p : out) {
      EXPECT_NEAR(p.normal_z, 1, 1e-6);
      EXPECT_LT(std::hypot(p.normal_x, p.normal_y), 1e-4);
      EXPECT_EQ(p.curvature, 0.25f);
    }
  }
}

TEST(ZAlignment, ColoursStay)
{
  pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZRGB>);
  for (int i = 0; i < 9; ++i) {
    pcl::PointXYZRGB p(std::uint8_t(i), 20, 30);
    p.getVector3fMap() = Eigen::Vector3f(float(i % 3), float(i / 3) * 2, 1);
    cloud->push_back(p);
  }
  ZAlignment<pcl::PointXYZRGB> stage;
  stage.setInputCloud(cloud);
  stage.filter(*cloud); // in place
  EXPECT_EQ((*cloud)[5].r, 5);
  EXPECT_FLOAT_EQ(static_cast<float>(stage.getExtents().x()), 4);
}

TEST(ZAlignment, WhatCannotBeAlignedIsRefused)
{
  ZAlignment<pcl::PointXYZ> stage;
  Cloud out;
  stage.setInputCloud(Cloud::Ptr(new Cloud));
  EXPECT_THROW(stage.filter(out), DataError);
  Cloud::Ptr few(new Cloud);
  few->push_back(pcl::PointXYZ(0, 0, 0));
  few->push_back(pcl::PointXYZ(1, 0, 0));
  stage.setInputCloud(few);
  EXPECT_THROW(stage.filter(out), DataError);
  for (int i = 0; i < 50; ++i)
    few->push_back(pcl::PointXYZ(float(i), 0, 0));
  for (const Up up : {Up::Plane, Up::Pca}) {
    stage.setUp(up);
    EXPECT_THROW(stage.filter(out), DataError);
  }
  stage.setUp(Up::Z);
  EXPECT_NO_THROW(stage.filter(out)); // a line has no width, but its up is known
  stage.setUpAxis(Eigen::Vector3d::Zero());
  EXPECT_THROW(stage.filter(out), ParameterError);
  stage.setUp(Up::Z);
  stage.setPlaneDistance(0);
  EXPECT_THROW(stage.filter(out), ParameterError);
  EXPECT_EQ(listParameters(stage).size(), 3u);
}
