// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// How long it takes to verify an hour of finishing: 500,000 moves of a cutter over a
// freeform part of 100 x 100 mm with a million points, the stock in cells of 0.1 mm.
//   bench_verify [options of Google Benchmark]
#include <pointmill/verify/program_verifier.h>
#include <pointmill_test/freeform.h>

#include <benchmark/benchmark.h>

#include <memory>

namespace {

using namespace pointmill;
using pointmill_test::Freeform;

constexpr double kEdge = 100, kStepOver = 0.2, kChord = 0.1;
constexpr int kRows = 500, kMovesPerRow = 1000;

std::shared_ptr<const PointIndex> part()
{
  static const auto index = [] {
    const auto cloud = Freeform::sample(1000000, kEdge, 0.0, 1);
    return std::make_shared<const PointIndex>(
        std::vector<PointSource>{pointSource(*cloud)});
  }();
  return index;
}

/// Rows forth and back, the tool resting on the points.
Program raster(const Tool& tool)
{
  Program program;
  program.blend = 0;
  program.ended = true;
  std::vector<Contact> contacts(kMovesPerRow + 1);
  Eigen::Vector3d at(0, 0, 30);
  const auto go = [&](const Eigen::Vector3d& to, bool rapid) {
    const std::size_t line = program.moves.size() + 1;
    program.moves.push_back(
        {at, to, rapid ? 0.0 : 833.0, 8000.0, line, tool.number, rapid, true, true});
    at = to;
  };
  for (int row = 0; row < kRows; ++row) {
    const double y = (row + 0.5) * kStepOver, sign = row % 2 ? -1 : 1;
    const double x0 = row % 2 ? kEdge : 0;
    part()->dropRow(
        tool, {x0, y}, {sign * kChord, 0}, contacts.size(), contacts.data());
    for (std::size_t i = 0; i < contacts.size(); ++i)
      if (row > 0 || i > 0)
        go({x0 + sign * kChord * double(i), y, contacts[i].tip}, false);
      else
        go({x0, y, 20}, true), go({x0, y, contacts[i].tip}, false);
  }
  go({at.x(), at.y(), 30}, true);
  return program;
}

void verify(benchmark::State& state, const Tool& tool, unsigned threads)
{
  const Program program = raster(tool);
  ProgramVerifier verifier;
  verifier.setPart(part());
  verifier.setStock({{0, 0, 0}, {kEdge, kEdge, 18}});
  verifier.setTools({tool});
  verifier.setCellSize(0.1);
  verifier.setNumberOfThreads(threads);
  Verification result;
  for (auto _ : state)
    result = verifier.verify(program);
  state.counters["moves"] = double(program.moves.size());
  state.counters["gouge_um"] = 1e3 * result.gouge;
  state.counters["residual_p99_um"] = 1e3 * result.residual.p99;
}

void add(const char* name, const Tool& tool, unsigned threads)
{
  benchmark::RegisterBenchmark(
      name, [=](benchmark::State& state) { verify(state, tool, threads); })
      ->Unit(benchmark::kSecond)
      ->Iterations(1)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
}

} // namespace

int main(int argc, char** argv)
{
  add("verify/ball_6/threads_2", Tool::ball(1, 6), 2);
  add("verify/ball_6/threads_1", Tool::ball(1, 6), 1);
  add("verify/bull_6/threads_2", Tool::bull(1, 6, 1), 2);
  add("verify/taper_ball_1/threads_2", Tool::taperBall(1, 1, 5, 6), 2);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
}
