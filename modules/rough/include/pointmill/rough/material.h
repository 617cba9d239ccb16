// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pointmill {

/// @brief What stands above one level, as a bitmap that a strategy mills in
/// simulation. Cells are a node's cell, or its odd part.
class Material {
public:
  enum Cell : unsigned char {
    Air = 0,
    Standing = 1, ///< stock that meets the tool, but is not to be cut on this level
    ToCut = 2     ///< stock that the tool gets at from a node that is needed
  };

  /// @param parts cells along the edge of a node's cell, odd
  explicit Material(const Level& level, int parts = 3);

  const CellGrid& grid() const { return grid_; }
  Cell at(int column, int row) const
  {
    const std::size_t word = wordOf(column, row);
    const int bit = column & 63;
    return static_cast<Cell>((stands_[word] >> bit & 1) + (to_cut_[word] >> bit & 1));
  }
  /// @brief Air beyond the grid.
  Cell at(const Eigen::Vector2d& p) const
  {
    const int column = grid_.columnOf(p.x()), row = grid_.rowOf(p.y());
    return grid_.has(column, row) ? at(column, row) : Air;
  }
  /// @brief Cells that are left to cut.
  std::size_t left() const { return left_; }
  /// @brief What is left is meant to stand.
  void leaveRest() { left_ = 0; }

  /// @brief Cells of one word of the bitmap that were cut, and which of them had been
  /// to cut.
  struct Taken {
    std::size_t word;
    std::uint64_t cells, to_cut;
  };
  using Log = std::vector<Taken>;

  /// @brief Moves a disc of @p radius [mm] straight from @p a to @p b: cells whose
  /// centres it passes over are air.
  /// @param log what it took is added, or null
  /// @return how many cells it took, of either kind
  std::size_t cut(const Eigen::Vector2d& a,
                  const Eigen::Vector2d& b,
                  double radius,
                  Log* log = nullptr);
  /// @brief Undoes what @p log holds beyond its first @p keep entries, and forgets it.
  void restore(Log& log, std::size_t keep);

  /// @brief Cells of either kind that a disc meets on its way straight from @p a to
  /// @p b; it stops counting beyond @p most.
  std::size_t standing(const Eigen::Vector2d& a,
                       const Eigen::Vector2d& b,
                       double radius,
                       std::size_t most) const;
  /// @brief Whether a disc moves straight from @p a to @p b through air alone.
  bool isClear(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double radius) const
  {
    return standing(a, b, radius, 0) == 0;
  }
  /// @brief A cell of the bitmap.
  struct Place {
    int column, row;
  };
  /// @brief A cell of either kind that a disc meets at @p p, or nothing.
  std::optional<Place> anyStanding(const Eigen::Vector2d& p, double radius) const;
  /// @brief A cell to cut that a disc meets at @p p, or nothing.
  std::optional<Place> anyToCut(const Eigen::Vector2d& p, double radius) const;
  /// @brief Cells to cut that a disc meets at @p p; it stops counting beyond @p most.
  std::size_t toCut(const Eigen::Vector2d& p, double radius, std::size_t most) const;
  /// @brief The middle of what is left to cut within @p radius of @p p; @p p itself
  /// where there is nothing.
  Eigen::Vector2d middleToCut(const Eigen::Vector2d& p, double radius) const;

  /// @brief Mills a path: cells that are under the tool's end for certain are air.
  void cut(const LevelPath& path);

  /// @brief Cells whose centres are within this of the tool's axis are under its end as
  /// a whole [mm].
  double certainRadius() const;
  /// @brief Set for the nodes at which the tool would cut something that is left to
  /// cut.
  std::vector<unsigned char> nodesToCut() const { return nodesToCut(certainRadius()); }
  /// @brief Set for the nodes within @p radius [mm] of the centre of a cell that is
  /// left to cut.
  std::vector<unsigned char> nodesToCut(double radius) const;

private:
  std::size_t wordOf(int column, int row) const
  {
    return static_cast<std::size_t>(row) * words_ +
           (static_cast<unsigned>(column) >> 6);
  }

  double radius_, z_;
  CellGrid grid_, nodes_;
  std::size_t words_ = 0; // in a row
  std::vector<std::uint64_t> stands_, to_cut_;
  std::size_t left_ = 0;
};

} // namespace pointmill
