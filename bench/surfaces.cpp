// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "surfaces.h"

#include <pointmill_test/random.h>

#include <cmath>
#include <limits>

namespace bench {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

bool onSurface(double x, double y)
{
  return x >= 0 && y >= 0 && x <= kEdge && y <= kEdge;
}

double freeform(double x, double y)
{
  return 10 + 4 * std::sin(x / 9) * std::cos(y / 11) + 2 * std::sin(x / 4 + y / 6);
}

double freeformTip(double x, double y)
{
  double u = 0, v = 0; // from the axis to the contact
  for (int round = 0; round < 50; ++round) {
    const double px = x + u, py = y + v;
    const double s = std::sin(px / 9), c = std::cos(px / 9);
    const double sy = std::sin(py / 11), cy = std::cos(py / 11);
    const double s2 = std::sin(px / 4 + py / 6), c2 = std::cos(px / 4 + py / 6);
    const double w = std::sqrt(kBall * kBall - u * u - v * v), w3 = w * w * w;
    // gradient and Hessian of height - profile
    const double gx = 4. / 9 * c * cy + 0.5 * c2 - u / w;
    const double gy = -4. / 11 * s * sy + c2 / 3 - v / w;
    const double xx = -4. / 81 * s * cy - s2 / 8 - 1 / w - u * u / w3;
    const double xy = -4. / 99 * c * sy - s2 / 12 - u * v / w3;
    const double yy = -4. / 121 * s * cy - s2 / 18 - 1 / w - v * v / w3;
    const double det = xx * yy - xy * xy;
    double du = -(gx * yy - gy * xy) / det, dv = -(gy * xx - gx * xy) / det;
    while (std::hypot(u + du, v + dv) > 0.95 * kBall) // stay under the ball
      du /= 2, dv /= 2;
    u += du;
    v += dv;
    if (std::hypot(du, dv) < 1e-9) // squared in the height
      break;
  }
  if (!onSurface(x + u, y + v))
    return kNowhere;
  return freeform(x + u, y + v) - kBall + std::sqrt(kBall * kBall - u * u - v * v);
}

constexpr double kDome = 30;

double hemisphere(double x, double y)
{
  const double r2 =
      (x - kEdge / 2) * (x - kEdge / 2) + (y - kEdge / 2) * (y - kEdge / 2);
  return r2 < kDome * kDome ? std::sqrt(kDome * kDome - r2) : 0.0;
}

double hemisphereTip(double x, double y)
{
  const double sum = kDome + kBall;
  const double r2 =
      (x - kEdge / 2) * (x - kEdge / 2) + (y - kEdge / 2) * (y - kEdge / 2);
  // Up to 60 degrees; beyond, a ground plan has too few points.
  return r2 < 0.75 * sum * sum ? std::sqrt(sum * sum - r2) - kBall : kNowhere;
}

} // namespace

const Surface kFreeform{"freeform", freeform, freeformTip};
const Surface kHemisphere{"hemisphere", hemisphere, hemisphereTip};
const Surface kLevel{"level",
                     [](double, double) { return 5.0; },
                     [](double x, double y) {
                       return onSurface(x - kBall, y - kBall) &&
                                      onSurface(x + kBall, y + kBall)
                                  ? 5.0
                                  : kNowhere;
                     }};

Cloud::Ptr makeCloud(const Surface& surface, std::size_t count)
{
  pointmill_test::Random random(7);
  Cloud::Ptr cloud(new Cloud);
  cloud->reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    // The height of the rounded place: the point is on the surface.
    const auto x = static_cast<float>(random.uniform(0, kEdge));
    const auto y = static_cast<float>(random.uniform(0, kEdge));
    cloud->push_back({x, y, static_cast<float>(surface.height(x, y))});
  }
  return cloud;
}

std::vector<double> truth(const Surface& surface)
{
  std::vector<double> tips;
  tips.reserve(static_cast<std::size_t>(kRows) * kColumns);
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column)
      tips.push_back(surface.tip(placeX(column), placeY(row)));
  return tips;
}

} // namespace bench
