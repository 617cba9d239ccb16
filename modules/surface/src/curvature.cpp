// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/common/parallel.h>
#include <pointmill/common/parameters.h>
#include <pointmill/surface/curvature.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

/// Less than so many standard deviations are noise.
constexpr double kSure = 3.0;

/// The cells of a map thinned out to every n-th column and row, each the highest
/// of those that it stands for.
CellCloud thinned(const CellCloud& map, std::uint32_t stride)
{
  const std::uint32_t columns = (map.width + stride - 1) / stride;
  const std::uint32_t rows = (map.height + stride - 1) / stride;
  CellCloud out;
  out.resize(std::size_t(columns) * rows);
  out.width = columns;
  out.height = rows;
  for (std::uint32_t r = 0; r < rows; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      // A middle one says where it is, also at the end, where cells are missing.
      PointCell& cell = out.at(c, r);
      const float half = 0.5f * static_cast<float>(stride - 1);
      const PointCell& first = map.at(0, 0);
      const float step = (map.at(map.width - 1, 0).x - first.x) /
                         static_cast<float>(std::max(1u, map.width - 1));
      const float step_y = (map.at(0, map.height - 1).y - first.y) /
                           static_cast<float>(std::max(1u, map.height - 1));
      cell.x = first.x + step * (half + static_cast<float>(c * stride));
      cell.y = first.y + step_y * (half + static_cast<float>(r * stride));
    }
  return out;
}

} // namespace

Curvatures curvaturesOf(const Patch& patch, double s, double t)
{
  const Patch::Slopes w = patch.slopes(s, t);
  // Shape operator I^-1 II; its half trace and determinant give its eigenvalues.
  const double e = 1 + w.s * w.s, f = w.s * w.t, g = 1 + w.t * w.t;
  const double area2 = e * g - f * f, length = std::sqrt(1 + w.s * w.s + w.t * w.t);
  const double mean = (e * w.tt - 2 * f * w.st + g * w.ss) / (2 * area2 * length);
  const double gauss = (w.ss * w.tt - w.st * w.st) / (area2 * length * length);
  const double half = std::sqrt(std::max(0.0, mean * mean - gauss));
  return {mean + half, mean - half};
}

CurvatureMap mapCurvature(const PointIndex& points,
                          const CellCloud& map,
                          std::size_t neighbours,
                          std::size_t most,
                          unsigned threads)
{
  checkRange("map of the curvature",
             "neighbours",
             static_cast<double>(neighbours),
             "",
             {12, 1000});
  if (map.size() < 4 || map.width < 2 || map.height < 2 ||
      std::size_t(map.width) * map.height != map.size())
    throw DataError("map of the curvature: the map is not organised");
  std::uint32_t stride = 1;
  while (map.size() / (std::size_t(stride) * stride) > most)
    ++stride;
  CurvatureMap out;
  out.hollow = thinned(map, stride);
  out.ridge = out.hollow;
  parallelFor(out.hollow.height, threads, [&](std::size_t r) {
    Neighbourhood near;
    Patch patch;
    const auto row = static_cast<std::uint32_t>(r);
    for (std::uint32_t c = 0; c < out.hollow.width; ++c) {
      const PointCell& top =
          map.at(std::min(c * stride + stride / 2, map.width - 1),
                 std::min(row * stride + stride / 2, map.height - 1));
      if (top.getState() != CellState::Occupied || !std::isfinite(top.z))
        continue;
      near.gather(points, {top.x, top.y, top.z}, neighbours);
      if (!patch.fit(near, near.planeNormal()))
        continue;
      const Curvatures bent = curvaturesOf(patch, 0, 0);
      const double noise = kSure * patch.bendDeviation();
      for (CellCloud* cells : {&out.hollow, &out.ridge}) {
        PointCell& cell = cells->at(c, row);
        const double curvature = cells == &out.hollow ? bent.hollow : bent.ridge;
        cell.z = std::abs(curvature) > noise ? static_cast<float>(curvature) : 0.f;
        cell.setState(CellState::Occupied);
      }
    }
  });
  return out;
}

} // namespace pointmill
