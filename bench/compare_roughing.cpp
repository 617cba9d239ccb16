// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Every roughing strategy on the same five parts: figures as JSON, and pictures.
#include "rough_job.h"
#include "strategies.h"

#include <pointmill/visual/level_picture.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>

using namespace pointmill;
using bench::RoughJob;
using bench::Standing;

namespace {

using Json = nlohmann::ordered_json;

constexpr double kSample = 0.2;        ///< between the points of a part [mm]
constexpr std::uint32_t kPictured = 4; ///< the fifth level

struct Options {
  std::string pictures, part;
  int repetitions = 5, width = 900;
};

template <typename Work>
double seconds(Work&& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
      .count();
}

double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool isAir(const PointCL& p)
{
  return p.getMotion() == Motion::Rapid || p.getMotion() == Motion::Retract;
}

/// Calls visit(cell height, part's height, area) for each cell of the stock, the part
/// being the floor where there is none.
template <typename Visit>
void forColumns(const RoughJob& job, const StockField& stock, Visit&& visit)
{
  const CellGrid map = CellGrid::of(*job.map);
  const double area = stock.cellSize() * stock.cellSize();
  for (int row = 0; row < stock.rows(); ++row)
    for (int column = 0; column < stock.columns(); ++column) {
      const int c = map.columnOf(stock.x(column)), r = map.rowOf(stock.y(row));
      const float part = map.has(c, r) ? (*job.map)[map.index(c, r)].z : NAN;
      visit(stock.height(column, row),
            std::isnan(part) ? job.floor : std::max<double>(part, job.floor),
            area);
    }
}

struct Volumes {
  double removed = 0, left = 0; // mm3
};

Volumes volumesOf(const RoughJob& job, const StockField& stock)
{
  Volumes v;
  forColumns(job, stock, [&](double height, double part, double area) {
    v.removed += (job.stock.top() - height) * area;
    v.left += std::max(0.0, height - part) * area;
  });
  return v;
}

/// One strategy on one part.
struct Result {
  CLCloud path;
  Json figures;
};

/// The figures of the last of several runs, which all do the same, and the median of
/// their times. Another figure needs a line here and one in bench_report.py.
Result measure(const bench::Strategy& strategy, const RoughJob& job, int repetitions)
{
  Result result;
  std::vector<double> plan, link;
  CLCloud passes;
  const auto roughing = strategy.make();
  LinkPasses linker;
  Volumes volumes;
  for (int i = 0; i < repetitions; ++i) {
    const Standing standing(job);
    plan.push_back(
        seconds([&] { passes = bench::planPasses(*roughing, job, standing); }));
    link.push_back(seconds(
        [&] { result.path = bench::linkPasses(linker, job, standing, passes); }));
    volumes = volumesOf(job, *standing.nominal);
  }
  const PathFigures path =
      measurePath(result.path, job.options.rapid_rate, linker.getCutFigures());
  result.figures = {{"cl_points", path.cl_points},
                    {"passes", path.passes},
                    {"retracts", path.retracts},
                    {"lifts", static_cast<int>(linker.getReport().get("lifts"))},
                    {"feed_mm", path.cutting_length},
                    {"air_mm", path.cut.air_length},
                    {"rapid_mm", path.rapid_length},
                    {"minutes", path.minutes},
                    {"mean_width_mm", path.cut.mean_radial},
                    {"max_width_mm", path.cut.max_radial},
                    {"max_depth_mm", path.cut.max_axial},
                    {"removed_mm3", volumes.removed},
                    {"left_mm3", volumes.left},
                    {"skipped", linker.getReport().get("skipped")},
                    {"missed_mm2", roughing->getReport().get("missed_mm2")},
                    {"plan_s", median(plan)},
                    {"link_s", median(link)}};
  return result;
}

/// The stock as the levels above @p level leave it.
CellCloud standingAbove(const RoughJob& job, const CLCloud& path, std::uint32_t level)
{
  StockField stock(job.stock, job.options.cell / 2, StockField::Bound::Nominal);
  for (std::size_t i = 1; i < path.size(); ++i)
    if (path[i].level < level && !isAir(path[i]))
      stock.cut(job.options.tool,
                path[i - 1].getVector3fMap().cast<double>(),
                path[i].getVector3fMap().cast<double>());
  return stock.toCloud();
}

std::string text(const char* format, double value)
{
  char line[80];
  std::snprintf(line, sizeof line, format, value);
  return line;
}

/// What the tool does on one level, in a few words.
std::vector<std::string>
describe(const RoughJob& job, const CLCloud& path, std::uint32_t level)
{
  double feed = 0, rapid = 0;
  int down = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (path[i].level != level)
      continue;
    const bool air = isAir(path[i]);
    const auto way = path[i].getVector3fMap() - path[i - 1].getVector3fMap();
    (air ? rapid : feed) += way.norm();
    down += !air && isAir(path[i - 1]);
  }
  return {text("level 5 at Z %.1f mm", heightOfLevel(path, level)),
          job.options.tool.describe(),
          text("%.0f mm feed", feed),
          text("%.0f mm rapid", rapid),
          text(down == 1 ? "%.0f entry" : "%.0f entries", down)};
}

void draw(const std::string& file,
          const std::string& title,
          const RoughJob& job,
          const CLCloud& path,
          int width)
{
  const CellCloud standing = standingAbove(job, path, kPictured);
  LevelScene scene;
  scene.title = title;
  scene.map = job.map.get();
  scene.standing = &standing;
  scene.stock = job.stock;
  scene.tool = job.options.tool;
  scene.path = &path;
  scene.level = kPictured;
  scene.figures = describe(job, path, kPictured);
  writeLevel(file, scene, width);
}

Json compare(const bench::RoughPart& part, const Options& options)
{
  const RoughJob job(bench::sample(part, kSample), part.margin, {});
  const Eigen::Vector3d size = job.part->max() - job.part->min();
  Json strategies = Json::array();
  for (const auto& strategy : bench::kStrategies) {
    const Result result = measure(strategy, job, options.repetitions);
    Json row = {{"name", strategy.name}, {"title", strategy.title}};
    row.update(result.figures);
    if (!options.pictures.empty()) {
      const std::string file =
          std::string("rough_") + part.name + "_" + strategy.name + ".png";
      draw(options.pictures + "/" + file,
           std::string(part.title) + ", " + strategy.title,
           job,
           result.path,
           options.width);
      row["picture"] = file;
    }
    strategies.push_back(row);
  }
  return {{"name", part.name},
          {"title", part.title},
          {"size_mm", {size.x(), size.y(), size.z()}},
          {"points", job.part->size()},
          {"strategies", strategies}};
}

int run(const Options& options)
{
  const bench::RoughOptions rough;
  Json parts = Json::array();
  for (const auto& part : bench::roughParts())
    if (options.part.empty() || options.part == part.name)
      parts.push_back(compare(part, options));
  const Json json = {{"tool", rough.tool.describe()},
                     {"allowance_mm", rough.allowance},
                     {"step_down_mm", rough.step_down},
                     {"step_over_mm", rough.step_over},
                     {"cell_mm", rough.cell},
                     {"repetitions", options.repetitions},
                     {"parts", parts}};
  std::cout << json.dump(2) << "\n";
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Compares the roughing strategies on five parts; prints JSON.");
  Options options;
  app.add_option("--pictures", options.pictures, "folder for pictures of level 5")
      ->check(CLI::ExistingDirectory);
  app.add_option("--part", options.part, "only this part");
  app.add_option("--repetitions", options.repetitions, "runs that are timed")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--width", options.width, "of the pictures [px]")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    return run(options);
  }
  catch (const pointmill::Error& e) {
    std::cerr << "compare_roughing: " << e.what() << "\n";
    return 2;
  }
}
