// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// The sweep of a program over points, to the bit as if every move met every point.
#include <moves.h>

#include <pointmill/surface/sweep.h>
#include <pointmill_test/clouds.h>

#include <gtest/gtest.h>

using namespace pointmill;
using namespace pointmill_test;

namespace {

struct Swept {
  Gouges gouges;
  std::vector<float> height;
};

Swept everyMoveOverEveryPoint(const PointIndex& points,
                              const std::vector<SweptMove>& moves,
                              double tolerance)
{
  Swept swept;
  swept.height.assign(points.size(), std::numeric_limits<float>::infinity());
  std::vector<bool> gouged(points.size());
  for (const auto& m : moves)
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d p = points.point(i);
      const double h = sweptHeight(*m.tool, m.a, m.b, p.x(), p.y());
      swept.height[i] = std::min(swept.height[i], static_cast<float>(h));
      const double depth = h < p.z() ? penetration(*m.tool, m.a, m.b, p) : 0;
      gouged[i] = gouged[i] || depth > tolerance;
      if (depth > swept.gouges.depth) {
        swept.gouges.depth = depth;
        swept.gouges.at = p;
        swept.gouges.line = m.line;
      }
    }
  swept.gouges.count =
      static_cast<std::size_t>(std::count(gouged.begin(), gouged.end(), true));
  return swept;
}

const std::vector<Tool> kTools = {
    Tool::flat(1, 5), Tool::ball(2, 4), Tool::bull(3, 3, 0.6), Tool::ball(4, 1.5)};
const Rectangle kArea{0, 0, 24, 17};

/// Passes that rest on the part or, by up to `deep`, in it; plunges, long diagonals,
/// moves on the spot and moves far beside it.
std::vector<SweptMove> randomMoves(const PointIndex& part, double deep, Random& random)
{
  std::vector<SweptMove> moves;
  std::size_t line = 1;
  for (const auto& tool : kTools) {
    const auto place = [&](double reach) {
      const double x = random.uniform(-reach, kArea.x1 + reach);
      const double y = random.uniform(-reach, kArea.y1 + reach);
      const double rest = std::max(-1.0, part.drop(tool, x, y).tip);
      return Eigen::Vector3d(x, y, rest + random.uniform(-deep, 0.5));
    };
    Eigen::Vector3d at = place(3);
    for (int i = 0; i < 200; ++i) {
      Eigen::Vector3d to = place(i % 50 ? 3 : 100);
      if (i % 3) // a short one, as of a finishing pass
        to = at + 0.05 * (to - at);
      if (i % 17 == 0) {
        to = at;
        to.z() += random.uniform(-1, 1);
      }
      if (i % 41 == 0)
        to = at;
      moves.push_back({at, to, &tool, line++, i % 29 == 0});
      at = to;
    }
  }
  return moves;
}

void expectSame(const PointIndex& part,
                const std::vector<SweptMove>& moves,
                double tolerance)
{
  const Swept truth = everyMoveOverEveryPoint(part, moves, tolerance);
  for (const unsigned threads : {1u, 3u}) {
    Swept swept;
    swept.gouges = sweepPoints(part, moves, tolerance, threads, swept.height);
    EXPECT_EQ(swept.gouges.depth, truth.gouges.depth);
    EXPECT_EQ(swept.gouges.count, truth.gouges.count);
    EXPECT_EQ(swept.gouges.line, truth.gouges.line);
    EXPECT_EQ(swept.gouges.at, truth.gouges.at);
    ASSERT_EQ(swept.height, truth.height);
  }
}

} // namespace

TEST(SweepPoints, IsThatOfEveryMoveOverEveryPoint)
{
  std::uint64_t seed = 31;
  for (const double step : {0.15, 0.4, 3.0})
    for (const double deep : {0.0, 0.015, 0.6}) {
      const auto part = indexOf(*surface(kArea, step, Bumps(kArea, 6, 7, seed)));
      Random random(seed++);
      const auto moves = randomMoves(*part, deep, random);
      SCOPED_TRACE(testing::Message() << step << " apart, " << deep << " deep");
      expectSame(*part, moves, 0.02);
    }
}

TEST(SweepPoints, HoldsForCloudsOfAnyShape)
{
  Random random(77);
  const auto cloudOf = [&](auto&& place, int count) {
    Cloud cloud;
    for (int i = 0; i < count; ++i)
      cloud.push_back(place());
    return indexOf(cloud);
  };
  const auto at = [](double x, double y, double z) {
    return pcl::PointXYZ(float(x), float(y), float(z));
  };
  const auto wall = cloudOf(
      [&] { return at(12, random.uniform(0, 17), random.uniform(-1, 8)); }, 2000);
  const auto spot = cloudOf([&] { return at(12, 8, 0.5); }, 50);
  const auto one = cloudOf([&] { return at(3, 4, 1); }, 1);
  const auto scattered = cloudOf(
      [&] {
        const double far = random.uniform() < 0.01 ? 300 : 1;
        return at(
            far * random.uniform(0, 24), random.uniform(0, 17), random.uniform(-1, 3));
      },
      3000);
  for (const auto& part : {wall, spot, one, scattered})
    expectSame(*part, randomMoves(*part, 0.2, random), 0.02);
}

TEST(SweepPoints, OfEquallyDeepGougesTheFirstInTheProgramIsNamed)
{
  const auto plate = indexOf(*surface(kArea, 0.5, [](double, double) { return 0; }));
  std::vector<SweptMove> moves;
  for (std::size_t line = 1; line <= 8; ++line) { // from the far side on
    const double y = 18 - 2.0 * double(line);
    moves.push_back({{-5, y, -0.1}, {30, y, -0.1}, &kTools[0], line, false});
  }
  std::vector<float> height;
  const Gouges gouges = sweepPoints(*plate, moves, 0.02, 2, height);
  EXPECT_EQ(gouges.depth, 0.1);
  EXPECT_EQ(gouges.line, 1u);
  EXPECT_EQ(gouges.count, plate->size());
}

TEST(SweepPoints, WithoutMovesNothingIsTouched)
{
  const auto plate = indexOf(*surface(kArea, 0.5, [](double, double) { return 0; }));
  std::vector<float> height;
  const Gouges gouges = sweepPoints(*plate, {}, 0.02, 2, height);
  EXPECT_EQ(gouges.count, 0u);
  EXPECT_EQ(height.size(), plate->size());
  EXPECT_EQ(*std::min_element(height.begin(), height.end()),
            std::numeric_limits<float>::infinity());
}
