// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/common/tour.h>
#include <pointmill/common/watch.h>

// Boost 1.74 includes a header of its own that it calls deprecated.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pointmill {
namespace {

namespace bg = boost::geometry;
using Spot = bg::model::point<double, 2, bg::cs::cartesian>;
using Entry = std::pair<Spot, std::size_t>;
using Tree = bg::index::rtree<Entry, bg::index::quadratic<16>>;

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kNeighbours = 4;      // of a place, for each way of an item
constexpr std::size_t kFew = 64;            // items or places; time for all of them
constexpr std::size_t kTable = 1000;        // places with a table of their costs
constexpr std::size_t kLongestTurn = 25000; // items; longer ones take too long
constexpr std::size_t kFarthestMove = 1000; // items
constexpr std::size_t kLongestMove = 3;     // items that are moved elsewhere together
constexpr std::size_t kStarts = 12;         // ways to begin a tour of few items with
constexpr int kMostRounds = 20;
constexpr double kLeastGain = 1e-6; // mm; less is rounding

/// All ways of all items. A place is an end of a way; ways of an item share theirs.
struct Ways {
  struct Way {
    std::size_t item, in, out; // in and out: places
    std::size_t back = kNone;  // the way back, if there is one
  };
  std::vector<Way> ways;
  std::vector<std::size_t> first; // way of each item, and the end
  std::vector<Eigen::Vector2d> places;
  std::vector<std::size_t> item_of; // of each place
  TourCost cost;
  bool all_turn = true; // every way has its way back

  Ways(const std::vector<TourItem>& items, const TourCost& given)
      : cost(given ? given : [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
          return (a - b).norm();
        })
  {
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (items[i].empty())
        throw DataError("a tour's item has no way through it");
      first.push_back(ways.size());
      const std::size_t own = places.size();
      for (const TourWay& way : items[i])
        ways.push_back({i, place(own, way.in), place(own, way.out)});
      item_of.resize(places.size(), i);
      for (std::size_t a = first.back(); a < ways.size(); ++a) {
        for (std::size_t b = first.back(); b < ways.size(); ++b)
          if (ways[a].in == ways[b].out && ways[a].out == ways[b].in)
            ways[a].back = b;
        all_turn = all_turn && ways[a].back != kNone;
      }
    }
    first.push_back(ways.size());
    if (given && places.size() <= kTable) // which may take longer than to look it up
      table_.assign(places.size() * places.size(), -1.0);
  }

  std::size_t items() const { return first.size() - 1; }
  double between(std::size_t place, std::size_t other) const
  {
    if (table_.empty())
      return cost(places[place], places[other]);
    double& known =
        table_[std::min(place, other) * places.size() + std::max(place, other)];
    if (known < 0)
      known = cost(places[place], places[other]);
    return known;
  }
  /// From way to way; nothing before the first and behind the last.
  double step(std::size_t a, std::size_t b) const
  {
    return a == kNone || b == kNone ? 0 : between(ways[a].out, ways[b].in);
  }
  double cost_of(const std::vector<std::size_t>& order) const
  {
    double sum = 0;
    for (std::size_t k = 1; k < order.size(); ++k)
      sum += step(order[k - 1], order[k]);
    return sum;
  }
  Spot spot(std::size_t place) const { return {places[place].x(), places[place].y()}; }

private:
  mutable std::vector<double> table_; // of costs; negative: not known yet

  std::size_t place(std::size_t own, const Eigen::Vector2d& at)
  {
    if (!at.allFinite())
      throw DataError("a place of a tour is not finite");
    const auto there =
        std::find(places.begin() + static_cast<std::ptrdiff_t>(own), places.end(), at);
    const auto found = static_cast<std::size_t>(there - places.begin());
    if (there == places.end())
      places.push_back(at);
    return found;
  }
};

/// The way that costs least to get to from a place.
std::size_t nearestWay(const Ways& all, const Tree& left, std::size_t here)
{
  std::vector<Entry> found;
  for (std::size_t most = 1;; most *= 8) {
    found.clear();
    left.query(bg::index::nearest(all.spot(here), static_cast<unsigned>(most)),
               std::back_inserter(found));
    double best = std::numeric_limits<double>::infinity(), farthest = 0;
    std::size_t way = kNone;
    for (const Entry& e : found) {
      const double cost = all.between(here, all.ways[e.second].in);
      farthest = std::max(farthest, bg::distance(e.first, all.spot(here)));
      if (cost < best || (cost == best && e.second < way)) {
        best = cost;
        way = e.second;
      }
    }
    if (best <= farthest || most >= left.size()) // no cost is less than the distance
      return way;
  }
}

/// From the first way on always to what is nearest of the items that are left.
std::vector<std::size_t> alwaysToTheNearest(const Ways& all, std::size_t first)
{
  std::vector<Entry> entries;
  for (std::size_t w = 0; w < all.ways.size(); ++w)
    entries.emplace_back(all.spot(all.ways[w].in), w);
  Tree left(entries);
  std::vector<std::size_t> order;
  order.reserve(all.items());
  for (std::size_t next = first;;) {
    checkInterrupted();
    order.push_back(next);
    const std::size_t item = all.ways[next].item;
    for (std::size_t w = all.first[item]; w < all.first[item + 1]; ++w)
      left.remove(entries[w]);
    if (left.empty())
      return order;
    next = nearestWay(all, left, all.ways[next].out);
  }
}

/// Of each place the nearest ones of other items.
std::vector<std::vector<std::size_t>> neighboursOf(const Ways& all)
{
  std::vector<Entry> entries;
  for (std::size_t p = 0; p < all.places.size(); ++p)
    entries.emplace_back(all.spot(p), p);
  const Tree tree(entries);
  const std::size_t most =
      all.places.size() <= kFew
          ? kFew
          : kNeighbours * (1 + (all.ways.size() - 1) / all.items());
  std::vector<std::vector<std::size_t>> near(all.places.size());
  std::vector<Entry> found;
  for (std::size_t p = 0; p < near.size(); ++p) {
    checkInterrupted();
    const auto away = [&](const Entry& e) {
      return bg::comparable_distance(e.first, entries[p].first);
    };
    const std::size_t item = all.item_of[p];
    const std::size_t own = 2 * (all.first[item + 1] - all.first[item]);
    found.clear();
    tree.query(bg::index::nearest(entries[p].first, static_cast<unsigned>(most + own)),
               std::back_inserter(found));
    // by distance and number, in whatever order the tree gives them
    std::sort(found.begin(), found.end(), [&](const Entry& a, const Entry& b) {
      const double da = away(a), db = away(b);
      return da != db ? da < db : a.second < b.second;
    });
    for (const Entry& e : found)
      if (all.item_of[e.second] != item && near[p].size() < most)
        near[p].push_back(e.second);
  }
  return near;
}

/// An order of ways that is made better move by move.
class Route {
public:
  Route(const Ways& all,
        const std::vector<std::vector<std::size_t>>& near,
        std::vector<std::size_t> order,
        TourStart start)
      : all_(all), near_(near), order_(std::move(order)), at_(order_.size()),
        fixed_(start == TourStart::First ? 1 : 0)
  {
    place(0, order_.size());
  }

  void improve()
  {
    bool better = true;
    for (int round = 0; better && round < kMostRounds; ++round) {
      // Each round takes about half as long as the one before.
      const WorkStep step(
          {1 - std::ldexp(1.0, -round), 1 - std::ldexp(1.0, -round - 1)});
      better = chooseWays();
      for (std::size_t k = fixed_; k <= order_.size(); ++k) {
        step.reach(double(k) / double(order_.size() + 1));
        better = improveBefore(k) || better;
      }
    }
  }
  const std::vector<std::size_t>& order() const { return order_; }

private:
  using Way = Ways::Way;

  std::size_t wayAt(std::size_t k) const
  {
    return k < order_.size() ? order_[k] : kNone;
  }
  std::size_t wayBefore(std::size_t k) const { return k > 0 ? order_[k - 1] : kNone; }
  double step(std::size_t a, std::size_t b) const { return all_.step(a, b); }
  std::size_t back(std::size_t way) const { return all_.ways[way].back; }
  void place(std::size_t first, std::size_t end)
  {
    for (std::size_t k = first; k < end; ++k)
      at_[all_.ways[order_[k]].item] = k;
  }

  /// The best ways in the order as it is.
  bool chooseWays()
  {
    std::vector<double> cost(all_.ways.size(), std::numeric_limits<double>::infinity());
    std::vector<std::size_t> from(all_.ways.size(), kNone);
    for (std::size_t k = 0; k < order_.size(); ++k)
      forWaysAt(k, [&](std::size_t w) {
        if (k == 0)
          cost[w] = 0;
        else
          forWaysAt(k - 1, [&](std::size_t v) {
            const double sum = cost[v] + step(v, w);
            if (sum < cost[w]) {
              cost[w] = sum;
              from[w] = v;
            }
          });
      });
    std::size_t best = order_.back();
    forWaysAt(order_.size() - 1, [&](std::size_t w) {
      if (cost[w] < cost[best])
        best = w;
    });
    if (cost[best] > all_.cost_of(order_) - kLeastGain)
      return false;
    for (std::size_t k = order_.size(); k-- > 0; best = from[best])
      order_[k] = best;
    return true;
  }
  template <typename Visit>
  void forWaysAt(std::size_t k, Visit&& visit) const
  {
    const std::size_t item = all_.ways[order_[k]].item;
    for (std::size_t w = all_.first[item]; w < all_.first[item + 1]; ++w)
      if (k >= fixed_ || w == order_[k])
        visit(w);
  }

  // A move that saves anything puts in a step that is shorter than one it takes out,
  // and this leads from a place to a neighbour of it.
  bool improveBefore(std::size_t k)
  {
    const std::size_t a = wayBefore(k), b = wayAt(k);
    if (a != kNone)
      for (const std::size_t c : near_[all_.ways[a].out]) {
        const std::size_t m = at_[all_.item_of[c]];
        if (all_.ways[order_[m]].out == c && turnBetween(k, m + 1))
          return true;
        if (moveTo(k, m, c, &Way::in))
          return true;
      }
    if (b != kNone)
      for (const std::size_t d : near_[all_.ways[b].in]) {
        const std::size_t m = at_[all_.item_of[d]];
        if (all_.ways[order_[m]].in == d && turnBetween(k, m))
          return true;
        if (moveTo(k, m, d, &Way::out))
          return true;
      }
    return false;
  }

  /// Turns what lies from the lower of two places in the order to before the other.
  bool turnBetween(std::size_t k, std::size_t m)
  {
    const std::size_t first = std::min(k, m), end = std::max(k, m);
    if (first < fixed_ || end - first < 2 || end - first > kLongestTurn)
      return false;
    const std::size_t a = wayBefore(first), d = wayAt(end);
    const std::size_t b = back(order_[end - 1]), c = back(order_[first]);
    if (b == kNone || c == kNone ||
        step(a, order_[first]) + step(order_[end - 1], d) - step(a, b) - step(c, d) <=
            kLeastGain)
      return false;
    return turn(first, end);
  }
  bool turn(std::size_t first, std::size_t end)
  {
    const auto from = order_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto to = order_.begin() + static_cast<std::ptrdiff_t>(end);
    if (!all_.all_turn &&
        std::any_of(from, to, [&](std::size_t way) { return back(way) == kNone; }))
      return false;
    std::reverse(from, to);
    std::for_each(from, to, [&](std::size_t& way) { way = back(way); });
    place(first, end);
    return true;
  }

  /// Moves the m-th item, alone or with a few, to before the k-th: so that it begins
  /// there, or ends, with `place`.
  bool moveTo(std::size_t k, std::size_t m, std::size_t place, std::size_t Way::*end)
  {
    const std::size_t item = all_.ways[order_[m]].item;
    for (std::size_t w = all_.first[item]; w < all_.first[item + 1]; ++w)
      if (all_.ways[w].*end == place && moveStretch(k, m, m + 1, w, w, false))
        return true;
    const bool begins = end == &Way::in;
    const bool as_is = all_.ways[order_[m]].*end == place;
    const bool forth = begins == as_is; // what goes with it follows it in the order
    for (std::size_t n = 2; n <= kLongestMove; ++n) {
      if (forth ? m + n > order_.size() : m + 1 < n)
        return false;
      const std::size_t first = forth ? m : m + 1 - n, last = first + n - 1;
      const std::size_t in = as_is ? order_[first] : back(order_[last]);
      const std::size_t out = as_is ? order_[last] : back(order_[first]);
      if (in == kNone || out == kNone || all_.ways[begins ? in : out].*end != place)
        continue;
      if (moveStretch(k, first, last + 1, in, out, !as_is))
        return true;
    }
    return false;
  }

  /// Moves [first, end) to before the k-th, where it begins with `in` and ends with
  /// `out`, if that saves anything.
  bool moveStretch(std::size_t k,
                   std::size_t first,
                   std::size_t end,
                   std::size_t in,
                   std::size_t out,
                   bool turned)
  {
    if (first < fixed_ || (k >= first && k <= end) ||
        (k < first ? end - k : k - first) > kFarthestMove)
      return false;
    const std::size_t a = wayBefore(first), b = wayAt(end);
    const std::size_t c = wayBefore(k), d = wayAt(k);
    const double gain = step(a, order_[first]) + step(order_[end - 1], b) - step(a, b) +
                        step(c, d) - step(c, in) - step(out, d);
    if (gain <= kLeastGain || (turned && !turn(first, end)))
      return false;
    if (end - first == 1)
      order_[first] = in;
    const auto it = [&](std::size_t i) {
      return order_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    if (k < first)
      std::rotate(it(k), it(first), it(end));
    else
      std::rotate(it(first), it(end), it(k));
    this->place(std::min(k, first), std::max(k, end));
    return true;
  }

  const Ways& all_;
  const std::vector<std::vector<std::size_t>>& near_;
  std::vector<std::size_t> order_; // ways
  std::vector<std::size_t> at_;    // of each item in the order
  std::size_t fixed_;              // items at the beginning that stay
};

} // namespace

Tour shortTour(const std::vector<TourItem>& items,
               TourStart start,
               const TourCost& cost)
{
  Tour tour;
  if (items.empty())
    return tour;
  const Ways all(items, cost);
  std::vector<std::size_t> order(all.first.begin(), all.first.end() - 1);
  tour.before = tour.after = all.cost_of(order);
  if (items.size() > 1) {
    const auto near = neighboursOf(all);
    std::vector<std::vector<std::size_t>> begins{alwaysToTheNearest(all, 0)};
    if (items.size() <= kFew) {
      begins.push_back(order);
      if (start == TourStart::Any)
        for (std::size_t w = 1; w < all.ways.size(); w += 1 + all.ways.size() / kStarts)
          begins.push_back(alwaysToTheNearest(all, w));
    }
    else if (tour.before < all.cost_of(begins[0]))
      begins[0] = order; // which is a good one already
    for (auto& begin : begins) {
      Route route(all, near, std::move(begin), start);
      route.improve();
      const double after = all.cost_of(route.order());
      if (after < tour.after - kLeastGain) {
        tour.after = after;
        order = route.order();
      }
    }
  }
  for (const std::size_t w : order)
    tour.stops.push_back({all.ways[w].item, w - all.first[all.ways[w].item]});
  return tour;
}

} // namespace pointmill
