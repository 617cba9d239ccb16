// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "io_test.h"

using io_test::bytes;
using io_test::expectRefused;
using io_test::read;

namespace {

using Triangle = std::array<Eigen::Vector3f, 3>;

// The unit square at z = 0.1 as two triangles, and one more upon them.
std::vector<Triangle> triangles()
{
  const Eigen::Vector3f a(0, 0, 0.1f), b(1, 0, 0.1f), c(1, 1, 0.1f), d(-0.f, 1, 0.1f);
  return {{a, b, c}, {a, c, d}, {c, d, {0.5f, 1, 2.1f}}};
}

std::string binaryFile(std::uint32_t announced = 3, const std::string& start = "binary")
{
  std::string text = start + std::string(80 - start.size(), '\0') + bytes(announced);
  for (const auto& triangle : triangles()) {
    text += bytes(0.f) + bytes(0.f) + bytes(1.f);
    for (const auto& corner : triangle)
      for (const float value : corner)
        text += bytes(value);
    text += bytes<std::uint16_t>(0x8421); // some programs keep a colour here
  }
  return text;
}

std::string asciiFile()
{
  std::string text = "solid square plate\n";
  for (const auto& triangle : triangles()) {
    text += "  facet normal 0 0 1\n    outer loop\n";
    for (const auto& corner : triangle)
      text += "      VERTEX " + std::to_string(corner.x()) + " " +
              std::to_string(corner.y()) + " " + std::to_string(corner.z()) + "\n";
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid square plate\n";
}

} // namespace

TEST(Stl, EqualVerticesAreWelded)
{
  for (const std::string& content :
       {binaryFile(), binaryFile(3, "solid that is binary"), asciiFile()}) {
    const auto scan = read("a.stl", content);
    EXPECT_EQ(scan.format, "STL");
    ASSERT_EQ(scan.points.size(), 5u);
    EXPECT_EQ(scan.points[3].cast<float>(), Eigen::Vector3f(0, 1, 0.1f));
    const std::vector<std::array<std::uint32_t, 3>> expected{
        {0, 1, 2}, {0, 2, 3}, {2, 3, 4}};
    EXPECT_EQ(scan.faces, expected);
  }
}

TEST(Stl, ManyVerticesAreWelded)
{
  // A grid of 100 x 100 squares has 101 x 101 vertices.
  std::string text = std::string(80, ' ') + bytes<std::uint32_t>(20000);
  for (int i = 0; i < 20000; ++i) {
    const float x = float(i / 2 % 100), y = float(i / 200), s = float(i % 2);
    text += std::string(12, '\0');
    for (const float value : {x, y, 0.f, x + 1, y + 1, 0.f, x + 1 - s, y + s, 0.f})
      text += bytes(value);
    text += std::string(2, '\0');
  }
  EXPECT_EQ(read("a.stl", text).points.size(), 101u * 101u);
}

TEST(Stl, EveryTruncationIsRefused)
{
  const std::string binary = binaryFile();
  for (std::size_t size = 84; size < binary.size(); size += 11)
    expectRefused("a.stl", binary.substr(0, size), "cut short");
  expectRefused("a.stl", binary.substr(0, 83), "is not an STL file");
  expectRefused("a.stl", binaryFile(4000000000u), "cut short");
  const std::string text = asciiFile();
  for (const char* word : {"endsolid", "endfacet", "endloop", "VERTEX 0.5"})
    expectRefused("a.stl", text.substr(0, text.rfind(word)), "cut short");
}

TEST(Stl, NonsenseIsRefusedWithItsLine)
{
  std::string text = asciiFile();
  text.replace(text.find("VERTEX 0"), 8, "VERTEX a");
  expectRefused("a.stl", text, "line 4");
  text = asciiFile();
  text.replace(text.find("endloop"), 7, "VERTEX 1 1 1\nendloop");
  expectRefused("a.stl", text, "line 8");
  expectRefused("a.stl", "solid\nendsolid\n", "holds no points");
  expectRefused("a.stl", "ply\nformat ascii 1.0\n", "is not an STL file");
}
