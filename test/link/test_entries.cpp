// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Entries into material, arcs into and out of passes, and motions that are handed in.
#include "link_test.h"

using namespace link_test;

namespace {

const Stock kBox{{0, 0, -6}, {40, 30, 0}};

/// A part below the passes, with what stands in their way by `height`.
template <typename Height>
Cloud::Ptr ground(Height height)
{
  return surface({-12, -12, 52, 42}, 0.3, height);
}

struct Entering : ::testing::Test {
  LinkPasses linker;
  Cutting cutting;
  const Tool tool = Tool::flat(1, 5);
  static constexpr double allowance = 0.2;
  std::shared_ptr<StockField> nominal;

  Entering()
  {
    cutting.feed = 900;
    cutting.plunge_feed = 200;
    linker.setTool(tool);
    linker.setCutting(cutting);
    linker.setClearancePlane(8);
    linker.setRampAngle(5);
    renew();
    setPart(*ground([](double, double) { return -5.0; }));
  }
  void renew()
  {
    linker.setStock(fieldOf(kBox));
    nominal = std::make_shared<StockField>(kBox, 0.25, StockField::Bound::Nominal);
    linker.setNominalStock(nominal);
  }
  void setPart(const Cloud& cloud) { linker.setPart(indexOf(cloud), allowance, -5.5); }
  double report(const char* name) const { return linker.getReport().get(name); }

  /// No feed move comes nearer to the part than its allowance.
  static void expectClear(const CLCloud& path, const Tool& with, const Cloud& cloud)
  {
    const Tool grown = with.grown(allowance);
    const Eigen::Vector3d down(0, 0, allowance);
    double worst = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Eigen::Vector3d a = position(path[i - 1]), b = position(path[i]);
      const double reach = grown.radius() + (b - a).norm();
      for (const auto& p : cloud)
        if (std::hypot(p.x - b.x(), p.y - b.y()) <= reach &&
            p.z > std::min(a.z(), b.z()) - allowance)
          worst = std::max(
              worst,
              brute::gouge(
                  grown, a - down, b - down, Eigen::Vector3d(p.x, p.y, p.z), 40));
    }
    EXPECT_LE(worst, 1e-4);
  }
  static std::vector<PointCL> with(const CLCloud& path, Motion motion)
  {
    std::vector<PointCL> found;
    for (const auto& p : path)
      if (p.getMotion() == motion)
        found.push_back(p);
    return found;
  }
};

} // namespace

TEST_F(Entering, ComesFromOutsideWhereItCan)
{
  // The pass begins 4 mm inside the block: behind it is the open.
  CLCloud passes;
  addPass(passes, 0, {{4, 15, -2}, {30, 15, -2}});
  const auto path = link(linker, passes);
  expectSound(path, 8, cutting, 5);
  EXPECT_EQ(report("outside"), 1);
  EXPECT_EQ(report("ramps") + report("helices") + report("plunges"), 0);
  const auto leads = with(path, Motion::LeadIn);
  ASSERT_FALSE(leads.empty());
  EXPECT_EQ(position(leads.back()), position(passes[0]));
  Heap heap(kBox, 0.3);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector3d a = position(path[i - 1]), b = position(path[i]);
    const double taken = heap.cut(tool, a, b);
    if ((b - a).head<2>().norm() == 0 || isRapid(path[i])) {
      EXPECT_LE(taken, 0.051) << "straight down at " << i;
    }
  }
}

TEST_F(Entering, NotFromOutsideThroughThePart)
{
  // A wall of the part between the open and the start.
  const auto part = ground([](double x, double) { return x < 1 ? 0.0 : -5.0; });
  setPart(*part);
  CLCloud passes;
  addPass(passes, 0, {{4, 15, -2}, {30, 15, -2}});
  const auto path = link(linker, passes);
  EXPECT_EQ(report("outside"), 0);
  EXPECT_EQ(report("helices"), 1);
  expectClear(path, tool, *part);
}

TEST_F(Entering, AHelixDescendsAtTheRampAngleAndEndsInThePassesDirection)
{
  for (const auto& t : {Tool::flat(1, 5), Tool::ball(2, 5), Tool::bull(3, 5, 1)}) {
    linker.setTool(t);
    renew();
    CLCloud passes;
    addPass(passes, 0, {{15, 15, -2}, {30, 21, -2}});
    const auto path = link(linker, passes);
    expectSound(path, 8, cutting, 5);
    EXPECT_EQ(report("helices"), 1);
    EXPECT_EQ(report("plunges") + report("ramps") + report("outside"), 0);
    const auto turns = with(path, Motion::Ramp);
    ASSERT_GT(turns.size(), 40u);
    EXPECT_EQ(position(turns.back()), position(passes[0]));
    const Eigen::Vector3d last =
        position(turns.back()) - position(turns[turns.size() - 2]);
    const Eigen::Vector3d first = position(passes[1]) - position(passes[0]);
    EXPECT_GT(last.normalized().dot(first.normalized()), std::cos(M_PI / 36) - 1e-4);
    for (std::size_t i = 1; i < turns.size(); ++i)
      EXPECT_LE(turns[i].z, turns[i - 1].z);
  }
}

TEST_F(Entering, AHelixLeavesNoCoreAndNoWedge)
{
  // After it, the floor within its reach is flat, but for a ball's own form.
  for (const auto& t : {Tool::flat(1, 5), Tool::bull(3, 5, 1)}) {
    linker.setTool(t);
    renew();
    CLCloud passes;
    addPass(passes, 0, {{15, 15, -2}, {15.1, 15, -2}});
    const auto path = link(linker, passes);
    ASSERT_EQ(report("helices"), 1);
    const double radius = std::min(0.45 * 5, 0.95 * t.flatRadius());
    Heap heap(kBox, 0.2);
    for (std::size_t i = 1; i < path.size(); ++i)
      heap.cut(t, position(path[i - 1]), position(path[i]));
    EXPECT_NEAR(
        heap.highest(15, 15 + radius, radius + t.flatRadius() - 0.05), -2, 0.02);
  }
}

TEST_F(Entering, AHelixKeepsTheAllowanceInAPocket)
{
  // A round pocket with room for a helix of the greatest radius nowhere near its wall.
  for (const double room : {4.4, 5.2, 7.0, 9.0}) {
    const auto part = ground([&](double x, double y) {
      return std::hypot(x - 20, y - 15) > room ? 0.0 : -5.0;
    });
    for (const auto& t : {Tool::flat(1, 5), Tool::ball(2, 5)}) {
      linker.setTool(t);
      setPart(*part);
      renew();
      CLCloud passes;
      const double to = room - 3.0;
      addPass(passes, 0, {{20 - to, 15, -3}, {20 + to, 15, -3}});
      const auto path = link(linker, passes);
      expectSound(path, 8, cutting, 5);
      expectClear(path, t, *part);
      EXPECT_EQ(report("helices") + report("ramps"), 1) << room;
      if (room > 6) {
        EXPECT_EQ(report("helices"), 1) << room;
      }
    }
  }
}

TEST_F(Entering, NoHelixWithoutItsRadius)
{
  linker.setHelixRadius(0);
  CLCloud passes;
  addPass(passes, 0, {{15, 15, -2}, {30, 15, -2}});
  link(linker, passes);
  EXPECT_EQ(report("helices"), 0);
  EXPECT_EQ(report("ramps"), 1);
}

TEST_F(Entering, AHelixMakesAPassThatIsTooShortForAFlatEnd)
{
  CLCloud passes;
  addPass(passes, 0, {{20, 15, -2}});
  const auto path = link(linker, passes);
  expectSound(path, 8, cutting, 5);
  EXPECT_EQ(report("skipped"), 0);
  EXPECT_EQ(report("helices"), 1);
}

TEST_F(Entering, ARampTurnsWhereAFlatEndWouldSinkAsItComesBack)
{
  linker.setHelixRadius(0);
  linker.setPart(nullptr, 0, 0); // no entry from outside
  CLCloud passes;
  addPass(passes, 0, {{10, 15, -3}, {16, 15, -3}, {16, 15, -2}, {24, 15, -2}});
  const auto path = link(linker, passes);
  expectSound(path, 8, cutting, 5);
  EXPECT_EQ(report("ramps"), 1);
  Heap heap(kBox, 0.2);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector3d a = position(path[i - 1]), b = position(path[i]);
    const double taken = isRapid(path[i]) ? 0.0 : heap.cut(tool, a, b);
    if ((b - a).head<2>().norm() < 1e-6 && b.z() < a.z()) {
      EXPECT_LE(taken, 0.06) << i;
    }
  }
}

TEST_F(Entering, KeepsOutOfZones)
{
  // As NotFromOutsideThroughThePart, with a clamp in place of the wall.
  linker.setKeepOut(KeepOut({KeepOutZone::box(-50, -50, -0.5, 80, 4)}, 1.0));
  CLCloud passes;
  addPass(passes, 0, {{4, 15, -2}, {30, 15, -2}});
  for (const auto& p : link(linker, passes))
    EXPECT_GE(p.x, 3.5 - 1e-4);
  EXPECT_EQ(report("outside"), 0);
}

TEST_F(Entering, ArcsLeadIntoALevelPassAndOutOfIt)
{
  linker.setLeadRadius(1);
  CLCloud passes; // beside the block, along it: half a millimetre is cut
  addPass(passes, 0, {{5, -2, -2}, {35, -2, -2}});
  const auto path = link(linker, passes);
  expectSound(path, 8, cutting, 5);
  EXPECT_EQ(report("lead_ins"), 1);
  EXPECT_EQ(report("lead_outs"), 1);
  const auto in = with(path, Motion::LeadIn), out = with(path, Motion::LeadOut);
  ASSERT_GT(in.size(), 5u);
  ASSERT_GT(out.size(), 5u);
  EXPECT_EQ(position(in.back()), position(passes[0]));
  for (const auto& p : in) // away from the block, round (5, -3)
    if (p.z == -2.f) {
      EXPECT_NEAR(std::hypot(p.x - 5, p.y + 3), 1, 1e-5);
      EXPECT_LE(p.y, -2 + 1e-5);
    }
  for (const auto& p : out)
    EXPECT_NEAR(std::hypot(p.x - 35, p.y + 3), 1, 1e-5);
  EXPECT_NEAR(out.back().x, 36, 1e-5);
}

TEST_F(Entering, NoArcIntoThePartOrIntoStock)
{
  linker.setLeadRadius(1);
  const auto part = ground([](double, double y) { return y < -5 ? 0.0 : -5.0; });
  setPart(*part); // a wall along the pass; on the other side is the block
  CLCloud passes;
  addPass(passes, 0, {{5, -2, -2}, {35, -2, -2}});
  const auto path = link(linker, passes);
  EXPECT_EQ(report("lead_ins"), 0);
  EXPECT_EQ(report("lead_outs"), 0);
  expectClear(path, tool, *part);
}

TEST_F(Entering, NoArcUnlessAskedForOrIntoASlope)
{
  CLCloud passes;
  addPass(passes, 0, {{5, -2, -2}, {35, -2, -2}});
  link(linker, passes);
  EXPECT_EQ(report("lead_ins") + report("lead_outs"), 0);
  linker.setLeadRadius(1);
  renew();
  passes.clear();
  addPass(passes, 0, {{5, -3, -2}, {20, -3, -1}, {35, -3, -2}});
  link(linker, passes);
  EXPECT_EQ(report("lead_ins") + report("lead_outs"), 0);
}

TEST_F(Entering, MotionsThatAreHandedInAreKept)
{
  // A strategy's own ramp, a link within the pass, and the leads.
  CLCloud passes;
  const std::pair<Eigen::Vector3d, Motion> steps[] = {{{10, 15, 0.1}, Motion::Rapid},
                                                      {{25, 15, -1}, Motion::Ramp},
                                                      {{10, 15, -1}, Motion::Cut},
                                                      {{10, 15, 1}, Motion::LeadOut},
                                                      {{20, 10, 1}, Motion::Link},
                                                      {{25, 10, 0.2}, Motion::LeadIn},
                                                      {{30, 10, -0.1}, Motion::Cut}};
  for (const auto& [at, motion] : steps)
    passes.push_back(PointCL(at.x(), at.y(), at.z(), motion));
  const auto path = link(linker, passes);
  std::size_t i = 0;
  while (position(path[i]) != position(passes[0]))
    ++i;
  ASSERT_EQ(path.size(), i + passes.size() + 1);
  for (std::size_t k = 1; k < passes.size(); ++k) {
    const PointCL& p = path[i + k];
    EXPECT_EQ(position(p), position(passes[k]));
    EXPECT_EQ(p.getMotion(), passes[k].getMotion());
    const Eigen::Vector3d move = position(p) - position(path[i + k - 1]);
    EXPECT_LE(p.feed * -move.z() / move.norm(), 200.01) << "down at " << k;
  }
  EXPECT_LE(path[i + 1].feed, 450.f) << "a ramp runs at half the feed";
  EXPECT_FLOAT_EQ(path[i + 4].feed, 900) << "a link in the air at all of it";
  EXPECT_EQ(report("ramps") + report("helices") + report("plunges"), 0);
}

TEST_F(Entering, RefusesARapidWithinAPass)
{
  CLCloud passes;
  addPass(passes, 0, {{5, -2, -2}, {35, -2, -2}});
  for (const Motion motion : {Motion::Rapid, Motion::Retract}) {
    passes[1].setMotion(motion);
    EXPECT_THROW(link(linker, passes), DataError);
  }
}
