// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// A good program, and what becomes of it when it is spoilt as programs are in practice.
#include "verify_test.h"

#include <functional>

using namespace verify_test;

namespace {

/// A small hill, roughed by a flat end mill and finished by a ball, row by row with a
/// retract after each.
struct Job : ::testing::Test {
  const Rectangle area{0, 0, 24, 18};
  const Cloud::Ptr cloud = surface(area, 0.2, [](double x, double y) {
    return -5 + 3 * std::exp(-((x - 12) * (x - 12) + (y - 9) * (y - 9)) / 30);
  });
  const std::shared_ptr<const PointIndex> part = indexOf(*cloud);
  const Tool rough = Tool::flat(1, 6), fine = Tool::ball(2, 4);
  ProgramVerifier verifier;
  Program program;

  Job()
  {
    verifier.setPart(part);
    verifier.setStock({{0, 0, -6}, {24, 18, 0}});
    verifier.setTools({rough, fine});
    verifier.setResidualLimit(0.05);
    verifier.setBlendLimit(0.01);
    Text text;
    text("G64 P0.005 Q0.");
    mill(text, rough, 0.3, 2, 1.0);
    text("G53 G0 Z0.")("T2 M6")("G43 H2")("S8000 M3")("G0 Z10.");
    mill(text, fine, 0, 0.4, 0.2);
    program = text.end();
  }
  void mill(Text& text, const Tool& tool, double allowance, double step, double chord)
  {
    for (double y = area.y0; y <= area.y1; y += step) {
      text.over(-6, y);
      for (double x = -6; x <= 30; x += chord) {
        const double tip = part->drop(tool.grown(allowance), x, y).tip + allowance;
        text.feed(x, y, std::max(-5.0 + allowance, tip));
      }
    }
  }
  /// The codes for the program as `spoil` leaves each of its moves.
  std::string after(const std::function<void(ProgramMove&)>& spoil) const
  {
    Program spoilt = program;
    for (auto& m : spoilt.moves)
      spoil(m);
    const auto result = verifier.verify(spoilt);
    EXPECT_FALSE(result.good());
    return codes(result);
  }
};
using Mutations = Job;

bool has(const std::string& codes, const std::string& code)
{
  return codes.find(code + " ") != std::string::npos;
}

} // namespace

TEST_F(Mutations, TheProgramItselfIsGood)
{
  const auto result = verifier.verify(program);
  EXPECT_EQ(codes(result), "");
  EXPECT_LE(result.gouge, 0.005);
  EXPECT_EQ(result.sections.size(), 2u);
}

TEST_F(Mutations, LoweredByAFifthOfAMillimetre)
{
  Program lowered = program;
  for (auto& m : lowered.moves)
    m.from.z() -= 0.2, m.to.z() -= 0.2;
  const auto result = verifier.verify(lowered);
  ASSERT_EQ(codes(result), "gouge ");
  EXPECT_NEAR(result.findings[0].worst, 0.2, 0.005);
}

TEST_F(Mutations, ARapidThroughThePart)
{
  // West of the hill a feed is lost, and most of the row with it.
  const auto west = std::find_if(
      program.moves.begin(), program.moves.end(), [](const ProgramMove& m) {
        return m.tool == 2 && !m.rapid && m.to.x() > 2 &&
               std::abs(m.to.y() - 8.8) < 0.1;
      });
  const Eigen::Vector3d east(22, 10, -4.9);
  const std::string found = after([&](ProgramMove& m) {
    if (m.line == west->line) {
      m.rapid = true;
      m.to = east;
    }
    if (m.line == west->line + 1)
      m.from = east;
  });
  EXPECT_TRUE(has(found, "gouge")) << found;
  EXPECT_TRUE(has(found, "rapid_in_stock")) << found;
  EXPECT_TRUE(has(found, "rapid_in_part")) << found;
}

TEST_F(Mutations, AWrongTool)
{
  // The finishing with the roughing tool.
  EXPECT_TRUE(
      has(after([](ProgramMove& m) { m.tool = m.tool == 2 ? 1 : m.tool; }), "gouge"));
  // A thinner one leaves more; one that nobody knows is named.
  verifier.setTools({rough, Tool::ball(2, 0.6)});
  EXPECT_TRUE(has(after([](ProgramMove&) {}), "residual"));
  EXPECT_TRUE(has(after([](ProgramMove& m) { m.tool = m.tool == 2 ? 5 : m.tool; }),
                  "unknown_tool"));
}

TEST_F(Mutations, AShiftedOrigin)
{
  for (const Eigen::Vector3d& shift :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(0, 0, -1)})
    EXPECT_TRUE(
        has(after([&](ProgramMove& m) { m.from += shift, m.to += shift; }), "gouge"));
  // Upwards it gouges nothing, but leaves all of it.
  EXPECT_EQ(after([](ProgramMove& m) { m.from.z() += 1, m.to.z() += 1; }), "residual ");
}

TEST_F(Mutations, ADroppedRetract)
{
  // The first after a finishing row: the way back goes through what the row left.
  std::size_t drop = 0;
  for (std::size_t k = 0; k < program.moves.size() && drop == 0; ++k)
    if (program.moves[k].rapid && program.moves[k].tool == 2 &&
        program.moves[k].to.z() > program.moves[k].from.z() &&
        std::abs(program.moves[k].from.y() - 8) < 0.3)
      drop = k;
  ASSERT_GT(drop, 0u);
  Program spoilt = program;
  spoilt.moves[drop + 1].from.z() = spoilt.moves[drop].from.z();
  spoilt.moves[drop + 1].to.z() = spoilt.moves[drop].from.z();
  spoilt.moves[drop + 2].from.z() = spoilt.moves[drop].from.z();
  spoilt.moves.erase(spoilt.moves.begin() + std::ptrdiff_t(drop));
  const auto result = verifier.verify(spoilt);
  EXPECT_FALSE(result.good());
  EXPECT_TRUE(has(codes(result), "rapid_in_stock")) << codes(result);
  EXPECT_TRUE(has(codes(result), "rapid_in_part")) << codes(result);
}
