// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pointmill {

enum class Severity {
  Error,  ///< refuses the program
  Warning ///< should be known before the program is run
};

/// @brief What can be found in a program: one row for each code.
struct FindingCode {
  std::string code; ///< "gouge", "rapid_in_stock", ...
  Severity severity;
  std::string unit;    ///< of Finding::worst; empty where there is nothing to measure
  std::string meaning; ///< one line for people
};

/// @brief All codes, errors first.
const std::vector<FindingCode>& findingCodes();

/// @brief Something about a program that must not be, or should be known. There is one
/// of each code, about the worst place; where there is nothing to measure, the first.
struct Finding {
  std::string code;
  std::string text; ///< one line for people
  double worst = 0; ///< in the unit of the code
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double limit = 0;      ///< that `worst` is beyond, where the text names it; else 0
  std::size_t line = 0;  ///< of the program, 0: none
  int tool = 0;          ///< 0: none, or not known
  std::size_t count = 1; ///< of the moves or points that are so
  Severity severity = Severity::Error;
};

} // namespace pointmill
