// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "row.h"

#include <pointmill/common/parallel.h>

namespace pointmill {
namespace {

constexpr double kSamples = 64; // along the longer side

/// Rows fall no faster than the plunge feed, which is taken for a third of the feed.
constexpr double kPlunge = 1.0 / 3;

/// How long it takes to mill the ground there, by its area in XY over the step-over and
/// the feed. Rows climb, half of them fall, and their spacing is halved until at right
/// angles to the feed it is that of a flat.
double effort(double along, double across, double most)
{
  const double length = std::sqrt(1 + along * along);
  const double fall = std::max(1.0, std::abs(along) / length / kPlunge);
  const double spread = std::hypot(length, across) / length;
  const double halvings = std::ceil(std::log2(spread) - 1e-9);
  return 0.5 * length * (1 + fall) * std::min(most, std::exp2(halvings));
}

} // namespace

double rasterAngle(const Raster& raster, const SurfaceModel& surface)
{
  Raster sample = raster;
  const Eigen::Vector3d size = surface.points().max() - surface.points().min();
  const double step = std::max({size.x(), size.y(), 1e-3}) / kSamples;
  sample.forward_step = step;
  const RowMaker maker(surface, sample, 0);
  if (maker.width().first > maker.width().last)
    return 0;
  const Places places(maker.width().first, maker.width().last, step);
  std::vector<Row> rows(places.count);
  parallelFor(rows.size(), raster.threads, {0.0, 1.0}, [&](std::size_t i) {
    rows[i] = maker.drop(places[i], {0, maker.stations().count - 1});
  });

  const double most =
      raster.scallop > 0 ? std::max(1.0, raster.step_over / raster.min_step_over) : 1.0;
  double along_x = 0, along_y = 0;
  for (std::size_t j = 1; j < rows.size(); ++j)
    for (std::size_t i = 1; i < maker.stations().count; ++i) {
      const Station &a = rows[j - 1][i - 1], &b = rows[j - 1][i], &c = rows[j][i - 1],
                    &d = rows[j][i];
      if (!a.touches || !b.touches || !c.touches || !d.touches)
        continue;
      const double x = (b.tip - a.tip + d.tip - c.tip) / (2 * maker.stations().step);
      const double y = (c.tip - a.tip + d.tip - b.tip) / (2 * places.step);
      along_x += effort(x, y, most);
      along_y += effort(y, x, most);
    }
  const double cell = places.step * maker.stations().step / raster.step_over;
  const double turn = raster.tool.diameter / raster.step_over;
  return cell * along_x + turn * size.y() <= cell * along_y + turn * size.x() ? 0 : 90;
}

} // namespace pointmill
