// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pointmill::visual {

/// @brief How a move of a level is drawn.
enum class MoveKind { Cut, Entry, Link, Rapid };

/// @brief A move seen from above.
struct LevelMove {
  Eigen::Vector2d from, to; ///< mm
  MoveKind kind;
  double begun; ///< feed length on the level before this move [mm]
};

/// @brief What the tool does on one level.
struct LevelMoves {
  std::vector<LevelMove> moves;
  std::vector<Eigen::Vector2d> entries; ///< where it comes down from a rapid [mm]
  double length = 0;                    ///< of all feed moves, seen from above [mm]

  /// @brief Calls visit(move) for those of one kind.
  template <typename Visit>
  void each(MoveKind kind, Visit&& visit) const
  {
    for (const auto& m : moves)
      if (m.kind == kind)
        visit(m);
  }
};

/// @brief The moves of @p path that arrive on @p level; those from or to a point that
/// is not finite are left out.
LevelMoves movesOfLevel(const CLCloud& path, std::uint32_t level);

} // namespace pointmill::visual
