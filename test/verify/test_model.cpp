// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Noisy scans are judged by their smoothed surface.
#include "verify_test.h"

using namespace verify_test;

namespace {

constexpr double kNoise = 0.04;

/// A plate at -2 as it is and as it was measured, and rows of a flat over it.
struct NoisyPlate : ::testing::Test {
  const Rectangle area{0, 0, 30, 20};
  const Cloud::Ptr smooth = surface(area, 0.3, [](double, double) { return -2; });
  Cloud::Ptr measured{new Cloud(*smooth)};
  ProgramVerifier verifier;
  double peak = 0;

  NoisyPlate()
  {
    Random random(8);
    for (auto& p : *measured) {
      const double off = kNoise * random.normal();
      p.z += static_cast<float>(off);
      peak = std::max(peak, off);
    }
    verifier.setPart(indexOf(*measured));
    verifier.setStock({{0, 0, -3}, {30, 20, 0}});
    verifier.setTools({Tool::flat(1, 6)});
    verifier.setResidualLimit(0.5);
  }
  static Program rows(double z)
  {
    Text text;
    text.over(-5, 0).feed(-5, 0, z);
    bool back = false;
    for (double y = 0; y <= 20; y += 4, back = !back)
      text.feed(back ? 35 : -5, y, z).feed(back ? -5 : 35, y, z);
    return text.end();
  }
};
using Model = NoisyPlate;

} // namespace

TEST_F(Model, WithoutOneThePeaksOfTheNoiseAreGouged)
{
  const auto result = verifier.verify(rows(-2));
  EXPECT_EQ(codes(result), "gouge ");
  EXPECT_NEAR(result.gouge, peak, 1e-5);
  EXPECT_EQ(result.raw_gouge, 0);
  EXPECT_EQ(result.raw_gouged_points, 0u);
  EXPECT_EQ(result.raw_deviation.max, 0);
}

TEST_F(Model, TheSurfaceIsHeldToTheToleranceThePeaksToTheAllowance)
{
  verifier.setModel(indexOf(*smooth));
  verifier.setNoiseAllowance(peak);
  const auto result = verifier.verify(rows(-2));
  EXPECT_TRUE(result.good()) << codes(result);
  EXPECT_NEAR(result.gouge, 0, 1e-6);
  EXPECT_NEAR(result.residual.max, 0, 1e-5);
  EXPECT_NEAR(result.deviation.max, 0, 1e-5);
  EXPECT_EQ(result.points, smooth->size());
  EXPECT_NEAR(result.raw_gouge, peak, 1e-5);
  EXPECT_EQ(result.raw_gouged_points, 0u);
  // Surface minus point is minus the noise.
  EXPECT_NEAR(result.raw_deviation.p50, 0, 0.1 * kNoise);
  EXPECT_NEAR(result.raw_deviation.p95, 1.645 * kNoise, 0.1 * kNoise);
}

TEST_F(Model, PeaksBeyondTheAllowanceAreAFindingOfTheirOwn)
{
  verifier.setModel(indexOf(*smooth));
  verifier.setNoiseAllowance(2 * kNoise - 0.02);
  const auto result = verifier.verify(rows(-2));
  const auto* gouge = find(result, "scan_gouge");
  ASSERT_NE(gouge, nullptr);
  EXPECT_EQ(result.findings.size(), 1u) << codes(result);
  EXPECT_NEAR(gouge->worst, peak, 1e-5);
  std::size_t high = 0;
  for (const auto& p : *measured)
    high += p.z > -2 + 2 * kNoise;
  EXPECT_NEAR(double(result.raw_gouged_points), double(high), 1);
  EXPECT_GT(high, 50u);
  EXPECT_EQ(result.gouged_points, 0u);
}

TEST_F(Model, ACutIntoTheSurfaceIsOneWhateverTheAllowance)
{
  verifier.setModel(indexOf(*smooth));
  verifier.setNoiseAllowance(10);
  const auto result = verifier.verify(rows(-2.03));
  const auto* gouge = find(result, "gouge");
  ASSERT_NE(gouge, nullptr);
  EXPECT_EQ(result.findings.size(), 1u) << codes(result);
  EXPECT_NEAR(gouge->worst, 0.03, 1e-5);
  EXPECT_EQ(result.gouged_points, smooth->size());
}

TEST_F(Model, AnAbsurdAllowanceIsRefused)
{
  verifier.setNoiseAllowance(-0.01);
  EXPECT_THROW(verifier.verify(rows(-2)), ParameterError);
}
