// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What the arc fitter's proof says of arcs that the fitter would not try.
#include "arc_fit.h"
#include "arc_geometry.h"

#include <pointmill_test/random.h>

#include <gtest/gtest.h>

using pointmill::MachineArc;
using pointmill_test::Random;
using namespace pointmill::gcode;

namespace {

const double pi = std::acos(-1.0);

ArcLimits anything()
{
  ArcLimits limits;
  limits.tolerance = 1e9;
  limits.largest_radius = 1e12;
  limits.largest_sweep = 6.28;
  limits.steepest = 1e9;
  limits.mismatch = 1e9;
  return limits;
}

/// A circle's points at some angles [deg], about the origin in XY.
arcs::Path onCircle(double radius, const std::vector<double>& angles, double climb = 0)
{
  arcs::Path path;
  for (const double a : angles)
    path.emplace_back(std::round(radius * std::cos(a * pi / 180)),
                      std::round(radius * std::sin(a * pi / 180)),
                      std::round(climb * double(path.size())));
  return path;
}

/// The arc in XY from the path's first to its last point.
MachineArc about(const arcs::Path& path, double x, double y, bool clockwise = false)
{
  MachineArc arc;
  arc.to = toPosition(path.back());
  arc.clockwise = clockwise;
  arc.u = std::llround(x - path.front().x());
  arc.v = std::llround(y - path.front().y());
  return arc;
}

double deviation(const arcs::Path& path, const MachineArc& arc, const ArcLimits& limits)
{
  return arcDeviation({path.data(), path.size()}, arc, limits);
}

} // namespace

TEST(ArcDeviation, OfOneChordIsItsSagitta)
{
  const auto path = onCircle(1e6, {10, 50});
  const double sagitta = 1e6 * (1 - std::cos(20 * pi / 180));
  EXPECT_NEAR(deviation(path, about(path, 0, 0), anything()), sagitta, 2);
  auto limits = anything();
  limits.tolerance = sagitta - 3;
  EXPECT_TRUE(std::isinf(deviation(path, about(path, 0, 0), limits)));
}

TEST(ArcDeviation, OfAHelixIsLargestWhereBothClimbAlike)
{
  // Chords with ends at different radii, so that they do not turn evenly about their
  // middle, and climbs of all kinds: what is found at the same angle by dense sampling.
  Random random(5);
  for (int round = 0; round < 200; ++round) {
    arcs::Path path = onCircle(
        1e6, {random.uniform(0, 5), random.uniform(20, 60), random.uniform(70, 100)});
    path[1] *= random.uniform(0.8, 1.2);
    for (auto& p : path)
      p = {std::round(p.x()), std::round(p.y()), std::round(random.uniform(-9e6, 9e6))};
    const auto arc = about(path, 0, 0);
    const arcs::Turn turn(path.front(), arc);
    const double begin = std::atan2(path[0].y(), path[0].x());
    double is = 0;
    for (int chord = 0; chord < 2; ++chord) {
      double in_plane = 0, along = 0;
      for (const auto& p : arcs::refined({path[chord], path[chord + 1]}, 3000)) {
        const double part = (std::atan2(p.y(), p.x()) - begin) / turn.sweep;
        in_plane = std::max(in_plane, std::abs(std::hypot(p.x(), p.y()) - 1e6));
        along = std::max(along, std::abs(p.z() - turn.at(part).z()));
      }
      is = std::max(is, std::hypot(in_plane, along));
    }
    EXPECT_NEAR(deviation(path, arc, anything()), is, 5 + 1e-6 * is) << round;
  }
}

TEST(ArcDeviation, NoWayBackAndNoMoreThanOneTurn)
{
  const auto finite = [](const std::vector<double>& angles, bool clockwise = false) {
    const auto path = onCircle(1e6, angles);
    return std::isfinite(deviation(path, about(path, 0, 0, clockwise), anything()));
  };
  EXPECT_TRUE(finite({0, 30, 60, 90}));
  EXPECT_FALSE(finite({0, 30, 60, 90}, true)) << "the other way round";
  EXPECT_TRUE(finite({90, 60, 30, 0}, true));
  EXPECT_FALSE(finite({0, 40, 20, 90})) << "back and forth";
  EXPECT_TRUE(finite({0, 80, 160, 240, 300, 350}));
  EXPECT_FALSE(finite({0, 80, 160, 240, 300, 380, 440})) << "round past the start";
  EXPECT_FALSE(finite({0, 95})) << "more than a quarter turn in one chord";
  auto radial = onCircle(1e6, {0, 30, 60});
  radial.insert(radial.begin() + 1, radial[0] * 1.5);
  EXPECT_FALSE(std::isfinite(deviation(radial, about(radial, 0, 0), anything())));
}

TEST(ArcDeviation, KeepsEachLimit)
{
  const auto path = onCircle(1e6, {0, 30, 60, 90}, 1e5);
  const double climb = 3e5 / (1e6 * pi / 2);
  const auto finite = [&](auto&& set) {
    auto limits = anything();
    set(limits);
    return std::isfinite(deviation(path, about(path, 3, 0), limits));
  };
  EXPECT_TRUE(finite([](ArcLimits& l) { l.mismatch = 3.01; }));
  EXPECT_FALSE(finite([](ArcLimits& l) { l.mismatch = 2.99; }));
  EXPECT_TRUE(finite([](ArcLimits& l) { l.largest_sweep = pi / 2 + 1e-5; }));
  EXPECT_FALSE(finite([](ArcLimits& l) { l.largest_sweep = pi / 2 - 1e-5; }));
  EXPECT_TRUE(finite([](ArcLimits& l) { l.largest_radius = 1e6 + 4; }));
  EXPECT_FALSE(finite([](ArcLimits& l) { l.largest_radius = 1e6 - 1; }));
  EXPECT_TRUE(finite([](ArcLimits& l) { l.smallest_radius = 1e6 - 4; }));
  EXPECT_FALSE(finite([](ArcLimits& l) { l.smallest_radius = 1e6 - 2; }));
  EXPECT_TRUE(finite([&](ArcLimits& l) { l.steepest = 1.001 * climb; }));
  EXPECT_FALSE(finite([&](ArcLimits& l) { l.steepest = 0.999 * climb; }));
}

TEST(ArcDeviation, OfAStraightMoveIsThatOfTheFarthestPoint)
{
  const arcs::Path path{{0, 0, 0}, {100, 30, 40}, {200, -10, 0}, {300, 0, 0}};
  EXPECT_DOUBLE_EQ(straightDeviation({path.data(), 4}, 50.1), 50);
  EXPECT_TRUE(std::isinf(straightDeviation({path.data(), 4}, 49.9)));
  const arcs::Path back{{0, 0, 0}, {200, 0, 0}, {100, 0, 0}, {300, 0, 0}};
  EXPECT_TRUE(std::isinf(straightDeviation({back.data(), 4}, 500)));
  const arcs::Path beyond{{0, 0, 0}, {301, 0, 0}, {300, 0, 0}};
  EXPECT_TRUE(std::isinf(straightDeviation({beyond.data(), 3}, 500)));
  const arcs::Path closed{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  EXPECT_TRUE(std::isinf(straightDeviation({closed.data(), 3}, 500)));
}
