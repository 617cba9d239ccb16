// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/operation.h>
#include <pointmill/common/parameters.h>
#include <pointmill/gcode/machine_calls.h>

#include <cstddef>
#include <iosfwd>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace pointmill {

/// @brief Writes operations as one NC program for LinuxCNC, in millimetres.
///
/// Every rule is checked before the first byte is written: no program is better than a
/// wrong one.
/// - A path begins and ends on the clearance plane or above it. The writer lifts to the
///   top of the machine before each tool change, goes to the first point's Z, then to
///   its X and Y; between two operations of one tool it travels at the higher of both
///   ends.
/// - `Motion::Rapid` and `Motion::Retract` become G0, all others G1 with the point's
///   feed. A rapid is either vertical, or level on the clearance plane or above it, or
///   below it where that is allowed.
/// - X and Y are rounded to the nearest decimal, Z upwards; points that coincide
///   after rounding are written once.
///
/// The same operations and settings give the same bytes, in any locale.
class GCodeWriter {
public:
  struct Statistics {
    std::size_t lines = 0;
    std::size_t bytes = 0;
    std::size_t feed_moves = 0;
    std::size_t rapids = 0; ///< with those of retracts and approaches
    std::size_t tool_changes = 0;
    std::size_t skipped = 0; ///< points that coincide with the one before
  };

  /// @brief Text for the head of the program. Turned to ASCII without parentheses and
  /// wrapped at 80 characters.
  void addComment(const std::string& text) { comments_.push_back(text); }
  void setComments(std::vector<std::string> lines) { comments_ = std::move(lines); }
  const std::vector<std::string>& getComments() const { return comments_; }

  /// @brief Z [mm], part frame, above which the tool may travel in rapid. Obligatory.
  void setClearancePlane(double z) { clearance_ = z; }
  double getClearancePlane() const { return clearance_; }

  /// @brief Whether level rapids may run below the clearance plane, as LinkPasses plans
  /// them where a machine may dog-leg.
  void setLowRapids(bool allowed) { low_rapids_ = allowed; }
  bool getLowRapids() const { return low_rapids_; }

  /// @brief How far the control may blend corners [mm]: `G64 P.. Q0.`; 0: `G61`, exact
  /// path. It belongs into the error budget.
  void setPathTolerance(double tolerance) { tolerance_ = tolerance; }
  double getPathTolerance() const { return tolerance_; }

  /// @brief Decimals of coordinates, 3 .. 6.
  void setDecimals(int decimals) { decimals_ = decimals; }
  int getDecimals() const { return decimals_; }

  template <typename V>
  void parameters(V&& v)
  {
    v("clearance_plane", clearance_, "mm", Range{-1e5, 1e5}, "Z of rapid travel");
    v("path_tolerance", tolerance_, "mm", Range{0, 1}, "blending of corners, G64 P");
    v("decimals", decimals_, "", Range{3, 6}, "decimals of coordinates");
  }

  /// @brief Writes the program to @p out. Throws ParameterError for settings, tools,
  /// feeds and speeds, DataError for paths, both before anything is written; Error when
  /// @p out fails.
  Statistics write(const std::vector<Operation>& operations, std::ostream& out) const;

  /// @brief The same as machine calls; `lines` and `bytes` stay 0.
  Statistics write(const std::vector<Operation>& operations, MachineCalls& calls) const;

private:
  std::vector<std::string> comments_;
  double clearance_ = std::numeric_limits<double>::quiet_NaN();
  double tolerance_ = 0.01;
  int decimals_ = 4;
  bool low_rapids_ = false;
};

} // namespace pointmill
