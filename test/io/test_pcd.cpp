// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "io_test.h"

#include <pcl/io/lzf.h>
#include <pcl/io/pcd_io.h>

#include <limits>

using io_test::bytes;
using io_test::exact;
using io_test::expectRefused;
using io_test::read;
using io_test::utmPoints;

namespace {

// An intensity before x y z, so that a wrong column shows.
std::string header(const std::string& type,
                   const std::string& size,
                   const std::string& points,
                   const std::string& data)
{
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS i x y z\nSIZE 4 " + size + " " + size + " " +
         size + "\nTYPE F " + type + " " + type + " " + type +
         "\nCOUNT 1 1 1 1\nWIDTH " + points + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n" +
         "POINTS " + points + "\nDATA " + data + "\n";
}

std::string asciiFile(const std::string& announced = "12")
{
  std::string text = header("F", "8", announced, "ascii");
  for (const auto& p : utmPoints())
    text += "7 " + exact(p.x()) + " " + exact(p.y()) + " " + exact(p.z()) + "\n";
  return text;
}

std::string binaryFile(const std::string& announced = "12")
{
  std::string text = header("F", "8", announced, "binary");
  for (const auto& p : utmPoints())
    text += bytes(7.f) + bytes(p.x()) + bytes(p.y()) + bytes(p.z());
  return text;
}

pcl::PointCloud<pcl::PointXYZI> organised()
{
  pcl::PointCloud<pcl::PointXYZI> cloud(6, 4);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    cloud[i].x = float(i % 6);
    cloud[i].y = float(i / 6);
    cloud[i].z = i % 5 == 0 ? std::numeric_limits<float>::quiet_NaN() : 0.1f * float(i);
    cloud[i].intensity = 9;
  }
  cloud.is_dense = false;
  return cloud;
}

// What PCL itself writes, as the bytes of its file.
std::string writtenByPcl(bool compressed)
{
  const std::string path = io_test::ownPath("by_pcl.pcd");
  if (compressed)
    pcl::io::savePCDFileBinaryCompressed(path, organised());
  else
    pcl::io::savePCDFileBinary(path, organised());
  std::ifstream in(path, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(in), {}};
  std::remove(path.c_str());
  return content;
}

} // namespace

TEST(Pcd, DoublesAreExactInText)
{
  EXPECT_EQ(read("a.pcd", asciiFile()).points, utmPoints());
}

TEST(Pcd, DoublesAreExactInBinary)
{
  const auto scan = read("a.PCD", binaryFile());
  EXPECT_EQ(scan.points, utmPoints());
  EXPECT_EQ(scan.format, "PCD");
  EXPECT_TRUE(scan.faces.empty());
}

TEST(Pcd, OrganisedCloudsOfPclLoseTheirNaN)
{
  for (const bool compressed : {false, true}) {
    const auto scan = read("a.pcd", writtenByPcl(compressed));
    EXPECT_EQ(scan.non_finite, 5u);
    ASSERT_EQ(scan.points.size(), 19u);
    EXPECT_EQ(scan.points[0], Eigen::Vector3d(1, 0, 0.1f));
    EXPECT_EQ(scan.points.back(), Eigen::Vector3d(5, 3, 0.1f * 23.f));
  }
}

TEST(Pcd, DoublesAreExactWhenCompressed)
{
  std::string plain;
  for (int i = 0; i < 12; ++i)
    plain += bytes(7.f);
  for (int axis = 0; axis < 3; ++axis)
    for (const auto& p : utmPoints())
      plain += bytes(p[axis]);
  std::string packed(2 * plain.size(), ' ');
  packed.resize(pcl::lzfCompress(plain.data(),
                                 static_cast<unsigned>(plain.size()),
                                 packed.data(),
                                 static_cast<unsigned>(packed.size())));
  const auto size = [](const std::string& text) {
    return bytes(static_cast<std::uint32_t>(text.size()));
  };
  const auto scan = read("a.pcd",
                         header("F", "8", "12", "binary_compressed") + size(packed) +
                             size(plain) + packed);
  EXPECT_EQ(scan.points, utmPoints());
}

TEST(Pcd, IntegerCoordinatesAndCountsAreRead)
{
  std::string text = "FIELDS h x y z\nSIZE 1 2 2 2\nTYPE U I I I\nCOUNT 3 1 1 1\n"
                     "WIDTH 4\nHEIGHT 3\nDATA binary\n";
  for (std::int16_t i = 0; i < 12; ++i)
    text += "abc" + bytes<std::int16_t>(-i) + bytes<std::int16_t>(i % 3) +
            bytes<std::int16_t>(1000);
  const auto scan = read("a.pcd", text);
  ASSERT_EQ(scan.points.size(), 12u);
  EXPECT_EQ(scan.points[11], Eigen::Vector3d(-11, 2, 1000));
}

TEST(Pcd, EveryTruncationIsRefused)
{
  for (const std::string& whole :
       {binaryFile(), writtenByPcl(false), writtenByPcl(true)}) {
    const std::size_t data = whole.find("DATA");
    for (std::size_t size = data + 30; size < whole.size(); size += 17)
      expectRefused("a.pcd", whole.substr(0, size), "cut short");
    expectRefused("a.pcd", whole.substr(0, data), "is not a PCD file");
  }
  const std::string text = asciiFile();
  expectRefused("a.pcd", text.substr(0, text.rfind("\n7 ") + 1), "cut short");
  // Within a row.
  const std::string row = text.substr(0, text.rfind(' '));
  expectRefused("a.pcd", row, "line 23");
}

TEST(Pcd, DamagedCompressedDataIsRefused)
{
  std::string text = writtenByPcl(true);
  const std::size_t data = text.find("DATA binary_compressed\n") + 23;
  std::string sizes = text;
  sizes.replace(data + 4, 4, bytes<std::uint32_t>(0xfffffff0u));
  expectRefused("a.pcd", sizes, "damaged");
  for (std::size_t i = data + 8; i < text.size(); ++i)
    text[i] = '\xff';
  expectRefused("a.pcd", text, "damaged");
}

TEST(Pcd, AnnouncedCountsAreNotBelieved)
{
  for (const char* points : {"4000000000", "13"}) {
    expectRefused("a.pcd", asciiFile(points), "cut short");
    expectRefused("a.pcd", binaryFile(points), "cut short");
  }
  expectRefused("a.pcd", asciiFile("11"), "more points than the 11 announced");
  expectRefused("a.pcd", asciiFile("99999999999999999999"), "is no count");
  expectRefused("a.pcd", asciiFile("-1"), "is no count");
  std::string text = binaryFile();
  text.replace(text.find("HEIGHT 1"), 8, "HEIGHT 2");
  expectRefused("a.pcd", text, "contradicts itself");
}

TEST(Pcd, FieldsAndRowsMustFit)
{
  std::string text = asciiFile();
  expectRefused("a.pcd", text.replace(text.find("x y z"), 5, "u v w"), "no field 'x'");
  text = asciiFile();
  expectRefused("a.pcd", text.replace(text.find("F F F F"), 7, "F Q Q Q"), "type Q8");
  text = asciiFile();
  expectRefused("a.pcd", text.replace(text.find("512702"), 3, "abc"), "line 1");
  expectRefused("a.pcd", "ply\nformat ascii 1.0\n", "is not a PCD file");
}
