// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "entries.h"

namespace pointmill {

/// @brief How the tool gets from one pass to the next: up to a height, sideways, and
/// down to an entry.
struct Transition {
  enum class Kind {
    Plane, ///< rapids over the clearance plane
    Rapid, ///< rapids below it, over all that a dog-legging machine may meet
    Lift,  ///< a straight feed move just above what stands below it
    Stay   ///< a straight feed move between the passes
  };

  Kind kind;
  double height;  ///< of the way sideways [mm]
  double minutes; ///< all that it takes to the start of the pass
  Entry entry;
};

/// @brief Finds the quickest of the transitions that are proven clear.
class Transitions {
public:
  /// @param rapid_rate mm/min
  /// @param stay_down longest move between passes at feed [mm]
  /// @param low_rapids whether there may be rapids sideways below the clearance plane
  Transitions(const Surroundings& around,
              const Entries& entries,
              const Cutting& cutting,
              double rapid_rate,
              double stay_down,
              bool low_rapids);

  /// @brief To @p entry, over the stock.
  Transition over(const Eigen::Vector3d& from, const Entry& entry) const;
  /// @brief To the start of @p pass, between the passes if that is quicker.
  Transition best(const Eigen::Vector3d& from,
                  const std::vector<Eigen::Vector3d>& pass) const;

  /// @brief Height at which a rapid straight down to @p entry ends.
  double rapidDown(const Entry& entry) const;
  /// @brief Whether the nominal stock proves that nothing is above @p at.
  bool isAir(const Eigen::Vector3d& at) const;

private:
  double stayHeight(const Eigen::Vector3d& from, const Eigen::Vector3d& start) const;
  double minutes(const Eigen::Vector3d& from,
                 double height,
                 Transition::Kind kind,
                 const Entry& entry) const;

  const Surroundings& around_;
  const Entries& entries_;
  const Cutting& cutting_;
  double rapid_rate_, stay_down_;
  bool low_rapids_;
};

} // namespace pointmill
