// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// The width of cut of HighSpeedRoughing, by a simulation of its own.
#include "rough_test.h"

#include <functional>

using namespace rough_test;

namespace {

const Rectangle kBlock{0, 0, 64, 52};
constexpr double kCell = 0.4, kStepDown = 2.0;

using Height = std::function<double(double, double)>;

Height bumps(int count, std::uint64_t seed)
{
  return [field = Bumps(kBlock, 5, count, seed)](double x, double y) {
    return field(x, y) - 5;
  };
}

struct Part {
  const char* name;
  Height height;
  bool closed; ///< there is no way in from outside the stock
};

const Part kParts[] = {
    {"pocket",
     [](double x, double y) {
       return Rectangle{8, 8, 56, 44}.holds(x, y) ? -5.0 : 0.0;
     },
     true},
    {"island",
     [](double x, double y) {
       return Rectangle{24, 20, 40, 32}.holds(x, y) ? 0.0 : -5.0;
     },
     false},
    {"ring",
     [](double x, double y) {
       const double r = std::hypot(x - 32, y - 26);
       return r >= 13 && r <= 17 ? 0.0 : -5.0;
     },
     true},
    {"towers",
     [](double x, double y) {
       return Rectangle{12, 16, 25, 36}.holds(x, y) ||
                      Rectangle{36, 16, 52, 36}.holds(x, y)
                  ? 0.0
                  : -5.0;
     },
     false},
    {"at the edge",
     [](double x, double y) {
       return Rectangle{0, 0, 20, 52}.holds(x, y) ? 0.0 : -5.0;
     },
     false},
    {"bumps", bumps(14, 21), false},
    {"other bumps", bumps(20, 22), false},
};

/// What stands at one level, seen from above in cells of 0.1 mm.
class Plan {
public:
  Plan() : columns_(640), stands_(640 * 520, 1) {}

  /// Moves a disc straight; @return the area that it took [mm2]
  double cut(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double radius)
  {
    const int pieces = std::max(1, int(std::ceil((b - a).norm() / 0.25)));
    int cells = 0;
    for (int i = 0; i <= pieces; ++i)
      cells += cutDisc(a + (b - a) * (double(i) / pieces), radius);
    return cells * 0.01;
  }

private:
  int cutDisc(const Eigen::Vector2d& p, double radius)
  {
    int cells = 0;
    for (int row = std::max(0, int((p.y() - radius) * 10) - 1);
         row < std::min(520, int((p.y() + radius) * 10) + 2);
         ++row)
      for (int column = std::max(0, int((p.x() - radius) * 10) - 1);
           column < std::min(640, int((p.x() + radius) * 10) + 2);
           ++column) {
        const double dx = (column + 0.5) / 10 - p.x(), dy = (row + 0.5) / 10 - p.y();
        char& stands = stands_[std::size_t(row) * columns_ + column];
        if (stands && dx * dx + dy * dy <= radius * radius) {
          stands = 0;
          ++cells;
        }
      }
    return cells;
  }

  std::size_t columns_;
  std::vector<char> stands_;
};

struct Measured {
  double widest = 0;           ///< largest mean over a quarter of a diameter [mm]
  double area = 0, length = 0; ///< of the cutting moves
  double start_area = 0;       ///< taken where passes begin on the level
};

/// The width of cut on the first level but for ramps.
Measured measure(const CLCloud& passes, double diameter)
{
  Plan plan;
  Measured m;
  double area = 0, length = 0;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const PointCL& to = passes[i];
    if (to.level != 0)
      continue;
    const PointCL& from = passes[i > 0 && passes[i - 1].label == to.label ? i - 1 : i];
    const Eigen::Vector2d a(from.x, from.y), b(to.x, to.y);
    const bool level = from.z == -float(kStepDown) && to.z == -float(kStepDown);
    if (to.getMotion() == Motion::Ramp || &from == &to) {
      const double taken = level ? plan.cut(a, b, diameter / 2) : 0.0;
      if (to.getMotion() != Motion::Ramp)
        m.start_area += taken;
      area = length = 0;
      continue;
    }
    EXPECT_TRUE(level);
    const int pieces = std::max(1, int(std::ceil((b - a).norm() / 0.25)));
    for (int k = 0; k < pieces; ++k) {
      const Eigen::Vector2d p = a + (b - a) * (double(k) / pieces);
      const Eigen::Vector2d q = a + (b - a) * (double(k + 1) / pieces);
      const double taken = plan.cut(p, q, diameter / 2);
      area += taken;
      length += (q - p).norm();
      if (to.getMotion() == Motion::Cut) {
        m.area += taken;
        m.length += (q - p).norm();
      }
      if (length >= diameter / 4) {
        m.widest = std::max(m.widest, area / length);
        area = length = 0;
      }
    }
  }
  return m;
}

class HighSpeed : public ::testing::Test {
protected:
  CLCloud run(const Part& part, double diameter, double step_over, MillingMode mode)
  {
    const auto cloud = surface(kBlock, 0.4, part.height);
    roughing.setTool(Tool::flat(1, diameter));
    roughing.setAllowance(0.3);
    roughing.setStepDown(kStepDown);
    roughing.setStepOver(step_over);
    roughing.setMillingMode(mode);
    roughing.setStock(block(kBlock, -5, 0, kCell));
    roughing.setFloor(-4);
    roughing.setPart(indexOf(*cloud));
    roughing.setInputCloud(mapOf(cloud, kCell));
    CLCloud passes;
    roughing.filter(passes);
    return passes;
  }
  HighSpeedRoughing roughing;
};

double turnBetween(const PointCL& a, const PointCL& b, const PointCL& c)
{
  const double before = std::atan2(b.y - a.y, b.x - a.x);
  const double after = std::atan2(c.y - b.y, c.x - b.x);
  return std::remainder(after - before, 2 * M_PI);
}

} // namespace

TEST_F(HighSpeed, TheWidthOfCutKeepsItsLimit)
{
  for (const auto& part : kParts)
    for (const double share : {0.15, 0.25, 0.4})
      for (const MillingMode mode : {MillingMode::Climb, MillingMode::Conventional}) {
        const double d = 8, limit = share * d;
        const auto passes = run(part, d, limit, mode);
        ASSERT_GT(passes.size(), 50u) << part.name;
        const Measured m = measure(passes, d);
        // a cell of the level's simulation, a sixteenth of a radius at most
        EXPECT_LE(m.widest, 1.05 * limit + d / 2 / 16) << part.name << " " << share;
        EXPECT_LE(m.start_area, 0.5) << part.name << " " << share;
      }
}

TEST_F(HighSpeed, InOpenGroundTheWidthOfCutIsTheLimit)
{
  const auto passes = run(kParts[1], 8, 2, MillingMode::Climb);
  const Measured m = measure(passes, 8);
  EXPECT_GT(m.area / m.length, 0.85 * 2);
}

TEST_F(HighSpeed, ClimbHasTheMaterialOnTheRight)
{
  // Round an island the tool goes clockwise, from outside; the other way conventional.
  for (const MillingMode mode : {MillingMode::Climb, MillingMode::Conventional}) {
    const auto passes = run(kParts[1], 8, 2, mode);
    double around = 0;
    for (std::size_t i = 1; i < passes.size(); ++i)
      if (passes[i].level == 0 && passes[i].label == passes[i - 1].label &&
          passes[i].getMotion() == Motion::Cut) {
        const double a = std::atan2(passes[i - 1].y - 26, passes[i - 1].x - 32);
        const double b = std::atan2(passes[i].y - 26, passes[i].x - 32);
        around += std::remainder(b - a, 2 * M_PI);
      }
    EXPECT_GT(mode == MillingMode::Climb ? -around : around, 4 * M_PI);
  }
}

TEST_F(HighSpeed, MaterialIsEnteredDownAHelixOrARampOnly)
{
  for (const auto& part : kParts) {
    const auto passes = run(part, 8, 2, MillingMode::Climb);
    bool ramps = false;
    for (std::size_t i = 1; i < passes.size(); ++i) {
      if (passes[i].label != passes[i - 1].label)
        continue;
      const double down = passes[i - 1].z - passes[i].z;
      if (down == 0)
        continue;
      ramps = true;
      EXPECT_EQ(passes[i].getMotion(), Motion::Ramp);
      const double along =
          std::hypot(passes[i].x - passes[i - 1].x, passes[i].y - passes[i - 1].y);
      EXPECT_LE(std::abs(down), along * std::tan(3.0 * M_PI / 180) + 1e-4);
    }
    if (part.closed) {
      EXPECT_TRUE(ramps) << part.name;
    }
  }
}

TEST_F(HighSpeed, APocketIsOnePathPerLevelWithoutAnyLift)
{
  const auto passes = run(kParts[0], 8, 2, MillingMode::Climb);
  EXPECT_EQ(roughing.getReport().get("helices"), 2); // levels
  EXPECT_EQ(roughing.getReport().get("passes"), 2);
}

TEST_F(HighSpeed, CornersAreRounded)
{
  // In the open no corner of the path is sharper than a step of the tightest turn.
  const auto passes = run(kParts[1], 8, 2, MillingMode::Climb);
  const Rectangle near_island = Rectangle{24, 20, 40, 32}.inner(-6);
  for (std::size_t i = 2; i < passes.size(); ++i)
    if (passes[i - 2].label == passes[i].label &&
        passes[i - 1].getMotion() == Motion::Cut &&
        passes[i].getMotion() == Motion::Cut &&
        !near_island.holds(passes[i - 1].x, passes[i - 1].y)) {
      EXPECT_LE(std::abs(turnBetween(passes[i - 2], passes[i - 1], passes[i])), 0.66);
    }
}

TEST_F(HighSpeed, ASlotOfTheToolsWidthIsRampedForthAndBack)
{
  const Part slot{"slot",
                  [](double x, double y) {
                    return Rectangle{10, 20, 50, 29.6}.holds(x, y) ? -5.0 : 0.0;
                  },
                  true};
  const auto passes = run(slot, 8, 2, MillingMode::Climb);
  ASSERT_FALSE(passes.empty());
  EXPECT_GT(roughing.getReport().get("ramped_slots_mm"), 40);
  const Measured m = measure(passes, 8);
  EXPECT_LE(m.widest, 1.05 * 2 + 0.25);
}

TEST_F(HighSpeed, WhatIsTooNarrowToEnterIsNamed)
{
  // A round hole that the tool just fits in: no helix, no ramp.
  const Part hole{
      "hole",
      [](double x, double y) { return std::hypot(x - 32, y - 26) < 5.2 ? -5.0 : 0.0; },
      true};
  run(hole, 8, 2, MillingMode::Climb);
  EXPECT_EQ(roughing.getReport().get("passes"), 0);
  EXPECT_GT(roughing.getReport().get("narrow_mm2"), 2 * 40); // of two levels
}

TEST_F(HighSpeed, AbsurdRampAnglesAreRefused)
{
  for (const double angle : {0.0, -3.0, 46.0, std::nan("")}) {
    roughing.setRampAngle(angle);
    EXPECT_THROW(run(kParts[0], 8, 2, MillingMode::Climb), ParameterError) << angle;
  }
}
