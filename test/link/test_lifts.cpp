// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Ways between passes below the clearance plane.
#include "link_test.h"

#include <pointmill/finish/cl_surface.h>

using namespace link_test;

namespace {

constexpr Rectangle kArea{0, 0, 24, 18};
const Stock kBlock{{0, 0, -1}, {24, 18, 7}};
constexpr double kClearance = 20, kApproach = 1, kAllowance = 0.1;

struct Lifting : ::testing::Test {
  LinkPasses linker;
  Cutting cutting;
  const Tool tool = Tool::ball(1, 3);
  const Cloud::Ptr cloud = surface(kArea, 0.3, Bumps(kArea, 5.5, 7, 51));
  const std::shared_ptr<const PointIndex> index = indexOf(*cloud);
  CLCloud rows;

  Lifting()
  {
    cutting.feed = 900;
    cutting.plunge_feed = 200;
    linker.setTool(tool);
    linker.setCutting(cutting);
    linker.setClearancePlane(kClearance);
    linker.setApproach(kApproach);
    linker.setPart(index, kAllowance, -0.5);
    renew();
    CLSurface<pcl::PointXYZ> stage;
    stage.setTool(tool);
    stage.setStepOver(1.5);
    stage.setForwardStep(0.5);
    stage.setAllowance(kAllowance);
    stage.setInputCloud(cloud);
    CLCloud all;
    stage.filter(all);
    // Short passes, each far from the next, so that there is much to link.
    const std::size_t pieces = all.size() / 6;
    for (std::size_t k = 0; k < pieces; k += 3)
      for (std::size_t i = 0; i < 6; ++i) {
        rows.push_back(all[k * 7 % pieces * 6 + i]);
        rows.back().label = static_cast<std::uint32_t>(k);
      }
  }
  void renew()
  {
    linker.setStock(fieldOf(kBlock));
    linker.setNominalStock(
        std::make_shared<StockField>(kBlock, 0.25, StockField::Bound::Nominal));
  }
  double report(const char* name) const { return linker.getReport().get(name); }
  PathFigures figures(const CLCloud& path) const
  {
    return measurePath(path, linker.getRapidRate(), linker.getCutFigures());
  }
};

/// Calls leg(a, b) for what a dog-legging machine may do: all at once, X first or Y
/// first.
template <typename Leg>
void forLegs(const Eigen::Vector3d& a, const Eigen::Vector3d& b, Leg&& leg)
{
  const Eigen::Vector3d x_first(b.x(), a.y(), a.z()), y_first(a.x(), b.y(), a.z());
  leg(a, b);
  for (const auto& corner : {x_first, y_first}) {
    leg(a, corner);
    leg(corner, b);
  }
}

} // namespace

TEST_F(Lifting, NoRapidMeetsStockOrPartHoweverTheAxesMove)
{
  linker.setLowRapids(true);
  linker.setStayDown(4);
  linker.setRapidRate(1500);
  const auto path = link(linker, rows);
  Heap heap(kBlock, 0.3);
  int low = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector3d a = position(path[i - 1]), b = position(path[i]);
    if (!isRapid(path[i])) {
      heap.cut(tool, a, b);
      continue;
    }
    const bool sideways = (b - a).head<2>().norm() > 0;
    if (sideways) {
      ASSERT_EQ(a.z(), b.z()) << "a slanted rapid at " << i;
    }
    low += sideways && b.z() < kClearance;
    // The approach above all that stands, but straight up from a cut.
    const Eigen::Vector3d margin(
        0, 0, sideways || b.z() < a.z() ? kApproach - 0.051 : 0.0);
    forLegs(a, b, [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
      EXPECT_LE(heap.cut(tool, from - margin, to - margin), 1e-6) << i;
      if (sideways) {
        EXPECT_GE(from.z() - margin.z(),
                  index->dropAlong(tool, from.x(), from.y(), to.x(), to.y()));
      }
    });
  }
  EXPECT_GT(low, 10);
}

TEST_F(Lifting, WaysAtFeedKeepTheApproachAboveStockAndPart)
{
  linker.setRapidRate(600); // slow, so that there are many
  const auto path = link(linker, rows);
  EXPECT_GT(report("lifts"), 10);
  EXPECT_EQ(report("links"), 0);
  Heap heap(kBlock, 0.3);
  const Eigen::Vector3d margin(0, 0, kApproach - 1e-4);
  int ways = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector3d a = position(path[i - 1]), b = position(path[i]);
    if (isRapid(path[i])) {
      EXPECT_TRUE((b - a).head<2>().norm() == 0 || b.z() == kClearance) << i;
      continue;
    }
    if (path[i].getMotion() == Motion::Link) {
      ++ways;
      EXPECT_EQ(a.z(), b.z());
      EXPECT_FLOAT_EQ(path[i].feed, 900);
      EXPECT_LE(heap.cut(tool, a - margin, b - margin), 1e-6) << i;
      EXPECT_GE(b.z() - margin.z(),
                index->dropAlong(tool.grown(kAllowance), a.x(), a.y(), b.x(), b.y()) +
                    kAllowance);
    }
    heap.cut(tool, a, b);
  }
  EXPECT_EQ(ways, report("lifts"));
}

TEST_F(Lifting, TakesFewerRetractsAndNoMoreTimeThanThePlaneAlone)
{
  // Without the part nothing is proven clear: all ways lead over the plane. Entries
  // from outside need it too, so the passes lie in the air here.
  CLCloud passes = rows;
  for (auto& p : passes)
    p.z += 7.5f;
  for (const double rate : {500.0, 5000.0, 20000.0})
    for (const bool low : {false, true}) {
      linker.setRapidRate(rate);
      linker.setLowRapids(low);
      linker.setPart(nullptr, kAllowance, -0.5);
      linker.setStayDown(0);
      const auto plane = figures(link(linker, passes));
      linker.setPart(index, kAllowance, -0.5);
      const auto lifted = figures(link(linker, passes));
      linker.setStayDown(6);
      const auto linked = figures(link(linker, passes));
      EXPECT_LE(lifted.retracts, plane.retracts);
      if (low || rate < 1000) {
        EXPECT_LT(lifted.retracts, plane.retracts / 2);
      }
      EXPECT_LE(linked.retracts, lifted.retracts);
      EXPECT_LE(lifted.minutes, plane.minutes + 1e-6) << rate << low;
      EXPECT_LE(linked.minutes, lifted.minutes + 1e-6) << rate << low;
    }
}

TEST_F(Lifting, ALowRapidMindsTheCornersOfItsBox)
{
  // A tower stands in the corner of the box between two passes, far from the line.
  const auto towers = surface(kArea, 0.3, [](double x, double y) {
    return x > 17 && x < 19 && y > 3 && y < 5 ? 7.0 : 0.0;
  });
  linker.setPart(indexOf(*towers), kAllowance, -0.5);
  linker.setStock(std::make_shared<StockField>(
      Stock{{0, 0, -1}, {24, 18, 0.2}}, 0.25, StockField::Bound::Upper));
  linker.setNominalStock(nullptr);
  linker.setLowRapids(true);
  CLCloud passes;
  addPass(passes, 0, {{3, 4, 1}, {5, 4, 1}});
  addPass(passes, 1, {{18, 14, 1}, {20, 14, 1}});
  const auto lowest = [&] { // of the sideways rapids
    double z = kClearance;
    const auto path = link(linker, passes);
    for (std::size_t i = 1; i < path.size(); ++i)
      if (isRapid(path[i]) &&
          (position(path[i]) - position(path[i - 1])).head<2>().norm() > 0)
        z = std::min<double>(z, path[i].z);
    return z;
  };
  EXPECT_NEAR(lowest(), 8, 1e-6); // the tower and the approach
  linker.setPart(indexOf(*surface(kArea, 0.3, [](double, double) { return 0.0; })),
                 kAllowance,
                 -0.5);
  EXPECT_NEAR(lowest(), 2, 1e-6); // from the passes themselves, with the approach
  linker.setKeepOut(KeepOut({KeepOutZone::cylinder(18, 4, 0.5, 8)}, 1.0));
  EXPECT_NEAR(lowest(), 10, 1e-6);
}

TEST_F(Lifting, RapidsStayOnThePlaneUnlessAllowedBelow)
{
  const auto path = link(linker, rows);
  for (std::size_t i = 1; i < path.size(); ++i)
    if (isRapid(path[i]) &&
        (position(path[i]) - position(path[i - 1])).head<2>().norm() > 0) {
      EXPECT_EQ(path[i].z, float(kClearance)) << i;
    }
}
