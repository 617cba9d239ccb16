// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/keep_out.h>
#include <pointmill/common/machine.h>
#include <pointmill/common/stock.h>
#include <pointmill/common/tool.h>
#include <pointmill/surface/point_index.h>
#include <pointmill/verify/program_verifier.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace pointmill {

/// @brief What a program is judged by: the part and all that stands round it, the
/// tools, and the limits [mm]. A job makes it and leaves it in its directory, where any
/// other program can be judged by it later.
struct Criteria {
  using Points = std::shared_ptr<const PointIndex>;

  Points part;    ///< as scanned
  Points model;   ///< the same without noise; null where nothing was smoothed
  Points bridges; ///< over its gaps, may be null
  Points raw;     ///< of the raw part, null where the stock is a block
  double raw_reach = 0.0;
  double noise_allowance = 0.0;
  Stock stock;
  KeepOut keep_out;
  std::vector<Tool> tools;
  Machine machine;
  double tolerance = 0.02; ///< deepest gouge, all errors together
  /// What of the tolerance the control may use up by rounding corners.
  double blend = 0.01;
  /// Whether the control rounds corners as it likes, and nobody knows how much.
  bool corners_by_control = false;
  double residual_limit = 1e4;
  /// What the job's own program keeps over a tenth of the points [mm].
  double left_p90 = std::numeric_limits<double>::infinity();
  double floor = 0.0;
  double cell = 0.25;
  ProgramForm form = ProgramForm::Rs274; ///< how programs for the machine are spelled
  /// Chords that stand for arcs lie so near to them [mm].
  double arc_error = 5e-4;
  unsigned threads = 0;

  /// @brief Deepest gouge that the text of a program may show.
  double gougeLimit() const { return tolerance - blend - arc_error; }

  /// @brief Judges @p program as it was read back.
  Verification judge(const Program& program) const;

  /// @brief Writes its clouds into @p directory; what else it holds is in report.json.
  /// @return their names
  std::vector<std::string> writeClouds(const std::string& directory) const;

  /// @brief Reads what a job left in @p directory: report.json and the clouds.
  /// @throws DataError where a file is missing, or not as a job writes it
  static Criteria read(const std::string& directory);
};

} // namespace pointmill
