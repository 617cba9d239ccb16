// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "mill_test.h"

using namespace mill_test;

TEST(MillOptions, TheDefaultsAreGood)
{
  EXPECT_NO_THROW(MillOptions().validate());
}

TEST(MillOptions, AbsurdOnesAreRefused)
{
  const double nan = std::nan("");
  const auto refused = [](const char* why, auto&& change) {
    MillOptions options;
    change(options);
    EXPECT_THROW(options.validate(), ParameterError) << why;
  };
  refused("tolerance", [](auto& o) { o.tolerance = 0; });
  refused("tolerance NaN", [&](auto& o) { o.tolerance = nan; });
  refused("scallop", [](auto& o) { o.scallop = -0.01; });
  refused("units", [](auto& o) { o.mm_per_unit = 0; });
  refused("fit", [](auto& o) { o.fit = -5; });
  refused("clearance", [](auto& o) { o.clearance = 0; });
  refused("step-over", [](auto& o) { o.step_over = o.rough.tool.diameter + 0.1; });
  refused("stock margin", [](auto& o) { o.stock_margin = -1; });
  refused("residual", [&](auto& o) { o.residual_limit = nan; });
  refused("tool", [](auto& o) { o.semi.tool.diameter = 0; });
  refused("tool NaN", [&](auto& o) { o.finish.tool.diameter = nan; });
  refused("feed", [](auto& o) { o.rough.cutting.feed = 0; });
  refused("plunge feed", [](auto& o) { o.semi.cutting.plunge_feed = -1; });
  refused("spindle", [](auto& o) { o.finish.cutting.spindle = 0; });
  refused("allowance", [](auto& o) { o.rough.allowance = -0.1; });
  refused("one number", [](auto& o) { o.semi.tool.number = o.finish.tool.number; });
}

TEST(MillOptions, TheErrorBudgetAddsUpToTheTolerance)
{
  for (const double tolerance : {0.002, 0.02, 1.0}) {
    const auto budget = ErrorBudget::of(tolerance);
    EXPECT_NEAR(
        budget.chord + budget.arcs + budget.blend + budget.rounding, tolerance, 1e-12);
    EXPECT_GT(std::min({budget.chord, budget.arcs, budget.blend, budget.rounding}), 0);
  }
}
