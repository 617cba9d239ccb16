// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/link/order_passes.h>

// Boost 1.74 includes a header of its own that it calls deprecated.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace pointmill {
namespace {

namespace bg = boost::geometry;
using Place = bg::model::point<float, 2, bg::cs::cartesian>;
/// An end of a pass is 2 * pass, or 2 * pass + 1 for its last point.
using End = std::size_t;
using Entry = std::pair<Place, End>;
using Tree = bg::index::rtree<Entry, bg::index::quadratic<16>>;

constexpr unsigned kNeighbours = 8;
constexpr std::size_t kLongestTurn = 25000; // passes; longer ones take too long
constexpr int kMostRounds = 20;
constexpr double kLeastGain = 1e-6; // mm; less is rounding

/// A sequence of passes, each by the end at which it begins.
class Route {
public:
  explicit Route(std::vector<Place> ends)
      : ends_(std::move(ends)), order_(), at_(ends_.size() / 2)
  {
  }

  /// From the first pass on always to the nearest end of those that are left.
  void goToTheNearest()
  {
    Tree left(entries());
    End next = 0;
    order_.reserve(at_.size());
    while (true) {
      order_.push_back(next);
      left.remove(entry(next));
      left.remove(entry(next ^ 1));
      if (left.empty())
        break;
      next = left.qbegin(bg::index::nearest(ends_[next ^ 1], 1))->second;
    }
    for (std::size_t k = 0; k < order_.size(); ++k)
      at_[order_[k] / 2] = k;
  }

  /// Turns stretches of the sequence round wherever that shortens it (2-opt, between
  /// ends that are neighbours); the first pass stays.
  void turnStretches()
  {
    const auto near = neighbours();
    for (int round = 0; round < kMostRounds; ++round) {
      bool better = false;
      for (std::size_t k = 0; k + 1 < order_.size(); ++k)
        better = turnBehind(k, near) || better;
      if (!better)
        return;
    }
  }

  double air() const
  {
    double sum = 0;
    for (std::size_t k = 1; k < order_.size(); ++k)
      sum += between(order_[k - 1] ^ 1, order_[k]);
    return sum;
  }
  double between(End a, End b) const { return bg::distance(ends_[a], ends_[b]); }
  const std::vector<End>& order() const { return order_; }

private:
  Entry entry(End e) const { return {ends_[e], e}; }
  std::vector<Entry> entries() const
  {
    std::vector<Entry> all;
    for (End e = 0; e < ends_.size(); ++e)
      all.push_back(entry(e));
    return all;
  }
  std::vector<End> neighbours() const
  {
    const Tree tree(entries());
    std::vector<End> near;
    std::vector<Entry> found;
    for (End e = 0; e < ends_.size(); ++e) {
      found.clear();
      tree.query(bg::index::nearest(ends_[e], kNeighbours + 1),
                 std::back_inserter(found));
      // by distance and number, in whatever order the tree gives them
      std::sort(found.begin(), found.end(), [&](const Entry& a, const Entry& b) {
        const double da = between(e, a.second), db = between(e, b.second);
        return da != db ? da < db : a.second < b.second;
      });
      for (unsigned k = 0; k < kNeighbours; ++k)
        near.push_back(k < found.size() ? found[k].second : e);
    }
    return near;
  }

  // One of the two new ways is from an end of the way behind the k-th pass to a
  // neighbour that is nearer than the other end: a pass's end if it leaves from the
  // pass's end, a pass's beginning if it leaves from the beginning.
  bool turnBehind(std::size_t k, const std::vector<End>& near)
  {
    const End a = order_[k] ^ 1, b = order_[k + 1];
    const double now = between(a, b);
    for (unsigned n = 0; n < kNeighbours; ++n) {
      const End c = near[a * kNeighbours + n], d = near[b * kNeighbours + n];
      const std::size_t m = at_[c / 2], o = at_[d / 2];
      if (between(a, c) < now && order_[m] == (c ^ 1) && turnBetween(k, m))
        return true;
      if (between(b, d) < now && order_[o] == d && o > 0 && turnBetween(k, o - 1))
        return true;
    }
    return false;
  }

  // ... a] [b ... c] [d ... becomes ... a] [c ... b] [d ..., where a and c end the two
  // passes, if that is shorter.
  bool turnBetween(std::size_t k, std::size_t m)
  {
    const std::size_t first = std::min(k, m), last = std::max(k, m);
    if (first == last || last - first > kLongestTurn)
      return false;
    const End a = order_[first] ^ 1, b = order_[first + 1], c = order_[last] ^ 1;
    double gain = between(a, b) - between(a, c);
    if (last + 1 < order_.size()) {
      const End d = order_[last + 1];
      gain += between(c, d) - between(b, d);
    }
    if (gain <= kLeastGain)
      return false;
    turn(first + 1, last);
    return true;
  }

  void turn(std::size_t first, std::size_t last)
  {
    std::reverse(order_.begin() + static_cast<std::ptrdiff_t>(first),
                 order_.begin() + static_cast<std::ptrdiff_t>(last + 1));
    for (std::size_t k = first; k <= last; ++k) {
      order_[k] ^= 1;
      at_[order_[k] / 2] = k;
    }
  }

  std::vector<Place> ends_;
  std::vector<End> order_;
  std::vector<std::size_t> at_; // of each pass in the order
};

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

  std::vector<Place> ends;
  for (std::size_t k = 0; k < count; ++k)
    for (const std::size_t i : {begin[k], begin[k + 1] - 1}) {
      const PointCL& p = cloud[ids[i]];
      if (!std::isfinite(p.x) || !std::isfinite(p.y))
        throw DataError("OrderPasses: an end of a pass is not finite");
      ends.emplace_back(p.x, p.y);
    }
  Route route(std::move(ends));
  double before = 0;
  for (std::size_t k = 1; k < count; ++k)
    before += route.between(2 * k - 1, 2 * k);
  route.goToTheNearest();
  route.turnStretches();

  output.reserve(ids.size());
  std::uint32_t label = 0;
  for (const End e : route.order()) {
    const std::size_t first = begin[e / 2], last = begin[e / 2 + 1];
    for (std::size_t i = first; i < last; ++i) {
      output.push_back(cloud[ids[e % 2 ? first + last - 1 - i : i]]);
      output.back().label = label;
    }
    ++label;
  }
  report_.set("passes", static_cast<double>(count));
  report_.set("air_before_mm", before);
  report_.set("air_after_mm", route.air());
}

} // namespace pointmill
