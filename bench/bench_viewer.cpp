// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// How fluently the viewer shows a million CL points, and plays the cut: pictures per
// second of 1280 x 800 px, drawn off the screen on what OpenGL the machine has.
//   bench_viewer [options of Google Benchmark]
// Names are paths/POINTS/moving, paths/POINTS/still and play/MOVES.
#include <pointmill/viewer/viewer.h>
#include <pointmill_test/freeform.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace {

using namespace pointmill;
using pointmill_test::Freeform;

constexpr double kEdge = 100;
constexpr int kWidth = 1280, kHeight = 800, kPictures = 20;
const Stock kStock{{0, 0, 0}, {kEdge, kEdge, 18}};

/// Rows forth and back over the freeform, as many points in a row as there are rows.
CLCloud::Ptr raster(int rows)
{
  auto path = std::make_shared<CLCloud>();
  for (int row = 0; row < rows; ++row)
    for (int i = 0; i < rows; ++i) {
      const double x = kEdge * (row % 2 ? rows - 1 - i : i) / (rows - 1);
      const double y = kEdge * row / (rows - 1);
      PointCL p(x, y, Freeform::height(x, y), Motion::Cut);
      p.label = static_cast<std::uint32_t>(row);
      p.feed = 900;
      path->push_back(p);
    }
  return path;
}

ViewerScene sceneOf(const CLCloud::Ptr& path)
{
  ViewerScene scene;
  scene.title = "freeform";
  scene.stock = kStock;
  scene.path = path;
  scene.operations = {{"finishing", 0, 0, path->size()}};
  return scene;
}

void paths(benchmark::State& state, int rows, bool moving)
{
  ViewerLook look;
  look.paths = ViewedPaths::All;
  look.solid = ViewedSolid::None;
  look.colouring = PathColouring::Height;
  Viewer viewer(sceneOf(raster(rows)), look);
  double rate = 0;
  for (auto _ : state) {
    rate = viewer.framesPerSecond(kWidth, kHeight, kPictures, moving);
    state.SetIterationTime(1 / rate);
  }
  state.counters["points"] = double(rows) * rows;
  state.counters["per_s"] = rate;
}

void play(benchmark::State& state, int rows)
{
  const auto path = raster(rows);
  auto program = std::make_shared<Program>();
  std::vector<double> ends;
  for (std::size_t i = 1; i < path->size(); ++i) {
    ProgramMove move;
    move.from = (*path)[i - 1].getVector3fMap().cast<double>();
    move.to = (*path)[i].getVector3fMap().cast<double>();
    move.feed = 900;
    move.tool = 1;
    move.line = i;
    program->moves.push_back(move);
    ends.push_back((ends.empty() ? 0 : ends.back()) +
                   60 * (move.to - move.from).norm() / move.feed);
  }
  constexpr double cell = 0.25;
  ViewerScene scene = sceneOf(path);
  scene.player =
      std::make_shared<CutPlayer>(StockField(kStock, cell, StockField::Bound::Nominal),
                                  program,
                                  ends,
                                  std::vector<Tool>{Tool::ball(1, 6)});
  scene.sections = {{"finishing", 0}};
  ViewerLook look;
  look.paths = ViewedPaths::Trail;
  Viewer viewer(std::move(scene), look);
  double rate = 0;
  for (auto _ : state) {
    rate = viewer.playedPerSecond(kWidth, kHeight, kPictures);
    state.SetIterationTime(1 / rate);
  }
  state.counters["points"] = double(path->size());
  state.counters["per_s"] = rate;
}

template <typename Run>
void add(const std::string& name, Run run)
{
  benchmark::RegisterBenchmark(name.c_str(), run)
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1)
      ->UseManualTime();
}

} // namespace

int main(int argc, char** argv)
{
  using State = benchmark::State;
  for (const int rows : {316, 1000}) {
    const std::string points = std::to_string(rows * rows);
    add("paths/" + points + "/moving", [=](State& s) { paths(s, rows, true); });
    add("paths/" + points + "/still", [=](State& s) { paths(s, rows, false); });
    add("play/" + points + "/-", [=](State& s) { play(s, rows); });
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
}
