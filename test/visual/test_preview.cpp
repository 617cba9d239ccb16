// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "picture.h"

#include <pointmill/common/error.h>
#include <pointmill/visual/preview.h>

#include <cmath>

using namespace pointmill;

namespace {

const Pixel kFirst{0x00, 0x72, 0xB2}, kSecond{0xE6, 0x9F, 0x00},
    kRapid{0x1A, 0x1A, 0x1A};
const Pixel kGap{0xD5, 0x5E, 0x00}, kMachined{0xDD, 0xE3, 0xE8};

bool isBlue(const Pixel& p)
{
  return p[2] > p[0] + 50;
}
bool isDark(const Pixel& p)
{
  return p[0] + p[1] + p[2] < 3 * 0xB0;
}

/// A field of 1 mm cells, `height(x, y)` high.
template <typename Height>
CellCloud field(int columns, int rows, const Height& height)
{
  CellCloud cells;
  cells.resize(static_cast<std::size_t>(columns) * rows);
  cells.width = columns;
  cells.height = rows;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      PointCell& cell = cells[static_cast<std::size_t>(r) * columns + c];
      cell.x = static_cast<float>(c);
      cell.y = static_cast<float>(r);
      cell.z = static_cast<float>(height(c, r));
      cell.setState(CellState::Occupied);
    }
  return cells;
}

/// A plate with a boss and a gap, two operations, and the milled field.
struct Sample {
  Sample()
      : map(field(
            60,
            40,
            [](int x, int y) { return std::hypot(x - 20, y - 20) < 9 ? 12 : 6; })),
        milled(field(60, 40, [](int x, int) { return x < 3 ? 15 : 7; }))
  {
    for (int x = 40; x < 50; ++x)
      map[20 * 60 + x].setState(CellState::Gap);
    for (int y = 0; y < 400; ++y)
      for (int x = 0; x < 600; ++x)
        if (y < 195 || y > 215 || x < 395 || x > 495)
          scan.push_back(pcl::PointXYZ(
              x * 0.1f, y * 0.1f, std::hypot(x - 200, y - 200) < 90 ? 12.f : 6.f));
    scan.push_back(pcl::PointXYZ(std::nanf(""), 0.f, 0.f));
    for (int y = 0; y < 40; y += 4)
      for (int x = 0; x < 60; ++x)
        first.push_back(PointCL(x, y, 13.0));
    for (int x = 0; x < 60; ++x)
      second.push_back(PointCL(x, 1.0, 7.0));
    scene.title = "plate.pcd";
    scene.scan = &scan;
    scene.map = &map;
    scene.milled = &milled;
    scene.stock.max = {59, 39, 15};
    scene.operations = {{"1  roughing", &first}, {"2  finishing", &second}};
    scene.figures = {"12 min", "gouge 0.004 mm"};
  }
  pcl::PointCloud<pcl::PointXYZ> scan;
  CellCloud map, milled;
  CLCloud first, second;
  PreviewScene scene;
};

} // namespace

TEST(Preview, HasItsSizeAndEveryColourOfItsLegends)
{
  const TemporaryFolder folder;
  const Sample sample;
  writePreview(folder.file("preview.png"), sample.scene);
  const Picture picture(folder.file("preview.png"));
  EXPECT_EQ(picture.width(), 2100);
  EXPECT_EQ(picture.height(), 900);
  EXPECT_EQ(picture.channels(), 3);
  for (const Pixel& colour : {kFirst, kSecond, kGap, kMachined})
    EXPECT_GT(picture.count(colour), 50);
  // All that is drawn keeps clear of the picture's edge.
  const Pixel white{255, 255, 255};
  for (int x = 0; x < picture.width(); ++x) {
    ASSERT_EQ(picture.at(x, 0), white);
    ASSERT_EQ(picture.at(x, picture.height() - 1), white);
  }
  EXPECT_EQ(folder.files(), 1u);
}

TEST(Preview, OnlyRapidsBringTheirColour)
{
  const TemporaryFolder folder;
  Sample sample;
  writePreview(folder.file("feed.png"), sample.scene);
  EXPECT_EQ(Picture(folder.file("feed.png")).count(kRapid), 0);
  sample.first.push_back(PointCL(0, 0, 20, Motion::Retract));
  sample.first.push_back(PointCL(59, 39, 20, Motion::Rapid));
  writePreview(folder.file("rapid.png"), sample.scene);
  EXPECT_GT(Picture(folder.file("rapid.png")).count(kRapid), 20);
}

TEST(Preview, HidesWhatLiesBehindThePart)
{
  // The viewer stands in front, to the left: a move behind a tall wall.
  const TemporaryFolder folder;
  const CellCloud wall = field(60, 60, [](int, int y) { return y < 6 ? 60 : 0; });
  const CellCloud low = field(60, 60, [](int, int y) { return y < 6 ? 1 : 0; });
  CLCloud behind, before;
  for (int x = 15; x < 35; ++x) {
    behind.push_back(PointCL(x, 10, 2));
    before.push_back(PointCL(x, -4, 2));
  }
  PreviewScene scene;
  scene.stock.max = {59, 59, 60}; // the same view for all
  const auto shown = [&](const CellCloud& map, const CLCloud& path) {
    scene.map = &map;
    scene.operations = {{"1", &path}};
    writePreview(folder.file("hidden.png"), scene);
    return Picture(folder.file("hidden.png")).count(720, 1380, 130, 755, isBlue);
  };
  EXPECT_GT(shown(low, behind), 30);
  EXPECT_EQ(shown(wall, behind), 0);
  EXPECT_GT(shown(wall, before), 30);
}

TEST(Preview, ShowsTheMilledPartsWalls)
{
  const TemporaryFolder folder;
  const CellCloud flat = field(40, 40, [](int, int) { return 0; });
  const CellCloud stepped =
      field(40, 40, [](int x, int) { return x > 10 && x < 30 ? 20 : 0; });
  PreviewScene scene;
  scene.stock.max = {39, 39, 20};
  const auto dark = [&](const CellCloud& milled) {
    scene.milled = &milled;
    writePreview(folder.file("walls.png"), scene);
    return Picture(folder.file("walls.png")).count(1420, 2060, 130, 690, isDark);
  };
  EXPECT_GT(dark(stepped), dark(flat) + 5000);
}

TEST(Preview, IsTheSameEveryTime)
{
  const TemporaryFolder folder;
  const Sample sample;
  writePreview(folder.file("a.png"), sample.scene, 1050, 450);
  writePreview(folder.file("b.png"), sample.scene, 1050, 450);
  EXPECT_FALSE(readBytes(folder.file("a.png")).empty());
  EXPECT_EQ(readBytes(folder.file("a.png")), readBytes(folder.file("b.png")));
}

TEST(Preview, TakesWhateverTheSceneHolds)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("preview.png");
  PreviewScene scene;
  pcl::PointCloud<pcl::PointXYZ> one;
  one.push_back(pcl::PointXYZ(1, 2, 3));
  scene.scan = &one;
  writePreview(path, scene, 640, 360);
  EXPECT_EQ(Picture(path).width(), 640);

  CLCloud path_of_nothing;
  CLCloud broken;
  broken.push_back(PointCL(0, 0, 0));
  broken.push_back(PointCL(std::nan(""), 0, 0, Motion::Rapid));
  broken.push_back(PointCL(9, 9, 9, Motion::Cut));
  scene.title = "\xFF\n$x$ | B\xC3\xBCste " + std::string(300, 'w');
  scene.figures.assign(60, "a figure that is rather long");
  scene.operations.assign(20, {std::string(200, 'o'), &broken});
  scene.operations.push_back({"none", &path_of_nothing});
  scene.operations.push_back({"", nullptr});
  writePreview(path, scene, 1600, 2000);
  EXPECT_EQ(Picture(path).height(), 2000);
}

TEST(Preview, RefusesWhatItCannotShow)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("preview.png");
  EXPECT_THROW(writePreview(path, PreviewScene()), DataError);
  Sample sample;
  EXPECT_THROW(writePreview(path, sample.scene, 10, 900), ParameterError);
  const CellCloud empty;
  sample.scene.map = &empty;
  EXPECT_THROW(writePreview(path, sample.scene), DataError);
  Sample other;
  other.milled.width = 2400;
  other.milled.height = 1;
  EXPECT_THROW(writePreview(path, other.scene), DataError);
  EXPECT_THROW(writePreview(folder.file("no/such.png"), Sample().scene, 640, 360),
               DataError);
  EXPECT_TRUE(folder.empty());
}
