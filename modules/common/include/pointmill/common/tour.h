// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <vector>

namespace pointmill {

/// @brief One way to go through an item of a tour: from where to where [mm].
struct TourWay {
  Eigen::Vector2d in, out;
};

/// @brief What a tour visits once, in one of several ways; the first is how it was
/// given. Stretches of a tour can be turned round where each of their items also has
/// the way back (with the same two places, swapped).
using TourItem = std::vector<TourWay>;

/// @brief What it costs to get from one place to another [mm]: not less than their
/// distance, and the same both ways.
using TourCost =
    std::function<double(const Eigen::Vector2d& from, const Eigen::Vector2d& to)>;

enum class TourStart {
  First, ///< with the first item in its first way
  Any    ///< with whatever is best
};

/// @brief An item's number, and that of the way through it.
struct TourStop {
  std::size_t item, way;
};

struct Tour {
  std::vector<TourStop> stops; ///< every item once
  double before = 0;           ///< cost of all items as given, in the order given
  double after = 0;            ///< cost of the stops, never more
};

/// @brief An order and ways of @p items with little cost between them, an open path:
/// first always on to what is nearest, then, as long as that saves anything, stretches
/// are turned round (2-opt), short ones moved elsewhere (Or-opt), and the best ways in
/// the order found (dynamic programming). Moves are tried between places that are
/// near each other, so that a hundred thousand items take seconds. The same items give
/// the same tour.
/// @param cost the distance, if empty
/// @throws DataError where an item has no way or a place is not finite
Tour shortTour(const std::vector<TourItem>& items,
               TourStart start,
               const TourCost& cost = {});

} // namespace pointmill
