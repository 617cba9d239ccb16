// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "rough_test.h"

using namespace rough_test;

namespace {

template <typename S>
class RoughingRefuses : public EveryRoughing<S> {
protected:
  const Cloud::Ptr cloud = surface(
      {0, 0, 20, 20}, 0.5, [](double x, double) { return x < 10 ? 0.0 : -3.0; });
  const CellCloud::Ptr map = mapOf(cloud, 0.5);

  /// Throws E and leaves the output as it was.
  template <typename E>
  void expectRefused(const char* why)
  {
    CLCloud output;
    output.push_back(PointCL(1, 2, 3));
    EXPECT_THROW(this->roughing.filter(output), E) << why;
    ASSERT_EQ(output.size(), 1u) << why;
    EXPECT_EQ(output[0].y, 2.f) << why;
  }
};
TYPED_TEST_SUITE(RoughingRefuses, Strategies, StrategyNames);

} // namespace

TYPED_TEST(RoughingRefuses, NoInputAtAll)
{
  this->template expectRefused<DataError>("none");
  this->roughing.setInputCloud(CellCloud::ConstPtr(new CellCloud));
  this->template expectRefused<DataError>("empty");
}

TYPED_TEST(RoughingRefuses, APartOfAMap)
{
  this->roughing.setInputCloud(this->map);
  pcl::IndicesPtr some(new pcl::Indices{0, 1, 2});
  this->roughing.setIndices(some);
  this->template expectRefused<DataError>("indices");
}

TYPED_TEST(RoughingRefuses, AMapWithoutAPart)
{
  CellCloud::Ptr nothing(new CellCloud(*this->map));
  for (auto& c : *nothing)
    c.setState(CellState::Empty);
  this->roughing.setInputCloud(nothing);
  this->template expectRefused<DataError>("nothing but empty cells");
}

TYPED_TEST(RoughingRefuses, AMapThatIsNotOne)
{
  CellCloud::Ptr loose(new CellCloud(*this->map));
  loose->width = static_cast<std::uint32_t>(loose->size());
  loose->height = 1;
  this->roughing.setInputCloud(loose);
  this->template expectRefused<DataError>("not organised");
}

TYPED_TEST(RoughingRefuses, AStepOverWiderThanTheTool)
{
  this->roughing.setInputCloud(this->map);
  this->set(Tool::flat(1, 6), 0.5, 1, 6.1);
  this->template expectRefused<ParameterError>("step over");
  this->set(Tool::flat(1, 6), 0.5, 1, 6.0);
  CLCloud passes;
  EXPECT_NO_THROW(this->roughing.filter(passes));
}

TYPED_TEST(RoughingRefuses, AbsurdParameters)
{
  this->roughing.setInputCloud(this->map);
  const Tool good = Tool::flat(1, 6);
  const double nan = std::nan("");
  this->set(good, -0.1, 1, 2);
  this->template expectRefused<ParameterError>("negative allowance");
  this->set(good, nan, 1, 2);
  this->template expectRefused<ParameterError>("allowance NaN");
  this->set(good, 0.5, -1, 2);
  this->template expectRefused<ParameterError>("negative step down");
  this->set(good, 0.5, 1, 0);
  this->template expectRefused<ParameterError>("no step over");
  this->set(good, 0.5, 1e-5, 2);
  this->template expectRefused<ParameterError>("more levels than sense");
  this->set(Tool::flat(1, 0), 0.5, 1, 2);
  this->template expectRefused<ParameterError>("no tool");
  this->set(Tool::flat(1, nan), 0.5, 1, 2);
  this->template expectRefused<ParameterError>("tool NaN");
  this->set(good, 0.5, 1, 2);
  this->roughing.setRestLimits(-1, 0);
  this->template expectRefused<ParameterError>("negative thickness");
  this->roughing.setRestLimits(0, nan);
  this->template expectRefused<ParameterError>("width NaN");
}

TYPED_TEST(RoughingRefuses, AFloorAboveTheStock)
{
  this->roughing.setInputCloud(this->map);
  this->set(Tool::flat(1, 6), 0.5, 1, 2);
  this->roughing.setStock(block({0, 0, 20, 20}, -4, 1));
  this->roughing.setFloor(2);
  this->template expectRefused<ParameterError>("floor");
}

TYPED_TEST(RoughingRefuses, NothingWithoutAReason)
{
  this->set(Tool::flat(1, 6), 0.5, 1, 2);
  this->roughing.setStock(block({0, 0, 20, 20}, -4, 1));
  EXPECT_FALSE(this->run(this->map).empty());
}
