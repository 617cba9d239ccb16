// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/page/view_scene.h>

namespace pointmill {

/// @brief A place that the tool passes, and when [s].
struct TimedPlace {
  Eigen::Vector3d at;
  double seconds;
};
/// @brief Places that are joined by moves of one kind.
using Stroke = std::vector<TimedPlace>;

/// @brief The moves of a ViewPath that are known at both ends.
struct Strokes {
  std::vector<Stroke> feeds, rapids;
};

/// @brief @p path from the second @p start on. Its time is spread over its moves as
/// their lengths and speeds want it.
Strokes strokesOf(const Program& program,
                  const ViewPath& path,
                  double start,
                  double rapid_rate);

/// @brief What of @p stroke is needed so that nothing left out is farther than @p off
/// from the chord over it (Ramer, Douglas, Peucker).
Stroke simplified(const Stroke& stroke, double off);

/// @brief Strokes as bytes: their number of places, then each place as whole steps of
/// @p step mm, and of a hundredth of a second, from the one before. Numbers are written
/// in as few bytes as they need, seven bits each, the lowest first; signed ones in turn
/// (0, -1, 1, -2, ...).
std::string packed(const std::vector<Stroke>& strokes, double step);

} // namespace pointmill
