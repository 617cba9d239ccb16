// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "io_test.h"

#include <pointmill/io/scan.h>

#include <Eigen/Geometry>
#include <pcl/search/kdtree.h>

#include <limits>

using pointmill::prepareScan;
using pointmill::RawScan;
using pointmill::Scan;
using pointmill::ScanScale;

namespace {

RawScan utmCloud()
{
  RawScan raw;
  raw.points = io_test::utmPoints();
  raw.format = "PLY";
  raw.non_finite = 4;
  return raw;
}

// A flat sheet, `columns` x `rows` squares of two triangles each [mm].
RawScan sheet(double width, double height, unsigned columns, unsigned rows)
{
  RawScan raw;
  for (unsigned j = 0; j <= rows; ++j)
    for (unsigned i = 0; i <= columns; ++i)
      raw.points.emplace_back(width * i / columns, height * j / rows, 0);
  for (unsigned j = 0; j < rows; ++j)
    for (unsigned i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i, b = a + columns + 1;
      raw.faces.push_back({a, a + 1, b});
      raw.faces.push_back({a + 1, b + 1, b});
    }
  return raw;
}

// The radius of the largest circle without a sample, in distances of a square grid of
// the same density, for the centres at least `margin` [mm] from the border of a turned
// sheet.
double largestGap(const Scan& scan,
                  const Eigen::Matrix3d& turn,
                  double width,
                  double height,
                  double margin)
{
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud(scan.cloud);
  const double spacing = 1 / std::sqrt(scan.density);
  double largest = 0;
  for (double x = margin; x <= width - margin; x += spacing / 4)
    for (double y = margin; y <= height - margin; y += spacing / 4) {
      pcl::Indices index;
      std::vector<float> squared;
      const Eigen::Vector3f p =
          (turn * Eigen::Vector3d(x, y, 0) - scan.shift).cast<float>();
      tree.nearestKSearch({p.x(), p.y(), p.z()}, 1, index, squared);
      largest = std::max(largest, std::sqrt(double(squared[0])) / spacing);
    }
  return largest;
}

constexpr std::size_t plenty = 10000000;

} // namespace

TEST(PrepareScan, LargeCoordinatesSurvive)
{
  const RawScan raw = utmCloud();
  for (const ScanScale scale :
       {ScanScale{1, 0}, ScanScale{1000, 0}, ScanScale{1, 300}}) {
    const Scan scan = prepareScan(raw, scale, 1, plenty, 1);
    ASSERT_EQ(scan.cloud->size(), raw.points.size());
    const double half = 121 * scan.scale / 2; // the largest extent is y, 0 .. 11^2
    for (std::size_t i = 0; i < raw.points.size(); ++i) {
      const auto& p = (*scan.cloud)[i];
      const Eigen::Vector3d back = Eigen::Vector3d(p.x, p.y, p.z) + scan.shift;
      const double error = (back - raw.points[i] * scan.scale).cwiseAbs().maxCoeff();
      // Rounding to float, and what doubles of this size can still tell.
      EXPECT_LE(error, 6e-8 * half + 4e-16 * 5.5e6 * scan.scale);
      EXPECT_LE(std::abs(p.y), half * 1.000001);
    }
  }
  const Scan scan = prepareScan(raw, {1, 300}, 1, plenty, 1);
  EXPECT_DOUBLE_EQ(scan.scale, 300.0 / 121.0);
  EXPECT_EQ(scan.vertices, 12u);
  EXPECT_EQ(scan.faces + scan.sampled, 0u);
  EXPECT_EQ(scan.density, 0.0);
  EXPECT_EQ(scan.non_finite, 4u);
  EXPECT_EQ(scan.format, "PLY");
}

TEST(PrepareScan, SamplesAreAsManyAsTheAreaIsDue)
{
  for (const RawScan& raw :
       {sheet(100, 80, 1, 1), sheet(100, 80, 7, 90), sheet(100, 80, 200, 3)})
    for (const std::uint32_t seed : {1u, 2u, 77u}) {
      const Scan scan = prepareScan(raw, {}, 2.5, plenty, seed);
      EXPECT_NEAR(double(scan.sampled), 100 * 80 * 2.5, 0.01 * 100 * 80 * 2.5);
      EXPECT_EQ(scan.cloud->size(), scan.vertices + scan.sampled);
      EXPECT_EQ(scan.density, 2.5);
    }
  // Twice as large is four times the area.
  EXPECT_NEAR(double(prepareScan(sheet(50, 50, 2, 2), {2, 0}, 1, plenty, 1).sampled),
              10000,
              100);
}

TEST(PrepareScan, SamplesLeaveNoLargeGap)
{
  // 0.71 is what a square grid leaves; chance leaves more than 2.
  const Eigen::Matrix3d flat = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d chamfer =
      Eigen::AngleAxisd(M_PI / 4, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const Eigen::Matrix3d corner =
      Eigen::AngleAxisd(std::acos(std::sqrt(1.0 / 3)),
                        Eigen::Vector3d(1, -1, 0).normalized())
          .toRotationMatrix();
  // Two triangles, slivers either way, and triangles about as large as the distance.
  for (const auto& [columns, rows] :
       std::vector<std::pair<unsigned, unsigned>>{{1, 1}, {300, 1}, {1, 300}, {37, 41}})
    for (const auto& [turn, inside] : std::vector<std::pair<Eigen::Matrix3d, double>>{
             {flat, 0.71}, {chamfer, 1.0}, {corner, 1.0}}) {
      RawScan raw = sheet(40, 30, columns, rows);
      for (auto& point : raw.points)
        point = turn * point;
      const Scan scan = prepareScan(raw, {}, 4, plenty, 1);
      EXPECT_NEAR(double(scan.sampled), 4800, 48);
      EXPECT_LE(largestGap(scan, turn, 40, 30, 1), inside) << columns << " x " << rows;
      EXPECT_LE(largestGap(scan, turn, 40, 30, 0), 1.5) << columns << " x " << rows;
    }
}

TEST(PrepareScan, TheSameSeedGivesTheSameBytes)
{
  const RawScan raw = sheet(60, 40, 9, 7);
  const auto bytesOf = [&](std::uint32_t seed) {
    const Scan scan = prepareScan(raw, {}, 3, plenty, seed);
    std::string all;
    for (const auto& p : *scan.cloud)
      all += io_test::bytes(p.x) + io_test::bytes(p.y) + io_test::bytes(p.z);
    return all;
  };
  EXPECT_EQ(bytesOf(3), bytesOf(3));
  EXPECT_NE(bytesOf(3), bytesOf(4));
}

TEST(PrepareScan, TheLimitLowersTheDensity)
{
  for (const std::size_t most : {1u, 10u, 999u, 1000u}) {
    const Scan scan = prepareScan(sheet(100, 100, 5, 5), {}, 50, most, 1);
    EXPECT_LE(scan.sampled, most);
    EXPECT_GE(double(scan.sampled), 0.97 * double(most) - 5);
    EXPECT_LT(scan.density, 0.1001);
  }
}

TEST(PrepareScan, VerticesComeFirst)
{
  const RawScan raw = sheet(10, 10, 1, 1);
  const Scan scan = prepareScan(raw, {}, 1, plenty, 1);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& p = (*scan.cloud)[i];
    EXPECT_LT((Eigen::Vector3d(p.x, p.y, p.z) + scan.shift - raw.points[i]).norm(),
              1e-6);
  }
}

TEST(PrepareScan, NonsenseIsRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const RawScan raw = utmCloud();
  using pointmill::ParameterError;
  for (const double bad : {0.0, -1.0, nan, 1e300}) {
    EXPECT_THROW(prepareScan(raw, {bad, 0}, 1, plenty, 1), ParameterError) << bad;
    EXPECT_THROW(prepareScan(raw, {}, bad, plenty, 1), ParameterError) << bad;
    if (bad != 0.0) {
      EXPECT_THROW(prepareScan(raw, {1, bad}, 1, plenty, 1), ParameterError) << bad;
    }
  }
  EXPECT_THROW(prepareScan(raw, {}, 1, 0, 1), ParameterError);

  using pointmill::DataError;
  EXPECT_THROW(prepareScan({}, {}, 1, plenty, 1), DataError);
  RawScan wrong = sheet(10, 10, 1, 1);
  wrong.faces[0][1] = 4;
  EXPECT_THROW(prepareScan(wrong, {}, 1, plenty, 1), DataError);
  wrong.faces = {{0, 1, 1}};
  EXPECT_THROW(prepareScan(wrong, {}, 1, plenty, 1), DataError);
  wrong.points[2].x() = nan;
  EXPECT_THROW(prepareScan(wrong, {}, 1, plenty, 1), DataError);
  wrong.points.assign(20, Eigen::Vector3d(1, 2, 3));
  EXPECT_THROW(prepareScan(wrong, {}, 1, plenty, 1), DataError);
}
