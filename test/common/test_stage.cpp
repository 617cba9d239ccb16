// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/stage.h>

#include <pcl/filters/passthrough.h>

#include <gtest/gtest.h>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// Raises every selected point by `height`.
class Raise : public pointmill::Filter<pcl::PointXYZ> {
public:
  Raise() : pointmill::Filter<pcl::PointXYZ>("Raise") {}
  double height = 1.0;
  template <typename V>
  void parameters(V&& v)
  {
    v("height", height, "mm", pointmill::Range{0, 10}, "how far up");
  }

protected:
  void checkParameters() const override { validateParameters(*this, getName()); }
  void apply(PointCloud& output) override
  {
    for (const auto i : *indices_) {
      output.push_back((*input_)[i]);
      output.back().z += static_cast<float>(height);
    }
    report_.set("points", static_cast<double>(output.size()));
  }
};

/// One CL point over every selected point.
class Over : public pointmill::Stage<pcl::PointXYZ, pointmill::PointCL> {
public:
  Over() : Stage("Over") {}

protected:
  void checkParameters() const override {}
  void apply(Output& output) override
  {
    for (const auto i : *indices_)
      output.push_back(
          pointmill::PointCL((*input_)[i].x, (*input_)[i].y, (*input_)[i].z));
  }
};

Cloud::Ptr threePoints()
{
  Cloud::Ptr cloud(new Cloud);
  for (int i = 0; i < 3; ++i)
    cloud->push_back(pcl::PointXYZ(float(i), 0, float(i)));
  return cloud;
}

} // namespace

TEST(Stage, ChainsWithPclFilters)
{
  pcl::PassThrough<pcl::PointXYZ> pass;
  pass.setFilterFieldName("x");
  pass.setFilterLimits(0.5f, 5.f);
  Raise raise;
  Over over;
  const auto cl = pointmill::run(threePoints(), pass, raise, over);
  ASSERT_EQ(cl->size(), 2u);
  EXPECT_FLOAT_EQ((*cl)[0].z, 2.f);
}

TEST(Stage, ReadsOnlyItsIndices)
{
  pcl::IndicesPtr only(new pcl::Indices{2});
  Over over;
  over.setInputCloud(threePoints());
  over.setIndices(only);
  pointmill::CLCloud out;
  over.filter(out);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_FLOAT_EQ(out[0].x, 2.f);
}

TEST(Stage, AFailureLeavesTheOutputUntouched)
{
  Raise raise;
  raise.height = 99;
  raise.setInputCloud(threePoints());
  Cloud out = *threePoints();
  try {
    raise.filter(out);
    FAIL() << "99 mm was taken";
  }
  catch (const pointmill::ParameterError& e) {
    EXPECT_NE(std::string(e.what()).find("Raise: height is 99 mm"), std::string::npos)
        << e.what();
  }
  EXPECT_EQ(out.size(), 3u);
  EXPECT_FLOAT_EQ(out[2].z, 2.f);
}

TEST(Stage, NoInputIsAnError)
{
  Raise raise;
  Over over;
  Cloud out;
  pointmill::CLCloud cl;
  EXPECT_THROW(raise.filter(out), pointmill::DataError);
  EXPECT_THROW(over.filter(cl), pointmill::DataError);
  over.setInputCloud(Cloud::Ptr(new Cloud));
  EXPECT_THROW(over.filter(cl), pointmill::DataError);
  raise.setInputCloud(Cloud::Ptr(new Cloud));
  EXPECT_THROW(raise.filter(out), pointmill::DataError);
}
