// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// How thick a layer a tool takes at once.
#include "verify_test.h"

using namespace verify_test;

namespace {

/// A block of 40 x 20, 20 high, over a part at its bottom.
struct OnABlock : ::testing::Test {
  const Rectangle area{0, 0, 40, 20};
  const Cloud::Ptr cloud = surface(area, 1.0, [](double, double) { return -20; });
  ProgramVerifier verifier;

  OnABlock()
  {
    verifier.setPart(indexOf(*cloud));
    verifier.setStock({{0, 0, -20}, {40, 20, 0}});
    verifier.setTools({Tool::flat(1, 8), Tool::ball(2, 4)});
  }
  double depthOf(const Text& text, int tool = 1)
  {
    return verifier.verify(text.end()).axial_depth.at(tool);
  }
};
using Engagement = OnABlock;

} // namespace

TEST_F(Engagement, ALevelCutTakesItsDepth)
{
  Text text;
  text.over(-10, 10).feed(-10, 10, -7).feed(50, 10, -7);
  EXPECT_NEAR(depthOf(text), 7, 1e-5);
}

TEST_F(Engagement, AWallOfStockCountsWithItsWholeHeight)
{
  Text text; // a millimetre of the block's flank
  text.over(-10, -3).feed(-10, -3, -20).feed(50, -3, -20);
  EXPECT_NEAR(depthOf(text), 20, 1e-5);
}

TEST_F(Engagement, ShortMovesCountTogether)
{
  // A millimetre of the flank, in moves that are shorter than a cell.
  Text text;
  text.over(-10, -3).feed(-10, -3, -20);
  for (int k = 0; k <= 600; ++k)
    text.feed(-10 + 0.1 * k, -3, -20);
  EXPECT_NEAR(depthOf(text), 20, 1e-5);
}

TEST_F(Engagement, ASteepDescentTakesAPieceAtATime)
{
  // Down the flank, half of the tool in the block: no piece is longer than 2 mm.
  Text steep;
  steep.over(-1, 10).feed(-1, 10, 0.5).feed(0, 10, -19.5);
  EXPECT_LE(depthOf(steep), 2.01);
  EXPECT_GE(depthOf(steep), 1.5);
  Text plunge;
  plunge.over(0, 10).feed(0, 10, 1).feed(0, 10, -19);
  EXPECT_LE(depthOf(plunge), 2.01);
  // The same with a ball.
  Text ball(2);
  ball.over(0, 10).feed(0, 10, 0.5).feed(1, 10, -19.5);
  EXPECT_LE(depthOf(ball, 2), 1.1); // the shank shaves
  EXPECT_GE(depthOf(ball, 2), 0.75);
}

TEST_F(Engagement, InPiecesTheStockIsWhatItIsAtOnce)
{
  Text one, many;
  one.over(-6, 3).feed(-6, 3, -1).feed(46, 17, -18);
  many.over(-6, 3).feed(-6, 3, -1);
  for (int k = 1; k <= 400; ++k)
    many.feed(-6 + 52 * k / 400.0, 3 + 14 * k / 400.0, -1 - 17 * k / 400.0);
  const auto a = verifier.verify(one.end()).milled,
             b = verifier.verify(many.end()).milled;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_NEAR(a[i].z, b[i].z, 1e-4);
}

TEST_F(Engagement, ASplinterIsNoLayerAWallIs)
{
  // Two slots leave a rib between them, which a third pass takes.
  const auto ribOf = [&](double width) {
    Text text;
    for (const double y : {6.0, 6.0 + 8 + width})
      for (double z = -2; z >= -14; z -= 2)
        text.over(-10, y).feed(-10, y, z).feed(50, y, z);
    const double y = 6 + 4 + width / 2;
    text.over(-10, y).feed(-10, y, -14).feed(50, y, -14);
    return depthOf(text);
  };
  EXPECT_NEAR(ribOf(1.0), 14, 1e-5);
  // One row of cells.
  EXPECT_NEAR(ribOf(0.2), 2, 1e-5);
}
