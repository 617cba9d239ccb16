// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// How many blocks a second are written and read. Names are write/POST, read/POST.
#include <pointmill/gcode/gcode_reader.h>
#include <pointmill/gcode/gcode_writer.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

using namespace pointmill;

namespace {

constexpr int kRows = 1000;
constexpr int kColumns = 1000; ///< 10^6 blocks: rows over a wavy surface

PointCL at(double x, double y, double z, Motion how)
{
  PointCL p(float(x), float(y), float(z), how);
  p.feed = 1200;
  return p;
}

std::vector<Operation> makeRows()
{
  Operation op;
  op.name = "rows";
  op.tool = Tool::ball(1, 6.0);
  op.path.push_back(at(0, 0, 10, Motion::Rapid));
  for (int r = 0; r < kRows; ++r)
    for (int i = 0; i < kColumns; ++i) {
      const double x = 0.1 * (r % 2 ? kColumns - 1 - i : i), y = 0.1 * r;
      op.path.push_back(at(x,
                           y,
                           3 * std::sin(x / 7) * std::cos(y / 11) - 3,
                           i ? Motion::Cut : Motion::Link));
    }
  const auto last = op.path.back();
  op.path.push_back(at(last.x, last.y, 10, Motion::Retract));
  return {op};
}

const std::vector<Operation>& rows()
{
  static const auto operations = makeRows();
  return operations;
}

GCodeWriter writerOf(const std::string& post)
{
  GCodeWriter writer;
  writer.setPost(Post::named(post));
  writer.setClearancePlane(10);
  return writer;
}

void count(benchmark::State& state, double blocks, double bytes)
{
  using Counter = benchmark::Counter;
  const auto kind = Counter::kIsIterationInvariantRate;
  state.counters["blocks/s"] = Counter(blocks, kind);
  state.counters["bytes/s"] = Counter(bytes, kind);
}

void writeRows(benchmark::State& state, const std::string& post)
{
  const auto writer = writerOf(post);
  GCodeWriter::Statistics statistics;
  for (auto _ : state) {
    std::ostringstream out;
    statistics = writer.write(rows(), out);
  }
  count(state, double(statistics.lines), double(statistics.bytes));
}

void readRows(benchmark::State& state, const std::string& post)
{
  const auto writer = writerOf(post);
  std::ostringstream out;
  const auto statistics = writer.write(rows(), out);
  const std::string text = out.str();
  GCodeReader reader;
  reader.setForm(writer.getPost().form);
  for (auto _ : state) {
    std::istringstream in(text);
    std::size_t moves = 0;
    reader.read(in, [&moves](const ProgramMove&) { ++moves; });
    benchmark::DoNotOptimize(moves);
  }
  count(state, double(statistics.lines), double(statistics.bytes));
}

} // namespace

int main(int argc, char** argv)
{
  for (const auto& post : Post::names()) {
    const auto add = [&post](const std::string& name, auto run) {
      benchmark::RegisterBenchmark(
          (name + "/" + post).c_str(),
          [run, post](benchmark::State& state) { run(state, post); })
          ->Unit(benchmark::kMillisecond);
    };
    add("write", writeRows);
    add("read", readRows);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
