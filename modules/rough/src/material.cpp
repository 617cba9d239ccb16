// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "bit_rows.h"
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

using Bits = std::vector<std::uint64_t>;

/// Bits of `bits` under a disc or a capsule that is given row by row; it stops counting
/// beyond `most`.
template <typename Rows>
std::size_t
countBits(const Bits& bits, std::size_t words, std::size_t most, Rows&& rows)
{
  std::size_t count = 0;
  rows([&](int row, int first, int last) {
    const std::uint64_t* line = &bits[row * words];
    return forWords(first, last, [&](std::size_t word, std::uint64_t mask) {
      if (const std::uint64_t set = line[word] & mask)
        count += static_cast<std::size_t>(bitCount(set));
      return count <= most;
    });
  });
  return count;
}

std::optional<Material::Place> anyBit(const Bits& bits,
                                      std::size_t words,
                                      const CellGrid& grid,
                                      const Eigen::Vector2d& p,
                                      double radius)
{
  std::optional<Material::Place> found;
  forDisc(grid, p, radius, [&](int row, int first, int last) {
    const std::uint64_t* line = &bits[row * words];
    return forWords(first, last, [&](std::size_t word, std::uint64_t mask) {
      if (const std::uint64_t set = line[word] & mask)
        found = Material::Place{static_cast<int>(word) * 64 + lowestBit(set), row};
      return !found;
    });
  });
  return found;
}

} // namespace

Material::Material(const Level& level, int parts)
    : radius_(level.map().endRadius()), z_(level.z()), grid_(level.map().grid()),
      nodes_(grid_)
{
  grid_.cell /= parts;
  grid_.columns *= parts;
  grid_.rows *= parts;
  words_ = (static_cast<std::size_t>(grid_.columns) + 63) / 64;
  stands_.assign(words_ * static_cast<std::size_t>(grid_.rows), 0);
  to_cut_ = stands_;
  std::vector<std::uint64_t> line(words_);
  for (int row = 0; row < nodes_.rows; ++row) {
    std::fill(line.begin(), line.end(), 0);
    for (int column = 0; column < nodes_.columns; ++column)
      if (level.map().standing({column, row}) > z_ + 1e-3)
        forWords(column * parts,
                 column * parts + parts - 1,
                 [&](std::size_t word, std::uint64_t mask) { line[word] |= mask; });
    for (int part = 0; part < parts; ++part)
      std::copy(line.begin(), line.end(), &stands_[wordOf(0, row * parts + part)]);
  }
  for (int row = 0; row < nodes_.rows; ++row)
    forRuns(
        nodes_,
        row,
        [&](int column) {
          return level.isNeeded({column, row});
        },
        [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
          forCapsule(grid_, a, b, certainRadius(), [&](int r, int first, int last) {
            std::uint64_t* cells = &to_cut_[wordOf(0, r)];
            forWords(first, last, [&](std::size_t word, std::uint64_t mask) {
              cells[word] |= mask;
            });
          });
        });
  for (std::size_t i = 0; i < to_cut_.size(); ++i) {
    to_cut_[i] &= stands_[i];
    left_ += static_cast<std::size_t>(bitCount(to_cut_[i]));
  }
}

std::size_t Material::cut(const Eigen::Vector2d& a,
                          const Eigen::Vector2d& b,
                          double radius,
                          Log* log)
{
  std::size_t taken = 0;
  forCapsule(grid_, a, b, radius, [&](int row, int first, int last) {
    const std::size_t line = wordOf(0, row);
    forWords(first, last, [&](std::size_t word, std::uint64_t mask) {
      const std::size_t i = line + word;
      const std::uint64_t cells = stands_[i] & mask, wanted = to_cut_[i] & mask;
      if (cells == 0)
        return;
      if (log)
        log->push_back({i, cells, wanted});
      taken += static_cast<std::size_t>(bitCount(cells));
      left_ -= static_cast<std::size_t>(bitCount(wanted));
      stands_[i] &= ~mask;
      to_cut_[i] &= ~mask;
    });
  });
  return taken;
}

void Material::restore(Log& log, std::size_t keep)
{
  for (; log.size() > keep; log.pop_back()) {
    const Taken& taken = log.back();
    stands_[taken.word] |= taken.cells;
    to_cut_[taken.word] |= taken.to_cut;
    left_ += static_cast<std::size_t>(bitCount(taken.to_cut));
  }
}

std::size_t Material::standing(const Eigen::Vector2d& a,
                               const Eigen::Vector2d& b,
                               double radius,
                               std::size_t most) const
{
  return countBits(stands_, words_, most, [&](auto&& take) {
    forCapsule(grid_, a, b, radius, take);
  });
}

std::size_t
Material::toCut(const Eigen::Vector2d& p, double radius, std::size_t most) const
{
  return countBits(
      to_cut_, words_, most, [&](auto&& take) { forDisc(grid_, p, radius, take); });
}

std::optional<Material::Place> Material::anyStanding(const Eigen::Vector2d& p,
                                                     double radius) const
{
  return anyBit(stands_, words_, grid_, p, radius);
}

std::optional<Material::Place> Material::anyToCut(const Eigen::Vector2d& p,
                                                  double radius) const
{
  return anyBit(to_cut_, words_, grid_, p, radius);
}

Eigen::Vector2d Material::middleToCut(const Eigen::Vector2d& p, double radius) const
{
  Eigen::Vector2d sum(0, 0);
  double count = 0;
  forDisc(grid_, p, radius, [&](int row, int first, int last) {
    for (int column = first; column <= last; ++column)
      if (at(column, row) == ToCut) {
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
  for (int row = 0; row < grid_.rows; ++row) {
    const auto line = to_cut_.begin() + static_cast<std::ptrdiff_t>(wordOf(0, row));
    if (std::all_of(line,
                    line + static_cast<std::ptrdiff_t>(words_),
                    [](std::uint64_t word) { return word == 0; }))
      continue;
    forRuns(
        grid_,
        row,
        [&](int column) { return at(column, row) == ToCut; },
        [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
          forCapsule(nodes_, a, b, radius, [&](int r, int first, int last) {
            std::fill_n(&nodes[nodes_.index(first, r)], last - first + 1, 1);
          });
        });
  }
  return nodes;
}

} // namespace pointmill
