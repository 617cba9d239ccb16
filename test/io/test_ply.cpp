// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "io_test.h"

using io_test::bytes;
using io_test::exact;
using io_test::expectRefused;
using io_test::read;
using io_test::rows;
using io_test::utmPoints;

namespace {

using Faces = std::vector<std::array<std::uint32_t, 3>>;

std::string
header(const std::string& format, const std::string& vertices, const std::string& faces)
{
  return "ply\nformat " + format + " 1.0\ncomment made by a test\nelement vertex " +
         vertices +
         "\nproperty uchar quality\nproperty double x\nproperty double y\n"
         "property double z\nproperty list uchar short extra\n" +
         faces + "end_header\n";
}

const std::string face_element =
    "element face 2\nproperty list uchar int vertex_indices\n";
const std::string strip_element =
    "element tristrips 1\nproperty list int int vertex_indices\n";

std::string binaryVertices(bool big)
{
  std::string text;
  for (const auto& p : utmPoints())
    text += bytes<std::uint8_t>(200) + bytes(p.x(), big) + bytes(p.y(), big) +
            bytes(p.z(), big) + bytes<std::uint8_t>(2) + "abcd";
  return text;
}

// A triangle and a quadrangle.
std::string binaryFile(bool big)
{
  std::string text =
      header(big ? "binary_big_endian" : "binary_little_endian", "12", face_element) +
      binaryVertices(big);
  text += bytes<std::uint8_t>(3);
  for (std::int32_t i : {0, 1, 2})
    text += bytes(i, big);
  text += bytes<std::uint8_t>(4);
  for (std::int32_t i : {3, 4, 5, 11})
    text += bytes(i, big);
  return text;
}

std::string asciiFile(const std::string& faces = "3 0 1 2\n4 3 4 5 11\n",
                      const std::string& element = face_element,
                      const std::string& announced = "12")
{
  std::string text = header("ascii", announced, element);
  for (const auto& p : utmPoints())
    text += "200 " + exact(p.x()) + " " + exact(p.y()) + " " + exact(p.z()) + " 1 5\n";
  return text + faces;
}

const Faces fanned{{0, 1, 2}, {3, 4, 5}, {3, 5, 11}};

} // namespace

TEST(Ply, DoublesAreExactInEveryVariant)
{
  for (const std::string& content :
       {asciiFile(), binaryFile(false), binaryFile(true)}) {
    const auto scan = read("a.ply", content);
    EXPECT_EQ(scan.points, utmPoints());
    EXPECT_EQ(scan.faces, fanned);
    EXPECT_EQ(scan.format, "PLY");
  }
}

TEST(Ply, FloatsAndWindowsLineEndsAreRead)
{
  std::string text =
      "ply\r\nformat ascii 1.0\r\nelement vertex 12\r\nproperty float32 x\r\n"
      "property float32 y\r\nproperty float32 z\r\nend_header\r\n" +
      rows(utmPoints(), " ", " \r\n");
  const auto scan = read("a.ply", text);
  EXPECT_EQ(scan.points, utmPoints());
  EXPECT_TRUE(scan.faces.empty());
}

TEST(Ply, StripsAreUnrolledWithOneOrientation)
{
  const auto scan = read("a.ply", asciiFile("9 0 1 2 3 3 -1 4 5 6\n", strip_element));
  EXPECT_EQ(scan.faces, (Faces{{0, 1, 2}, {2, 1, 3}, {4, 5, 6}}));
  std::string binary = header("binary_big_endian", "12", strip_element) +
                       binaryVertices(true) + bytes<std::int32_t>(5, true);
  for (std::int32_t i : {7, 8, 9, -1, 10})
    binary += bytes(i, true);
  EXPECT_EQ(read("a.ply", binary).faces, (Faces{{7, 8, 9}}));
}

TEST(Ply, FacesMayComeFirstAndOtherElementsAreSkipped)
{
  const std::string text =
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar uint vertex_index\n"
      "element range_grid 2\nproperty list uchar int vertex_indices\n"
      "element vertex 3\nproperty float z\nproperty float y\nproperty float x\n"
      "end_header\n3 2 1 0\n0\n1 2\n3 2 1\n6 5 4\n9 8 70\n";
  const auto scan = read("a.ply", text);
  EXPECT_EQ(scan.faces, (Faces{{2, 1, 0}}));
  EXPECT_EQ(scan.points[2], Eigen::Vector3d(70, 8, 9));
}

TEST(Ply, EveryTruncationIsRefused)
{
  for (const bool big : {false, true}) {
    const std::string whole = binaryFile(big);
    const std::size_t data = whole.find("end_header") + 11;
    for (std::size_t size = data; size < whole.size(); size += 7)
      expectRefused("a.ply", whole.substr(0, size), "cut short");
  }
  const std::string whole = asciiFile();
  expectRefused("a.ply", whole.substr(0, whole.find("\n3 0 1 2") + 1), "cut short");
  expectRefused("a.ply", whole.substr(0, whole.size() - 4), "line 26");
}

TEST(Ply, AnnouncedCountsAreNotBelieved)
{
  expectRefused("a.ply", asciiFile("", face_element, "99999999999"), "cut short");
  expectRefused("a.ply", asciiFile("", "", "11"), "line 22");
  expectRefused("a.ply", asciiFile("", face_element, "-3"), "is unknown");
  std::string binary = header("binary_little_endian", "12", strip_element) +
                       binaryVertices(false) + bytes<std::int32_t>(2000000000);
  expectRefused("a.ply", binary, "cut short or damaged");
  binary.replace(binary.find("element tristrips 1"), 19, "element tristrips 9");
  expectRefused("a.ply", binary, "cut short");
}

TEST(Ply, NonsenseIsRefused)
{
  expectRefused("a.ply", "solid\nply\n", "is not a PLY file");
  expectRefused("a.ply", asciiFile("3 0 1 12\n3 0 1 2\n"), "uses vertex 13 of 12");
  expectRefused("a.ply", asciiFile("3 0 1 -1\n3 0 1 2\n"), "is not the row of values");
  expectRefused("a.ply", asciiFile("3 0 1 2.5\n3 0 1 2\n"), "is not the row of values");
  std::string text = asciiFile();
  expectRefused("a.ply", text.replace(text.find("double y"), 8, "double h"), "lack");
  text = asciiFile();
  expectRefused("a.ply",
                text.replace(text.find("format ascii"), 12, "format magic"),
                "'magic' is unknown");
}
