// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/link/order_passes.h>

// Boost 1.74 includes a header of its own that it calls deprecated.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace pointmill {
namespace {

namespace bg = boost::geometry;
using Place = bg::model::point<float, 2, bg::cs::cartesian>;
/// An end of a pass: where it is, and 2 * pass + (1 for its last point).
using End = std::pair<Place, std::size_t>;

double between(const PointCL& a, const PointCL& b)
{
  return std::hypot(double(a.x) - b.x, double(a.y) - b.y);
}

} // namespace

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
  const auto end = [&](std::size_t e) -> const PointCL& {
    return cloud[ids[e % 2 ? begin[e / 2 + 1] - 1 : begin[e / 2]]];
  };
  const auto entry = [&](std::size_t e) { return End{Place(end(e).x, end(e).y), e}; };

  std::vector<End> ends;
  for (std::size_t e = 0; e < 2 * count; ++e) {
    if (!std::isfinite(end(e).x) || !std::isfinite(end(e).y))
      throw DataError("OrderPasses: an end of a pass is not finite");
    ends.push_back(entry(e));
  }
  bg::index::rtree<End, bg::index::quadratic<16>> left(ends.begin(), ends.end());

  double before = 0, after = 0;
  for (std::size_t k = 1; k < count; ++k)
    before += between(end(2 * k - 1), end(2 * k));
  std::size_t next = 0; // the first pass, from its beginning
  for (std::uint32_t label = 0; label < count; ++label) {
    if (label > 0) {
      const Place here(output.back().x, output.back().y);
      next = left.qbegin(bg::index::nearest(here, 1))->second;
      after += between(output.back(), end(next));
    }
    left.remove(entry(next));
    left.remove(entry(next ^ 1));
    const std::size_t first = begin[next / 2], last = begin[next / 2 + 1];
    for (std::size_t i = first; i < last; ++i) {
      output.push_back(cloud[ids[next % 2 ? first + last - 1 - i : i]]);
      output.back().label = label;
    }
  }
  report_.set("passes", static_cast<double>(count));
  report_.set("air_before_mm", before);
  report_.set("air_after_mm", after);
}

} // namespace pointmill
