// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Stock as it was scanned: high enough everywhere, full where nothing was seen.
#include <pointmill/common/error.h>
#include <pointmill/surface/raw_stock.h>
#include <pointmill_test/clouds.h>

#include <gtest/gtest.h>

using namespace pointmill;
using namespace pointmill_test;

namespace {

const Stock kBox{{0, 0, -10}, {30, 20, 5}};

double sloped(double x, double y)
{
  return -6 + 0.2 * x + 0.1 * y;
}

} // namespace

TEST(RawStock, IsNeverLowerThanTheRawPart)
{
  const auto raw = indexOf(*surface({0, 0, 30, 20}, 0.25, sloped));
  const auto upper = stockOf(kBox, 0.5, StockField::Bound::Upper, *raw, 0.6);
  const auto nominal = stockOf(kBox, 0.2, StockField::Bound::Nominal, *raw, 0.6);
  const double rise = std::hypot(0.2, 0.1);
  for (int row = 0; row < nominal.rows(); ++row)
    for (int column = 0; column < nominal.columns(); ++column) {
      const double x = nominal.x(column), y = nominal.y(row);
      const double height = nominal.height(column, row);
      EXPECT_GE(height, sloped(x, y) - 1e-5);
      EXPECT_LE(height, sloped(x, y) + rise * 0.6 + 1e-5);
      EXPECT_GE(upper.highest(x, y, 0), height)
          << "the bound holds at " << x << " " << y;
    }
}

TEST(RawStock, IsFullWhereNothingWasSeen)
{
  const auto raw = indexOf(*surface({0, 0, 12, 20}, 0.25, sloped));
  for (const auto bound : {StockField::Bound::Upper, StockField::Bound::Nominal}) {
    const auto field = stockOf(kBox, 0.5, bound, *raw, 0.6);
    for (int row = 0; row < field.rows(); ++row)
      for (int column = 0; column < field.columns(); ++column) {
        const double x = field.x(column), h = field.height(column, row);
        if (x > 12 + 0.6) {
          EXPECT_EQ(h, 5.f) << x;
        }
        else if (x < 11) {
          EXPECT_LT(h, 0) << x;
        }
      }
    EXPECT_LT(field.highest(3, 3, 1), 0) << "runs know that they are lower";
  }
}

TEST(RawStock, BoundsOfCellsWiderThanTheReachAreFull)
{
  const auto raw = indexOf(*surface({0, 0, 30, 20}, 0.25, sloped));
  const auto field = stockOf(kBox, 2.0, StockField::Bound::Upper, *raw, 0.6);
  EXPECT_EQ(field.highest(15, 10, 20), 5.f);
  EXPECT_EQ(field.height(7, 5), 5.f);
  EXPECT_THROW(stockOf(kBox, 2.0, StockField::Bound::Upper, *raw, 0.0), ParameterError);
}
