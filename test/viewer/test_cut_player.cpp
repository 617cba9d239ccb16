// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "viewer_test.h"

#include <pointmill/common/error.h>
#include <pointmill/common/watch.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace viewer_test;

namespace {

/// What stands over a place after the slot and, if it @p crosses, the groove.
double truth(double x, double y, bool crosses)
{
  double z = std::abs(y - 15) <= 3 ? -4 : 0;
  const double off = std::abs(x - 30);
  if (crosses && off < 2)
    z = std::min(z, -2 + 2 - std::sqrt(4 - off * off));
  return z;
}

void expectField(const CutPlayer& player, bool crosses, double until_x = 1e9)
{
  const StockField& field = player.stock();
  int wrong = 0;
  for (int r = 0; r < field.rows(); ++r)
    for (int c = 0; c < field.columns(); ++c)
      if (field.x(c) < until_x)
        wrong += std::abs(field.height(c, r) - truth(field.x(c), field.y(r), crosses)) >
                 1e-5;
  EXPECT_EQ(wrong, 0);
}

/// Rows and links at random in the block, some rapid.
std::string randomProgram(int moves)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(0, 40), y(0, 30), z(-8, 3);
  std::ostringstream text;
  text << "G21 G17 G90 G94 G54\nT2 M6\nG43 H2\nS9000 M3\nG0 X0 Y0\nG0 Z5\n";
  for (int i = 0; i < moves; ++i)
    text << (i % 7 == 3 ? "G0" : "G1") << " X" << x(random) << " Y" << y(random) << " Z"
         << z(random) << (i % 7 == 3 ? "" : " F900") << "\n";
  text << "G0 Z5\nM5\nM2\n";
  return text.str();
}

std::vector<float> heights(const CutPlayer& player)
{
  std::vector<float> all;
  for (int r = 0; r < player.stock().rows(); ++r)
    for (int c = 0; c < player.stock().columns(); ++c)
      all.push_back(static_cast<float>(player.stock().height(c, r)));
  return all;
}

} // namespace

TEST(CutPlayer, CutsWhatTheProgramSays)
{
  const auto player = playerOf(twoCuts());
  player->seek(player->duration());
  expectField(*player, true);
  EXPECT_DOUBLE_EQ(player->time(), player->duration());
}

TEST(CutPlayer, IsWhereTheToolIsAtAnyMoment)
{
  const auto player = playerOf(twoCuts());
  const std::size_t slot = player->moveOfLine(9);
  const double middle = (player->beginOf(slot) + player->endOf(slot)) / 2;
  player->seek(middle);
  EXPECT_EQ(player->move(), slot);
  EXPECT_NEAR(player->tip().x(), 20, 1e-6); // half of the way from -5 to 45
  EXPECT_NEAR(player->tip().z(), -4, 1e-9);
  ASSERT_NE(player->tool(), nullptr);
  EXPECT_EQ(player->tool()->number, 1);
  EXPECT_EQ(player->sectionOf(player->move()), 0u);
  expectField(*player, false, 20 - 0.2); // behind the axis
  // Ahead of the tool the block stands.
  const StockField& field = player->stock();
  EXPECT_EQ(field.height(field.columns() - 1, field.rowOf(15)), 0);
}

TEST(CutPlayer, GoesBackToWhatItWas)
{
  const auto player = playerOf(twoCuts());
  const std::size_t slot = player->moveOfLine(9);
  player->seek(player->duration());
  player->seek(player->endOf(slot));
  expectField(*player, false);
  player->seek(0);
  for (const float z : heights(*player))
    ASSERT_EQ(z, 0);
}

TEST(CutPlayer, ComesToTheSameStockOnAnyWay)
{
  const auto player = playerOf(randomProgram(700), 0.5);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> moment(0, player->duration());
  for (int i = 0; i < 12; ++i) {
    const double t = moment(random);
    player->seek(t);
    const auto straight = playerOf(randomProgram(700), 0.5);
    straight->seek(t);
    const auto a = heights(*player), b = heights(*straight);
    double worst = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
      worst = std::max<double>(worst, std::abs(a[k] - b[k]));
    EXPECT_LT(worst, 1e-4) << "at " << t; // a move in two parts rounds otherwise
  }
}

TEST(CutPlayer, ThreadsChangeNothing)
{
  const auto program = programOf(randomProgram(700));
  std::vector<float> first;
  for (const unsigned threads : {1u, 2u, 5u}) {
    CutPlayer player(StockField(block(), 0.25, StockField::Bound::Nominal),
                     program,
                     endsOf(*program),
                     tools(),
                     threads);
    player.seek(player.duration());
    if (first.empty())
      first = heights(player);
    EXPECT_EQ(heights(player), first);
  }
}

TEST(CutPlayer, KnowsWhatCutACellLast)
{
  const auto player = playerOf(twoCuts());
  player->seek(player->duration());
  const StockField& field = player->stock();
  const auto by = [&](double x, double y) {
    const int c = static_cast<int>((x - field.stock().min.x()) / field.cellSize());
    return player
        ->cutBy()[static_cast<std::size_t>(field.rowOf(y)) * field.columns() + c];
  };
  EXPECT_EQ(by(10, 15), 0);                // in the slot
  EXPECT_EQ(by(30, 5), 1);                 // in the groove
  EXPECT_EQ(by(30, 15), 0);                // where they cross: the groove is less deep
  EXPECT_EQ(by(10, 5), CutPlayer::kUncut); // beside both
  EXPECT_EQ(player->sectionOf(player->moveOfLine(19)), 1u);
}

TEST(CutPlayer, WhatCutACellDoesNotDependOnHowFinelyItIsMilled)
{
  // Down a ramp of 1 mm over 20 mm, in one move and in 800.
  const std::string head = "G21 G17 G90 G94 G54\n(Operation 1: ramp)\nT1 M6\nG43 H1\n"
                           "S8000 M3\nG0 X10 Y15\nG0 Z5\nG1 Z0 F600\n";
  std::ostringstream chords;
  chords << head;
  for (int i = 1; i <= 800; ++i)
    chords << "G1 X" << 10 + i * 0.025 << " Z" << -i * 0.00125 << "\n";
  const auto one = playerOf(head + "G1 X30 Z-1\nG0 Z5\nM5\nM2\n");
  const auto many = playerOf(chords.str() + "G0 Z5\nM5\nM2\n");
  const auto ticks = playerOf(head + "G1 X30 Z-1\nG0 Z5\nM5\nM2\n");
  one->seek(one->duration());
  many->seek(many->duration());
  for (double t = 0; t < ticks->duration(); t += 0.02)
    ticks->seek(t);
  ticks->seek(ticks->duration());
  const auto cut = [](const CutPlayer& player) {
    return std::count(player.cutBy().begin(), player.cutBy().end(), 0);
  };
  EXPECT_GT(cut(*one), 1500);
  EXPECT_NEAR(cut(*many), cut(*one), 20);
  EXPECT_NEAR(cut(*ticks), cut(*one), 20);
}

TEST(CutPlayer, FindsWhenTheToolIsNearestToAPlace)
{
  const auto player = playerOf(twoCuts());
  player->seek(player->nearestInLine(9, {12, 15, -4}));
  EXPECT_NEAR(player->tip().x(), 12, 1e-6);
  player->seek(player->nearestInLine(9, {99, 15, -4})); // beyond its end
  EXPECT_NEAR(player->tip().x(), 45, 1e-6);
}

TEST(CutPlayer, TellsHowFarItIsAndStops)
{
  const auto player = playerOf(randomProgram(2000), 0.5);
  Watch watch;
  player->seek(player->duration() / 2);
  EXPECT_EQ(watch.share(), 1.0);
  EXPECT_EQ(watch.stage(), "cutting the stock");
  watch.stop();
  EXPECT_THROW(player->seek(player->duration()), Interrupted);
  EXPECT_EQ(player->time(), 0);
  for (const float z : heights(*player)) // the whole block, not half a cut
    ASSERT_EQ(z, 0);
}

TEST(CutPlayer, APlaceThatIsNotKnownIsNone)
{
  const auto player = playerOf(twoCuts());
  player->seek(0);
  EXPECT_FALSE(player->tip().allFinite()); // before the first move in Z
  const auto nothing = playerOf("G21 G17 G90 G94 G54\nM2\n");
  nothing->seek(5);
  EXPECT_EQ(nothing->duration(), 0);
  EXPECT_EQ(nothing->tool(), nullptr);
  EXPECT_EQ(nothing->moveOfLine(7), 0u);
}

TEST(CutPlayer, TimesOfAnotherProgramAreRefused)
{
  const auto program = programOf(twoCuts());
  EXPECT_THROW(CutPlayer(StockField(block(), 0.5, StockField::Bound::Nominal),
                         program,
                         {1.0, 2.0},
                         tools()),
               DataError);
}
