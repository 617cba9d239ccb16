// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "picture.h"

#include <pointmill/common/error.h>
#include <pointmill/visual/deviation_picture.h>

#include <cmath>
#include <random>

using namespace pointmill;

namespace {

using Points = pcl::PointCloud<pcl::PointXYZI>;

const Pixel kTooDeep{0x8E, 0x0B, 0x22}, kLeft{0x0A, 0x3A, 0x70},
    kNone{0xF7, 0xF4, 0xEC}, kNeverCut{0x9D, 0xA5, 0xAD}, kOutOfReach{0xCD, 0xD3, 0xD8},
    kWhite{255, 255, 255};
constexpr int kFoot = 284; // px, under the map

/// 60 x 40 mm of points, about 0.5 mm apart; deviation(x, y).
template <typename Deviation>
Points plate(const Deviation& deviation)
{
  std::mt19937 random(1);
  const auto any = [&] { return static_cast<double>(random()) / random.max() - 0.5; };
  Points points;
  for (double y = 0.25; y < 40; y += 0.5)
    for (double x = 0.25; x < 60; x += 0.5) {
      pcl::PointXYZI p;
      p.x = static_cast<float>(x + 0.2 * any());
      p.y = static_cast<float>(y + 0.2 * any());
      p.z = 3.f;
      p.intensity = static_cast<float>(deviation(p.x, p.y));
      points.push_back(p);
    }
  return points;
}

/// Its map with places in mm.
class Drawn {
public:
  Drawn(const TemporaryFolder& folder,
        const Points& points,
        double tolerance,
        const std::vector<bool>& in_reach = {})
      : picture_((writeDeviation(folder.file("d.png"), points, tolerance, in_reach),
                  folder.file("d.png")))
  {
    // The map is all that is coloured between title and foot.
    left_ = picture_.width();
    top_ = picture_.height();
    for (int y = 84; y < picture_.height() - kFoot; ++y)
      for (int x = 0; x < picture_.width(); ++x)
        if (picture_.at(x, y) != kWhite) {
          left_ = std::min(left_, x);
          right_ = std::max(right_, x);
          top_ = std::min(top_, y);
          bottom_ = std::max(bottom_, y);
        }
  }
  Pixel at(double x, double y) const
  {
    return picture_.at(left_ + static_cast<int>((right_ - left_) * x / 60),
                       bottom_ - static_cast<int>((bottom_ - top_) * y / 40));
  }
  const Picture& picture() const { return picture_; }
  double ratio() const { return double(right_ - left_) / (bottom_ - top_); }

private:
  Picture picture_;
  int left_, top_, right_ = 0, bottom_ = 0;
};

} // namespace

TEST(DeviationPicture, EveryKindOfPlaceHasItsColour)
{
  const TemporaryFolder folder;
  const Drawn drawn(folder,
                    plate([](double x, double y) {
                      return x < 15   ? -0.5
                             : x < 30 ? 0.5
                             : x < 45 ? 0.0
                             : y < 20 ? std::nan("")
                                      : 0.04;
                    }),
                    0.05);
  EXPECT_NEAR(drawn.ratio(), 1.5, 0.03);
  EXPECT_EQ(drawn.at(7, 30), kTooDeep);
  EXPECT_EQ(drawn.at(22, 10), kLeft);
  EXPECT_EQ(drawn.at(37, 20), kNone);
  EXPECT_EQ(drawn.at(52, 10), kNeverCut);
  // Within the tolerance it is pale, bluish for what is left.
  const Pixel pale = drawn.at(52, 30);
  EXPECT_GT(pale[2], pale[0]);
  EXPECT_GT(pale[0], 200);
}

TEST(DeviationPicture, TheToleranceIsAJump)
{
  const TemporaryFolder folder;
  const Drawn drawn(
      folder, plate([](double x, double) { return x < 30 ? 0.0495 : 0.0505; }), 0.05);
  EXPECT_GT(drawn.at(15, 20)[0], drawn.at(45, 20)[0] + 50);
}

TEST(DeviationPicture, TheFarthestOffIsSeenInACell)
{
  const TemporaryFolder folder;
  Points points = plate([](double, double) { return 0.001; });
  const Points same = points;
  for (const auto& p : same) {
    points.push_back(p);
    points.back().intensity = p.y < 20 ? -0.5f : std::nanf("");
  }
  const Drawn drawn(folder, points, 0.05);
  EXPECT_EQ(drawn.at(30, 10), kTooDeep);
  EXPECT_GT(drawn.at(30, 30)[0], 240); // a tool came, if not to all
}

TEST(DeviationPicture, WhatIsCoveredHidesNothing)
{
  const TemporaryFolder folder;
  Points points = plate([](double, double) { return 0.0; });
  std::vector<bool> in_reach;
  for (const auto& p : points)
    in_reach.push_back(p.x < 40);
  const std::size_t upper = points.size();
  for (std::size_t i = 0; i < upper; ++i) { // the underside of a closed part
    points.push_back(points[i]);
    points.back().z = -20.f;
    points.back().intensity = 20.f;
    in_reach.push_back(false);
  }
  const Drawn all(folder, points, 0.05), drawn(folder, points, 0.05, in_reach);
  EXPECT_EQ(all.at(20, 20), kLeft);
  EXPECT_EQ(drawn.at(20, 20), kNone);
  EXPECT_EQ(drawn.at(50, 20), kOutOfReach);
  // Nor is it in the histogram.
  const auto foot = [&](const Picture& p) {
    return p.count(p.width() / 2,
                   p.width(),
                   p.height() - kFoot,
                   p.height() - 144,
                   [](const Pixel& at) { return at[2] > at[0] + 60; });
  };
  const Drawn good(folder, plate([](double, double) { return 0.0; }), 0.05);
  EXPECT_EQ(foot(drawn.picture()), foot(good.picture()));
  EXPECT_GT(foot(all.picture()), foot(good.picture()) + 100);
}

TEST(DeviationPicture, TheHistogramShowsTheShares)
{
  const TemporaryFolder folder;
  const auto foot = [&](double share, const Pixel& colour) {
    const Drawn drawn(
        folder,
        plate([&](double x, double) { return x < 60 * share ? -0.5 : 0.5; }),
        0.05);
    const Picture& p = drawn.picture();
    return p.count(
        0, p.width(), p.height() - kFoot, p.height() - 144, [&](const Pixel& at) {
          return std::abs(at[0] - colour[0]) + std::abs(at[1] - colour[1]) +
                     std::abs(at[2] - colour[2]) <
                 60;
        });
  };
  // The highest column is as high as there is room, the other in proportion.
  const int few = foot(0.2, kTooDeep), many = foot(0.8, kTooDeep);
  EXPECT_GT(few, 100);
  EXPECT_NEAR(static_cast<double>(many) / few, 4, 1);
}

TEST(DeviationPicture, HolesOfThePartStayWhiteAndGapsBetweenPointsClose)
{
  const TemporaryFolder folder;
  std::mt19937 random(5);
  const auto any = [&] { return static_cast<double>(random()) / random.max(); };
  Points points;
  while (points.size() < 20000) { // not on a grid: some cells get none
    pcl::PointXYZI p;
    p.x = static_cast<float>(60 * any());
    p.y = static_cast<float>(40 * any());
    p.z = 0.f;
    p.intensity = -0.5f;
    if (std::hypot(p.x - 30, p.y - 20) > 8)
      points.push_back(p);
  }
  const Drawn drawn(folder, points, 0.05);
  EXPECT_EQ(drawn.at(30, 20), kWhite);
  int white = 0;
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j)
      white += drawn.at(2 + 18 * i / 99.0, 2 + 36 * j / 99.0) == kWhite;
  EXPECT_LT(white, 20); // of 10000; 7 % of the cells hold no point
}

TEST(DeviationPicture, TakesWhatNoToolCameTo)
{
  const TemporaryFolder folder;
  const Drawn drawn(folder, plate([](double, double) { return std::nan(""); }), 0.05);
  EXPECT_EQ(drawn.at(30, 20), kNeverCut);
}

TEST(DeviationPicture, RefusesWhatItCannotShow)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("d.png");
  const Points points = plate([](double, double) { return 0.0; });
  EXPECT_THROW(writeDeviation(path, Points(), 0.05), DataError);
  EXPECT_THROW(writeDeviation(path, points, 0), ParameterError);
  EXPECT_THROW(writeDeviation(path, points, 0.05, {true, false}), DataError);
  EXPECT_THROW(writeDeviation(path, points, std::nan("")), ParameterError);
  EXPECT_THROW(writeDeviation(folder.file("no/such.png"), points, 0.05), DataError);
  Points row;
  for (const auto& p : points)
    if (p.y == points[0].y)
      row.push_back(p);
  EXPECT_THROW(writeDeviation(path, row, 0.05), DataError);
  EXPECT_TRUE(folder.empty());
}
