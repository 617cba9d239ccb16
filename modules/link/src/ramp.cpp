// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "ramp.h"

#include <algorithm>
#include <cmath>

namespace pointmill {

using Eigen::Vector3d;

std::vector<Vector3d> rampAlong(const std::vector<Vector3d>& pass,
                                double height,
                                double degrees,
                                double shortest,
                                double longest)
{
  // The stretch that is ramped on, cut off at its length, or where the tool would sink
  // down what it climbs as it comes back.
  std::vector<Vector3d> track{pass.front()};
  double length = 0;
  for (std::size_t i = 1; i < pass.size() && length < longest; ++i) {
    const double step = (pass[i] - pass[i - 1]).head<2>().norm();
    if (length >= shortest && std::abs(pass[i].z() - pass[i - 1].z()) > step)
      break;
    if (length + step > longest)
      track.push_back(pass[i - 1] +
                      (pass[i] - pass[i - 1]) * ((longest - length) / step));
    else
      track.push_back(pass[i]);
    length = std::min(longest, length + step);
  }
  const double slope = std::tan(degrees * M_PI / 180.0);
  constexpr double most_turns = 200;
  if (length <= 0 || height / slope > most_turns * length)
    return {};

  // As many whole trips forth and back as the slope wants, at an even descent.
  const double trips = std::max(1.0, std::ceil(height / slope / (2 * length)));
  const double descent = height / (trips * 2 * length);
  std::vector<Vector3d> ramp;
  double above = height;
  ramp.push_back(track.front() + Vector3d(0, 0, above));
  const auto go = [&](const Vector3d& from, const Vector3d& to) {
    above = std::max(0.0, above - descent * (to - from).head<2>().norm());
    ramp.push_back(to + Vector3d(0, 0, above));
  };
  for (int trip = 0; trip < trips; ++trip) {
    for (std::size_t i = 1; i < track.size(); ++i)
      go(track[i - 1], track[i]);
    for (std::size_t i = track.size() - 1; i > 0; --i)
      go(track[i], track[i - 1]);
  }
  ramp.back() = track.front(); // exactly, whatever the sums rounded to
  return ramp;
}

} // namespace pointmill
