// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/parameters.h>
#include <pointmill/slice/sink.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {
namespace {

constexpr int kDirections = 360; // about half of a void's border
constexpr int kHalvings = 100;

/// Where a concave function is largest in [low, high], by golden sections.
template <typename Function>
double highest(double low, double high, Function&& f)
{
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double fa = f(a), fb = f(b);
  for (int i = 0; i < kHalvings; ++i)
    if (fa < fb) {
      low = a;
      a = b;
      fa = fb;
      b = low + golden * (high - low);
      fb = f(b);
    }
    else {
      high = b;
      b = a;
      fb = fa;
      a = high - golden * (high - low);
      fa = f(a);
    }
  return (low + high) / 2;
}

} // namespace

double sinkBetweenPoints(const Tool& tool, double spacing, double slope, double bulge)
{
  const std::string me = "sinkBetweenPoints";
  checkRange(me, "spacing", spacing, "mm", {0, 1e6});
  checkRange(me, "slope", slope, "deg", {0, 89.9});
  checkRange(me, "bulge", bulge, "1/mm", {0, 1e6});
  const double radius = tool.radius(), a = spacing / std::sqrt(2.0);
  if (a >= radius)
    return std::numeric_limits<double>::infinity();

  // The ground's height less the cutter's, x up the slope from its axis, y across.
  const double rise = std::tan(slope * M_PI / 180);
  const auto plane = [&](double x) { return rise * x - tool.profile(std::abs(x)); };
  const double contact = highest(0, radius, plane);
  const auto over = [&](double x, double y) {
    const double dx = x - contact;
    return rise * x - bulge / 2 * (dx * dx + y * y) - tool.profile(std::hypot(x, y));
  };
  // The lowest place on the border of a void about (x, 0): there a point may lie.
  const auto lowestAbout = [&](double x) {
    double lowest = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kDirections; ++i) {
      const double angle = M_PI * i / kDirections;
      lowest = std::min(lowest, over(x + a * std::cos(angle), a * std::sin(angle)));
    }
    return lowest;
  };
  // The void lies about the contact as suits the cutter best; the cutter is symmetric
  // about y = 0, and so is where that is.
  const double middle = highest(0, radius - a, lowestAbout);
  const double sink = plane(contact) - lowestAbout(middle);
  return std::max(0.0, sink) * std::cos(slope * M_PI / 180);
}

} // namespace pointmill
