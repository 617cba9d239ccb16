// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/error.h>
#include <pointmill/link/link_passes.h>
#include <pointmill_test/clouds.h>

#include <gtest/gtest.h>

namespace link_test {

using namespace pointmill;
using namespace pointmill_test;

inline bool isRapid(const PointCL& p)
{
  return p.getMotion() == Motion::Rapid || p.getMotion() == Motion::Retract;
}

/// The stock as heights over a grid of places, cut by many small steps of the tool.
class Heap {
public:
  Heap(const Stock& stock, double spacing) : stock_(stock)
  {
    for (double y = stock.min.y() + spacing / 3; y < stock.max.y(); y += spacing)
      for (double x = stock.min.x() + spacing / 3; x < stock.max.x(); x += spacing)
        places_.emplace_back(x, y, stock.max.z());
  }
  /// Returns the thickest layer that was taken from any place.
  double cut(const Tool& tool, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
  {
    const double r = tool.radius(), low = std::min(a.z(), b.z());
    const int steps = std::max(1, static_cast<int>((b - a).norm() / 0.04));
    double deepest = 0;
    for (auto& p : places_) {
      if (p.z() <= low || p.x() < std::min(a.x(), b.x()) - r ||
          p.x() > std::max(a.x(), b.x()) + r || p.y() < std::min(a.y(), b.y()) - r ||
          p.y() > std::max(a.y(), b.y()) + r)
        continue;
      const double z = brute::swept(tool, a, b, p.x(), p.y(), steps);
      deepest = std::max(deepest, p.z() - z);
      p.z() = std::min(p.z(), z);
    }
    return deepest;
  }
  /// The highest place within @p radius of (x, y), or the stock's bottom.
  double highest(double x, double y, double radius) const
  {
    double best = stock_.min.z();
    for (const auto& p : places_)
      if (std::hypot(p.x() - x, p.y() - y) <= radius)
        best = std::max(best, p.z());
    return best;
  }

private:
  Stock stock_;
  std::vector<Eigen::Vector3d> places_;
};

inline std::shared_ptr<StockField> fieldOf(const Stock& stock, double cell = 0.25)
{
  return std::make_shared<StockField>(stock, cell, StockField::Bound::Upper);
}

inline CLCloud link(LinkPasses& stage, const CLCloud& passes)
{
  CLCloud path;
  stage.setInputCloud(CLCloud::ConstPtr(new CLCloud(passes)));
  stage.filter(path);
  return path;
}

inline void
addPass(CLCloud& passes, std::uint32_t label, std::initializer_list<Eigen::Vector3d> at)
{
  for (const auto& p : at) {
    passes.push_back(PointCL(p.x(), p.y(), p.z()));
    passes.back().label = label;
  }
}

/// What must be true of every path, whatever was linked.
inline void expectSound(const CLCloud& path,
                        double clearance,
                        const Cutting& cutting,
                        double ramp_angle)
{
  ASSERT_GE(path.size(), 2u);
  EXPECT_FLOAT_EQ(path.front().z, float(clearance));
  EXPECT_FLOAT_EQ(path.back().z, float(clearance));
  const double steepest = std::tan(ramp_angle * M_PI / 180);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector3d a = position(path[i - 1]), b = position(path[i]);
    const double across = (b - a).head<2>().norm(), down = a.z() - b.z();
    const Motion motion = path[i].getMotion();
    if (isRapid(path[i])) {
      EXPECT_EQ(path[i].feed, 0.f) << i;
      if (across > 0) {
        EXPECT_FLOAT_EQ(path[i].z, float(clearance)) << i;
        EXPECT_EQ(down, 0) << "a slanted rapid at " << i;
      }
      continue;
    }
    EXPECT_GT(path[i].feed, 0.f) << i;
    EXPECT_LE(path[i].feed, 1.00001 * std::max(cutting.feed, cutting.plunge_feed)) << i;
    if (down > 0) {
      const bool air = motion == Motion::LeadIn && across == 0; // proven to be
      const double fastest = air ? cutting.feed : cutting.plunge_feed;
      EXPECT_LE(path[i].feed * down / (b - a).norm(), 1.0001 * fastest) << i;
    }
    if (motion == Motion::Plunge) {
      EXPECT_EQ(across, 0) << i;
    }
    if (motion == Motion::Ramp) {
      // Passes are level here; 0.05 mm of swarf may be passed straight down.
      EXPECT_LE(down, across > 0 ? steepest * across + 1e-5 : 0.0501) << i;
    }
  }
}

} // namespace link_test
