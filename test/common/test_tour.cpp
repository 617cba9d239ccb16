// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/common/tour.h>
#include <pointmill_test/random.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

using namespace pointmill;
using namespace pointmill_test;

namespace {

using Eigen::Vector2d;
using Items = std::vector<TourItem>;

Vector2d anywhere(Random& random)
{
  return {random.uniform(0, 100), random.uniform(0, 60)};
}

/// Short passes that may be cut from either end.
Items passes(int count, std::uint64_t seed)
{
  Random random(seed);
  Items items;
  for (int i = 0; i < count; ++i) {
    const Vector2d a = anywhere(random), b = a + Vector2d(random.uniform(0, 8), 0);
    items.push_back({{a, b}, {b, a}});
  }
  return items;
}

/// Rectangles that are entered at a corner and left at another one; some one way only.
Items regions(int count, std::uint64_t seed)
{
  Random random(seed);
  Items items;
  for (int i = 0; i < count; ++i) {
    const Vector2d a = anywhere(random);
    const Vector2d w(random.uniform(1, 20), 0), h(0, random.uniform(1, 12));
    TourItem item{{a, a + w + h}, {a + w, a + h}};
    if (i % 3 > 0) {
      item.push_back({a + w + h, a});
      item.push_back({a + h, a + w});
    }
    items.push_back(item);
  }
  return items;
}

/// Straight on a side of x = 50, a long way round from one side to the other.
double roundTheWall(const Vector2d& a, const Vector2d& b)
{
  return (a - b).norm() + ((a.x() < 50) == (b.x() < 50) ? 0 : 40);
}

double
costOf(const Items& items, const std::vector<TourStop>& stops, const TourCost& cost)
{
  double sum = 0;
  for (std::size_t k = 1; k < stops.size(); ++k) {
    const TourWay& a = items[stops[k - 1].item].at(stops[k - 1].way);
    sum += cost(a.out, items[stops[k].item].at(stops[k].way).in);
  }
  return sum;
}

/// The least cost over all orders and ways.
double cheapest(const Items& items, TourStart start, const TourCost& cost)
{
  std::vector<std::size_t> order(items.size());
  std::iota(order.begin(), order.end(), 0);
  double best = std::numeric_limits<double>::infinity();
  do {
    if (start == TourStart::First && order[0] != 0)
      break;
    std::vector<double> sum; // to the end of each way of the last item
    for (std::size_t k = 0; k < order.size(); ++k) {
      const TourItem& item = items[order[k]];
      std::vector<double> next;
      for (std::size_t w = 0; w < item.size(); ++w) {
        double least = k > 0 ? std::numeric_limits<double>::infinity() : 0;
        for (std::size_t v = 0; k > 0 && v < sum.size(); ++v)
          least =
              std::min(least, sum[v] + cost(items[order[k - 1]][v].out, item[w].in));
        next.push_back(least);
      }
      if (k == 0 && start == TourStart::First)
        std::fill(
            next.begin() + 1, next.end(), std::numeric_limits<double>::infinity());
      sum = next;
    }
    best = std::min(best, *std::min_element(sum.begin(), sum.end()));
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

void expectEachOnce(const Items& items, const Tour& tour)
{
  std::vector<int> visits(items.size(), 0);
  for (const TourStop& stop : tour.stops) {
    ASSERT_LT(stop.item, items.size());
    ++visits[stop.item];
  }
  EXPECT_EQ(visits, std::vector<int>(items.size(), 1));
}

double distance(const Vector2d& a, const Vector2d& b)
{
  return (a - b).norm();
}

} // namespace

TEST(Tour, OfAFewItemsIsCloseToTheBestOfAllOrders)
{
  int best = 0, all = 0;
  double worst = 1;
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
    for (const TourStart start : {TourStart::First, TourStart::Any})
      for (const bool wall : {false, true}) {
        const TourCost cost = wall ? roundTheWall : distance;
        const Items items = seed % 2 ? passes(7, seed) : regions(7, seed);
        const Tour tour = shortTour(items, start, cost);
        expectEachOnce(items, tour);
        EXPECT_NEAR(tour.after, costOf(items, tour.stops, cost), 1e-9);
        const double least = cheapest(items, start, cost);
        EXPECT_GE(tour.after, least - 1e-9);
        worst = std::max(worst, tour.after / least);
        best += tour.after < least + 1e-6;
        ++all;
      }
  EXPECT_LE(worst, 1.2);
  EXPECT_GE(best, all * 9 / 10) << "of " << all;
}

TEST(Tour, IsNeverLongerThanTheOrderGiven)
{
  // A row of passes that are in the best order already, with a way that leads astray:
  // the nearest end is not the one to go on from.
  Items row;
  for (int i = 0; i < 9; ++i)
    row.push_back({{{10.0 * i, 0}, {10.0 * i + 9, 0}}});
  const Tour straight = shortTour(row, TourStart::Any);
  EXPECT_NEAR(straight.before, 8, 1e-12);
  EXPECT_NEAR(straight.after, 8, 1e-12);
  for (std::uint64_t seed = 50; seed < 70; ++seed)
    for (const int count : {2, 3, 30, 300}) {
      const Items items = seed % 2 ? passes(count, seed) : regions(count, seed);
      const Tour tour = shortTour(items, TourStart::First, roundTheWall);
      expectEachOnce(items, tour);
      std::vector<TourStop> given;
      for (std::size_t i = 0; i < items.size(); ++i)
        given.push_back({i, 0});
      EXPECT_NEAR(tour.before, costOf(items, given, roundTheWall), 1e-9);
      EXPECT_NEAR(tour.after, costOf(items, tour.stops, roundTheWall), 1e-6);
      EXPECT_LE(tour.after, tour.before);
      EXPECT_EQ(tour.stops[0].item, 0u);
      EXPECT_EQ(tour.stops[0].way, 0u);
    }
}

TEST(Tour, OfManyItemsIsMuchShorterThanChance)
{
  // Of n places spread at random over an area A the shortest tour is about
  // 0.71 sqrt(n A) (Beardwood, Halton, Hammersley, 1959).
  Random random(5);
  Items points;
  for (int i = 0; i < 4000; ++i) {
    const Vector2d at = anywhere(random);
    points.push_back({{at, at}});
  }
  const Tour tour = shortTour(points, TourStart::Any);
  EXPECT_LT(tour.after, 1.12 * 0.7124 * std::sqrt(4000.0 * 6000));
  EXPECT_GT(tour.after, 0.90 * 0.7124 * std::sqrt(4000.0 * 6000));
}

TEST(Tour, GoesTheWayThroughAnItemThatSuitsItsNeighbours)
{
  // Three rectangles in a row; only the second way of the middle one leads on.
  const Items items{{{{0, 0}, {9, 0}}},
                    {{{19, 0}, {10, 0}}, {{10, 0}, {19, 0}}},
                    {{{20, 0}, {29, 0}}}};
  const Tour tour = shortTour(items, TourStart::First);
  ASSERT_EQ(tour.stops.size(), 3u);
  EXPECT_EQ(tour.stops[1].item, 1u);
  EXPECT_EQ(tour.stops[1].way, 1u);
  EXPECT_NEAR(tour.before, 20, 1e-12);
  EXPECT_NEAR(tour.after, 2, 1e-12);
}

TEST(Tour, OfNothingIsNothingAndOfOneIsThatOne)
{
  EXPECT_TRUE(shortTour({}, TourStart::Any).stops.empty());
  const Tour one = shortTour(passes(1, 3), TourStart::Any);
  ASSERT_EQ(one.stops.size(), 1u);
  EXPECT_EQ(one.after, 0);
}

TEST(Tour, RefusesWhatIsNoPlaceAndNoWay)
{
  EXPECT_THROW(shortTour({TourItem{}}, TourStart::Any), DataError);
  Items items = passes(3, 4);
  items[1][0].out.x() = std::nan("");
  EXPECT_THROW(shortTour(items, TourStart::Any), DataError);
}
