// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/parameters.h>

#include <vector>

namespace pointmill {

/// @brief The horizontal planes that a part is roughed on, from the top down (paper
/// 001, segmentation on Z): pitch `0.3 d / 4` for a cutter of diameter d, or a given
/// step-down; `n = ceil((z_max - z_min) / pitch)` of them, the last exactly on the
/// floor.
class ZSlices {
public:
  /// @brief Highest and lowest Z of what is cut [mm].
  void setZLimits(double z_min, double z_max)
  {
    z_min_ = z_min;
    z_max_ = z_max;
  }
  /// @brief Distance between two planes [mm].
  void setPitch(double pitch) { pitch_ = pitch; }
  double getPitch() const { return pitch_; }
  /// @brief Paper 001's pitch for a cutter of diameter @p d [mm].
  void setPitchForDiameter(double d) { pitch_ = pitchForDiameter(d); }
  static double pitchForDiameter(double d) { return 0.3 * d / 4; }

  template <typename V>
  void parameters(V&& v)
  {
    v("pitch", pitch_, "mm", Range{1e-3, 1000}, "distance between two levels");
  }

  /// @brief The planes' heights, descending.
  /// @throws ParameterError for limits or a pitch that give no plane, or over 100,000
  std::vector<double> levels() const;

private:
  double z_min_ = 0, z_max_ = 0, pitch_ = pitchForDiameter(10);
};

} // namespace pointmill
