// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// How long planning a roughing operation takes: one layer, a large plate, and a scan of
// ten million points. Names are CASE/STRATEGY.
#include "rough_job.h"
#include "strategies.h"

#include <pointmill_test/freeform.h>

#include <benchmark/benchmark.h>

#include <string>

using namespace pointmill;
using bench::RoughJob;
using bench::RoughOptions;
using bench::Standing;

namespace {

constexpr std::size_t kScan = 10'000'000;
constexpr double kScanEdge = 100; ///< mm

/// A job that is made when it is first asked for: it takes longer than what is timed.
using MakeJob = RoughJob (*)();

/// 60 x 60 cells of 1 mm, cut on one level.
RoughJob layerJob()
{
  RoughOptions o;
  o.tool = Tool::flat(1, 4.0);
  o.allowance = 0.2;
  o.cell = 1.0;
  o.step_down = 1.0;
  o.step_over = 1.6;
  RoughJob job(bench::sample(bench::layerPart(), 0.25), bench::layerPart().margin, o);
  job.floor = 0.5; // half way up
  return job;
}

/// 160 x 150 x 29 mm in cells of 0.5 mm, on the levels of paper 001.
RoughJob plateJob()
{
  RoughOptions o;
  o.step_down = 0.75;
  return {bench::sample(bench::largePlate(), 0.2), bench::largePlate().margin, o};
}

/// 40 levels, 20 mm deep, of the other benchmarks' free-form surface.
RoughJob scanJob()
{
  const auto points = pointmill_test::Freeform::sample(kScan, kScanEdge, 0.0, 7);
  RoughOptions o;
  o.step_down = 0.5;
  RoughJob job(points, 0.0, o);
  job.stock.max.z() = job.floor + 20;
  return job;
}

const RoughJob& jobOf(MakeJob make)
{
  static MakeJob made = nullptr;
  static std::unique_ptr<RoughJob> job;
  if (made != make) {
    job.reset(); // never two of them in memory
    job = std::make_unique<RoughJob>(make());
    made = make;
  }
  return *job;
}

double lengthOf(const CLCloud& passes)
{
  double length = 0;
  for (std::size_t i = 1; i < passes.size(); ++i)
    if (passes[i].label == passes[i - 1].label)
      length += (passes[i].getVector3fMap() - passes[i - 1].getVector3fMap()).norm();
  return length;
}

void plan(benchmark::State& state, const bench::Strategy& strategy, MakeJob make)
{
  const RoughJob& job = jobOf(make);
  const Standing standing(job);
  const auto roughing = strategy.make();
  CLCloud passes;
  for (auto _ : state)
    passes = bench::planPasses(*roughing, job, standing);
  state.counters["cells"] = static_cast<double>(job.map->size());
  state.counters["levels"] = roughing->getReport().get("levels");
  state.counters["cl_points"] = static_cast<double>(passes.size());
  state.counters["cut_mm"] = lengthOf(passes);
}

} // namespace

int main(int argc, char** argv)
{
  const std::pair<const char*, MakeJob> cases[] = {
      {"layer", layerJob}, {"plate", plateJob}, {"scan", scanJob}};
  for (const auto& [name, make] : cases)
    for (const auto& strategy : bench::kStrategies)
      benchmark::RegisterBenchmark((std::string(name) + "/" + strategy.name).c_str(),
                                   [&strategy, job = make](benchmark::State& state) {
                                     plan(state, strategy, job);
                                   })
          ->UseRealTime()
          ->MeasureProcessCPUTime()
          ->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
