// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <optional>

namespace pointmill {

/// @brief How long it will still take, from how long it took so far.
class Pace {
public:
  /// @brief @p share of the work, from 0 to 1, was done after @p seconds. Times grow.
  void note(double seconds, double share);

  /// @brief Seconds, or none as long as there is too little to tell it by.
  std::optional<double> left() const { return left_; }

private:
  double last_ = 0;
  std::optional<double> left_;
};

} // namespace pointmill
