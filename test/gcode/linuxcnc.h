// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <string>
#include <vector>

/// @brief LinuxCNC's own interpreter, as a judge of programs.
namespace linuxcnc {

/// @brief A canonical motion, in the program's first frame and in mm.
struct Call {
  bool rapid = false, arc = false;
  Eigen::Vector3d to;
  double feed = 0.0; ///< mm/min
  // Of an arc: its axes (turning from u to v is positive), centre and turning.
  int u = 0, v = 1, w = 2;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  bool clockwise = false;
  double rounding = 0.0; ///< of the interpreter's output [mm]
};

/// @brief What LinuxCNC would have made the machine do.
struct Judgement {
  int status = -1;
  std::string text, errors;
  std::vector<Call> calls;
  std::vector<int> tools;
};

bool installed();
Judgement judge(const std::string& program);

} // namespace linuxcnc

#define NEED_LINUXCNC()                                                                \
  if (!linuxcnc::installed())                                                          \
  GTEST_SKIP() << "rs274 (linuxcnc-uspace) is not installed"
