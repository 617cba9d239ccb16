// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Rows keep out of zones, whatever is done to them later.
#include "finish_test.h"

using namespace finish_test;

namespace {

const std::vector<Tool> kAllTools{Tool::flat(1, 4.0),
                                  Tool::ball(2, 4.0),
                                  Tool::bull(3, 4.0, 1.0),
                                  Tool::taperBall(4, 1.0, 15.0, 4.0),
                                  Tool::cone(5, 30.0, 4.0, 0.5)};

const double kPi = std::acos(-1.0);

// Ground with a valley along Y: rows along X lose height between their CL points.
double ground(double x, double y)
{
  return 1.5 * std::sin(0.9 * x) + 0.1 * y;
}

struct Rows {
  Cloud::Ptr cloud;
  CLSurface<pcl::PointXYZ> stage;

  explicit Rows(const Cloud::Ptr& part, const Tool& tool) : cloud(part)
  {
    stage.setTool(tool);
    stage.setStepOver(0.5);
    stage.setForwardStep(0.5);
    stage.setFloor(-3);
  }
  CLCloud operator()() { return raster(stage, cloud); }
};

CLCloud buffered(const CLCloud& path, const Cloud::Ptr& part, const Tool& tool)
{
  BufferPoints<pcl::PointXYZ> buffer;
  buffer.setSurface(part);
  buffer.setTool(tool);
  buffer.setFloor(-3);
  buffer.setTolerance(0.01);
  buffer.setInputCloud(std::make_shared<CLCloud>(path));
  CLCloud result;
  buffer.filter(result);
  return result;
}

double deepestIn(const KeepOut& keep_out, const Tool& tool, const CLCloud& path)
{
  double deepest = 0;
  forMovesOfPasses(path, [&](const auto& a, const auto& b, const PointCL&) {
    deepest = std::max(deepest, keep_out.depth(tool, a, b));
  });
  return deepest;
}

} // namespace

TEST(KeepOutRows, EndAtTheMarginOfATallZone)
{
  const auto part = surface({-15, -15, 15, 15}, 0.5, [](double, double) { return 0; });
  const double reach = 2 + 1; // radius and margin
  for (const auto& tool : kAllTools) {
    Rows rows(part, tool);
    rows.stage.setKeepOut(KeepOut({KeepOutZone::cylinder(0, 0, 5, 9)}, 1.0));
    const auto path = rows();
    double nearest = 1e9;
    for (const auto& p : path)
      nearest = std::min(nearest, std::hypot(double(p.x), double(p.y)));
    EXPECT_GE(nearest, 5 + reach - 1e-5) << tool.describe();
    EXPECT_LE(nearest, 5 + reach + 0.02) << tool.describe();
    // Rows are half a millimetre apart.
    EXPECT_NEAR(rows.stage.getReport().get("keep_out_length_mm"),
                kPi * 64 / 0.5,
                0.02 * kPi * 64 / 0.5);
  }
}

TEST(KeepOutRows, MissNothingThatIsClear)
{
  const auto part = surface({-15, -15, 15, 15}, 0.5, ground);
  for (const auto& tool : kAllTools) {
    Rows all(part, tool), some(part, tool);
    const KeepOut keep_out({KeepOutZone::box(-4, -3, 5, 4, 1.0)}, 0.5);
    some.stage.setKeepOut(keep_out);
    const auto whole = all(), rest = some();
    // Every CL point that is clear by a hair, and whose neighbours are, is still there.
    std::size_t lost = 0, clear = 0, found = 0;
    for (std::size_t i = 1; i + 1 < whole.size(); ++i) {
      bool free = true;
      for (std::size_t k = i - 1; k <= i + 1; ++k)
        free &= whole[k].z > 0.3 + keep_out.lowest(tool, whole[k].x, whole[k].y);
      if (!free) {
        ++lost;
        continue;
      }
      ++clear;
      const auto same = [&](const PointCL& p) {
        return p.x == whole[i].x && p.y == whole[i].y && p.z == whole[i].z;
      };
      found += std::any_of(rest.begin(), rest.end(), same);
    }
    EXPECT_EQ(found, clear) << tool.describe();
    EXPECT_GT(lost, 50u);
  }
}

// Low zones, over which the tool may hang, and zones that are thinner than the way
// between two CL points.
TEST(KeepOutRows, AreClearBetweenTheirPointsAndAfterBuffering)
{
  const auto part = surface({-12, -12, 12, 12}, 0.4, ground);
  for (const auto& tool : kAllTools)
    for (const double top : {-1.5, 0.0, 1.0, 8.0}) {
      Rows rows(part, tool);
      const KeepOut keep_out(
          {KeepOutZone::box(-6, -6, -2, 1, top),
           KeepOutZone::cylinder(4, 3, 0.05, top),
           KeepOutZone::polygon({{2, -8}, {10, -8}, {10, -4}, {5, -6}}, top)},
          0.1);
      rows.stage.setKeepOut(keep_out);
      rows.stage.setAngle(17);
      const auto path = rows();
      EXPECT_EQ(deepestIn(keep_out, tool, path), 0) << tool.describe() << " " << top;
      EXPECT_EQ(deepestIn(keep_out, tool, buffered(path, part, tool)), 0)
          << tool.describe() << " " << top;
    }
}

TEST(KeepOutRows, InsertedRowsAndThoseAcrossKeepOutToo)
{
  const auto part = surface({-12, -12, 12, 12}, 0.3, ground);
  const Tool tool = Tool::ball(1, 4.0);
  Rows rows(part, tool);
  rows.stage.setScallop(0.02);
  rows.stage.setMinStepOver(0.2);
  rows.stage.setAngle(90);
  rows.stage.setAcross(true);
  const KeepOut keep_out({KeepOutZone::box(-6, -6, 2, 1, 5)}, 1.0);
  rows.stage.setKeepOut(keep_out);
  const auto path = rows();
  EXPECT_GT(rows.stage.getReport().get("inserted_passes"), 0);
  EXPECT_EQ(deepestIn(keep_out, tool, path), 0);
}

TEST(KeepOutRows, NoZonesChangeNothing)
{
  const auto part = surface({-8, -8, 8, 8}, 0.4, ground);
  Rows plain(part, Tool::ball(1, 3.0)), none(part, Tool::ball(1, 3.0));
  none.stage.setKeepOut(KeepOut({}, 2.0));
  const auto a = plain(), b = none();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_TRUE(a[i].x == b[i].x && a[i].y == b[i].y && a[i].z == b[i].z);
}
