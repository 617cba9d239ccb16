// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>
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
    return static_cast<Cell>(cells_[grid_.index(column, row)]);
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

  /// @brief Cells that were cut, and what they had been.
  using Log = std::vector<std::pair<std::size_t, Cell>>;

  /// @brief Moves a disc of @p radius [mm] straight from @p a to @p b: cells whose
  /// centres it passes over are air.
  /// @param log what it took is added, or null
  /// @return how many cells it took, of either kind
  std::size_t cut(const Eigen::Vector2d& a,
                  const Eigen::Vector2d& b,
                  double radius,
                  Log* log = nullptr);
  /// @brief Undoes what @p log holds beyond its first @p keep cells, and forgets it.
  void restore(Log& log, std::size_t keep);

  /// @brief Cells of either kind that a disc of @p radius [mm] meets at @p b which it
  /// does not at @p a.
  std::size_t
  ahead(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double radius) const;
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
  double radius_, z_;
  CellGrid grid_, nodes_;
  std::vector<unsigned char> cells_;
  std::size_t left_ = 0;
};

} // namespace pointmill
