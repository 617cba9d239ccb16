// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// From the sample scan to its files.
#include "mill_test.h"

#include <nlohmann/json.hpp>
#include <pcl/io/pcd_io.h>

using namespace mill_test;

namespace {

/// One job for the tests that only look.
class Sample : public ::testing::Test {
protected:
  static void SetUpTestSuite()
  {
    job_ = std::make_unique<MillJob>(MillOptions());
    job_->plan(data("sample_scan.pcd"));
    folder_ = std::make_unique<TempDir>();
    job_->write((*folder_ / "nc").string());
  }
  static void TearDownTestSuite()
  {
    job_.reset();
    folder_.reset();
  }
  static const MillJob& job() { return *job_; }
  static fs::path file(const std::string& name) { return *folder_ / "nc" / name; }
  static nlohmann::json report()
  {
    return nlohmann::json::parse(contents(file("report.json")));
  }
  static pcl::PointCloud<pcl::PointXYZ> cloud(const std::string& path)
  {
    pcl::PointCloud<pcl::PointXYZ> points;
    EXPECT_EQ(pcl::PCDReader().read(path, points), 0) << path;
    return points;
  }

  static std::unique_ptr<MillJob> job_;
  static std::unique_ptr<TempDir> folder_;
};
std::unique_ptr<MillJob> Sample::job_;
std::unique_ptr<TempDir> Sample::folder_;

} // namespace

TEST_F(Sample, IsVerified)
{
  const Verification& v = job().verification();
  EXPECT_TRUE(v.good());
  EXPECT_EQ(v.rapids_in_stock, 0u);
  EXPECT_EQ(v.gouged_points, 0u);
  EXPECT_LT(v.gouge, job().options().tolerance);
  EXPECT_LT(v.residual.p50, 0.01);
  EXPECT_GE(job().operations().size(), 3u);
  EXPECT_NEAR(job().partSize().x(), 100, 0.2);
  EXPECT_NEAR(job().partSize().y(), 70, 0.2);
  EXPECT_NEAR(job().partSize().z(), 17.5, 0.2); // from the groove's floor to the top
}

TEST_F(Sample, AllFilesAreWrittenAndNothingElse)
{
  std::vector<std::string> names = folder_->names();
  EXPECT_EQ(names, std::vector<std::string>{"nc"});
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(*folder_ / "nc")) {
    files.push_back(entry.path().filename().string());
    EXPECT_GT(fs::file_size(entry), 1000u) << files.back();
  }
  std::sort(files.begin(), files.end());
  EXPECT_EQ(files,
            (std::vector<std::string>{"bridges.pcd",
                                      "cl.pcd",
                                      "curvature.png",
                                      "deviation.pcd",
                                      "deviation.png",
                                      "gaps.png",
                                      "heights.png",
                                      "levels.png",
                                      "map.pcd",
                                      "model.pcd",
                                      "occupancy_1.png",
                                      "occupancy_2.png",
                                      "occupancy_3.png",
                                      "part.pcd",
                                      "preview.png",
                                      "program.ngc",
                                      "report.html",
                                      "report.json"}));
  EXPECT_EQ(contents(file("program.ngc")), job().programs().front().text);
  for (const char* picture : {"preview.png", "occupancy_2.png"})
    EXPECT_EQ(contents(file(picture)).substr(1, 3), "PNG");
}

TEST_F(Sample, TheReportHoldsWhatTheJobKnows)
{
  const auto json = report();
  EXPECT_EQ(json.at("scan").at("file"), "sample_scan.pcd");
  EXPECT_EQ(json.at("scan").at("points"), job().part().size());
  EXPECT_EQ(json.at("scan").at("vertices").get<std::size_t>() +
                json.at("scan").at("nan_points").get<std::size_t>(),
            218060u);
  EXPECT_EQ(json.at("stock").at("min").size(), 3u);
  EXPECT_EQ(json.at("stock").at("max").at(2), job().stock().top());
  ASSERT_EQ(json.at("tools").size(), 3u);
  EXPECT_EQ(json.at("tools").at(1).at("number"), 2);
  EXPECT_EQ(json.at("tools").at(2).at("type"), "ball");
  ASSERT_EQ(json.at("operations").size(), job().operations().size());
  double minutes = 0;
  std::size_t points = 0;
  for (std::size_t i = 0; i < job().operations().size(); ++i) {
    const auto& told = json.at("operations").at(i);
    const auto& planned = job().operations()[i];
    EXPECT_EQ(told.at("name"), planned.operation.name);
    EXPECT_EQ(told.at("cl_points"), planned.operation.path.size());
    EXPECT_GT(told.at("minutes"), 0.0);
    minutes += told.at("minutes").get<double>();
    points += planned.operation.path.size();
  }
  EXPECT_NEAR(json.at("minutes"), minutes, 1e-6);
  EXPECT_TRUE(json.at("verification").at("passed"));
  EXPECT_EQ(json.at("verification").at("rapids_in_stock"), 0);
  EXPECT_TRUE(json.at("verification").at("findings").empty());
  EXPECT_GT(points, 10000u);
}

TEST_F(Sample, TheAlignmentIsRigidAndMapsTheScanOntoThePart)
{
  const auto numbers = report().at("alignment");
  ASSERT_EQ(numbers.size(), 16u);
  Eigen::Matrix4d to_part;
  for (int i = 0; i < 16; ++i)
    to_part(i / 4, i % 4) = numbers.at(static_cast<std::size_t>(i)).get<double>();
  const Eigen::Matrix3d turn = to_part.topLeftCorner<3, 3>();
  EXPECT_NEAR((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm(), 0, 1e-9);
  EXPECT_NEAR(turn.determinant(), 1, 1e-9);
  EXPECT_EQ(to_part.row(3), Eigen::RowVector4d(0, 0, 0, 1));
  // Turned by 7 degrees; the long side goes to X.
  EXPECT_NEAR(
      std::abs(std::atan2(turn(1, 0), turn(0, 0))), 7 * M_PI / 180, 0.1 * M_PI / 180);

  // Both clouds are in the scan's order; the part lacks what was left out.
  const auto scan = cloud(data("sample_scan.pcd"));
  const auto part = cloud(file("part.pcd").string());
  ASSERT_EQ(part.size(), job().part().size());
  std::size_t at = 0, skipped = 0;
  for (const auto& p : scan) {
    const Eigen::Vector4d mapped = to_part * Eigen::Vector4d(p.x, p.y, p.z, 1);
    if (at < part.size() &&
        (mapped.head<3>() - part[at].getVector3fMap().cast<double>()).norm() < 1e-3)
      ++at;
    else
      ++skipped;
  }
  EXPECT_EQ(at, part.size());
  EXPECT_EQ(skipped, job().scanFigures().strays + job().scanFigures().nan_points);
  EXPECT_LT(skipped, scan.size() / 1000);
}

TEST_F(Sample, TheDatumIsTheCornerAndTheTop)
{
  const auto part = cloud(file("part.pcd").string());
  Eigen::Vector3f low(1e9f, 1e9f, 1e9f), high = -low;
  for (const auto& p : part) {
    low = low.cwiseMin(p.getVector3fMap());
    high = high.cwiseMax(p.getVector3fMap());
  }
  EXPECT_NEAR(low.x(), 0, 1e-4);
  EXPECT_NEAR(low.y(), 0, 1e-4);
  EXPECT_NEAR(high.z(), 0, 1e-4);
  // The floor is the lowest point without its noise.
  EXPECT_NEAR(low.z(), job().floor(), job().surfaceFigures().farthest + 1e-4);
}

TEST_F(Sample, TheCLPointsAreThoseOfTheOperations)
{
  CLCloud all;
  ASSERT_EQ(pcl::PCDReader().read(file("cl.pcd").string(), all), 0);
  std::size_t at = 0;
  for (const auto& planned : job().operations())
    for (const auto& p : planned.operation.path) {
      ASSERT_LT(at, all.size());
      ASSERT_EQ(all[at].getVector3fMap(), p.getVector3fMap()) << at;
      ASSERT_EQ(all[at].feed, p.feed);
      ASSERT_EQ(all[at].label, p.label);
      ASSERT_EQ(all[at].motion, p.motion);
      ++at;
    }
  EXPECT_EQ(at, all.size());
}

TEST_F(Sample, EveryOperationBeginsAndEndsOnTheClearancePlane)
{
  EXPECT_DOUBLE_EQ(job().clearancePlane(), job().stock().top() + 5);
  std::uint32_t last = 0;
  for (const auto& planned : job().operations()) {
    const auto& path = planned.operation.path;
    EXPECT_FLOAT_EQ(path.front().z, float(job().clearancePlane()));
    EXPECT_FLOAT_EQ(path.back().z, float(job().clearancePlane()));
    for (const auto& p : path) {
      EXPECT_GE(p.label, last) << "pass numbers run through the program";
      last = p.label;
      EXPECT_GE(p.z, job().floor() - 1e-4);
    }
  }
}

TEST(SampleAgain, GivesTheSameProgramForAnyNumberOfThreads)
{
  MillOptions options;
  options.threads = 1;
  MillJob one(options);
  one.plan(data("sample_scan.pcd"));
  options.threads = 5;
  MillJob five(options);
  five.plan(data("sample_scan.pcd"));
  ASSERT_GT(one.programs().front().text.size(), 100000u);
  EXPECT_TRUE(one.programs().front().text == five.programs().front().text);
  EXPECT_EQ(one.verification().gouge, five.verification().gouge);
  EXPECT_EQ(one.verification().residual.p95, five.verification().residual.p95);
}
