// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "read_back.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace pointmill;

namespace {

/// Down, along, and up again.
CLCloud smallPath()
{
  CLCloud path;
  path.push_back(PointCL(1, 2, 5, Motion::Rapid));
  path.push_back(PointCL(1, 2, 1, Motion::Rapid));
  path.push_back(PointCL(1, 2, -1.3, Motion::Plunge));
  path.push_back(PointCL(4.00004, 2, -1.3));
  path.push_back(PointCL(4, 6, -1.29996));
  path.push_back(PointCL(4, 6, 5, Motion::Retract));
  for (auto& p : path)
    p.feed = 600;
  return path;
}

struct Written {
  Written()
  {
    writer.setClearancePlane(5);
    std::ostringstream out;
    writer.write({{"passes", Tool::ball(1, 3), {}, smallPath()}}, out);
    text = out.str();
  }
  /// What differs once @p old of the text is something else.
  std::string changed(const std::string& old, const std::string& now) const
  {
    std::string other = text;
    const auto at = other.find(old);
    EXPECT_NE(at, std::string::npos) << old << " is not in\n" << text;
    other.replace(at, old.size(), now);
    std::istringstream in(other);
    return differenceFrom(smallPath(), readProgram(in), writer);
  }
  GCodeWriter writer;
  std::string text;
};

} // namespace

TEST(ReadBack, AProgramIsThatOfItsPath)
{
  EXPECT_EQ(Written().changed("", ""), "");
}

TEST(ReadBack, WhatDiffersIsFound)
{
  const Written program;
  EXPECT_NE(program.changed("X4.", "X4.0003"), "");
  EXPECT_NE(program.changed("Y6.", "Y7."), "");
  EXPECT_NE(program.changed("Z-1.3", "Z-1.3001"), ""); // deeper
  EXPECT_NE(program.changed("F600.", "F700."), "");
  EXPECT_NE(program.changed("G0 Z5.\nM5", "G1 Z5.\nM5"), "");
  EXPECT_NE(program.changed("Y6.", "Y4.\nY6."), "");                     // one more
  EXPECT_NE(program.changed("X4.", ""), "");                             // one less
  EXPECT_NE(program.changed("G0 Z5.\nM5", "G0 Z5.\nG1 X0 F1.\nM5"), ""); // goes on
}

TEST(ReadBack, PassesThatAreLeftOutAreCounted)
{
  CLCloud passes;
  for (const std::uint32_t label : {0u, 1u, 2u})
    for (const double x : {0.0, 1.0, 2.0}) {
      passes.push_back(PointCL(x, label, 0));
      passes.back().label = label;
    }
  CLCloud path = passes;
  EXPECT_EQ(pointsLeftOut(passes, path), 0u);
  path.erase(path.begin() + 3, path.begin() + 6);
  EXPECT_EQ(pointsLeftOut(passes, path), 3u);
}
