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
    const std::string number = std::to_string(tool);
    (*this)("G21 G17 G90 G94 G54")("T" + number + " M6")("G43 H" + number);
    (*this)("S8000 M3")("G0 Z10.");
  }
  Text& operator()(const std::string& line)
  {
    text_ += line + "\n";
    ++lines_;
    return *this;
  }
  /// Straight to (x, y, z) at feed.
  Text& feed(double x, double y, double z)
  {
    return (*this)("G1 X" + number(x) + " Y" + number(y) + " Z" + number(z) + " F600");
  }
  /// Over (x, y) in rapid.
  Text& over(double x, double y)
  {
    return (*this)("G0 Z10.")("G0 X" + number(x) + " Y" + number(y));
  }
  std::size_t lines() const { return lines_; }
  Program end(const char* last = "G0 Z10.\nM5\nM2\n") const
  {
    std::istringstream in(text_ + last);
    return readProgram(in);
  }

private:
  static std::string number(double v)
  {
    std::ostringstream text;
    text << std::fixed << std::setprecision(6) << v;
    return text.str();
  }
  std::string text_;
  std::size_t lines_ = 0;
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
