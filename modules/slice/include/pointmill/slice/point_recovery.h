// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/stage.h>

#include <cmath>

namespace pointmill {

/// @brief Point recovery (paper 001): all points above the plane `z = level`, projected
/// straight down onto it, so that what stands higher up still keeps the tool away.
template <typename PointT>
class PointRecovery : public Filter<PointT> {
public:
  using PointCloud = typename Filter<PointT>::PointCloud;

  PointRecovery() : Filter<PointT>("PointRecovery") {}

  /// @brief Height of the plane [mm].
  void setLevel(double level) { level_ = level; }
  double getLevel() const { return level_; }

  template <typename V>
  void parameters(V&& v)
  {
    v("level", level_, "mm", Range{-1e5, 1e5}, "height of the slicing plane");
  }

protected:
  void checkParameters() const override { validateParameters(*this, this->getName()); }

  void apply(PointCloud& output) override
  {
    std::size_t not_finite = 0;
    for (const auto i : *this->indices_) {
      PointT p = (*this->input_)[i];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
        ++not_finite;
        continue;
      }
      if (!(p.z > level_))
        continue;
      p.z = static_cast<float>(level_);
      output.push_back(p);
    }
    output.is_dense = true;
    this->report_.set("nan_points", static_cast<double>(not_finite));
    this->report_.set("points", static_cast<double>(output.size()));
  }

private:
  double level_ = 0.0;
};

} // namespace pointmill
