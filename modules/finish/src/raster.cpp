// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "layer.h"

#include <pointmill/common/watch.h>
#include <pointmill/finish/raster.h>

#include <utility>

namespace pointmill {
namespace {

/// What the rows are of the work, where a raster across may follow.
constexpr double kRowsShare = 0.85;

/// Appends the passes in machining order.
class Sequence {
public:
  Sequence(const Raster& raster, CLCloud& path) : raster_(raster), path_(path) {}

  void append(std::vector<Pass> passes)
  {
    const bool one_way = raster_.pattern == RasterPattern::OneWay;
    // Along +u the right hand side is that of falling v.
    if (one_way && raster_.mode == MillingMode::Climb)
      std::stable_sort(passes.begin(), passes.end(), [](const Pass& a, const Pass& b) {
        return a.v > b.v;
      });
    bool back = false;
    for (std::size_t first = 0; first < passes.size();) {
      std::size_t last = first;
      while (last < passes.size() && passes[last].v == passes[first].v)
        ++last;
      for (std::size_t k = first; k < last; ++k)
        append(passes[back ? first + last - 1 - k : k].path, back);
      back = !back && !one_way;
      first = last;
    }
  }
  std::size_t passes() const { return label_; }

private:
  void append(CLCloud& pass, bool back)
  {
    if (back)
      std::reverse(pass.begin(), pass.end());
    for (auto& p : pass)
      p.label = label_;
    ++label_;
    path_ += pass;
    CLCloud().swap(pass);
  }

  const Raster& raster_;
  CLCloud& path_;
  std::uint32_t label_ = 0;
};

} // namespace

RasterPasses Raster::over(const SurfaceModel& surface) const
{
  RasterPasses result;
  Sequence sequence(*this, result.path);
  Layer layer;
  {
    const WorkStep rows({0.0, across ? kRowsShare : 1.0});
    layer = LayerMaker(surface, *this, angle).everywhere();
  }
  result.inserted = layer.inserted;
  result.kept_out = layer.kept_out;
  sequence.append(std::move(layer.passes));
  ScallopTally tally = layer.tally;
  std::vector<Steep> left = std::move(layer.steep);

  if (across && !left.empty()) {
    std::vector<Eigen::Vector2d> places;
    for (const Steep& s : left)
      places.push_back(s.xy);
    const WorkStep more({kRowsShare, 1.0});
    const Mask mask(places, std::max(step_over, forward_step));
    Layer second = LayerMaker(surface, *this, angle + 90).on(mask, layer.noise);
    result.across = second.passes.size();
    result.inserted += second.inserted;
    result.kept_out += second.kept_out;
    sequence.append(std::move(second.passes));
    tally.add(second.tally);
    left = std::move(second.steep);
  }
  for (const Steep& s : left) {
    tally.add(s.height, s.weight);
    result.left += s.weight * step_over * forward_step;
  }
  result.passes = sequence.passes();
  result.scallop_p95 = tally.quantile(0.95);
  result.scallop_max = tally.highest();
  return result;
}

} // namespace pointmill
