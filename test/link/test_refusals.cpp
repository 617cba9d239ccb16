// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "link_test.h"

using namespace link_test;

namespace {

const Stock kBox{{0, 0, -6}, {24, 18, 0}};

struct LinkingRefuses : ::testing::Test {
  LinkPasses linker;
  CLCloud passes;

  LinkingRefuses()
  {
    linker.setTool(Tool::flat(1, 5));
    linker.setClearancePlane(8);
    linker.setStock(fieldOf(kBox));
    addPass(passes, 0, {{5, 5, -1}, {9, 5, -1}});
    addPass(passes, 1, {{5, 9, -1}, {9, 9, -1}});
  }
  template <typename E>
  void expectRefused(const char* why)
  {
    CLCloud output;
    output.push_back(PointCL(1, 2, 3));
    linker.setInputCloud(CLCloud::ConstPtr(new CLCloud(passes)));
    EXPECT_THROW(linker.filter(output), E) << why;
    ASSERT_EQ(output.size(), 1u) << why;
    EXPECT_EQ(output[0].x, 1.f) << why;
  }
};

} // namespace

TEST_F(LinkingRefuses, NoPasses)
{
  passes.clear();
  expectRefused<DataError>("empty");
}

TEST_F(LinkingRefuses, PointsThatAreNotFinite)
{
  passes[3].y = std::nanf("");
  expectRefused<DataError>("NaN");
  passes[3].y = HUGE_VALF;
  expectRefused<DataError>("infinite");
}

TEST_F(LinkingRefuses, PointsAboveTheClearancePlane)
{
  passes[2].z = 8.5f;
  expectRefused<DataError>("too high");
}

TEST_F(LinkingRefuses, AClearancePlaneThatIsNotAboveTheStock)
{
  for (const double z : {-3.0, 0.0, std::nan("")}) {
    linker.setClearancePlane(z);
    expectRefused<ParameterError>("clearance");
  }
  LinkPasses unset;
  unset.setTool(Tool::flat(1, 5));
  unset.setInputCloud(CLCloud::ConstPtr(new CLCloud(passes)));
  CLCloud output;
  EXPECT_THROW(unset.filter(output), ParameterError);
}

TEST_F(LinkingRefuses, AbsurdParameters)
{
  linker.setRampAngle(0);
  expectRefused<ParameterError>("no ramp");
  linker.setRampAngle(3);
  linker.setApproach(0);
  expectRefused<ParameterError>("no approach");
  linker.setApproach(1);
  linker.setStayDown(-1);
  expectRefused<ParameterError>("stay down");
  linker.setStayDown(0);
  Cutting cutting;
  cutting.feed = 0;
  linker.setCutting(cutting);
  expectRefused<ParameterError>("no feed");
  cutting.feed = 1000;
  cutting.plunge_feed = std::nan("");
  linker.setCutting(cutting);
  expectRefused<ParameterError>("plunge feed NaN");
  linker.setCutting(Cutting());
  linker.setTool(Tool::flat(0, 5));
  expectRefused<ParameterError>("tool number");
}

TEST_F(LinkingRefuses, WithoutCuttingTheStock)
{
  // The stock is an output too: a stage that throws has touched nothing.
  const auto stock = fieldOf(kBox);
  linker.setStock(stock);
  passes[3].y = std::nanf("");
  expectRefused<DataError>("NaN in the second pass");
  EXPECT_EQ(stock->highest(7, 5, 1), 0) << "the first pass was cut";
}
