// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/verify/finding.h>

#include <map>
#include <vector>

namespace pointmill {

/// @brief Gathers findings: one of each code, about its worst place. A wrong program
/// repeats itself.
class Findings {
public:
  /// @param code one of findingCodes()
  /// @param worst in its unit; of equal ones the first to come is kept
  /// @param limit that it is beyond, to be named; 0: none
  void add(const char* code,
           double worst,
           const Eigen::Vector3d& place,
           std::size_t line,
           int tool,
           std::size_t count = 1,
           double limit = 0);
  void add(const char* code) { add(code, 0, Eigen::Vector3d::Zero(), 0, 0); }

  /// @brief In the order of findingCodes(), with their texts.
  std::vector<Finding> list() const;

private:
  std::map<std::string, Finding, std::less<>> by_code_;
};

} // namespace pointmill
