// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "io_test.h"

#include <locale>

using io_test::expectRefused;
using io_test::read;
using io_test::rows;
using io_test::utmPoints;

TEST(Text, EverySeparatorIsRead)
{
  for (const char* separator : {" ", "\t", "  ", ",", ", ", ";", " ; "})
    for (const char* end : {"\n", "\r\n", " \n\n"}) {
      const auto scan = read("a.xyz", rows(utmPoints(), separator, end));
      EXPECT_EQ(scan.points, utmPoints()) << "'" << separator << "'";
      EXPECT_EQ(scan.format, "text");
    }
  for (const char* name : {"a.XYZ", "a.asc", "a.txt", "a.csv", "a.Pts"})
    EXPECT_EQ(read(name, rows(utmPoints())).points, utmPoints());
}

TEST(Text, MoreColumnsAndCommentsAreSkipped)
{
  EXPECT_EQ(
      read("a.txt",
           "# x y z\n  // from somewhere\n\n" + rows(utmPoints(), " ", " 255 a b\n"))
          .points,
      utmPoints());
  EXPECT_EQ(read("a.csv", rows(utmPoints(), ",", ",255,a,\n")).points, utmPoints());
  EXPECT_EQ(read("a.csv", "\xef\xbb\xbfX,Y,Z\n" + rows(utmPoints(), ",")).points,
            utmPoints());
}

TEST(Text, NumbersComeInEveryForm)
{
  std::string text = "+1 -2 3.\n.5 1e3 -1E-3\n";
  for (int i = 0; i < 10; ++i)
    text += "1 2 3\n";
  const auto scan = read("a.xyz", text + "nan 0 0\n0 -inf 0\n1 1 NaN");
  EXPECT_EQ(scan.points[0], Eigen::Vector3d(1, -2, 3));
  EXPECT_EQ(scan.points[1], Eigen::Vector3d(0.5, 1000, -0.001));
  EXPECT_EQ(scan.points.size(), 12u);
  EXPECT_EQ(scan.non_finite, 3u);
}

TEST(Text, AHeaderTellsTheColumns)
{
  std::string text = "\"name\";Z (mm);\"x\";y_mm\n";
  for (const auto& p : utmPoints())
    text += "p;" + rows({{p.z(), p.x(), p.y()}}, ";");
  EXPECT_EQ(read("a.csv", text).points, utmPoints());
  // No such names, or not as many as columns: the first three.
  EXPECT_EQ(read("a.csv", "east,north,up\n" + rows(utmPoints(), ",")).points,
            utmPoints());
  EXPECT_EQ(read("a.txt", "X [m] Y [m] Z [m]\n" + rows(utmPoints())).points,
            utmPoints());
}

TEST(Text, ACountIsHeldToItsWord)
{
  EXPECT_EQ(read("a.pts", "12\n" + rows(utmPoints(), " ", " -1300 20 30 40\n")).points,
            utmPoints());
  expectRefused("a.pts", "13\n" + rows(utmPoints()), "cut short");
  expectRefused("a.pts", "11\n" + rows(utmPoints()), "holds 12 points where 11");
}

TEST(Text, AMalformedLineIsNamed)
{
  const std::string good = rows(utmPoints());
  expectRefused("a.xyz", good + "1 2\n", "line 13: '1 2' is not a point");
  expectRefused("a.xyz", "# comment\n" + good + "\n1 two 3\n" + good, "line 15");
  expectRefused("a.xyz", good + "1 2 3x\n", "line 13");
  expectRefused("a.xyz", "x y z\nnone at all\n" + good, "line 2");
  expectRefused("a.csv", rows(utmPoints(), ",") + "1,,2\n", "line 13");
  expectRefused("a.xyz", good + "1 2 1e999\n", "line 13");
  expectRefused("a.xyz", good + std::string("\0\1\2\n\3", 5), "line 13");
}

TEST(Text, DecimalCommasAreRefusedNotMisread)
{
  std::string commas, last, spaced;
  for (int i = 0; i < 12; ++i) {
    commas += std::to_string(i) + ",5;1,5;2,5\n";
    last += std::to_string(i) + " 1 2,5\n";
    spaced += std::to_string(i) + ",5 1,5 2,5\n";
  }
  for (const std::string& text : {commas, last, spaced})
    expectRefused("a.txt", text, "line 1: ");
}

TEST(Text, TheLocaleDoesNotMatter)
{
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const std::string text = rows(utmPoints());
  const std::locale before =
      std::locale::global(std::locale(std::locale::classic(), new Comma));
  const auto scan = read("a.xyz", text);
  std::locale::global(before);
  EXPECT_EQ(scan.points, utmPoints());
}
