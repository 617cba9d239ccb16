// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/cutting_data.h>
#include <pointmill/common/error.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>

using namespace pointmill;

namespace {

CutSetting cutOf(const std::string& material, Tool tool, int flutes = 2)
{
  CutSetting cut;
  cut.material = workMaterial(material);
  tool.flutes = flutes;
  cut.tool = tool;
  return cut;
}

/// A side cut in steel, everything given.
CutSetting sideCut(double width)
{
  CutSetting cut = cutOf("mild-steel", Tool::flat(1, 10), 4);
  cut.surface_speed = 100;
  cut.chip_load = 0.05;
  cut.depth = 6;
  cut.width = width;
  return cut;
}

std::string refusal(const std::function<void()>& call)
{
  try {
    call();
  }
  catch (const ParameterError& e) {
    return e.what();
  }
  return "";
}

std::string refusalOf(const CutSetting& cut, const Machine& machine = {})
{
  return refusal([&] { cuttingData(cut, machine); });
}

void expectWords(const std::string& text, const std::string& words)
{
  EXPECT_NE(text.find(words), std::string::npos) << "'" << text << "'";
}

/// Thickest chip, and force times speed of all teeth [W], of a tool that turns through
/// small steps: chips are fz sin(angle) thick along a straight edge.
std::pair<double, double>
turnedThrough(const CuttingData& data, const CutSetting& cut, double kc)
{
  const double radius = cut.tool.radius();
  const double arc = std::acos(1 - data.width / radius);
  const int steps = 100000;
  double thickest = 0, work = 0; // of one tooth in one turn [N mm]
  for (int i = 0; i < steps; ++i) {
    const double angle = arc * (i + 0.5) / steps;
    const double chip = data.feed_per_tooth * std::sin(angle);
    thickest = std::max(thickest, chip);
    work += kc * chip * data.depth * radius * arc / steps;
  }
  return {thickest, work * cut.tool.flutes * data.spindle / 60 / 1000};
}

} // namespace

TEST(CuttingData, ASlotByHand)
{
  // 1000 100 / (pi 10) rev/min, four teeth with 0.05 mm.
  const CuttingData data = cuttingData(sideCut(10));
  EXPECT_NEAR(data.spindle, 1e5 / (10 * M_PI), 1e-9);
  EXPECT_DOUBLE_EQ(data.surface_speed, 100);
  EXPECT_DOUBLE_EQ(data.feed_per_tooth, 0.05);
  EXPECT_NEAR(data.feed, 4 * 0.05 * data.spindle, 1e-9);
  EXPECT_NEAR(data.removal_rate, 6 * 10 * data.feed / 1000, 1e-9);
  EXPECT_NEAR(data.mean_chip, 0.05 * 2 / M_PI, 1e-12);
  const double kc = 1350 * std::pow(0.05 * 2 / M_PI, -0.21);
  EXPECT_NEAR(data.cutting_force, kc, 1e-9);
  EXPECT_NEAR(data.power, 6 * 10 * data.feed * kc / 60e3, 1e-9); // as [kW] / 60e6
  EXPECT_NEAR(data.torque * 2 * M_PI * data.spindle / 60, data.power, 1e-9);
  EXPECT_TRUE(data.limits.empty());
}

TEST(CuttingData, PowerAndChipsAreThoseOfTheTurningTool)
{
  for (const double width : {0.3, 1.0, 2.5, 5.0, 7.5, 10.0}) {
    CutSetting cut = sideCut(width);
    cut.max_thinning = 10;
    const CuttingData data = cuttingData(cut);
    const auto [thickest, power] = turnedThrough(data, cut, data.cutting_force);
    EXPECT_NEAR(thickest, data.max_chip, 1e-6) << width;
    EXPECT_NEAR(thickest, 0.05, 1e-6) << width; // thin chips are made up for
    EXPECT_NEAR(power / data.power, 1.0, 1e-6) << width;
  }
}

TEST(CuttingData, ThinChipsAreMadeUpForOnlySoFar)
{
  // At a hundredth of the diameter the factor is 1 / (2 sqrt(0.01 0.99)) = 5.03.
  const CuttingData data = cuttingData(sideCut(0.1));
  EXPECT_DOUBLE_EQ(data.feed_per_tooth, 3 * 0.05);
  EXPECT_NEAR(data.max_chip, 3 * 0.05 * 2 * std::sqrt(0.01 * 0.99), 1e-12);
  EXPECT_EQ(data.limits, std::vector<CutLimit>{CutLimit::Thinning});
  CutSetting free = sideCut(0.1);
  free.max_thinning = 10;
  EXPECT_NEAR(
      cuttingData(free).feed_per_tooth, 0.05 / (2 * std::sqrt(0.01 * 0.99)), 1e-12);
}

TEST(CuttingData, FinishingMarksAreNoCoarserAlongTheFeedThanAcross)
{
  CutSetting cut = cutOf("softwood", Tool::ball(1, 6));
  cut.depth = cut.width = 0.1;
  cut.chip_load = 0.1;
  EXPECT_GT(cuttingData(cut).feed_per_tooth, 0.2);
  cut.kind = CutKind::Finishing;
  const CuttingData data = cuttingData(cut);
  EXPECT_EQ(data.feed_per_tooth, 0.1);
  EXPECT_EQ(data.limits,
            (std::vector<CutLimit>{CutLimit::Thinning, CutLimit::StepOver}));
  cut.tool = Tool::flat(1, 6); // its marks are flat
  EXPECT_GT(cuttingData(cut).feed_per_tooth, 0.2);
}

TEST(CuttingData, ABallTurnsFasterTheShallowerItCuts)
{
  CutSetting cut = cutOf("hardwood", Tool::ball(1, 6));
  cut.surface_speed = 200;
  cut.depth = 0.6;
  cut.width = 0.6;
  const CuttingData data = cuttingData(cut);
  const double effective = 2 * std::sqrt(0.6 * 5.4);
  EXPECT_NEAR(data.effective_diameter, effective, 1e-12);
  EXPECT_NEAR(data.spindle, 200e3 / (M_PI * effective), 1e-6);
  // Its chips are thinned by the ball, sin k = De / D, and by the width.
  const double share = 0.6 / effective;
  EXPECT_NEAR(data.feed_per_tooth * effective / 6 * 2 * std::sqrt(share * (1 - share)),
              data.chip_load,
              1e-12);
  cut.depth = 3.0;
  EXPECT_NEAR(cuttingData(cut).effective_diameter, 6, 1e-12);
  cut.depth = 5.0; // above the ball: its cylinder
  EXPECT_NEAR(cuttingData(cut).effective_diameter, 6, 1e-12);
}

TEST(CuttingData, TheDiameterThatCutsIsThatOfTheProfile)
{
  const Tool tools[] = {Tool::flat(1, 8),
                        Tool::ball(1, 8),
                        Tool::bull(1, 8, 1.5),
                        Tool::taperBall(1, 1, 5, 6),
                        Tool::taperBull(1, 3, 0.5, 20, 8),
                        Tool::cone(1, 30, 6),
                        Tool::cone(1, 45, 6, 1)};
  for (const Tool& tool : tools)
    for (const double depth : {0.05, 0.3, 1.0, 2.0, 4.0, 12.0}) {
      CutSetting cut = cutOf("pom", tool);
      cut.depth = depth;
      cut.chip_load = 0.01;
      cut.width = 0.01;
      const CuttingData data = cuttingData(cut);
      const double r = data.effective_diameter / 2;
      EXPECT_LE(r, tool.radius() + 1e-12);
      if (r < tool.radius() - 1e-9)
        EXPECT_NEAR(tool.profile(r), depth, 1e-9) << tool.describe() << " " << depth;
      else
        EXPECT_LE(tool.profile(r - 1e-9), depth + 1e-6) << tool.describe();
      // The thickest chip is where the edge stands steepest.
      const double sine = tool.profile().steepness(std::min(r, tool.radius()) - 1e-9);
      const double share = std::min(data.width / data.effective_diameter, 0.5);
      const bool above = depth > tool.profile(tool.radius() - 1e-9) + 1e-3;
      EXPECT_NEAR(data.max_chip,
                  data.feed_per_tooth * (above ? 1.0 : sine) * 2 *
                      std::sqrt(share * (1 - share)),
                  1e-6)
          << tool.describe() << " " << depth;
    }
}

TEST(CuttingData, MeanChipOfARoundedEdgeIsItsAreaByItsLength)
{
  // A ball at half its depth: the edge from the tip to there is measured in chords.
  CutSetting cut = cutOf("mild-steel", Tool::ball(1, 10));
  cut.depth = 2.5;
  cut.width = cuttingData(cut).effective_diameter;
  const CuttingData data = cuttingData(cut);
  double length = 0;
  const int steps = 100000;
  const double r = data.effective_diameter / 2;
  for (int i = 0; i < steps; ++i)
    length += std::hypot(r / steps,
                         cut.tool.profile(r * (i + 1) / steps) -
                             cut.tool.profile(r * i / steps));
  EXPECT_NEAR(data.mean_chip, data.feed_per_tooth * 2 / M_PI * 2.5 / length, 1e-8);
}

TEST(CuttingData, TheMachineLimitsAreKeptAndNamed)
{
  const CuttingData free = cuttingData(sideCut(10));
  Machine machine;
  machine.max_spindle = 2000;
  CuttingData data = cuttingData(sideCut(10), machine);
  EXPECT_EQ(data.spindle, 2000);
  EXPECT_NEAR(data.surface_speed, 2000 * M_PI * 10 / 1000, 1e-9);
  EXPECT_DOUBLE_EQ(data.feed_per_tooth, 0.05); // chips as wanted, only slower
  EXPECT_EQ(data.limits, std::vector<CutLimit>{CutLimit::MaxSpindle});

  machine = {};
  machine.min_spindle = 8000;
  data = cuttingData(sideCut(10), machine);
  EXPECT_EQ(data.spindle, 8000);
  EXPECT_EQ(data.limits, std::vector<CutLimit>{CutLimit::MinSpindle});

  machine = {};
  machine.max_feed = 300;
  data = cuttingData(sideCut(10), machine);
  EXPECT_NEAR(data.feed, 300, 1e-9);
  EXPECT_NEAR(data.max_chip, 0.05 * 300 / free.feed, 1e-12);
  EXPECT_EQ(data.spindle, free.spindle);
  EXPECT_EQ(data.limits, std::vector<CutLimit>{CutLimit::MaxFeed});

  machine = {};
  machine.power = free.power / 3;
  data = cuttingData(sideCut(10), machine);
  EXPECT_NEAR(data.power / machine.power, 1, 1e-9);
  EXPECT_LT(data.feed, free.feed / 3); // thinner chips take more force
  EXPECT_TRUE(data.rubs());
  EXPECT_FALSE(free.rubs());
  EXPECT_EQ(data.limits, std::vector<CutLimit>{CutLimit::Power});

  machine.max_feed = 300;
  machine.max_spindle = 3000;
  machine.power = 100;
  data = cuttingData(sideCut(10), machine);
  EXPECT_EQ(data.limits,
            (std::vector<CutLimit>{
                CutLimit::MaxSpindle, CutLimit::MaxFeed, CutLimit::Power}));
  EXPECT_STREQ(nameOf(data.limits[1]), "max feed");
  EXPECT_LE(data.feed, 300);
  EXPECT_LE(data.power, 100 * (1 + 1e-12));
}

TEST(CuttingData, TimesFollowFeedAndRemovalRate)
{
  const CuttingData data = cuttingData(sideCut(10));
  EXPECT_NEAR(data.secondsForLength(data.feed), 60, 1e-9);
  // A length of path removes its depth by its width.
  EXPECT_NEAR(data.secondsForVolume(250 * data.depth * data.width),
              data.secondsForLength(250),
              1e-9);
}

TEST(CuttingData, AnOperationTakesWholeNumbersBelow)
{
  const CuttingData data = cuttingData(sideCut(10));
  const Cutting cutting = cuttingFor(sideCut(10));
  EXPECT_EQ(cutting.spindle, std::floor(data.spindle));
  EXPECT_EQ(cutting.feed, std::floor(data.feed));
  EXPECT_EQ(cutting.plunge_feed, std::floor(0.3 * data.feed));
  EXPECT_TRUE(cutting.coolant);
  EXPECT_FALSE(cuttingFor(cutOf("hardwood", Tool::flat(1, 6))).coolant);
}

TEST(CuttingData, DefaultsFollowFromMaterialToolAndKindOfCut)
{
  CutSetting cut = cutOf("aluminium-wrought", Tool::flat(1, 10), 3);
  const CuttingData rough = cuttingData(cut);
  EXPECT_DOUBLE_EQ(rough.depth, 5);
  EXPECT_DOUBLE_EQ(rough.width, 4);
  EXPECT_DOUBLE_EQ(rough.chip_load, 0.08);
  EXPECT_NEAR(rough.surface_speed, 300, 1e-9);
  cut.kind = CutKind::Finishing;
  EXPECT_DOUBLE_EQ(cuttingData(cut).depth, 5);
  EXPECT_DOUBLE_EQ(cuttingData(cut).width, 0.5);
  EXPECT_NEAR(cuttingData(cut).surface_speed, 600, 1e-9);
  cut.tool_material = ToolMaterial::Hss;
  EXPECT_NEAR(cuttingData(cut).surface_speed, 120, 1e-9);
  cut.tool = Tool::ball(2, 4);
  EXPECT_DOUBLE_EQ(cuttingData(cut).depth, 0.2);
  EXPECT_DOUBLE_EQ(cuttingData(cut).width, 0.2);
  // No deeper than the flutes, chips no thicker than the material bears.
  cut = cutOf("aluminium-wrought", Tool::flat(1, 40));
  cut.tool.flute_length = 12;
  EXPECT_DOUBLE_EQ(cuttingData(cut).depth, 12);
  EXPECT_DOUBLE_EQ(cuttingData(cut).chip_load, 0.15);
  // A tapered tool is as strong as its tip.
  cut = cutOf("brass", Tool::taperBall(1, 1, 5, 6));
  EXPECT_DOUBLE_EQ(cuttingData(cut).chip_load, 0.006);
}

TEST(CuttingData, EveryMaterialGivesSensibleDataForEveryTool)
{
  const Tool tools[] = {Tool::flat(1, 0.5),
                        Tool::flat(1, 25),
                        Tool::ball(1, 3),
                        Tool::bull(1, 10, 1),
                        Tool::taperBall(1, 0.5, 5, 6),
                        Tool::cone(1, 30, 6),
                        Tool::cone(1, 80, 20, 0.2)};
  Machine machine;
  machine.max_spindle = 24000;
  machine.max_feed = 8000;
  machine.power = 1500;
  for (const auto& material : workMaterials())
    for (const Tool& tool : tools)
      for (const CutKind kind : {CutKind::Roughing, CutKind::Finishing}) {
        CutSetting cut = cutOf(material.name, tool);
        cut.kind = kind;
        const CuttingData d = cuttingData(cut, machine);
        const std::string what = material.name + " " + tool.describe();
        EXPECT_GT(d.feed, 0) << what;
        EXPECT_LE(d.feed, 8000 * (1 + 1e-12)) << what;
        EXPECT_LE(d.spindle, 24000) << what;
        EXPECT_LE(d.power, 1500 * (1 + 1e-9)) << what;
        EXPECT_GT(d.power, 0) << what;
        EXPECT_LE(d.max_chip, d.chip_load * (1 + 1e-9)) << what;
        EXPECT_LT(d.mean_chip, d.max_chip) << what;
        EXPECT_LE(d.width, d.effective_diameter * (1 + 1e-9)) << what;
      }
}

TEST(CuttingData, NonsenseIsRefusedByName)
{
  const double nan = std::nan(""), endless = std::numeric_limits<double>::infinity();
  CutSetting cut = sideCut(4);
  cut.chip_load = 2;
  expectWords(refusalOf(cut), "cutting: chip load is 2 mm; it must lie in 0.0001 .. 1");
  cut.chip_load = nan;
  expectWords(refusalOf(cut), "chip load is nan");
  cut = sideCut(10.5);
  expectWords(refusalOf(cut), "width of cut at this depth is 10.5 mm");
  cut = sideCut(0);
  expectWords(refusalOf(cut), "width of cut at this depth is 0 mm");
  cut = sideCut(4);
  cut.tool.flutes = 0;
  expectWords(refusalOf(cut), "tool 1: flutes is 0");
  cut = sideCut(4);
  cut.tool.flute_length = 5;
  expectWords(refusalOf(cut), "depth of cut is 6 mm; it must lie in 0.0001 .. 5 mm");
  cut = sideCut(4);
  cut.depth = 60;
  expectWords(refusalOf(cut), "depth of cut is 60 mm");
  cut = sideCut(4);
  cut.surface_speed = -100;
  expectWords(refusalOf(cut), "surface speed is -100 m/min");
  cut.surface_speed = endless;
  expectWords(refusalOf(cut), "surface speed is inf");
  cut = sideCut(4);
  cut.max_thinning = 0.5;
  expectWords(refusalOf(cut), "max thinning is 0.5");
  cut = sideCut(4);
  cut.plunge_ratio = 0;
  expectWords(refusalOf(cut), "plunge ratio is 0");
  cut = sideCut(4);
  cut.material.mc = 1;
  expectWords(refusalOf(cut), "material mild-steel: mc is 1");
  Machine machine;
  machine.power = -1;
  expectWords(refusalOf(sideCut(4), machine), "machine: power is -1 W");
  cut = cutOf("hardened-steel", Tool::ball(1, 6));
  cut.tool_material = ToolMaterial::Hss;
  expectWords(refusalOf(cut),
              "hardened-steel is not to be milled with high-speed steel");
  // A ball cuts no wider than its chord at the depth.
  cut = cutOf("brass", Tool::ball(1, 6));
  cut.depth = 0.1;
  cut.width = 3;
  expectWords(refusalOf(cut), "width of cut at this depth is 3 mm");
}

TEST(WorkMaterial, TheTableIsInOrder)
{
  std::set<std::string> names;
  for (const auto& material : workMaterials()) {
    EXPECT_NO_THROW(material.validate());
    EXPECT_FALSE(material.description.empty());
    std::string all = material.name + " " + material.also + " ";
    for (std::size_t at = 0, end; (end = all.find(' ', at)) != std::string::npos;
         at = end + 1)
      if (end > at) {
        const std::string name = all.substr(at, end - at);
        EXPECT_TRUE(names.insert(name).second) << name << " stands there twice";
        EXPECT_EQ(workMaterial(name).name, material.name);
      }
  }
}

TEST(WorkMaterial, ThePageSaysWhatTheTableSays)
{
  std::ifstream file(POINTMILL_DOC "/cutting.md");
  const std::string page((std::istreambuf_iterator<char>(file)), {});
  ASSERT_FALSE(page.empty());
  for (const auto& m : workMaterials()) {
    std::ostringstream row;
    row << "| `" << m.name << "` | " << m.description << " | " << m.carbide_speed.low
        << " .. " << m.carbide_speed.high << " | ";
    if (m.hss_speed.high > 0)
      row << m.hss_speed.low << " .. " << m.hss_speed.high;
    else
      row << "no";
    row << " | " << m.chip_ratio << " | " << m.chip_limit << " | " << m.rough_depth
        << " | " << m.kc11 << " | " << m.mc << " | " << (m.coolant ? "flood" : "none")
        << " |";
    EXPECT_NE(page.find(row.str()), std::string::npos) << row.str();
  }
}

TEST(WorkMaterial, IsFoundHoweverItIsWritten)
{
  EXPECT_EQ(workMaterial("Stainless Steel").name, "stainless-steel");
  EXPECT_EQ(workMaterial("MILD_STEEL").name, "mild-steel");
  EXPECT_EQ(workMaterial("aluminum").name, "aluminium-wrought");
  EXPECT_EQ(workMaterial(" PMMA ").name, "acrylic");
}

TEST(WorkMaterial, AnUnknownOneIsRefusedWithTheNearestName)
{
  const auto refused = [](const std::string& name) {
    return refusal([&] { workMaterial(name); });
  };
  expectWords(refused("hartwood"),
              "unknown material 'hartwood', did you mean 'hardwood'?");
  expectWords(refused("Titan"), "did you mean 'titanium'?");
  expectWords(refused("stainles"), "did you mean 'stainless'?");
  expectWords(refused(""), "unknown material ''");
}
