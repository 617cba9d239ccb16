// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// How many blocks a second are written and read, a million for each control and ten
// millions for one. Names are write/POST/BLOCKS, read/POST/BLOCKS.
#include <pointmill/gcode/gcode_reader.h>
#include <pointmill/gcode/gcode_writer.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <sstream>
#include <streambuf>
#include <string>
#include <vector>

using namespace pointmill;

namespace {

constexpr int kColumns = 1000; ///< blocks in each row over a wavy surface

PointCL at(double x, double y, double z, Motion how)
{
  PointCL p(float(x), float(y), float(z), how);
  p.feed = 1200;
  return p;
}

std::vector<Operation> makeRows(int rows)
{
  Operation op;
  op.name = "rows";
  op.tool = Tool::ball(1, 6.0);
  op.path.push_back(at(0, 0, 10, Motion::Rapid));
  for (int r = 0; r < rows; ++r)
    for (int i = 0; i < kColumns; ++i) {
      const double x = 0.1 * (r % 2 ? kColumns - 1 - i : i), y = 100.0 * r / rows;
      op.path.push_back(at(x,
                           y,
                           3 * std::sin(x / 7) * std::cos(y / 11) - 3,
                           i ? Motion::Cut : Motion::Link));
    }
  const auto last = op.path.back();
  op.path.push_back(at(last.x, last.y, 10, Motion::Retract));
  return {op};
}

/// Made once for all that are measured with as many.
const std::vector<Operation>& operations(int rows)
{
  static std::map<int, std::vector<Operation>> made;
  auto& of_rows = made[rows];
  if (of_rows.empty())
    of_rows = makeRows(rows);
  return of_rows;
}

/// Takes what is written and keeps nothing.
struct Nowhere : std::streambuf {
  int overflow(int c) override { return c; }
  std::streamsize xsputn(const char*, std::streamsize n) override { return n; }
};

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

void writeRows(benchmark::State& state, const std::string& post, int rows)
{
  const auto writer = writerOf(post);
  const auto& job = operations(rows);
  GCodeWriter::Statistics statistics;
  for (auto _ : state) {
    Nowhere nowhere;
    std::ostream out(&nowhere);
    statistics = writer.write(job, out);
  }
  count(state, double(statistics.lines), double(statistics.bytes));
}

void readRows(benchmark::State& state, const std::string& post, int rows)
{
  const auto writer = writerOf(post);
  std::ostringstream out;
  const auto statistics = writer.write(operations(rows), out);
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
  const auto add =
      [](const std::string& name, auto run, const std::string& post, int rows) {
        const std::string blocks = std::to_string(rows * kColumns);
        benchmark::RegisterBenchmark(
            (name + "/" + post + "/" + blocks).c_str(),
            [=](benchmark::State& state) { run(state, post, rows); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->MeasureProcessCPUTime(); // threads encode the text
      };
  const auto addBoth = [&](const std::string& post, int rows) {
    add("write", writeRows, post, rows);
    add("read", readRows, post, rows);
  };
  for (const auto& post : Post::names())
    addBoth(post, 1000);
  addBoth("linuxcnc", 10000);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
