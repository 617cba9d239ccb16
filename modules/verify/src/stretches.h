// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "moves.h"
#include "sweep_range.h"

#include <pointmill/surface/swept_cutter.h>

#include <map>
#include <vector>

namespace pointmill {

/// @brief A few moves of a tool, one after the other, that are almost one: each of
/// their places is as near as said to a place of the straight way from @p a to @p b.
struct MoveStretch {
  Eigen::Vector3d a, b;
  const SweptCutter* cutter;
  std::uint32_t first, last; ///< moves [first, last)
  double aside, over;        ///< farthest from the straight way: in XY, along Z [mm]
};

/// @brief A program's moves in stretches, so that bounds are needed for few of them.
class Stretches {
public:
  explicit Stretches(const std::vector<SweptMove>& moves);

  std::size_t size() const { return stretches_.size(); }
  const MoveStretch& operator[](std::size_t i) const { return stretches_[i]; }
  const SweptMove& move(std::size_t k) const { return moves_[k]; }
  const SweptCutter& cutter(std::size_t k) const { return *cutter_[k]; }
  /// @brief Radius of the thinnest tool [mm].
  double thinnest() const;

  /// @brief Bounds of what the stretch's moves leave, as sweptHeightRange().
  HeightRange range(std::size_t i, double x, double y, double radius) const;
  /// @brief The same for one move.
  HeightRange moveRange(std::size_t k, double x, double y, double radius) const
  {
    return sweptHeightRange(
        cutter(k).profile(), moves_[k].a, moves_[k].b, x, y, radius);
  }
  /// @brief No move leaves less over (x, y) [mm]: a quick bound.
  double floor(std::size_t k, double x, double y) const
  {
    return cutter(k).floor(moves_[k].a, moves_[k].b, x, y);
  }

private:
  const std::vector<SweptMove>& moves_;
  std::map<const Tool*, SweptCutter> cutters_;
  std::vector<const SweptCutter*> cutter_; // by move
  std::vector<MoveStretch> stretches_;
};

} // namespace pointmill
