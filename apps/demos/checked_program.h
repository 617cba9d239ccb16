// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/gcode/gcode_writer.h>
#include <pointmill/link/link_passes.h>
#include <pointmill/verify/program_verifier.h>

#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// @brief A program of one tool from its passes, which is handed out only when it was
/// read back, compared with them, and verified against the part. The stock is a block
/// over part and passes.
struct CheckedProgram {
  pointmill::Tool tool;
  pointmill::Cutting cutting;
  std::shared_ptr<const pointmill::PointIndex> part; ///< null: not verified against one
  bool unverified = false;                           ///< whether that is wanted
  double stock_top =
      std::numeric_limits<double>::quiet_NaN(); ///< NaN: that of the part, else not
                                                ///< below it
  pointmill::LinkPasses link;
  pointmill::GCodeWriter writer;
  pointmill::ProgramVerifier verifier;

  /// @name What make() leaves
  /// @{
  std::string text;
  std::vector<std::pair<std::string, std::string>> figures;
  /// @}

  /// @return the passes, linked
  /// @throws ParameterError where what is needed is not given, DataError for passes
  /// that are none, VerificationError for a program that does not do what the passes
  /// say, or harms the part
  pointmill::CLCloud make(const pointmill::CLCloud& passes);

private:
  pointmill::Stock stockOver(const pointmill::CLCloud& passes) const;
  pointmill::CLCloud linkInto(const pointmill::CLCloud& passes,
                              const pointmill::Stock& stock);
  void write(const pointmill::CLCloud& path, const pointmill::Stock& stock);
  pointmill::Program readBack(const pointmill::CLCloud& path) const;
  void verify(const pointmill::Program& program, const pointmill::Stock& stock);
};
