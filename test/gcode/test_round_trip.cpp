// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "sample.h"

#include <pointmill/gcode/gcode_reader.h>

#include <gtest/gtest.h>

namespace {

/// The CL points in their order, as a machine that has read the program goes to them.
void expectSamePath(const std::vector<pointmill::Operation>& operations,
                    const pointmill::Program& program)
{
  std::size_t next = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  for (const auto& op : operations) {
    bool first = true;
    for (const auto& p : op.path) {
      const auto reached = [&] {
        // X and Y to half a decimal, Z never below.
        return std::abs(at.x() - p.x) < 5.1e-5 && std::abs(at.y() - p.y) < 5.1e-5 &&
               at.z() >= p.z - 5e-6 && at.z() < p.z + 1e-4;
      };
      while (!reached()) {
        ASSERT_LT(next, program.moves.size());
        const auto& move = program.moves[next++];
        at = move.to;
        if (!first) {
          ASSERT_TRUE(reached()) << "line " << move.line;
          const auto how = p.getMotion();
          ASSERT_EQ(move.rapid,
                    how == pointmill::Motion::Rapid ||
                        how == pointmill::Motion::Retract);
          if (!move.rapid) {
            ASSERT_NEAR(move.feed, p.feed, 5.1e-4);
          }
          ASSERT_EQ(move.tool, op.tool.number);
          ASSERT_EQ(move.spindle, op.cutting.spindle);
          ASSERT_TRUE(move.from_known);
        }
      }
      first = false;
    }
  }
  EXPECT_EQ(next + 1, program.moves.size()) << "only the last retract remains";
}

} // namespace

TEST(RoundTrip, TenThousandPoints)
{
  for (const int decimals : {4, 6}) {
    const auto operations = sample::random(10000, 3, 42);
    pointmill::GCodeWriter writer;
    writer.setClearancePlane(12.5);
    writer.setDecimals(decimals);
    std::stringstream text;
    const auto statistics = writer.write(operations, text);
    const auto program = pointmill::readProgram(text);
    EXPECT_TRUE(program.ended);
    EXPECT_FALSE(program.inches);
    EXPECT_EQ(program.lines, statistics.lines);
    EXPECT_EQ(program.blend, 0.01);
    EXPECT_EQ(program.merge, 0.0);
    EXPECT_EQ(program.tools, (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(program.moves.size(), statistics.feed_moves + statistics.rapids);
    expectSamePath(operations, program);
  }
}

TEST(RoundTrip, RapidsKeepTheirRules)
{
  std::stringstream text(sample::write(sample::random(10000, 3, 5), 12.5));
  for (const auto& m : pointmill::readProgram(text).moves) {
    if (!m.rapid || !m.to.allFinite() || !m.from_known)
      continue;
    const bool sideways = (m.to - m.from).head<2>().norm() > 0;
    if (sideways) {
      EXPECT_GE(m.from.z(), 12.5);
      EXPECT_EQ(m.from.z(), m.to.z());
    }
  }
}

TEST(RoundTrip, MovesCanBeReadOneByOne)
{
  const auto text = sample::write(sample::random(3000, 2, 9), 12.5);
  std::istringstream whole(text), pieces(text);
  const auto program = pointmill::readProgram(whole);
  std::size_t n = 0;
  const auto rest = pointmill::GCodeReader().read(pieces, [&](const auto& m) {
    ASSERT_LT(n, program.moves.size());
    EXPECT_EQ(m.line, program.moves[n++].line);
  });
  EXPECT_EQ(n, program.moves.size());
  EXPECT_TRUE(rest.moves.empty());
  EXPECT_EQ(rest.lines, program.lines);
}
