// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "io_test.h"

#include <pointmill/common/point_types.h>
#include <pointmill/io/write_cloud.h>
#include <pointmill/io/write_file.h>

#include <filesystem>
#include <ostream>

namespace fs = std::filesystem;
using pointmill::DataError;
using pointmill::writeCloud;
using pointmill::writeFileAtomically;

namespace {

/// A folder of its own, gone after the test.
class Write : public ::testing::Test {
protected:
  Write() : folder(io_test::ownPath("folder"))
  {
    fs::remove_all(folder);
    fs::create_directory(folder);
  }
  ~Write() override { fs::remove_all(folder); }

  std::size_t files() const
  {
    return std::size_t(std::distance(fs::directory_iterator(folder), {}));
  }
  static std::string content(const fs::path& path)
  {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder;
};

} // namespace

TEST_F(Write, ReplacesTheWholeFile)
{
  const fs::path path = folder / "a.nc";
  for (const char* text : {"a long first program\r\n", "short\n"}) {
    writeFileAtomically(path.string(), [&](std::ostream& out) {
      out << text << 1234.5;
      EXPECT_NE(content(path), text + std::string("1234.5")); // not before it is whole
    });
    EXPECT_EQ(content(path), text + std::string("1234.5"));
    EXPECT_EQ(files(), 1u);
  }
}

TEST_F(Write, LeavesNothingWhenItFails)
{
  const std::string path = (folder / "a.nc").string();
  const auto throwing = [](std::ostream& out) {
    out << "half";
    throw std::runtime_error("no more");
  };
  EXPECT_THROW(writeFileAtomically(path, throwing), DataError);
  EXPECT_EQ(files(), 0u);
  writeFileAtomically(path, [](std::ostream& out) { out << "old"; });
  EXPECT_THROW(writeFileAtomically(path, throwing), DataError);
  EXPECT_THROW(writeFileAtomically(
                   path, [](std::ostream& out) { out.setstate(std::ios::badbit); }),
               DataError);
  EXPECT_THROW(
      writeFileAtomically(
          path, [](std::ostream&) { throw pointmill::VerificationError("v"); }),
      pointmill::VerificationError);
  EXPECT_EQ(content(path), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(Write, RefusesWhatIsNoFile)
{
  const auto nothing = [](std::ostream&) {};
  EXPECT_THROW(writeFileAtomically((folder / "no" / "a.nc").string(), nothing),
               DataError);
  EXPECT_THROW(writeFileAtomically(folder.string(), nothing), DataError);
  EXPECT_THROW(writeFileAtomically("/dev/null", nothing), DataError);
  EXPECT_THROW(writeFileAtomically("", nothing), DataError);
  EXPECT_EQ(files(), 0u);
}

TEST_F(Write, FollowsALink)
{
  writeFileAtomically((folder / "a").string(), [](std::ostream& out) { out << 1; });
  fs::create_symlink("a", folder / "link");
  writeFileAtomically((folder / "link").string(), [](std::ostream& out) { out << 2; });
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(content(folder / "a"), "2");
}

TEST_F(Write, PclReadsWhatWriteCloudWrote)
{
  pointmill::CLCloud cloud;
  for (int i = 0; i < 100; ++i) {
    cloud.push_back({0.1 * i, -0.2 * i, 0.3 * i, pointmill::Motion::Link});
    cloud.back().feed = 500.f;
    cloud.back().level = 7;
  }
  cloud.width = 10;
  cloud.height = 10;
  const std::string path = (folder / "a.pcd").string();
  writeCloud(path, cloud);
  pointmill::CLCloud back;
  ASSERT_EQ(pcl::io::loadPCDFile(path, back), 0);
  ASSERT_EQ(back.size(), cloud.size());
  EXPECT_EQ(back.width, 10u);
  for (std::size_t i = 0; i < back.size(); ++i) {
    EXPECT_EQ(back[i].getVector3fMap(), cloud[i].getVector3fMap());
    EXPECT_EQ(back[i].normal_z, 1.f);
    EXPECT_EQ(back[i].feed, 500.f);
    EXPECT_EQ(back[i].level, 7u);
    EXPECT_EQ(back[i].getMotion(), pointmill::Motion::Link);
  }
  EXPECT_EQ(pointmill::readScan(path).points.size(), 100u);
}

TEST_F(Write, RefusesACloudThatIsNone)
{
  const std::string path = (folder / "a.pcd").string();
  pcl::PointCloud<pcl::PointXYZ> cloud;
  EXPECT_THROW(writeCloud(path, cloud), DataError);
  cloud.resize(4);
  cloud.width = 3;
  EXPECT_THROW(writeCloud(path, cloud), DataError);
  EXPECT_EQ(files(), 0u);
}
