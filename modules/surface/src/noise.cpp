// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/surface/noise.h>
#include <pointmill/surface/patch.h>

#include <algorithm>
#include <random>
#include <vector>

namespace pointmill {
namespace {

constexpr int kSamples = 3000;
constexpr std::size_t kNeighbours = 30;

double median(std::vector<double>& values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace

Noise measureNoise(const PointIndex& points, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::vector<double> deviations, radii;
  Neighbourhood near;
  Patch patch;
  for (int i = 0; i < kSamples; ++i) {
    near.gather(points, points.point(random() % points.size()), kNeighbours);
    if (!patch.fit(near, near.planeNormal()))
      continue;
    deviations.push_back(patch.residual());
    radii.push_back(near.radius);
  }
  if (deviations.empty())
    throw DataError(
        "the noise of the scan cannot be measured: its points lie on lines");
  return {median(deviations), median(radii)};
}

} // namespace pointmill
