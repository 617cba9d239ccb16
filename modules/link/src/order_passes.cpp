// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/tour.h>
#include <pointmill/link/order_passes.h>

#include <cstddef>
#include <vector>

namespace pointmill {

void OrderPasses::apply(CLCloud& output)
{
  const auto& ids = *indices_;
  const auto& cloud = *input_;
  std::vector<std::size_t> begin;
  for (std::size_t i = 0; i < ids.size(); ++i)
    if (i == 0 || cloud[ids[i]].label != cloud[ids[i - 1]].label)
      begin.push_back(i);
  const std::size_t count = begin.size();
  begin.push_back(ids.size());

  const auto place = [&](std::size_t i) {
    const PointCL& p = cloud[ids[i]];
    return Eigen::Vector2d(p.x, p.y);
  };
  std::vector<TourItem> passes;
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector2d first = place(begin[k]), last = place(begin[k + 1] - 1);
    if (!first.allFinite() || !last.allFinite())
      throw DataError("OrderPasses: an end of a pass is not finite");
    passes.push_back({{first, last}, {last, first}});
  }
  const Tour tour = shortTour(passes, TourStart::First);

  output.reserve(ids.size());
  std::uint32_t label = 0;
  for (const TourStop& stop : tour.stops) {
    const std::size_t first = begin[stop.item], last = begin[stop.item + 1];
    for (std::size_t i = first; i < last; ++i) {
      output.push_back(cloud[ids[stop.way > 0 ? first + last - 1 - i : i]]);
      output.back().label = label;
    }
    ++label;
  }
  report_.set("passes", static_cast<double>(count));
  report_.set("air_before_mm", tour.before);
  report_.set("air_after_mm", tour.after);
}

} // namespace pointmill
