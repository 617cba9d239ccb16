// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/error.h>
#include <pointmill/gcode/gcode_reader.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

/// @brief Reading of programs that stand in a test.
namespace reading {

using pointmill::Program;
using pointmill::ProgramForm;

inline Program read(const std::string& text, ProgramForm form = ProgramForm::Rs274)
{
  std::istringstream in(text);
  pointmill::GCodeReader reader;
  reader.setForm(form);
  return reader.read(in);
}

/// @brief Why a program is refused, or "accepted".
inline std::string refusal(const std::string& text,
                           ProgramForm form = ProgramForm::Rs274)
{
  try {
    read(text, form);
  }
  catch (const pointmill::DataError& error) {
    // PCL's exceptions may put ": " in front.
    const std::string what = error.what();
    return what.rfind(": ", 0) == 0 ? what.substr(2) : what;
  }
  return "accepted";
}

/// @brief A position as "1 2 inf", with "?" for what is not known.
inline std::string place(const Eigen::Vector3d& p)
{
  std::ostringstream out;
  for (int axis = 0; axis < 3; ++axis) {
    out << (axis ? " " : "");
    if (std::isnan(p[axis]))
      out << '?';
    else
      out << std::round(p[axis] * 1e6) / 1e6 + 0.0;
  }
  return out.str();
}

/// @brief The ends of all moves, "0 0 5, 1 0 5"; rapids in brackets.
inline std::string way(const Program& program)
{
  std::string out;
  for (const auto& m : program.moves)
    out +=
        (out.empty() ? "" : ", ") + (m.rapid ? "(" + place(m.to) + ")" : place(m.to));
  return out;
}

} // namespace reading
