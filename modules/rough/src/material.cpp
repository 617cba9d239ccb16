// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "capsule.h"

#include <pointmill/rough/material.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

/// Calls take(first place, last place) for the stretches of a row of `grid` in which
/// set(column) holds.
template <typename Set, typename Take>
void forRuns(const CellGrid& grid, int row, Set&& set, Take&& take)
{
  for (int column = 0; column < grid.columns; ++column) {
    if (!set(column))
      continue;
    const Eigen::Vector2d from(grid.x(column), grid.y(row));
    while (column + 1 < grid.columns && set(column + 1))
      ++column;
    take(from, Eigen::Vector2d(grid.x(column), grid.y(row)));
  }
}

} // namespace

Material::Material(const Level& level, int parts)
    : radius_(level.map().endRadius()), z_(level.z()), grid_(level.map().grid()),
      nodes_(grid_)
{
  grid_.cell /= parts;
  grid_.columns *= parts;
  grid_.rows *= parts;
  cells_.assign(grid_.size(), Air);
  for (int row = 0; row < grid_.rows; ++row)
    for (int column = 0; column < grid_.columns; ++column)
      if (level.map().standing({column / parts, row / parts}) > z_ + 1e-3)
        cells_[grid_.index(column, row)] = Standing;
  for (int row = 0; row < nodes_.rows; ++row)
    forRuns(
        nodes_,
        row,
        [&](int column) {
          return level.isNeeded({column, row});
        },
        [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
          forCapsule(grid_, a, b, certainRadius(), [&](int r, int first, int last) {
            unsigned char* line = &cells_[grid_.index(0, r)];
            for (int c = first; c <= last; ++c)
              if (line[c] == Standing) {
                line[c] = ToCut;
                ++left_;
              }
          });
        });
}

std::size_t Material::cut(const Eigen::Vector2d& a,
                          const Eigen::Vector2d& b,
                          double radius,
                          Log* log)
{
  std::size_t taken = 0;
  forCapsule(grid_, a, b, radius, [&](int row, int first, int last) {
    unsigned char* line = &cells_[grid_.index(0, row)];
    for (int column = first; column <= last; ++column) {
      if (line[column] == Air)
        continue;
      if (log)
        log->emplace_back(grid_.index(column, row), static_cast<Cell>(line[column]));
      ++taken;
      left_ -= line[column] == ToCut;
      line[column] = Air;
    }
  });
  return taken;
}

void Material::restore(Log& log, std::size_t keep)
{
  for (; log.size() > keep; log.pop_back()) {
    cells_[log.back().first] = log.back().second;
    left_ += log.back().second == ToCut;
  }
}

std::size_t
Material::ahead(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double radius) const
{
  // In each row what lies left and right of the first disc.
  const double x0 = grid_.x0 + grid_.cell / 2, y0 = grid_.y0 + grid_.cell / 2;
  const double r2 = radius * radius;
  const int bottom =
      std::max(0, static_cast<int>(std::ceil((b.y() - radius - y0) / grid_.cell)));
  const int top = std::min(
      grid_.rows - 1, static_cast<int>(std::floor((b.y() + radius - y0) / grid_.cell)));
  std::size_t count = 0;
  for (int row = bottom; row <= top; ++row) {
    const double y = grid_.y(row);
    const double half = std::sqrt(std::max(0.0, r2 - (y - b.y()) * (y - b.y())));
    const int first =
        std::max(0, static_cast<int>(std::ceil((b.x() - half - x0) / grid_.cell)));
    const int last =
        std::min(grid_.columns - 1,
                 static_cast<int>(std::floor((b.x() + half - x0) / grid_.cell)));
    const unsigned char* line = &cells_[grid_.index(0, row)];
    const auto add = [&](int from, int to) {
      for (int column = from; column <= to; ++column)
        count += line[column] != Air;
    };
    const double other2 = r2 - (y - a.y()) * (y - a.y());
    if (other2 < 0) {
      add(first, last);
      continue;
    }
    const double left = (a.x() - std::sqrt(other2) - x0) / grid_.cell;
    const double right = (a.x() + std::sqrt(other2) - x0) / grid_.cell;
    if (left > first)
      add(first, std::min(last, static_cast<int>(std::ceil(left)) - 1));
    if (right < last)
      add(std::max(first, static_cast<int>(std::floor(right)) + 1), last);
  }
  return count;
}

std::size_t Material::standing(const Eigen::Vector2d& a,
                               const Eigen::Vector2d& b,
                               double radius,
                               std::size_t most) const
{
  std::size_t count = 0;
  forCapsule(grid_, a, b, radius, [&](int row, int first, int last) {
    const unsigned char* line = &cells_[grid_.index(0, row)];
    for (int column = first; count <= most && column <= last; ++column)
      count += line[column] != Air;
    return count <= most;
  });
  return count;
}

std::size_t
Material::toCut(const Eigen::Vector2d& p, double radius, std::size_t most) const
{
  std::size_t count = 0;
  forCapsule(grid_, p, p, radius, [&](int row, int first, int last) {
    const unsigned char* line = &cells_[grid_.index(0, row)];
    for (int column = first; count <= most && column <= last; ++column)
      count += line[column] == ToCut;
    return count <= most;
  });
  return count;
}

Eigen::Vector2d Material::middleToCut(const Eigen::Vector2d& p, double radius) const
{
  Eigen::Vector2d sum(0, 0);
  double count = 0;
  forCapsule(grid_, p, p, radius, [&](int row, int first, int last) {
    for (int column = first; column <= last; ++column)
      if (cells_[grid_.index(column, row)] == ToCut) {
        sum += Eigen::Vector2d(grid_.x(column), grid_.y(row)) - p;
        count += 1;
      }
  });
  return count > 0 ? Eigen::Vector2d(p + sum / count) : p;
}

void Material::cut(const LevelPath& path)
{
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const auto &a = path.points[i > 0 ? i - 1 : 0], &b = path.points[i];
    if (std::max(a.at.z(), b.at.z()) <= z_ + 1e-3)
      cut(a.at.head<2>(), b.at.head<2>(), certainRadius());
  }
}

double Material::certainRadius() const
{
  return std::max(0.0, radius_ - grid_.cell * std::sqrt(0.5));
}

std::vector<unsigned char> Material::nodesToCut(double radius) const
{
  std::vector<unsigned char> nodes(nodes_.size(), 0);
  for (int row = 0; row < grid_.rows; ++row)
    forRuns(
        grid_,
        row,
        [&](int column) { return cells_[grid_.index(column, row)] == ToCut; },
        [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
          forCapsule(nodes_, a, b, radius, [&](int r, int first, int last) {
            std::fill_n(&nodes[nodes_.index(first, r)], last - first + 1, 1);
          });
        });
  return nodes;
}

} // namespace pointmill
