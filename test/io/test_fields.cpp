// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "io_test.h"

#include <pointmill/common/point_types.h>
#include <pointmill/io/read_fields.h>
#include <pointmill/io/write_cloud.h>

#include <pcl/common/io.h>

using namespace pointmill;

namespace {

/// A file of its own, gone after the test.
struct OwnFile {
  explicit OwnFile(const std::string& content = "")
      : path(io_test::ownPath("cloud.pcd"))
  {
    std::ofstream(path, std::ios::binary) << content;
  }
  ~OwnFile() { std::remove(path.c_str()); }
  std::string path;
};

CLCloud shortPass()
{
  CLCloud pass;
  for (int i = 0; i < 6; ++i) {
    pass.push_back(PointCL(i, 2, -3));
    pass.back().feed = 600;
  }
  return pass;
}

std::string asciiPcd(const std::string& points, const std::string& rows)
{
  return "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 4\n"
         "TYPE F F F F\nCOUNT 1 1 1 1\nWIDTH " +
         points + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + points +
         "\nDATA ascii\n" + rows;
}

void expectRefused(const std::string& content, const std::string& words)
{
  const OwnFile file(content);
  try {
    readFields(file.path);
    FAIL() << "was read; expected: " << words;
  }
  catch (const DataError& e) {
    EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
  }
}

} // namespace

// A scan needs ten points and more than a line; a pass does not.
TEST(ReadFields, AShortPassIsACloud)
{
  const OwnFile file;
  const CLCloud pass = shortPass();
  writeCloud(file.path, pass);
  const auto read = readPoints<PointCL>(file.path);
  ASSERT_EQ(read->size(), pass.size());
  EXPECT_EQ(read->back().x, pass.back().x);
  EXPECT_EQ(read->back().feed, pass.back().feed);
  EXPECT_GE(pcl::getFieldIndex(*readScanFields(file.path), "feed"), 0);
}

TEST(ReadFields, TheHeaderIsNotTrusted)
{
  const OwnFile file;
  writeCloud(file.path, shortPass());
  std::ifstream in(file.path, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  expectRefused(whole.substr(0, whole.size() - 4), "6 points");
  expectRefused(asciiPcd("4000000000", "1 2 3 4\n"), "4000000000 points");
  expectRefused(asciiPcd("2", "1 2 3 4\n1 two 3 4\n"), "is not a row of numbers");
  expectRefused(asciiPcd("2", "1 2 3 4\n1 2 3 four\n"), "is not a row of numbers");
  expectRefused("solid nothing\n", "is not a PCD file");
}

// PCL's conversion would leave it as it is.
TEST(ReadFields, AFieldOfAnotherTypeIsRefused)
{
  const OwnFile file(
      asciiPcd("1", "1 2 3 4\n")
          .replace(asciiPcd("1", "").find("SIZE 4 4 4 4"), 12, "SIZE 4 4 4 8"));
  EXPECT_THROW(readPoints<pcl::PointXYZI>(file.path), DataError);
  EXPECT_EQ(readPoints<pcl::PointXYZ>(file.path)->front().z, 3.f);
}

TEST(ReadFields, NamesOfFieldsAreInTheHeader)
{
  const OwnFile file(asciiPcd("4000000000", ""));
  EXPECT_EQ(fieldsOf(file.path),
            (std::vector<std::string>{"x", "y", "z", "intensity"}));
  EXPECT_TRUE(fieldsOf("no/such.pcd").empty());
}

TEST(ReadScanFields, TheLastBitOfAPlaceDoesNotCostTheOtherFields)
{
  // Just above the middle of two floats; as double it lies on it, and goes the other
  // way.
  const std::string x = "1.00000005960464477539062500000000001";
  std::string rows;
  for (int i = 0; i < 12; ++i)
    rows += x + " " + std::to_string(i * i) + " " + std::to_string(i) + " 7\n";
  const OwnFile file(asciiPcd("12", rows));
  const auto read = readScanFields(file.path);
  EXPECT_GE(pcl::getFieldIndex(*read, "intensity"), 0);
  pcl::PointCloud<pcl::PointXYZ> places;
  pcl::fromPCLPointCloud2(*read, places);
  EXPECT_NE(places[0].x, static_cast<float>(std::stod(x)));
}
