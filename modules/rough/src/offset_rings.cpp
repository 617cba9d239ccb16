// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "offset_rings.h"

#include <pointmill/rough/material.h>
#include <pointmill/slice/cell_regions.h>
#include <pointmill/slice/distance_field.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

/// Lines nearer to each other than this many nodes would not be lines [nodes].
constexpr double kNearest = 1.5;

/// Distance of every node from the walls, or from where nothing is needed if there are
/// no walls [mm].
std::vector<float> depthField(const Level& level, bool walls)
{
  const CellGrid& grid = level.map().grid();
  std::vector<unsigned char> outside(grid.size());
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      outside[grid.index(column, row)] =
          walls ? !level.isFree({column, row}) : !level.isNeeded({column, row});
  auto depth = distanceField(outside, grid.columns, grid.rows);
  for (auto& d : depth)
    d *= static_cast<float>(grid.cell);
  return depth;
}

/// Numbers the connected pieces of what is inside, from `next` on; -1 outside.
std::vector<int>
label(const CellGrid& grid, const std::vector<unsigned char>& inside, int& next)
{
  std::vector<int> labels(grid.size(), -1);
  for (const auto& piece : cellRegions(grid, inside, Connected::Edges)) {
    for (const auto at : piece)
      labels[at] = next;
    ++next;
  }
  return labels;
}

/// The label of the node inside that is next to a line.
int labelBeside(const CellGrid& grid,
                const std::vector<int>& labels,
                const IsoLine& line)
{
  for (const auto& p : line.points) {
    const int column = grid.columnOf(p.x()), row = grid.rowOf(p.y());
    for (int r = std::max(0, row - 1); r <= std::min(grid.rows - 1, row + 1); ++r)
      for (int c = std::max(0, column - 1); c <= std::min(grid.columns - 1, column + 1);
           ++c)
        if (labels[grid.index(c, r)] >= 0)
          return labels[grid.index(c, r)];
  }
  return -1;
}

/// Leaves only those lines, and stretches of lines, that cut what no other does.
void keepNeeded(const Level& level,
                bool walls,
                double step,
                std::vector<OffsetArea>& areas)
{
  const CellGrid& grid = level.map().grid();
  const Material material(level);
  const double certain = material.certainRadius();
  // An area needs no lines that those round it clear to its middle.
  std::vector<unsigned char> to_middle(areas.size(), 0);
  std::vector<unsigned char> has_children(areas.size(), 0);
  for (std::size_t i = areas.size(); i-- > 0;) {
    OffsetArea& area = areas[i];
    if (area.parent < 0)
      continue;
    if (!has_children[i] && area.deepest <= area.distance - step + certain) {
      area.lines.clear();
      to_middle[area.parent] = 1;
    }
    else
      has_children[area.parent] = 1;
  }
  // Nor does a line care for what the next one, nearer to the walls, is to cut.
  const auto all = level.neededNodes(), wide = material.nodesToCut(),
             near = material.nodesToCut(std::min(step, certain));
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const auto& needed = walls && areas[i].parent < 0 ? all
                         : to_middle[i]               ? wide
                                                      : near;
    std::vector<IsoLine> kept;
    for (const auto& line : areas[i].lines)
      for (auto& stretch : neededStretches(
               line,
               [&](const Eigen::Vector2d& p) { return isSetNear(grid, needed, p); },
               level.stepOver())) {
        if (!walls) // what is left to cut lies within
          std::reverse(stretch.points.begin(), stretch.points.end());
        kept.push_back(std::move(stretch));
      }
    areas[i].lines = std::move(kept);
  }
}

} // namespace

bool hasWalls(const Level& level)
{
  const CellGrid& grid = level.map().grid();
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      if (!level.isFree({column, row}))
        return true;
  return false;
}

std::vector<OffsetArea> offsetAreas(const Level& level, bool walls)
{
  const CellGrid& grid = level.map().grid();
  const auto depth = depthField(level, walls);
  double deepest = 0;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      if (level.isNeeded({column, row}))
        deepest = std::max<double>(deepest, depth[grid.index(column, row)]);

  const double step = std::max(level.stepOver(), kNearest * grid.cell);
  const auto needed = level.neededNodes();
  std::vector<OffsetArea> areas;
  std::vector<int> above; // labels of the last distance
  std::vector<unsigned char> inside(grid.size());
  for (int k = 0; k * step <= deepest; ++k) {
    const double least = k > 0 ? k * step : 1e-6;
    for (std::size_t i = 0; i < inside.size(); ++i)
      inside[i] = depth[i] >= least;
    int next = static_cast<int>(areas.size());
    const int first = next;
    const auto labels = label(grid, inside, next);
    areas.resize(static_cast<std::size_t>(next));
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (labels[i] < first)
        continue;
      OffsetArea& area = areas[labels[i]];
      area.distance = k * step;
      if (k > 0)
        area.parent = above[i];
      if (needed[i])
        area.deepest = std::max<double>(area.deepest, depth[i]);
    }
    const bool wall = k == 0 && walls;
    const auto lines =
        wall ? wallLines(level)
             : isoLines(grid, inside, [&](Node in, Node out) -> Eigen::Vector2d {
                 const double a = depth[grid.index(in.column, in.row)];
                 const double b = depth[grid.index(out.column, out.row)];
                 const double t = std::isfinite(a) ? (a - least) / (a - b) : 0.5;
                 return level.map().at(in) +
                        std::clamp(t, 0.0, 1.0) *
                            (level.map().at(out) - level.map().at(in));
               });
    for (const auto& line : lines) {
      const int area = labelBeside(grid, labels, line);
      if (area >= 0)
        areas[area].lines.push_back(wall ? line
                                         : straightened(level, line, grid.cell / 8));
    }
    above = labels;
  }
  keepNeeded(level, walls, step, areas);
  return areas;
}

} // namespace pointmill
