// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// How long it takes to drop a ball end mill onto a freeform, three ways that give the
// same heights: every point asked, one radius query of a kd-tree, PointIndex.
#include <pointmill/surface/point_index.h>

#include <pointmill_test/random.h>

#include <benchmark/benchmark.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>
#include <map>
#include <memory>
#include <vector>

namespace {

using pointmill::PointIndex;
using pointmill::Tool;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double kEdge = 100; // of the freeform [mm]
constexpr int kPlaces = 16;   // CL points along each edge
const Tool kBall = Tool::ball(1, 3.0);

/// `count` random points of the freeform.
Cloud::Ptr makeFreeform(std::size_t count)
{
  pointmill_test::Random random(7);
  Cloud::Ptr cloud(new Cloud);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.uniform(0, kEdge), y = random.uniform(0, kEdge);
    const double z =
        10 + 4 * std::sin(x / 9) * std::cos(y / 11) + 2 * std::sin(x / 4 + y / 6);
    cloud->push_back({float(x), float(y), float(z)});
  }
  return cloud;
}

/// Of each size one cloud for all benchmarks.
Cloud::ConstPtr freeform(std::size_t count)
{
  static std::map<std::size_t, Cloud::ConstPtr> clouds;
  auto& cloud = clouds[count];
  if (!cloud)
    cloud = makeFreeform(count);
  return cloud;
}

class BruteForce {
public:
  explicit BruteForce(const Cloud::ConstPtr& cloud) : cloud_(cloud) {}
  double drop(double x, double y)
  {
    double tip = -std::numeric_limits<double>::infinity();
    for (const auto& p : *cloud_) {
      const double dx = p.x - x, dy = p.y - y, d2 = dx * dx + dy * dy;
      if (d2 <= kBall.radius() * kBall.radius())
        tip = std::max(tip, p.z - kBall.profile(std::sqrt(d2)));
    }
    return tip;
  }

private:
  Cloud::ConstPtr cloud_;
};

/// Points as a kd-tree is to see them that is asked what lies under a cutter.
class WithoutHeight : public pcl::PointRepresentation<pcl::PointXYZ> {
public:
  WithoutHeight() { nr_dimensions_ = 2; }
  void copyToFloatArray(const pcl::PointXYZ& p, float* out) const override
  {
    out[0] = p.x;
    out[1] = p.y;
  }
};

class KdTree {
public:
  explicit KdTree(const Cloud::ConstPtr& cloud) : cloud_(cloud), tree_(false)
  {
    tree_.setPointRepresentation(
        pcl::PointRepresentation<pcl::PointXYZ>::ConstPtr(new WithoutHeight));
    tree_.setInputCloud(cloud);
  }
  double drop(double x, double y)
  {
    // A hair wider, since the tree measures in float; profile() then decides.
    tree_.radiusSearch(pcl::PointXYZ(float(x), float(y), 0.f),
                       kBall.radius() + 1e-4,
                       found_,
                       distances_);
    double tip = -std::numeric_limits<double>::infinity();
    for (const auto i : found_) {
      const auto& p = (*cloud_)[i];
      tip = std::max(tip, p.z - kBall.profile(std::hypot(p.x - x, p.y - y)));
    }
    return tip;
  }

private:
  Cloud::ConstPtr cloud_;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree_; // its results not sorted
  pcl::Indices found_;
  std::vector<float> distances_;
};

class Index {
public:
  explicit Index(const Cloud::ConstPtr& cloud) : index_(make(*cloud)) {}
  double drop(double x, double y) { return index_.drop(kBall, x, y).tip; }

private:
  static PointIndex make(const Cloud& cloud)
  {
    std::vector<float> x, y, z;
    for (const auto& p : cloud) {
      x.push_back(p.x);
      y.push_back(p.y);
      z.push_back(p.z);
    }
    return PointIndex(std::move(x), std::move(y), std::move(z));
  }
  PointIndex index_;
};

double place(int i)
{
  return kEdge * (i + 0.5) / kPlaces;
}

/// One iteration is one CL point; range 0 is the number of points.
template <typename Method>
void drop(benchmark::State& state)
{
  const auto cloud = freeform(static_cast<std::size_t>(state.range(0)));
  Method method(cloud);
  BruteForce truth(cloud);
  for (const int i : {0, 5, kPlaces - 1})
    if (std::abs(method.drop(place(i), place(i / 2)) -
                 truth.drop(place(i), place(i / 2))) > 1e-6)
      state.SkipWithError("the heights differ from brute force");
  int at = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(method.drop(place(at % kPlaces), place(at / kPlaces)));
    at = (at + 1) % (kPlaces * kPlaces);
  }
  state.SetItemsProcessed(state.iterations());
}

/// What has to be done once before the first drop.
template <typename Method>
void build(benchmark::State& state)
{
  const auto cloud = freeform(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state)
    benchmark::DoNotOptimize(std::make_unique<Method>(cloud));
}

constexpr int kFew = 100'000, kMany = 1'000'000;

BENCHMARK_TEMPLATE(drop, BruteForce)
    ->Arg(kFew)
    ->Arg(kMany)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(drop, KdTree)->Arg(kFew)->Arg(kMany)->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(drop, Index)->Arg(kFew)->Arg(kMany)->Unit(benchmark::kMicrosecond);
BENCHMARK_TEMPLATE(build, KdTree)->Arg(kFew)->Arg(kMany)->Unit(benchmark::kMillisecond);
BENCHMARK_TEMPLATE(build, Index)->Arg(kFew)->Arg(kMany)->Unit(benchmark::kMillisecond);

} // namespace
