// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "io_test.h"

using io_test::expectRefused;
using io_test::read;
using io_test::utmPoints;

namespace {

using Faces = std::vector<std::array<std::uint32_t, 3>>;

std::string vertices()
{
  std::string text = "# a mesh\nmtllib none.mtl\no thing\n";
  for (const auto& p : utmPoints())
    text += "v " + io_test::exact(p.x()) + "\t" + io_test::exact(p.y()) + "  " +
            io_test::exact(p.z()) + " 0.5 0.5 0.5\r\nvn 0 0 1\nvt 0 0\n";
  return text;
}

} // namespace

TEST(Obj, VerticesAreExactAndPolygonsFanned)
{
  const auto scan = read("a.obj", vertices() + "f 1 2 3\nf 4 5 6 7 8\n");
  EXPECT_EQ(scan.points, utmPoints());
  EXPECT_EQ(scan.faces, (Faces{{0, 1, 2}, {3, 4, 5}, {3, 5, 6}, {3, 6, 7}}));
  EXPECT_EQ(scan.format, "OBJ");
}

TEST(Obj, EveryFormOfACornerIsRead)
{
  const auto scan = read("a.obj",
                         vertices() + "f 1/1 2/2 3/3 # a comment\nf 1//1 2//2 3//3\n"
                                      "f 1/1/1 2/2/2 3/3/3\nf -12 -11/2 -10/3/3\n"
                                      "v 0 0 0\nf -1 \\\r\n -2 1\n");
  const std::array<std::uint32_t, 3> first{0, 1, 2};
  EXPECT_EQ(scan.faces, (Faces{first, first, first, first, {12, 11, 0}}));
}

TEST(Obj, ACloudHasNoFaces)
{
  EXPECT_TRUE(read("a.obj", vertices() + "p 1 2 3\nl 1 2\n").faces.empty());
}

TEST(Obj, NonsenseIsRefusedWithItsLine)
{
  expectRefused("a.obj", "v 0 0 0\nv 1 0\n", "line 2");
  expectRefused("a.obj", "v 0 0 0\nv 1 0 0,5\n", "line 2");
  expectRefused("a.obj", vertices() + "f 1 2 a\n", "is not a vertex of a face");
  expectRefused("a.obj", vertices() + "f 1 2 0\n", "is not a vertex of a face");
  expectRefused("a.obj", vertices() + "f 1 2 -13\n", "is not a vertex of a face");
  expectRefused("a.obj", vertices() + "f 1 2 13\n", "uses vertex 13 of 12");
  expectRefused("a.obj", "hello\nworld\n", "holds no points");
}
