// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Keep-out zones as they are written on the command line.
#include <keep_out_option.h>
#include <pointmill/common/error.h>

#include <gtest/gtest.h>

#include <clocale>

namespace {

std::string errorOf(const std::string& text)
{
  try {
    readKeepOutZone(text);
  }
  catch (const pointmill::ParameterError& error) {
    return error.what();
  }
  return "";
}

void expectError(const std::string& text, const std::string& about)
{
  const std::string error = errorOf(text);
  EXPECT_NE(error.find(about), std::string::npos) << text << " -> " << error;
  EXPECT_NE(error.find("--keep-out " + text), std::string::npos) << error;
}

} // namespace

TEST(KeepOutOption, ReadsAllKinds)
{
  const auto box = readKeepOutZone("box:10,20,-5.5,1e1,15.25");
  EXPECT_EQ(box.top(), 15.25);
  EXPECT_EQ(box.min(), Eigen::Vector2d(-5.5, 10));
  EXPECT_EQ(box.max(), Eigen::Vector2d(10, 20));
  const auto cylinder = readKeepOutZone("cylinder: 3, 4 ,2,-1");
  EXPECT_EQ(cylinder.top(), -1);
  EXPECT_EQ(cylinder.min(), Eigen::Vector2d(1, 2));
  const auto polygon = readKeepOutZone("polygon:0,0,10,0,0,10,5");
  EXPECT_EQ(polygon.top(), 5);
  EXPECT_EQ(polygon.distance(2, 2), 0);
  EXPECT_NEAR(polygon.distance(10, 10), std::sqrt(50.0), 1e-12);
  const auto keep_out = readKeepOut({"box:0,0,1,1,1", "cylinder:9,9,1,2"}, 0.5);
  EXPECT_EQ(keep_out.zones().size(), 2u);
  EXPECT_EQ(keep_out.margin(), 0.5);
}

TEST(KeepOutOption, SaysWhatIsWrong)
{
  expectError("", "must be written as");
  expectError("box", "must be written as");
  expectError("sphere:1,2,3,4", "must be written as");
  expectError("box:1,2,3,4", "five numbers");
  expectError("cylinder:1,2,3,4,5", "four numbers");
  expectError("polygon:0,0,1,0,1,1", "three corners");
  expectError("polygon:0,0,1,0,5", "three corners");
  expectError("box:1,2,x,4,5", "x is not a number");
  expectError("box:1,2,3mm,4,5", "3mm is not a number");
  expectError("box:1,2,,4,5", "missing");
  expectError("box:1,2,3,4,", "missing");
  expectError("box:", "missing");
  expectError("box:0,0,nan,4,5", "finite");
  expectError("box:0,0,0,4,5", "outline");
  expectError("cylinder:0,0,-1,5", "radius");
  expectError("polygon:0,0,2,2,2,0,0,2,5", "meets itself");
  EXPECT_THROW(readKeepOut({}, -1), pointmill::ParameterError);
}

TEST(KeepOutOption, DoesNotDependOnTheLocale)
{
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
    if (std::setlocale(LC_ALL, name))
      break; // where there is none, the test says less
  EXPECT_EQ(readKeepOutZone("cylinder:1.5,2.5,0.5,3.25").top(), 3.25);
  std::setlocale(LC_ALL, "C");
}
