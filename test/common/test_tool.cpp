// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/common/tool.h>

#include <gtest/gtest.h>

using pointmill::Tool;

TEST(Tool, ProfileOfABallIsItsSphere)
{
  const Tool ball = Tool::ball(1, 6.0);
  for (double r = 0; r <= 3.0; r += 0.25)
    EXPECT_DOUBLE_EQ(ball.profile(r), 3.0 - std::sqrt(9.0 - r * r));
  EXPECT_TRUE(std::isinf(ball.profile(3.001)));
}

TEST(Tool, ProfileOfAFlatIsZero)
{
  const Tool flat = Tool::flat(1, 10.0);
  EXPECT_EQ(flat.profile(0.0), 0.0);
  EXPECT_EQ(flat.profile(5.0), 0.0);
  EXPECT_TRUE(std::isinf(flat.profile(5.001)));
}

TEST(Tool, ProfileOfABullIsFlatThenRound)
{
  const Tool bull = Tool::bull(1, 10.0, 2.0);
  EXPECT_EQ(bull.profile(3.0), 0.0);
  EXPECT_DOUBLE_EQ(bull.profile(4.0), 2.0 - std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(bull.profile(5.0), 2.0);
}

TEST(Tool, AGrownToolIsTheOffsetSurface)
{
  // A ball of radius 3 grown by 0.5 is a ball of radius 3.5.
  const Tool grown = Tool::ball(1, 6.0).grown(0.5);
  EXPECT_DOUBLE_EQ(grown.radius(), 3.5);
  EXPECT_TRUE(grown.isBall());
  EXPECT_EQ(Tool::flat(1, 10.0).grown(0.5).corner_radius, 0.5);
}

TEST(Tool, ProfileOfATaperBallIsASphereThenACone)
{
  // At 30 degrees the sphere of radius 1 ends at r = cos 30, z = 1 - sin 30; the cone
  // climbs by cot 30.
  const Tool tool = Tool::taperBall(1, 2.0, 30.0, 6.0);
  const double joint = std::sqrt(0.75), cot = std::sqrt(3.0);
  EXPECT_DOUBLE_EQ(tool.profile(0.5), 1 - std::sqrt(0.75));
  EXPECT_NEAR(tool.profile(joint), 0.5, 1e-12);
  EXPECT_NEAR(tool.profile(2.0), 0.5 + (2.0 - joint) * cot, 1e-12);
  EXPECT_NEAR(tool.profile(3.0), 0.5 + (3.0 - joint) * cot, 1e-12);
  EXPECT_TRUE(std::isinf(tool.profile(3.001)));
}

TEST(Tool, ProfileOfAConeIsALineFromItsFlat)
{
  const Tool tool = Tool::cone(1, 45.0, 6.0, 1.0);
  EXPECT_EQ(tool.profile(0.5), 0.0);
  EXPECT_NEAR(tool.profile(2.0), 1.5, 1e-12);
  EXPECT_NEAR(tool.profile(3.0), 2.5, 1e-12);
  EXPECT_NEAR(Tool::cone(1, 30.0, 6.0).profile(1.0), std::sqrt(3.0), 1e-12);
}

TEST(Tool, AGrownSharpConeGetsARoundTip)
{
  // The tip becomes a ball, the side moves out by 0.5 along its normal: 0.5 / sin 30
  // up.
  const Tool cone = Tool::cone(1, 30.0, 6.0), grown = cone.grown(0.5);
  EXPECT_STREQ(grown.type(), "taper");
  EXPECT_EQ(grown.flatRadius(), 0.0);
  EXPECT_NEAR(grown.profile(0.4), 0.5 - std::sqrt(0.25 - 0.16), 1e-12);
  EXPECT_NEAR(grown.profile(2.0) - 0.5, cone.profile(2.0) - 1.0, 1e-12);
}

TEST(Tool, KindsAreToldApart)
{
  const auto kind = [](const Tool& t) {
    return std::string(t.type()) + (t.isFlat() ? " isFlat" : "") +
           (t.isBall() ? " isBall" : "");
  };
  EXPECT_EQ(kind(Tool::flat(1, 4)), "flat isFlat");
  EXPECT_EQ(kind(Tool::ball(1, 4)), "ball isBall");
  EXPECT_EQ(kind(Tool::bull(1, 4, 1)), "bull");
  EXPECT_EQ(kind(Tool::taperBall(1, 1, 5, 4)), "taper");
  EXPECT_EQ(kind(Tool::taperBull(1, 2, 0.5, 5, 4)), "taper");
  EXPECT_EQ(kind(Tool::cone(1, 30, 4)), "cone");
}

TEST(Tool, TheEndIsWhatCuts)
{
  EXPECT_EQ(Tool::bull(1, 10, 2).flatRadius(), 3);
  EXPECT_EQ(Tool::bull(1, 10, 2).endDiameter(), 10);
  EXPECT_EQ(Tool::taperBall(1, 1, 5, 6).flatRadius(), 0);
  EXPECT_EQ(Tool::taperBall(1, 1, 5, 6).endDiameter(), 1);
  EXPECT_EQ(Tool::cone(1, 30, 6).tipRadius(), 0);
  EXPECT_DOUBLE_EQ(Tool::cone(1, 30, 6).endDiameter(), 0.6);
}

TEST(Tool, SpeaksAsAMachinistDoes)
{
  EXPECT_EQ(Tool::ball(2, 5).describe(), "T2 ball 5 mm");
  EXPECT_EQ(Tool::bull(3, 5, 1).describe(), "T3 bull 5 mm corner 1 mm");
  EXPECT_EQ(Tool::taperBall(4, 1, 5, 6).describe(),
            "T4 taper ball 1 mm, 5 deg, to 6 mm");
  EXPECT_EQ(Tool::taperBull(5, 3, 0.5, 10, 6).describe(),
            "T5 taper bull 3 mm corner 0.5 mm, 10 deg, to 6 mm");
  EXPECT_EQ(Tool::cone(6, 30, 6).describe(), "T6 cone 6 mm, 30 deg");
  EXPECT_EQ(Tool::cone(7, 15, 4, 0.2).describe(), "T7 cone 4 mm, 15 deg, tip 0.2 mm");
}

TEST(Tool, NonsenseIsRefusedByName)
{
  EXPECT_THROW(Tool::flat(1, 0.0).validate(), pointmill::ParameterError);
  EXPECT_THROW(Tool::flat(1, std::nan("")).validate(), pointmill::ParameterError);
  EXPECT_THROW(Tool::bull(1, 4.0, 2.5).validate(), pointmill::ParameterError);
  EXPECT_THROW(Tool::flat(0, 4.0).validate(), pointmill::ParameterError);
  EXPECT_NO_THROW(Tool::ball(3, 3.0).validate());
  EXPECT_NO_THROW(Tool::taperBall(4, 1.0, 5.0, 6.0).validate());
  EXPECT_NO_THROW(Tool::cone(5, 30.0, 6.0).validate());
  const auto refusal = [](Tool tool) -> std::string {
    try {
      tool.validate();
    }
    catch (const pointmill::ParameterError& e) {
      return e.what();
    }
    return "";
  };
  const auto names = [&](const Tool& tool, const std::string& words) {
    EXPECT_NE(refusal(tool).find(words), std::string::npos) << refusal(tool);
  };
  names(Tool::taperBall(4, 7.0, 5.0, 6.0), "tool 4: tip diameter is 7 mm; it must");
  names(Tool::taperBull(4, 1.0, 0.6, 5.0, 6.0), "corner radius is 0.6 mm");
  names(Tool::cone(5, 85.0, 6.0), "taper is 85 deg");
  names(Tool::cone(5, -5.0, 6.0), "taper is -5 deg");
  names(Tool::cone(5, 0.01, 6.0), "taper is 0.01 deg");
  names(Tool::cone(5, std::nan(""), 6.0), "taper is nan deg");
  names(Tool::cone(5, 30.0, 6.0, -1.0), "tip diameter is -1 mm");
  Tool untapered = Tool::ball(1, 3.0);
  untapered.tip_diameter = 1.0;
  names(untapered, "tip diameter without a taper");
  Tool short_flutes = Tool::ball(1, 3.0);
  short_flutes.flute_length = -1;
  names(short_flutes, "flute length");
}
