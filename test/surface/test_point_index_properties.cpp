// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// What must hold for any points, the more so for awkward ones.
#include <pointmill/surface/point_index.h>

#include <pointmill_test/random.h>

#include <brute_force.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

using Eigen::Vector2d;
using pointmill::Contact;
using pointmill::PointIndex;
using pointmill::Tool;
using pointmill_test::Random;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Points {
  std::string name;
  std::vector<float> x, y, z;

  void add(double u, double v, double w)
  {
    x.push_back(float(u)), y.push_back(float(v)), z.push_back(float(w));
  }
  PointIndex index(unsigned threads = 0) const { return {x, y, z, threads}; }
  brute::Points all() const
  {
    brute::Points points;
    for (std::size_t i = 0; i < x.size(); ++i)
      points.emplace_back(x[i], y[i], z[i]);
    return points;
  }
};

Points random(const std::string& name,
              int count,
              std::uint64_t seed,
              const std::function<void(Points&, Random&)>& add)
{
  Points points;
  points.name = name;
  Random random(seed);
  for (int i = 0; i < count; ++i)
    add(points, random);
  return points;
}

/// Smooth ground with walls, 20 x 14.
double ground(double x, double y)
{
  return 2 * std::sin(0.7 * x) * std::cos(0.5 * y) + (x > 12 ? 4 : 0) + 0.3 * y;
}

std::vector<Points> clouds()
{
  std::vector<Points> all;
  all.push_back(random("ground", 4000, 1, [](Points& p, Random& r) {
    const double x = r.uniform(0, 20), y = r.uniform(0, 14);
    p.add(x, y, ground(x, y));
  }));
  all.push_back(random("noise", 3000, 2, [](Points& p, Random& r) {
    p.add(r.uniform(0, 20), r.uniform(0, 14), r.uniform(-3, 3));
  }));
  all.push_back(
      random("level, on a lattice, with duplicates", 3000, 3, [](Points& p, Random& r) {
        p.add(std::floor(r.uniform(0, 40)) / 2, std::floor(r.uniform(0, 28)) / 2, 1.5);
      }));
  all.push_back(random("steps", 3000, 4, [](Points& p, Random& r) {
    const double x = r.uniform(0, 20);
    p.add(x, r.uniform(0, 14), std::floor(x / 3));
  }));
  all.push_back(random("a line", 700, 5, [](Points& p, Random& r) {
    const double t = r.uniform(0, 20);
    p.add(t, 0.7 * t, std::sin(t));
  }));
  all.push_back(random("a line along Y", 700, 6, [](Points& p, Random& r) {
    const double t = r.uniform(0, 14);
    p.add(3, t, std::cos(t));
  }));
  all.push_back(random("a thin strip", 2000, 7, [](Points& p, Random& r) {
    const double t = r.uniform(0, 20);
    p.add(t, r.uniform(5, 5.001), std::sin(t));
  }));
  all.push_back(random("all in one place", 500, 8, [](Points& p, Random& r) {
    p.add(7, 7, r.uniform(-1, 1));
  }));
  all.push_back(random("two far clusters", 1000, 9, [](Points& p, Random& r) {
    const double far = r.uniform() < 0.5 ? 0 : 5000;
    p.add(far + r.uniform(0, 3), far + r.uniform(0, 3), r.uniform(0, 1));
  }));
  all.push_back(random("far from the origin", 3000, 10, [](Points& p, Random& r) {
    const double x = r.uniform(0, 20), y = r.uniform(0, 14);
    p.add(123456 + x, -654321 + y, 1000 + ground(x, y));
  }));
  Points one;
  one.name = "one point";
  one.add(4, 5, 6);
  all.push_back(one);
  return all;
}

const std::vector<Tool> kTools{Tool::flat(1, 4.0),
                               Tool::ball(2, 3.0),
                               Tool::bull(3, 5.0, 1.0),
                               Tool::ball(4, 0.4),
                               Tool::ball(5, 30.0),
                               Tool::flat(6, 60.0),
                               Tool::taperBall(7, 1.0, 5.0, 6.0),
                               Tool::cone(8, 45.0, 4.0)};

/// Places over and around the points, many of them special ones.
Vector2d somewhere(const PointIndex& index, Random& random)
{
  const Vector2d low = index.min().head<2>(), high = index.max().head<2>();
  const double margin = 4;
  const double u = random.uniform(), choice = random.uniform();
  if (choice < 0.3) { // over a point, or nearly
    const auto p =
        index.point(std::min(index.size() - 1, std::size_t(u * double(index.size()))));
    return p.head<2>() +
           (choice < 0.1 ? 0.0 : 1e-3) * Vector2d(random.normal(), random.normal());
  }
  return {random.uniform(low.x() - margin, high.x() + margin),
          random.uniform(low.y() - margin, high.y() + margin)};
}

void expectSame(const Contact& a, const Contact& b, const std::string& what)
{
  EXPECT_EQ(a.tip, b.tip) << what;
  EXPECT_EQ(a.point, b.point) << what;
  EXPECT_EQ(a.at, b.at) << what;
}

} // namespace

TEST(PointIndexProperties, ADropIsTheMaximumOverAllPoints)
{
  for (const auto& cloud : clouds()) {
    const PointIndex index = cloud.index();
    const brute::Points all = cloud.all();
    Random random(11);
    for (const auto& tool : kTools)
      for (int i = 0; i < 60; ++i) {
        const Vector2d at = somewhere(index, random);
        const Contact contact = index.drop(tool, at.x(), at.y());
        const double truth = brute::drop(all, tool, at.x(), at.y());
        // On the very rim, rounding decides whether a point is under the cutter.
        const double less = brute::drop(all, tool.grown(-1e-9), at.x(), at.y()) - 1e-9;
        if (truth == -kInfinity || contact.tip == -kInfinity) {
          EXPECT_EQ(contact.touches(), false) << cloud.name;
          EXPECT_EQ(less, -kInfinity) << cloud.name;
          continue;
        }
        EXPECT_LE(contact.tip, truth + 1e-11) << cloud.name << ", " << tool.describe();
        EXPECT_GE(contact.tip, std::min(truth - 1e-11, less))
            << cloud.name << ", " << tool.describe();
        EXPECT_EQ(index.point(std::size_t(contact.point)), contact.at);
        EXPECT_NEAR(contact.at.z() -
                        tool.profile(std::min(tool.radius(),
                                              (contact.at.head<2>() - at).norm())),
                    contact.tip,
                    1e-9)
            << cloud.name;
      }
  }
}

TEST(PointIndexProperties, ARowIsItsDrops)
{
  for (const auto& cloud : clouds()) {
    const PointIndex index = cloud.index();
    Random random(12);
    for (const auto& tool : kTools)
      for (double step : {0.0, 0.01, 0.1, 0.5, 7.0}) {
        const Vector2d from = somewhere(index, random);
        const double angle = random.uniform(0, 6.3);
        const Vector2d along = step * Vector2d(std::cos(angle), std::sin(angle));
        std::vector<Contact> row(1 + std::size_t(random.uniform(0, 90)));
        index.dropRow(tool, from, along, row.size(), row.data());
        for (std::size_t i = 0; i < row.size(); ++i) {
          const Vector2d at = from + double(i) * along;
          expectSame(row[i],
                     index.drop(tool, at.x(), at.y()),
                     cloud.name + ", " + tool.describe());
        }
      }
  }
}

TEST(PointIndexProperties, OfEqualHeightsTheFirstPointHolds)
{
  for (const auto& cloud : clouds()) {
    const PointIndex index = cloud.index();
    Random random(13);
    for (const auto& tool : {Tool::flat(1, 4.0), Tool::bull(2, 5.0, 1.0)})
      for (int i = 0; i < 60; ++i) {
        const Vector2d at = somewhere(index, random);
        const Contact contact = index.drop(tool, at.x(), at.y());
        std::int64_t first = -1;
        for (std::size_t k = 0; k < index.size() && first < 0; ++k) {
          const double dx = index.point(k).x() - at.x(),
                       dy = index.point(k).y() - at.y();
          const double d2 = dx * dx + dy * dy;
          if (d2 <= tool.radius() * tool.radius() &&
              index.point(k).z() -
                      tool.profile(std::min(std::sqrt(d2), tool.radius())) ==
                  contact.tip)
            first = std::int64_t(k);
        }
        EXPECT_EQ(contact.point, first) << cloud.name << ", " << tool.describe();
      }
  }
}

TEST(PointIndexProperties, TheOrderOfThePointsChangesNoHeight)
{
  for (const auto& cloud : clouds()) {
    Points shuffled = cloud;
    Random random(14);
    for (std::size_t i = cloud.x.size(); i > 1; --i) {
      const auto k = std::size_t(random.uniform() * double(i));
      std::swap(shuffled.x[i - 1], shuffled.x[k]);
      std::swap(shuffled.y[i - 1], shuffled.y[k]);
      std::swap(shuffled.z[i - 1], shuffled.z[k]);
    }
    const PointIndex a = cloud.index(), b = shuffled.index();
    for (const auto& tool : kTools)
      for (int i = 0; i < 40; ++i) {
        const Vector2d at = somewhere(a, random);
        EXPECT_EQ(a.drop(tool, at.x(), at.y()).tip, b.drop(tool, at.x(), at.y()).tip)
            << cloud.name;
      }
  }
}

TEST(PointIndexProperties, ThreadsChangeNothing)
{
  // Enough points for several parts and bands.
  const Points many = random("many", 300000, 15, [](Points& p, Random& r) {
    const double x = r.uniform(0, 60), y = r.uniform(0, 60);
    p.add(x, y, ground(x / 3, y / 4));
  });
  const PointIndex one = many.index(1);
  for (unsigned threads : {2u, 5u}) {
    const PointIndex other = many.index(threads);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i)
      ASSERT_EQ(one.point(i), other.point(i));
    for (int row = 0; row < one.rows(); ++row)
      ASSERT_EQ(one.cells(row, 0, one.columns() - 1),
                other.cells(row, 0, one.columns() - 1));
    Random random(16);
    for (int i = 0; i < 200; ++i) {
      const Vector2d at = somewhere(one, random);
      expectSame(one.drop(kTools[1], at.x(), at.y()),
                 other.drop(kTools[1], at.x(), at.y()),
                 "threads");
    }
  }
}

TEST(PointIndexProperties, FewerPointsNeverHoldTheCutterHigher)
{
  for (const auto& cloud : clouds()) {
    Points some;
    for (std::size_t i = 0; i < cloud.x.size(); ++i)
      if (i % 3 == 0)
        some.add(cloud.x[i], cloud.y[i], cloud.z[i]);
    const PointIndex all = cloud.index(), fewer = some.index();
    Random random(17);
    for (const auto& tool : kTools)
      for (int i = 0; i < 40; ++i) {
        const Vector2d at = somewhere(all, random);
        EXPECT_LE(fewer.drop(tool, at.x(), at.y()).tip,
                  all.drop(tool, at.x(), at.y()).tip)
            << cloud.name;
      }
  }
}

TEST(PointIndexProperties, NothingIsMetFarOutsideOrNowhere)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& cloud : clouds()) {
    const PointIndex index = cloud.index();
    for (const auto& tool : kTools)
      for (const Vector2d& at : {Vector2d(1e9, 0),
                                 Vector2d(0, -1e300),
                                 Vector2d(kInfinity, 0),
                                 Vector2d(nan, 5),
                                 Vector2d(5, nan)}) {
        EXPECT_FALSE(index.drop(tool, at.x(), at.y()).touches()) << cloud.name;
        EXPECT_EQ(index.dropAlong(tool, at.x(), at.y(), at.x(), at.y()), -kInfinity);
        std::vector<Contact> row(20);
        index.dropRow(tool, at, {0.01, 0.01}, row.size(), row.data());
        for (const auto& contact : row)
          EXPECT_FALSE(contact.touches()) << cloud.name;
      }
  }
}

TEST(PointIndexProperties, AMoveOnTheSpotIsADrop)
{
  for (const auto& cloud : clouds()) {
    const PointIndex index = cloud.index();
    Random random(18);
    for (const auto& tool : kTools)
      for (int i = 0; i < 20; ++i) {
        const Vector2d at = somewhere(index, random);
        EXPECT_EQ(index.dropAlong(tool, at.x(), at.y(), at.x(), at.y()),
                  index.drop(tool, at.x(), at.y()).tip)
            << cloud.name << ", " << tool.describe();
      }
  }
}
