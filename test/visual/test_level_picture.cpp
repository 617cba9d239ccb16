// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "picture.h"

#include <pointmill/common/error.h>
#include <pointmill/visual/level_picture.h>

#include <algorithm>
#include <cmath>

using namespace pointmill;

namespace {

const Pixel kPart{0xDE, 0x8C, 0x84}, kStands{0xE6, 0xDE, 0xBD},
    kMilled{0xDE, 0xE6, 0xEF}, kAir{0xF7, 0xF7, 0xF7}, kGap{0x5B, 0x7C, 0x99},
    kWhite{255, 255, 255}, kFirst{0x44, 0x01, 0x54}, kLast{0x7A, 0xD1, 0x51},
    kLink{0xE6, 0x9F, 0x00}, kBlack{0x1A, 0x1A, 0x1A};

/// Pictures have 32 tones of each channel.
bool is(const Pixel& p, const Pixel& colour)
{
  for (int i = 0; i < 3; ++i)
    if (std::abs(p[i] - colour[i]) > 9)
      return false;
  return true;
}

/// 40 x 30 mm of level ground with a boss 10 mm high on 10..20, 10..20, and a gap on
/// 28..36, 12..18 bridged at 8 mm. Level 0 is at 5 mm: a row from the left at the
/// front, a link to the right, a row back, a rapid to the far side, and a row there.
struct Sample {
  Sample()
  {
    map = field([](double x, double y) {
      return x > 10 && x < 20 && y > 10 && y < 20 ? 10.0 : 0.0;
    });
    for (auto& cell : map)
      if (cell.x > 28 && cell.x < 36 && cell.y > 12 && cell.y < 18) {
        cell.z = 8;
        cell.setState(CellState::Gap);
      }
    add(2, 3, 15, Motion::Rapid);
    add(2, 3, 5, Motion::Plunge);
    add(24, 3, 5, Motion::Cut);
    add(38, 3, 5, Motion::Link);
    add(38, 7, 5, Motion::Cut);
    add(38, 7, 15, Motion::Retract);
    add(4, 26, 15, Motion::Rapid);
    add(4, 26, 5, Motion::Plunge);
    add(36, 26, 5, Motion::Cut);
    add(36, 26, 15, Motion::Retract);
    scene.title = "a boss";
    scene.map = &map;
    scene.path = &path;
    scene.stock = {{0, 0, 0}, {40, 30, 10}};
    scene.tool = Tool::flat(1, 4.0);
    scene.figures = {"level 1", "some more"};
  }

  template <typename Height>
  static CellCloud field(Height height)
  {
    CellCloud cells;
    cells.width = 80;
    cells.height = 60;
    for (int r = 0; r < 60; ++r)
      for (int c = 0; c < 80; ++c) {
        PointCell cell;
        cell.x = static_cast<float>(0.5 * c + 0.25);
        cell.y = static_cast<float>(0.5 * r + 0.25);
        cell.z = static_cast<float>(height(cell.x, cell.y));
        cell.setState(CellState::Occupied);
        cells.points.push_back(cell);
      }
    return cells;
  }
  void add(double x, double y, double z, Motion motion, std::uint32_t level = 0)
  {
    path.push_back(PointCL(x, y, z, motion));
    path.back().level = level;
  }

  CellCloud map;
  CLCloud path;
  LevelScene scene;
};

/// A picture of a sample with places in mm: the boss, wherever it was drawn, says where
/// they are.
class Drawn {
public:
  Drawn(const TemporaryFolder& folder, const LevelScene& scene, int width = 900)
      : picture_((writeLevel(folder.file("level.png"), scene, width),
                  folder.file("level.png")))
  {
    // Columns and rows that hold much of it; the legend lies below.
    std::vector<int> columns(picture_.width()), rows(picture_.height());
    for (int y = 0; y < picture_.height() * 3 / 4; ++y)
      for (int x = 0; x < picture_.width(); ++x)
        if (isReddish(picture_.at(x, y)))
          ++columns[x], ++rows[y];
    const auto [left, right] = extent(columns);
    const auto [top, bottom] = extent(rows);
    scale_ = (right - left) / 10.0;
    EXPECT_NEAR(bottom - top, right - left, 2) << "the boss is not square";
    x0_ = (left + right) / 2.0 - 15 * scale_;
    y0_ = (top + bottom) / 2.0 + 15 * scale_;
  }
  Pixel at(double x, double y) const
  {
    return picture_.at(static_cast<int>(x0_ + x * scale_),
                       static_cast<int>(y0_ - y * scale_));
  }
  /// The darkest pixel within one pixel: the middle of a line.
  Pixel darkest(double x, double y) const
  {
    Pixel best = at(x, y);
    for (const double dx : {-1, 0, 1})
      for (const double dy : {-1, 0, 1})
        best = std::min(best, at(x + dx / scale_, y + dy / scale_), isDarker);
    return best;
  }
  /// Share of the places on a straight line about which a colour is seen.
  double share(double ax, double ay, double bx, double by, const Pixel& colour) const
  {
    int found = 0;
    for (int i = 0; i < 1000; ++i)
      found += is(darkest(ax + (bx - ax) * i / 999, ay + (by - ay) * i / 999), colour);
    return found / 1000.0;
  }
  double scale() const { return scale_; }
  const Picture& picture() const { return picture_; }

private:
  static bool isDarker(const Pixel& a, const Pixel& b)
  {
    return a[0] + a[1] + a[2] < b[0] + b[1] + b[2];
  }
  /// The part in any light.
  static bool isReddish(const Pixel& p)
  {
    return p[0] - p[2] > 60 && p[0] - p[2] < 110 && p[0] - p[1] > 50;
  }
  /// From the first to after the last of those above 100.
  static std::pair<int, int> extent(const std::vector<int>& counts)
  {
    const auto many = [](int n) { return n > 100; };
    const auto first = std::find_if(counts.begin(), counts.end(), many);
    const auto last = std::find_if(counts.rbegin(), counts.rend(), many);
    return {first - counts.begin(), counts.rend() - last};
  }

  Picture picture_;
  double scale_, x0_, y0_;
};

} // namespace

TEST(LevelPicture, EveryPlaceHasTheColourOfWhatIsThere)
{
  const TemporaryFolder folder;
  const Drawn drawn(folder, Sample().scene);
  EXPECT_EQ(drawn.picture().width(), 900);
  EXPECT_EQ(drawn.picture().channels(), 3);
  EXPECT_NEAR(drawn.scale(), 21, 0.5); // 40 mm and a rim on 860 px
  EXPECT_PRED2(is, drawn.at(15, 15), kPart);
  EXPECT_GT(drawn.share(29, 15, 35, 15, kGap), 0.5);
  EXPECT_PRED2(is, drawn.at(-0.4, 15), kWhite);
  // The tool's radius is 2 mm: beside a row it mills, farther off stock stands.
  for (const double away : {-1.7, -0.7, 0.7, 1.7}) {
    EXPECT_PRED2(is, drawn.at(20, 3 + away), kMilled) << away;
    EXPECT_PRED2(is, drawn.at(20, 26 + away), kMilled) << away;
  }
  for (const double away : {-2.4, 2.4}) {
    EXPECT_PRED2(is, drawn.at(20, 3 + away), kStands) << away;
    EXPECT_PRED2(is, drawn.at(20, 26 + away), kStands) << away;
  }
}

TEST(LevelPicture, CutsAreColouredByTheirOrder)
{
  const TemporaryFolder folder;
  const Drawn drawn(folder, Sample().scene);
  EXPECT_PRED2(is, drawn.darkest(3.5, 3), kFirst);
  EXPECT_PRED2(is, drawn.darkest(35.5, 26), kLast);
  int before = -1; // ever greener
  for (const auto& [x, y] : {std::pair(4, 3), {23, 3}, {38, 5}, {8, 26}, {34, 26}}) {
    const Pixel p = drawn.darkest(x, y);
    EXPECT_GT(p[1], before) << x << " " << y;
    before = p[1];
  }
}

TEST(LevelPicture, TellsLinksAndRapidsFromCuts)
{
  const TemporaryFolder folder;
  const Drawn drawn(folder, Sample().scene);
  EXPECT_GT(drawn.share(25, 3, 37, 3, kLink), 0.98);
  EXPECT_EQ(drawn.share(4, 3, 23, 3, kLink), 0);
  // Dashes from (38, 7) to (4, 26), thin: no pixel is wholly black.
  int dark = 0;
  for (int i = 0; i < 1000; ++i) {
    const Pixel p = drawn.darkest(24 - 0.017 * i, 14.824 + 0.0095 * i);
    dark += p[0] < 0x90 && p[0] == p[2];
  }
  EXPECT_GT(dark, 300);
  EXPECT_LT(dark, 850);
  // A ring with a white middle where the tool comes down, twice.
  for (const double y : {3.0, 26.0}) {
    const double x = y < 10 ? 2 : 4;
    EXPECT_PRED2(is, drawn.at(x, y), kWhite);
    EXPECT_GT(drawn.share(x, y, x - 0.35, y, kBlack), 0.05) << y;
  }
}

TEST(LevelPicture, ShowsTheStockThatTheLevelFinds)
{
  const TemporaryFolder folder;
  Sample sample;
  const CellCloud standing =
      Sample::field([](double x, double) { return x < 25 ? 10.0 : 5.0; });
  sample.scene.standing = &standing;
  const Drawn drawn(folder, sample.scene);
  EXPECT_PRED2(is, drawn.at(22, 22.5), kStands);
  EXPECT_PRED2(is, drawn.at(28, 22.5), kAir);
  EXPECT_PRED2(is, drawn.at(28, 27), kAir) << "swept air is no milled stock";
}

TEST(LevelPicture, LeavesOtherLevelsOut)
{
  const TemporaryFolder folder;
  Sample sample;
  sample.add(23, 10, 15, Motion::Rapid, 1);
  sample.add(23, 10, 3, Motion::Plunge, 1);
  sample.add(23, 20, 3, Motion::Cut, 1);
  const Drawn first(folder, sample.scene);
  EXPECT_PRED2(is, first.at(23, 12), kStands);
  sample.scene.level = 1;
  const Drawn second(folder, sample.scene);
  EXPECT_PRED2(is, second.at(24, 12), kMilled);
  EXPECT_PRED2(is, second.at(20, 25), kStands);
  EXPECT_EQ(heightOfLevel(sample.path, 0), 5);
  EXPECT_EQ(heightOfLevel(sample.path, 1), 3);
  EXPECT_THROW(heightOfLevel(sample.path, 2), DataError);
}

TEST(LevelPicture, IsTheSameEveryTimeAndHasItsWidth)
{
  const TemporaryFolder folder;
  Sample sample;
  sample.path[5].x = std::nanf(""); // broken moves are left out
  sample.scene.title = std::string(300, 'w');
  sample.scene.figures.assign(30, "a figure that is rather long");
  writeLevel(folder.file("a.png"), sample.scene, 400);
  writeLevel(folder.file("b.png"), sample.scene, 400);
  EXPECT_EQ(Picture(folder.file("a.png")).width(), 400);
  EXPECT_EQ(readBytes(folder.file("a.png")), readBytes(folder.file("b.png")));
}

TEST(LevelPicture, RefusesWhatItCannotShow)
{
  const TemporaryFolder folder;
  const auto refuses = [&](auto change) {
    Sample sample;
    change(sample.scene);
    try {
      writeLevel(folder.file("level.png"), sample.scene);
    }
    catch (const DataError&) {
      return true;
    }
    return false;
  };
  EXPECT_FALSE(refuses([](LevelScene&) {}));
  std::filesystem::remove(folder.file("level.png"));
  const CellCloud empty;
  EXPECT_TRUE(refuses([](LevelScene& s) { s.map = nullptr; }));
  EXPECT_TRUE(refuses([](LevelScene& s) { s.path = nullptr; }));
  EXPECT_TRUE(refuses([&](LevelScene& s) { s.map = &empty; }));
  EXPECT_TRUE(refuses([&](LevelScene& s) { s.standing = &empty; }));
  EXPECT_TRUE(refuses([](LevelScene& s) { s.stock.max.x() = s.stock.min.x(); }));
  EXPECT_TRUE(refuses([](LevelScene& s) { s.stock.max.z() = NAN; }));
  EXPECT_TRUE(refuses([](LevelScene& s) { s.level = 7; }));
  Sample sample;
  EXPECT_THROW(writeLevel(folder.file("no/such.png"), sample.scene), DataError);
  EXPECT_THROW(writeLevel(folder.file("level.png"), sample.scene, 399), ParameterError);
  sample.scene.tool.diameter = -1;
  EXPECT_THROW(writeLevel(folder.file("level.png"), sample.scene), ParameterError);
  EXPECT_TRUE(folder.empty());
}
