// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "rough_parts.h"

#include <pointmill_test/freeform.h>
#include <pointmill_test/sample_part.h>

#include <algorithm>
#include <cmath>

namespace bench {
namespace {

double away(double x, double y, double cx, double cy)
{
  return std::hypot(x - cx, y - cy);
}

/// Signed distance to a rectangle with corners of radius @p r, negative inside.
double box(double x, double y, double x0, double x1, double y0, double y1, double r = 0)
{
  const double u = std::abs(x - (x0 + x1) / 2) - ((x1 - x0) / 2 - r);
  const double v = std::abs(y - (y0 + y1) / 2) - ((y1 - y0) / 2 - r);
  return std::hypot(std::max(u, 0.0), std::max(v, 0.0)) +
         std::min(std::max(u, v), 0.0) - r;
}

/// A plate of 18 mm with a rectangular pocket round two islands and a round pocket
/// round one, closed on all sides.
double pockets(double x, double y)
{
  double z = 18;
  if (box(x, y, 6, 74, 6, 74, 8) < 0)
    z = 4;
  if (box(x, y, 24, 40, 22, 58, 4) < 0 || away(x, y, 57, 28) < 7)
    z = std::max(z, 14.0);
  if (away(x, y, 100, 40) < 21)
    z = away(x, y, 100, 40) < 6 ? 18 : 2;
  return z;
}

/// A ring with a notch, and two towers that are closer than a tool of 10 mm, on a base.
double ringAndTowers(double x, double y)
{
  const double r = away(x, y, 38, 38);
  if (r < 30 && r > 22 && !(x > 38 && std::abs(y - 38) < 8))
    return 20;
  const bool tower = std::abs(x - 92) < 12;
  if (tower && ((y > 12 && y < 35) || (y > 41 && y < 64)))
    return 20;
  return 4;
}

/// Free-form ground, twice as high as the other benchmarks' and cut off level below.
double relief(double x, double y)
{
  return std::max(4.0, 2 * pointmill_test::Freeform::height(0.8 * x + 4, 0.8 * y) - 10);
}

/// A mould: a U of constant depth round a tongue, a bowl at its foot, a channel of
/// 12 mm that leaves through the wall and a runner of 6 mm that no such tool enters.
double mould(double x, double y)
{
  double z = 22;
  const double outer = box(x, y, 8, 82, 8, 72, 12),
               tongue = box(x, y, 32, 58, 30, 90, 9);
  if (outer < 0 && tongue > 0)
    z = std::min(z, 8 + std::min(6.0, 0.4 * std::max(0.0, 6 + outer)));
  const double bowl = away(x, y, 45, 52);
  if (bowl < 8)
    z = std::min(z, 22 - std::sqrt(64 - bowl * bowl));
  if (x > 74 && std::abs(y - 24) < 6)
    z = std::min(z, 10.0);
  if (x > 74 && std::abs(y - 56) < 3)
    z = std::min(z, 12.0);
  return z;
}

double plate(double x, double y)
{
  double z = box(x, y, 10, 150, 10, 140, 10) < 0 ? 12 : 20;
  for (const double cx : {35.0, 80.0, 125.0})
    for (const double cy : {32.0, 75.0, 118.0})
      if (const double r = away(x, y, cx, cy); r < 15)
        z = r < 7 ? 6 : 29 - 0.3 * std::max(0.0, r - 10);
  if (std::abs(x - 57) < 3 || std::abs(y - 53) < 3)
    z = std::max(z, 17.0);
  if (box(x, y, 92, 112, 84, 130, 6) < 0)
    z = 0;
  return z;
}

double layer(double x, double y)
{
  const double r = away(x, y, 30, 30), turn = std::atan2(y - 30, x - 30);
  return r < 15 + 4 * std::cos(3 * turn) ? 1 : 0;
}

const RoughPart kPlate{"plate", "large plate", 160, 150, plate, 2};
const RoughPart kLayer{"layer", "one layer", 60, 60, layer, 0};

} // namespace

const std::vector<RoughPart>& roughParts()
{
  using pointmill_test::SamplePart;
  static const std::vector<RoughPart> parts = {
      {"sample",
       "sample part",
       SamplePart::length,
       SamplePart::width,
       SamplePart::height,
       3},
      {"pockets", "pockets and islands", 128, 80, pockets, 0},
      {"ring", "ring and towers", 114, 76, ringAndTowers, 3},
      {"relief", "free-form relief", 100, 80, relief, 0},
      {"mould", "mould with channels", 90, 80, mould, 0}};
  return parts;
}

const RoughPart& largePlate()
{
  return kPlate;
}

const RoughPart& layerPart()
{
  return kLayer;
}

} // namespace bench
