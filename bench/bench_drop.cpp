// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// How long it takes to drop a ball end mill at 333,000 places onto a scan, by several
// routes, and how far the heights are from those on the true surface.
//   bench_drop [--points=1e5,1e6,1e7] [options of Google Benchmark]
#include "surfaces.h"

#include <pointmill/common/parallel.h>
#include <pointmill/surface/point_index.h>
#include <pointmill/surface/surface_model.h>

#include <benchmark/benchmark.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace {

using bench::Cloud;
using bench::Surface;
using pointmill::Contact;
using pointmill::PointIndex;
using pointmill::Tool;

const Tool kBall = Tool::ball(1, 2 * bench::kBall);
constexpr std::size_t kPlaces = std::size_t(bench::kRows) * bench::kColumns;
constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// The last cloud that was asked for; the benchmarks are sorted by cloud.
Cloud::ConstPtr cloudOf(const Surface& surface, std::size_t count)
{
  static const Surface* of = nullptr;
  static Cloud::ConstPtr cloud;
  if (of != &surface || cloud->size() != count) {
    cloud.reset();
    cloud = bench::makeCloud(surface, count);
    of = &surface;
  }
  return cloud;
}

const std::vector<double>& truthOf(const Surface& surface)
{
  static const Surface* of = nullptr;
  static std::vector<double> tips;
  if (of != &surface)
    tips = bench::truth(surface);
  of = &surface;
  return tips;
}

double now()
{
  const auto t = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(t).count();
}

/// Most memory that the program has had since the last call [GiB], where Linux says so.
double peakMemory()
{
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0;
  while (status >> word)
    if (word == "VmHWM:")
      status >> kilobytes;
  std::ofstream("/proc/self/clear_refs") << 5;
  return kilobytes / (1024 * 1024);
}

/// Differences from the truth [um]; the mean is what the ball sinks by.
void countErrors(benchmark::State& state,
                 const std::vector<double>& tips,
                 const std::vector<double>& truth)
{
  std::vector<double> errors;
  double squares = 0, sum = 0;
  for (std::size_t i = 0; i < tips.size(); ++i) {
    const double error = 1e3 * (tips[i] - truth[i]);
    if (std::isnan(truth[i]))
      continue;
    errors.push_back(std::abs(error));
    squares += error * error;
    sum += error;
  }
  std::sort(errors.begin(), errors.end());
  const auto count = static_cast<double>(errors.size());
  state.counters["rms_um"] = std::sqrt(squares / count);
  state.counters["p99_um"] = errors[static_cast<std::size_t>(0.99 * count)];
  state.counters["max_um"] = errors.back();
  state.counters["mean_um"] = sum / count;
}

// --- The engine: all places, by rows, on several threads.

/// What gives rows of resting heights: anything with PointIndex's dropRow(). Another
/// route needs a function like these, a line in addAll() and one in bench_report.py.
PointIndex barePoints(const Cloud& cloud, unsigned threads)
{
  return PointIndex({pointmill::pointSource(cloud)}, threads);
}

pointmill::SurfaceModel smoothSurface(const Cloud& cloud, unsigned threads)
{
  return {std::make_shared<PointIndex>(barePoints(cloud, threads)),
          pointmill::SmoothSurface()};
}

template <typename Make>
void engine(benchmark::State& state,
            const Surface& surface,
            std::size_t count,
            unsigned threads,
            Make make)
{
  const auto cloud = cloudOf(surface, count);
  std::vector<double> tips(kPlaces);
  double index_seconds = 1e300, drop_seconds = 1e300, seconds = 1e300;
  peakMemory();
  for (auto _ : state) {
    const double start = now();
    const auto model = make(*cloud, threads);
    const double indexed = now();
    pointmill::parallelFor(bench::kRows, threads, [&](std::size_t row) {
      Contact contacts[bench::kColumns];
      model.dropRow(kBall,
                    {bench::placeX(0), bench::placeY(int(row))},
                    {bench::kStepX, 0},
                    bench::kColumns,
                    contacts);
      for (int i = 0; i < bench::kColumns; ++i)
        tips[row * bench::kColumns + i] = contacts[i].tip;
    });
    const double done = now();
    index_seconds = std::min(index_seconds, indexed - start);
    drop_seconds = std::min(drop_seconds, done - indexed);
    seconds = std::min(seconds, done - start);
    state.SetIterationTime(done - start);
  }
  state.counters["seconds"] = seconds;
  state.counters["index_s"] = index_seconds;
  state.counters["drop_s"] = drop_seconds;
  state.counters["memory_GiB"] = peakMemory();
  countErrors(state, tips, truthOf(surface));
}

// --- The others: some of the places, one by one.

class BruteForce {
public:
  explicit BruteForce(const Cloud::ConstPtr& cloud) : cloud_(cloud) {}
  double drop(double x, double y)
  {
    double tip = kNothing;
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

/// One radius query for each place.
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
    double tip = kNothing;
    for (const auto i : found_) {
      const auto& p = (*cloud_)[i];
      tip = std::max(tip, p.z - kBall.profile(std::hypot(p.x - x, p.y - y)));
    }
    return tip;
  }

private:
  Cloud::ConstPtr cloud_;
  pcl::search::KdTree<pcl::PointXYZ> tree_; // its results not sorted
  pcl::Indices found_;
  std::vector<float> distances_;
};

/// PointIndex asked for single places in no order.
class SingleDrops {
public:
  explicit SingleDrops(const Cloud::ConstPtr& cloud) : index_(barePoints(*cloud, 0)) {}
  double drop(double x, double y) { return index_.drop(kBall, x, y).tip; }

private:
  PointIndex index_;
};

/// Builds once, drops at `places` places that are spread over the surface, and says
/// what all 333,000 would take.
template <typename Route>
void oneByOne(benchmark::State& state,
              const Surface& surface,
              std::size_t count,
              std::size_t places)
{
  const auto cloud = cloudOf(surface, count);
  double drop_seconds = 1e300, index_seconds = 1e300;
  std::vector<Eigen::Vector2d> at;
  std::vector<double> tips, truth;
  for (std::size_t k = 0; k < places; ++k) {
    const std::size_t i = k * 104729 % kPlaces; // a prime number
    at.emplace_back(bench::placeX(int(i % bench::kColumns)),
                    bench::placeY(int(i / bench::kColumns)));
    truth.push_back(surface.tip(at.back().x(), at.back().y()));
  }
  peakMemory();
  for (auto _ : state) {
    tips.clear();
    const double start = now();
    Route route(cloud);
    const double built = now();
    for (const auto& p : at)
      tips.push_back(route.drop(p.x(), p.y()));
    const double done = now();
    index_seconds = std::min(index_seconds, built - start);
    drop_seconds =
        std::min(drop_seconds, (done - built) / double(places) * double(kPlaces));
    state.SetIterationTime(index_seconds + drop_seconds);
  }
  state.counters["seconds"] = index_seconds + drop_seconds;
  state.counters["index_s"] = index_seconds;
  state.counters["drop_s"] = drop_seconds;
  state.counters["memory_GiB"] = peakMemory();
  countErrors(state, tips, truth);
}

/// Chords of 0.1 mm along a row that rests on the points, each tried for gouges: what
/// the certification of a finishing pass asks.
void chords(benchmark::State& state, const Surface& surface, std::size_t count)
{
  const auto cloud = cloudOf(surface, count);
  const PointIndex index = barePoints(*cloud, 0);
  std::vector<Contact> row(bench::kColumns);
  index.dropRow(
      kBall, {bench::placeX(0), 50}, {bench::kStepX, 0}, row.size(), row.data());
  std::size_t i = 1;
  for (auto _ : state) {
    const Eigen::Vector3d a(bench::placeX(int(i) - 1), 50, row[i - 1].tip),
        b(bench::placeX(int(i)), 50, row[i].tip);
    benchmark::DoNotOptimize(index.gouge(kBall, a, b, 0.01));
    i = i + 1 < row.size() ? i + 1 : 1;
  }
}

std::vector<std::size_t> sizes(const std::string& list)
{
  std::vector<std::size_t> all;
  std::istringstream in(list);
  for (std::string one; std::getline(in, one, ',');)
    all.push_back(static_cast<std::size_t>(std::stod(one)));
  return all;
}

template <typename Run>
benchmark::internal::Benchmark*
add(const std::string& route, const Surface& surface, std::size_t count, Run run)
{
  std::ostringstream name;
  name << route << "/" << surface.name << "/" << double(count);
  return benchmark::RegisterBenchmark(
             name.str().c_str(),
             [=, &surface](benchmark::State& state) { run(state, surface, count); })
      ->Unit(benchmark::kMillisecond);
}

template <typename Make>
void addEngine(const std::string& route,
               const Surface& surface,
               std::size_t count,
               unsigned threads,
               Make make)
{
  const auto run = [=](auto& state, const Surface& s, std::size_t n) {
    engine(state, s, n, threads, make);
  };
  add(route + "_" + std::to_string(threads), surface, count, run)->UseManualTime();
}

template <typename Route>
void addOneByOne(const std::string& route,
                 const Surface& surface,
                 std::size_t count,
                 std::size_t places)
{
  const auto run = [=](auto& state, const Surface& s, std::size_t n) {
    oneByOne<Route>(state, s, n, places);
  };
  add(route, surface, count, run)->UseManualTime()->Iterations(1);
}

void addAll(std::size_t count)
{
  for (unsigned threads : {1u, 2u})
    addEngine("points", bench::kFreeform, count, threads, barePoints);
  if (count <= 10'000'000)
    addEngine("smooth", bench::kFreeform, count, 2, smoothSurface);
  add("chord", bench::kFreeform, count, chords)->Unit(benchmark::kNanosecond);
  addOneByOne<SingleDrops>("single_drops", bench::kFreeform, count, 20000);
  if (count <= 10'000'000) {
    addOneByOne<KdTree>("kd_tree", bench::kFreeform, count, 500);
    addOneByOne<BruteForce>("brute_force", bench::kFreeform, count, 20);
    addEngine("points", bench::kHemisphere, count, 2, barePoints);
    addEngine("points", bench::kLevel, count, 2, barePoints);
  }
}

} // namespace

int main(int argc, char** argv)
{
  std::string points = "1e5,1e6,1e7";
  for (int i = 1; i < argc; ++i)
    if (const std::string arg = argv[i]; arg.rfind("--points=", 0) == 0) {
      points = arg.substr(9);
      std::rotate(argv + i, argv + i + 1, argv + argc);
      --argc;
    }
  for (const auto count : sizes(points))
    addAll(count);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
