// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// How long it takes to verify an hour of finishing: 500,000 moves of a cutter over a
// freeform part of 100 x 100 mm with a million points, the stock in cells of 0.1 mm.
// What it takes to cut only the stock, exactly and by stamping the cutter. And what is
// found on level ground, where closed forms say what must be.
//   bench_verify [options of Google Benchmark]
// Names are verify/TOOL/THREADS, stock/TOOL/WAY and level/CASE.
#include <pointmill/surface/stock_field.h>
#include <pointmill/verify/program_verifier.h>
#include <pointmill_test/freeform.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using namespace pointmill;
using pointmill_test::Freeform;

constexpr double kEdge = 100, kStepOver = 0.2, kChord = 0.1, kCell = 0.1;
const Stock kStock{{0, 0, 0}, {kEdge, kEdge, 18}};
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
  verifier.setStock(kStock);
  verifier.setTools({tool});
  verifier.setCellSize(kCell);
  verifier.setNumberOfThreads(threads);
  Verification result;
  for (auto _ : state)
    result = verifier.verify(program);
  state.counters["moves"] = double(program.moves.size());
  state.counters["cells"] = std::pow(kEdge / kCell, 2);
  state.counters["gouge_um"] = 1e3 * result.gouge;
  state.counters["residual_p99_um"] = 1e3 * result.residual.p99;
}

/// The stock alone, on one thread: closed forms of swept cutters.
void sweep(const Program& program, const SweptCutter& cutter, StockField& field)
{
  for (const auto& move : program.moves)
    field.cut(cutter, move.from, move.to, 0, field.rows());
}

/// The same by stamping: the cutter stands at places half a cell apart, and lowers all
/// cells under it.
void stamp(const Program& program, const Tool& tool, StockField& field)
{
  const CutterProfile cutter = tool.profile();
  const double r2 = tool.radius() * tool.radius();
  const int columns = field.columns(), rows = field.rows();
  std::vector<float> height(std::size_t(columns) * rows, float(kStock.top()));
  const auto index = [](double v, int count) {
    return std::clamp(int(v / kCell), 0, count - 1);
  };
  for (const auto& move : program.moves) {
    const int stamps = std::max(
        1, int(std::ceil((move.to - move.from).head<2>().norm() / (kCell / 2))));
    for (int i = 1; i <= stamps; ++i) {
      const Eigen::Vector3d tip =
          move.from + double(i) / stamps * (move.to - move.from);
      const int row1 = index(tip.y() + tool.radius(), rows);
      const int column0 = index(tip.x() - tool.radius(), columns);
      const int column1 = index(tip.x() + tool.radius(), columns);
      for (int row = index(tip.y() - tool.radius(), rows); row <= row1; ++row) {
        const double dy = field.y(row) - tip.y();
        float* line = &height[std::size_t(row) * columns];
        for (int column = column0; column <= column1; ++column) {
          const double dx = field.x(column) - tip.x(), d2 = dx * dx + dy * dy;
          if (d2 <= r2)
            line[column] =
                std::min(line[column], float(tip.z() + cutter.height(std::sqrt(d2))));
        }
      }
    }
  }
  field.lowerTo([&](double x, double y) {
    return height[std::size_t(index(y, rows)) * columns + index(x, columns)];
  });
}

void cutStock(benchmark::State& state, const Tool& tool, bool stamped)
{
  const Program program = raster(tool);
  const SweptCutter cutter(tool);
  StockField field(kStock, kCell, StockField::Bound::Nominal);
  for (auto _ : state)
    stamped ? stamp(program, tool, field) : sweep(program, cutter, field);
  state.counters["moves"] = double(program.moves.size());
  if (!stamped)
    return;
  StockField exact(kStock, kCell, StockField::Bound::Nominal);
  sweep(program, cutter, exact);
  double left = 0;
  for (int row = 0; row < field.rows(); ++row)
    for (int column = 0; column < field.columns(); ++column)
      left = std::max(left, field.height(column, row) - exact.height(column, row));
  state.counters["left_um"] = 1e3 * left;
}

/// A ball over level ground, in rows 0.6 mm apart and `deep` below it.
void level(benchmark::State& state, double deep)
{
  constexpr double edge = 40, ground = 10, apart = 0.6;
  const Tool tool = Tool::ball(1, 6);
  auto cloud = Freeform::sample(1000000, edge, 0.0, 1);
  for (auto& p : *cloud)
    p.z = float(ground);
  Program program;
  program.blend = 0;
  program.ended = true;
  Eigen::Vector3d at(-5, 0, 30);
  const auto go = [&](double x, double y, double z, bool rapid) {
    const std::size_t line = program.moves.size() + 1;
    const Eigen::Vector3d to(x, y, z);
    program.moves.push_back(
        {at, to, 833.0, 8000.0, line, tool.number, rapid, true, true});
    at = to;
  };
  go(-5, -apart, 30, true);
  go(-5, -apart, ground - deep, false);
  double x = -5;
  for (double y = -apart; y < edge + 2 * apart; y += apart) {
    go(x, y, ground - deep, false);
    x = edge - x;
    go(x, y, ground - deep, false);
  }
  go(x, at.y(), 30, true);
  ProgramVerifier verifier;
  verifier.setPart(std::make_shared<const PointIndex>(
      std::vector<PointSource>{pointSource(*cloud)}));
  verifier.setStock({{0, 0, 0}, {edge, edge, 12}});
  verifier.setTools({tool});
  verifier.setCellSize(kCell);
  Verification result;
  for (auto _ : state)
    result = verifier.verify(program);
  // Of the points, spread evenly, half are in the inner half of a row.
  const double r = tool.radius();
  const auto scallop = [&](double share) {
    return r - std::sqrt(r * r - std::pow(share * apart / 2, 2));
  };
  state.counters["gouge_um"] = 1e3 * result.gouge;
  state.counters["gouge_true_um"] = 1e3 * deep;
  if (deep > 0)
    return;
  for (const auto& [name, found, share] :
       {std::tuple("p50", result.deviation.p50, 0.5),
        std::tuple("p99", result.deviation.p99, 0.99),
        std::tuple("max", result.deviation.max, 1.0)}) {
    const std::string key = std::string("left_") + name;
    state.counters[key + "_um"] = 1e3 * found;
    state.counters[key + "_true_um"] = 1e3 * scallop(share);
  }
}

template <typename Run>
void add(const std::string& name, Run run)
{
  benchmark::RegisterBenchmark(name.c_str(), run)
      ->Unit(benchmark::kSecond)
      ->Iterations(1)
      ->UseRealTime()
      ->MeasureProcessCPUTime();
}

} // namespace

int main(int argc, char** argv)
{
  const std::pair<const char*, Tool> tools[] = {
      {"ball_6", Tool::ball(1, 6)},
      {"bull_6", Tool::bull(1, 6, 1)},
      {"taper_ball_1", Tool::taperBall(1, 1, 5, 6)}};
  using State = benchmark::State;
  for (const auto& named : tools) {
    const std::string name = named.first;
    const Tool tool = named.second;
    for (const unsigned threads : {2U, 1U})
      add("verify/" + name + "/threads_" + std::to_string(threads),
          [=](State& state) { verify(state, tool, threads); });
    add("stock/" + name + "/swept",
        [=](State& state) { cutStock(state, tool, false); });
    add("stock/" + name + "/stamped",
        [=](State& state) { cutStock(state, tool, true); });
  }
  add("level/on_it", [](State& state) { level(state, 0.0); });
  add("level/too_deep", [](State& state) { level(state, 0.05); });
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
}
