// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace pointmill {

/// The distribution of scallop heights over the ground. Weights are parts of a regular
/// row's width, sums of powers of two and so exact in any order.
class ScallopTally {
public:
  ScallopTally() = default;
  explicit ScallopTally(double limit) : limit_(limit) {}

  void add(double height, double weight)
  {
    const double bin = std::ceil(height / limit_ * kPerLimit);
    weights_[static_cast<std::size_t>(std::min<double>(bin, kBins - 1))] += weight;
    highest_ = std::max(highest_, height);
  }
  void add(const ScallopTally& other)
  {
    for (std::size_t i = 0; i < kBins; ++i)
      weights_[i] += other.weights_[i];
    highest_ = std::max(highest_, other.highest_);
  }

  double highest() const { return highest_; }
  /// The height that @p share of the ground stay under, to a hundredth of the limit;
  /// the highest where that is over ten times the limit.
  double quantile(double share) const
  {
    double all = 0, below = 0;
    for (const double w : weights_)
      all += w;
    for (std::size_t i = 0; i + 1 < kBins; ++i) {
      below += weights_[i];
      if (below >= share * all)
        return std::min(highest_, static_cast<double>(i) / kPerLimit * limit_);
    }
    return highest_;
  }

private:
  static constexpr std::size_t kBins = 1002;
  static constexpr double kPerLimit = 100;
  std::array<double, kBins> weights_{};
  double limit_ = 1, highest_ = 0;
};

} // namespace pointmill
