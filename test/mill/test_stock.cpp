// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What the part is milled from, and what must not be touched.
#include "mill_test.h"

using namespace mill_test;

namespace {

MillOptions fast()
{
  MillOptions options;
  options.scallop = 0.05;
  options.semi_scallop = 0.2;
  return options;
}

double removedByRoughing(const MillJob& job)
{
  return job.operations().front().figures.cut.volume;
}

/// The dome scanned before it was milled, `above` mm higher, as text.
std::string rawDome(const MillJob& job, const TempDir& directory, double above)
{
  const Eigen::Matrix4d back = job.alignment().inverse();
  const std::string name = directory / "raw.xyz";
  std::ofstream out(name);
  for (const auto& p : job.part()) {
    const Eigen::Vector4d at =
        back * Eigen::Vector4d(p.x, p.y, double(p.z) + above, 1.0);
    out << at.x() << " " << at.y() << " " << at.z() << "\n";
  }
  return name;
}

} // namespace

TEST(MillStock, ARawPartThatWasScannedIsRoughedAsItIs)
{
  MillJob block(fast());
  block.plan(data("dome.pcd"));
  const TempDir directory;
  auto options = fast();
  options.stock_scan = rawDome(block, directory, 2.0);
  MillJob casting(options);
  casting.plan(data("dome.pcd"));
  EXPECT_TRUE(casting.verification().good());
  // A layer of 2 mm over the plan, all in all, not what fills the box.
  const double area = casting.partSize().x() * casting.partSize().y();
  EXPECT_LT(removedByRoughing(casting), 2.5 * area);
  EXPECT_LT(removedByRoughing(casting), 0.6 * removedByRoughing(block));
}

TEST(MillStock, ARawPartElsewhereIsRefused)
{
  MillJob block(fast());
  block.plan(data("dome.pcd"));
  const TempDir directory;
  auto options = fast();
  options.stock_scan = rawDome(block, directory, -3.0); // below the part
  MillJob casting(options);
  EXPECT_THROW(casting.plan(data("dome.pcd")), DataError);
}

TEST(MillStock, ABoxMustHoldThePart)
{
  auto options = fast();
  options.stock_box = Stock{{-5, -5, -20}, {65, 65, 1}};
  MillJob job(options);
  job.plan(data("dome.pcd"));
  EXPECT_EQ(job.stock().max.x(), 65);
  EXPECT_EQ(job.clearancePlane(), 1 + options.clearance);
  options.stock_box = Stock{{0, 0, -20}, {30, 60, 1}};
  EXPECT_THROW(MillJob(options).plan(data("dome.pcd")), DataError);
  options.stock_margin = 2;
  EXPECT_THROW(options.validate(), ParameterError) << "a box and margins";
}

TEST(MillStock, ClampsAreKeptOutOfByEveryOperation)
{
  auto options = fast();
  options.keep_out = KeepOut({KeepOutZone::box(-10, 20, 10, 40, 8)}, 1.0);
  MillJob job(options);
  job.plan(data("dome.pcd"));
  EXPECT_TRUE(job.verification().good());
  EXPECT_GE(job.clearancePlane(), 9 + options.clearance);
  EXPECT_GT(job.verification().kept_out_points, 100u);
  for (const auto& o : job.operations())
    for (std::size_t i = 1; i < o.operation.path.size(); ++i) {
      const auto &a = o.operation.path[i - 1], &b = o.operation.path[i];
      ASSERT_LE(options.keep_out.depth(o.operation.tool,
                                       a.getVector3fMap().cast<double>(),
                                       b.getVector3fMap().cast<double>()),
                1e-3)
          << o.operation.name << " " << i;
    }
}

TEST(MillStock, ARestToolWorksBeforeTheBalls)
{
  auto options = fast();
  options.rest = options.rough;
  options.rest->tool = Tool::flat(4, 4);
  MillJob job(options);
  job.plan(data("channel.pcd"));
  EXPECT_TRUE(job.verification().good());
  EXPECT_EQ(job.tools().size(), 4u);
  ASSERT_GE(job.operations().size(), 3u);
  for (std::size_t i = 1; i < job.operations().size(); ++i)
    if (job.operations()[i].operation.tool.number == 4) {
      EXPECT_EQ(i, 1u);
    }
  options.rest->tool = Tool::flat(4, 12);
  EXPECT_THROW(options.validate(), ParameterError);
}

TEST(MillStock, EveryRoughingPassesItsVerification)
{
  for (const auto strategy : {RoughingStrategy::Grid,
                              RoughingStrategy::ZigZag,
                              RoughingStrategy::Spiral,
                              RoughingStrategy::HighSpeed,
                              RoughingStrategy::Offset}) {
    auto options = fast();
    options.roughing = strategy;
    options.step_down = 2.0;
    MillJob job(options);
    job.plan(data("saddle.pcd"));
    EXPECT_TRUE(job.verification().good());
    EXPECT_LE(job.verification().axial_depth.at(1), 2.0 + 1e-3);
    EXPECT_GT(removedByRoughing(job), 0);
  }
}
