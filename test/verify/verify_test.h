// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/error.h>
#include <pointmill/verify/program_verifier.h>
#include <pointmill_test/clouds.h>

#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>

namespace verify_test {

using namespace pointmill;
using namespace pointmill_test;

/// Text of a program by hand: T1 in the spindle, 10 mm up.
class Text {
public:
  explicit Text(int tool = 1)
  {
    text_ << std::fixed << std::setprecision(6) << "G21 G17 G90 G94 G54\nT" << tool
          << " M6\nG43 H" << tool << "\nS8000 M3\nG0 Z10.\n";
    lines_ = 5;
  }
  Text& operator()(const std::string& line)
  {
    text_ << line << "\n";
    ++lines_;
    return *this;
  }
  /// Straight to (x, y, z) at feed.
  Text& feed(double x, double y, double z)
  {
    text_ << "G1 X" << x << " Y" << y << " Z" << z << " F600\n";
    ++lines_;
    return *this;
  }
  /// Over (x, y) in rapid.
  Text& over(double x, double y)
  {
    text_ << "G0 Z10.\nG0 X" << x << " Y" << y << "\n";
    lines_ += 2;
    return *this;
  }
  std::size_t lines() const { return lines_; }
  Program end(const char* last = "G0 Z10.\nM5\nM2\n") const
  {
    std::istringstream in(text_.str() + last);
    return readProgram(in);
  }

private:
  std::ostringstream text_;
  std::size_t lines_;
};

inline const Finding* find(const Verification& result, const std::string& code)
{
  for (const auto& f : result.findings)
    if (f.code == code)
      return &f;
  return nullptr;
}

inline std::string codes(const Verification& result)
{
  std::string all;
  for (const auto& f : result.findings)
    all += f.code + " ";
  return all;
}

} // namespace verify_test
