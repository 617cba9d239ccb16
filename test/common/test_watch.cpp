// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Progress, and stopping what takes long.
#include <pointmill/common/parallel.h>
#include <pointmill/common/point_types.h>
#include <pointmill/common/stage.h>
#include <pointmill/common/tour.h>
#include <pointmill/common/watch.h>

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

using namespace pointmill;

namespace {

/// Notes each share that the watched thread comes to.
class Shares {
public:
  explicit Shares(const Watch& watch) : watch_(watch) {}
  void note() { seen_.push_back(watch_.share()); }
  const std::vector<double>& seen() const { return seen_; }

private:
  const Watch& watch_;
  std::vector<double> seen_;
};

/// Copies its points, in many bodies, and calls `each` in every one.
class Copy : public Stage<pcl::PointXYZ, pcl::PointXYZ> {
public:
  explicit Copy(std::function<void(std::size_t)> each)
      : Stage("Copy"), each_(std::move(each))
  {
  }

private:
  void checkParameters() const override {}
  void apply(Output& output) override
  {
    output = *input_;
    parallelFor(output.size(), 2, {0.0, 1.0}, each_);
  }
  std::function<void(std::size_t)> each_;
};

pcl::PointCloud<pcl::PointXYZ>::Ptr points(int count)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (int i = 0; i < count; ++i)
    cloud->push_back({float(i), 0, 0});
  return cloud;
}

} // namespace

TEST(Watch, StepsDivideTheStepsAroundThem)
{
  const Watch watch;
  Shares shares(watch);
  EXPECT_EQ(watch.share(), 0);
  {
    const WorkStep half({0.0, 0.5});
    half.reach(0.5);
    shares.note();
    {
      const WorkStep of_it("inner", {0.6, 0.8});
      of_it.reach(0.5);
      shares.note();
    }
    shares.note();
  }
  shares.note();
  const std::vector<double> expected{0.25, 0.35, 0.4, 0.5};
  ASSERT_EQ(shares.seen().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(shares.seen()[i], expected[i], 1e-12);
  EXPECT_EQ(watch.stage(), "inner");
}

TEST(Watch, SharesNeverShrink)
{
  const Watch watch;
  const WorkStep all({0.0, 1.0});
  all.reach(0.7);
  all.reach(0.2);
  EXPECT_DOUBLE_EQ(watch.share(), 0.7);
  {
    const WorkStep again({0.0, 0.5});
  }
  EXPECT_DOUBLE_EQ(watch.share(), 0.7);
}

TEST(Watch, WithoutOneStepsDoNothing)
{
  const WorkStep step("nobody hears", {0.0, 1.0});
  EXPECT_NO_THROW(step.reach(0.5));
  EXPECT_NO_THROW(checkInterrupted());
}

TEST(Watch, StopsItsThreadOnlyAndUntilItIsDestroyed)
{
  {
    Watch watch;
    EXPECT_NO_THROW(checkInterrupted());
    watch.stop();
    EXPECT_THROW(checkInterrupted(), Interrupted);
    EXPECT_THROW(WorkStep({0.0, 1.0}), Interrupted);
    std::thread other([] { EXPECT_NO_THROW(checkInterrupted()); });
    other.join();
    {
      const Watch inner;
      EXPECT_NO_THROW(checkInterrupted());
    }
    EXPECT_THROW(checkInterrupted(), Interrupted);
  }
  EXPECT_NO_THROW(checkInterrupted());
}

TEST(Watch, AnExceptionIsNoProgress)
{
  const Watch watch;
  try {
    const WorkStep step({0.0, 1.0});
    step.reach(0.25);
    throw DataError("");
  }
  catch (const DataError&) {
  }
  EXPECT_DOUBLE_EQ(watch.share(), 0.25);
}

TEST(Watch, ParallelForTellsHowFarItIs)
{
  for (const unsigned threads : {1u, 2u, 5u}) {
    const Watch watch;
    std::mutex one_at_a_time;
    std::vector<double> seen;
    parallelFor(1000, threads, {0.2, 0.8}, [&](std::size_t) {
      const std::lock_guard<std::mutex> lock(one_at_a_time);
      seen.push_back(watch.share());
    });
    ASSERT_EQ(seen.size(), 1000u);
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end())) << threads << " threads";
    EXPECT_GE(seen.front(), 0.2);
    EXPECT_LE(seen.back(), 0.8);
    // The caller tells, which in so short a loop may have had nothing to do.
    if (threads == 1) {
      EXPECT_GT(seen.back(), seen.front());
    }
    EXPECT_DOUBLE_EQ(watch.share(), 0.8);
  }
}

TEST(Watch, ParallelForIsSilentWhereItWasGivenNoShare)
{
  const Watch watch;
  parallelFor(100, 2, [](std::size_t) {
    const WorkStep step({0.0, 1.0});
    step.reach(0.5);
  });
  EXPECT_EQ(watch.share(), 0);
}

TEST(Watch, StopsEveryThreadOfParallelFor)
{
  for (const unsigned threads : {1u, 2u, 5u}) {
    Watch watch;
    std::atomic<std::size_t> calls{0};
    EXPECT_THROW(parallelFor(100000,
                             threads,
                             [&](std::size_t) {
                               if (++calls == 10)
                                 watch.stop();
                             }),
                 Interrupted);
    EXPECT_LT(calls, 10u + threads) << threads << " threads";
  }
}

TEST(Watch, StopsLoopsWithinBodies)
{
  Watch watch;
  EXPECT_THROW(parallelFor(2,
                           2,
                           [&](std::size_t i) {
                             if (i == 0)
                               watch.stop();
                             for (;;) // for ever, were it not stopped
                               checkInterrupted();
                           }),
               Interrupted);
}

TEST(Watch, AStageThatIsStoppedLeavesItsOutput)
{
  Watch watch;
  Copy copy([&](std::size_t i) {
    if (i == 50)
      watch.stop();
  });
  copy.setInputCloud(points(100));
  pcl::PointCloud<pcl::PointXYZ> output = *points(3);
  EXPECT_THROW(copy.filter(output), Interrupted);
  EXPECT_EQ(output.size(), 3u);
  EXPECT_EQ(output[2].x, 2.f);
}

TEST(Watch, AStageEndsAtItsShare)
{
  const Watch watch;
  Copy copy([](std::size_t) {});
  copy.setInputCloud(points(100));
  pcl::PointCloud<pcl::PointXYZ> output;
  copy.filter(output);
  EXPECT_DOUBLE_EQ(watch.share(), 1);
}

TEST(Watch, AChainDividesItsShareAmongItsStages)
{
  const Watch watch;
  double before = -1, after = -1;
  Copy first([](std::size_t) {});
  Copy second([&](std::size_t i) {
    if (i == 0)
      before = watch.share();
    if (i == 99)
      after = watch.share();
  });
  const auto cloud = points(100);
  run(cloud, first, second);
  EXPECT_GE(before, 0.5);
  EXPECT_LE(after, 1);
  EXPECT_DOUBLE_EQ(watch.share(), 1);
}

TEST(Watch, StopsATour)
{
  Watch watch;
  std::vector<TourItem> items;
  for (int i = 0; i < 200; ++i)
    items.push_back({{{double(i * 37 % 200), 0.0}, {double(i * 37 % 200), 1.0}}});
  int asked = 0;
  const TourCost cost = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    if (++asked == 100)
      watch.stop();
    return (a - b).norm();
  };
  EXPECT_THROW(shortTour(items, TourStart::Any, cost), Interrupted);
}
