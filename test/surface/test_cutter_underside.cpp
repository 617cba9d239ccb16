// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "cutter_underside.h"

#include <gtest/gtest.h>

#include <cmath>

using pointmill::CutterUnderside;
using pointmill::Paraboloid;
using pointmill::SampledUnderside;
using pointmill::Tool;

namespace {

/// How far at most a paraboloid comes over the profile, and how far it is under it at
/// r.
template <typename Profile>
void expectUnder(
    const Paraboloid& under, double radius, Profile profile, double r, double gap)
{
  const auto height = [&](double d) { return under.height + under.bend * d * d; };
  for (int k = 0; k <= 5000; ++k) {
    const double d = radius * k / 5000;
    ASSERT_LE(height(d), profile(d) + 1e-12 * radius)
        << "touching " << r << " at " << d;
  }
  EXPECT_GE(height(r), profile(r) - gap) << "touching " << r;
}

} // namespace

TEST(CutterUnderside, IsNowhereAboveTheCutterAndTouchesIt)
{
  for (const Tool& tool : {Tool::flat(1, 4.0),
                           Tool::ball(2, 3.0),
                           Tool::bull(3, 5.0, 1.0),
                           Tool::bull(4, 10.0, 0.1),
                           Tool::ball(5, 3.0).grown(0.3)}) {
    const CutterUnderside underside(tool);
    for (double share : {0.0, 0.1, 0.5, 0.79, 0.81, 0.9, 0.97, 1.0}) {
      const double r = share * tool.radius();
      const double gap = share < 0.975 || tool.isFlat() ? 1e-12 : tool.corner_radius;
      expectUnder(
          underside.touching(r),
          tool.radius(),
          [&](double d) { return tool.profile(d); },
          r,
          gap);
    }
  }
}

TEST(CutterUnderside, OfATaperedToolIsNowhereAboveIt)
{
  for (const Tool& tool : {Tool::taperBall(1, 1.0, 5.0, 6.0),
                           Tool::taperBull(2, 3.0, 0.5, 10.0, 8.0),
                           Tool::cone(3, 45.0, 4.0),
                           Tool::cone(4, 15.0, 3.0, 0.2).grown(0.2)})
    for (double share : {0.0, 0.1, 0.3, 0.6, 0.9, 1.0})
      expectUnder(
          CutterUnderside(tool).touching(share * tool.radius()),
          tool.radius(),
          [&](double d) { return tool.profile(d); },
          share * tool.radius(),
          tool.profile(tool.radius()));
}

TEST(CutterUnderside, OfAnyConvexProfileIsNowhereAboveIt)
{
  const double radius = 3;
  const auto cone = [](double r) { return 1.7 * r; };
  const auto engraver = [](double r) { return 4.0 * std::max(0.0, r - 0.2); };
  // A ball of radius 1 whose flank goes on as a cone of half-angle 10 degrees.
  const auto taper = [](double r) {
    const double half = 10 * 3.14159265358979 / 180, meets = std::cos(half);
    return r < meets ? 1 - std::sqrt(1 - r * r)
                     : 1 - std::sin(half) + (r - meets) / std::tan(half);
  };
  const auto ball = [&](double r) {
    return radius - std::sqrt(radius * radius - r * r);
  };
  const auto flat = [](double) { return 0.0; };
  for (double r : {0.0, 0.01, 0.3, 0.9, 1.0, 1.6, 2.7, 2.99, 3.0}) {
    expectUnder(SampledUnderside(radius, cone).touching(r), radius, cone, r, radius);
    expectUnder(SampledUnderside(radius, engraver).touching(r),
                radius,
                engraver,
                r,
                3 * radius);
    expectUnder(
        SampledUnderside(radius, taper).touching(r), radius, taper, r, 4 * radius);
    expectUnder(SampledUnderside(radius, ball).touching(r),
                radius,
                ball,
                r,
                r < 2.9 ? 0.02 * radius : radius);
    expectUnder(SampledUnderside(radius, flat).touching(r), radius, flat, r, 1e-12);
  }
}
