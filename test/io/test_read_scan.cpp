// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "io_test.h"

#include <filesystem>

using io_test::expectRefused;
using io_test::read;
using io_test::rows;

TEST(ReadScan, WhatIsNoFileIsRefused)
{
  try {
    pointmill::readScan(::testing::TempDir() + "pointmill_none.xyz");
    FAIL();
  }
  catch (const pointmill::DataError& e) {
    EXPECT_NE(std::string(e.what()).find("pointmill_none.xyz: there is no such file"),
              std::string::npos)
        << e.what();
  }
  const std::string folder = io_test::ownPath("folder.ply");
  std::filesystem::create_directory(folder);
  EXPECT_THROW(pointmill::readScan(folder), pointmill::DataError);
  std::filesystem::remove(folder);
  EXPECT_THROW(pointmill::readScan("/dev/null"), pointmill::DataError);
  EXPECT_THROW(pointmill::readScan(""), pointmill::DataError);
}

TEST(ReadScan, EmptyFilesOfEveryKindAreRefused)
{
  for (const char* name : {"a.pcd", "a.ply", "a.obj", "a.stl", "a.xyz"})
    expectRefused(name, "", "is empty");
}

TEST(ReadScan, UnknownKindsAreRefused)
{
  expectRefused("a.e57", "ASTM-E57", "save the scan as .pcd");
  expectRefused("a", "1 2 3\n", "save the scan as .pcd");
}

TEST(ReadScan, DegenerateScansAreRefused)
{
  std::string same, line, nan;
  for (int i = 0; i < 20; ++i) {
    same += "1 2 3\n";
    line += "1 " + std::to_string(i) + " 3\n";
    nan += "nan nan nan\n";
  }
  expectRefused("a.xyz", "# nothing\n", "holds no points");
  expectRefused("a.xyz", "1 2 3\n", "too few points, 1 finite");
  expectRefused("a.xyz", same, "one spot or line");
  expectRefused("a.xyz", line, "one spot or line");
  expectRefused("a.xyz", nan, "all of its 20 points are NaN");
  expectRefused("a.xyz", nan + "1 2 3\n", "too few points, 1 finite");
}

TEST(ReadScan, ASmallMeshIsNoSmallCloud)
{
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expectRefused("a.obj", vertices, "too few points");
  EXPECT_EQ(read("a.obj", vertices + "f 1 2 3\n").faces.size(), 1u);
}

TEST(ReadScan, FacesFollowTheirVerticesWhenNaNIsDropped)
{
  const auto scan = read("a.obj",
                         "v nan 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 inf 1\n"
                         "f 2 3 4\nf 1 2 3\nf 3 4 5\nf 4 3 2\n");
  EXPECT_EQ(scan.non_finite, 2u);
  const std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 2}, {2, 1, 0}};
  EXPECT_EQ(scan.faces, faces);
}
