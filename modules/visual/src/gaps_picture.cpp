// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "callouts.h"
#include "canvas_png.h"
#include "cell_sheet.h"
#include "cloud_extent.h"
#include "hatch.h"
#include "ruler.h"

#include <pointmill/common/error.h>
#include <pointmill/visual/gaps_picture.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

using namespace visual;

constexpr std::size_t kMostListed = 24;
constexpr int kLine = 32, kText = 74, kBetween = 40; // px, of the list

constexpr Rgb kBetweenGround = hex(0xF6E3EE), kBetweenInk = hex(0xD9A5C4);

struct Look {
  Hatch hatch;
  Rgb ground, ink;
  const char* name;
};

/// Holes look like what is milled, the others like what is protected.
const Look& lookOf(const GapRegion& gap)
{
  static const Look bridged{Hatch::Rising, kProtected, hex(0xD5DFE8), "bridged"};
  static const Look kept{Hatch::Crossed, kProtected, hex(0xD5DFE8), "stock kept"};
  static const Look milled{Hatch::Dots, kFree, kInk, "milled"};
  return gap.treatment == GapPolicy::Bridge ? bridged
         : gap.treatment == GapPolicy::Keep ? kept
                                            : milled;
}

/// As precise as the cells that it is counted in.
std::string areaText(double area)
{
  return number(area < 10 ? std::round(10 * area) / 10 : std::round(area)) +
         " mm\xC2\xB2";
}

std::string describe(const GapRegion& gap)
{
  return areaText(gap.area) + " " +
         (gap.kind == GapKind::ThroughHole ? "through hole" : "not scanned") + ", " +
         lookOf(gap).name;
}

Rgb pale(const PointCell& cell, const Light& light)
{
  if (!std::isfinite(cell.z))
    return kPage;
  const double share = (cell.z - light.low) / std::max(light.high - light.low, 1e-6);
  return mix(heightColour(static_cast<float>(share)), kPage, 0.6f);
}

/// Hatches the region's cells and draws a line where it ends.
void drawRegion(CellSheet& sheet, const Grid& grid, const GapRegion& gap)
{
  const Look& look = lookOf(gap);
  std::vector<unsigned char> in(grid.cells().size(), 0);
  for (const std::size_t at : gap.cells)
    in[at] = 1;
  const auto has = [&](int c, int r) {
    return c >= 0 && r >= 0 && c < grid.columns() && r < grid.rows() &&
           in[static_cast<std::size_t>(r) * grid.columns() + c] != 0;
  };
  Canvas& canvas = sheet.canvas();
  for (const std::size_t at : gap.cells)
    fillHatched(canvas,
                sheet.place(static_cast<int>(at) % grid.columns(),
                            static_cast<int>(at) / grid.columns()),
                look.hatch,
                look.ground,
                look.ink);
  constexpr int rim = 3; // px
  for (const std::size_t at : gap.cells) {
    const int c = static_cast<int>(at) % grid.columns();
    const int r = static_cast<int>(at) / grid.columns();
    const Rect here = sheet.place(c, r);
    for (const auto& [dc, dr] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      if (has(c + dc, r + dr))
        continue;
      // The side towards the neighbour, wherever columns and rows run in the picture.
      const int right = (grid.stepX() > 0) == (dc > 0) ? 1 : -1;
      const int down = (grid.stepY() > 0) == (dr > 0) ? -1 : 1;
      if (dc != 0)
        canvas.fill({right > 0 ? here.right() : here.x - rim,
                     here.y - rim,
                     rim,
                     here.height + 2 * rim},
                    kInk);
      else
        canvas.fill({here.x - rim,
                     down > 0 ? here.bottom() : here.y - rim,
                     here.width + 2 * rim,
                     rim},
                    kInk);
    }
  }
}

/// The middle of the region's box, or of its cell that is nearest to it [px].
Eigen::Vector2f middleOf(const CellSheet& sheet, const Grid& grid, const GapRegion& gap)
{
  std::vector<Eigen::Vector2f> cells;
  Eigen::AlignedBox2f box;
  for (const std::size_t at : gap.cells) {
    const Rect r = sheet.place(static_cast<int>(at) % grid.columns(),
                               static_cast<int>(at) / grid.columns());
    cells.emplace_back(r.x + 0.5f * r.width, r.y + 0.5f * r.height);
    box.extend(cells.back());
  }
  const Eigen::Vector2f middle = box.center();
  return *std::min_element(
      cells.begin(), cells.end(), [&](const auto& p, const auto& q) {
        return (p - middle).squaredNorm() < (q - middle).squaredNorm();
      });
}

/// The numbers of the first regions on white discs beside them.
void drawNumbers(CellSheet& sheet,
                 const Grid& grid,
                 const std::vector<GapRegion>& gaps,
                 std::size_t count)
{
  constexpr int half = 17; // px
  std::vector<Eigen::Vector2f> places;
  for (std::size_t i = 0; i < count; ++i)
    places.push_back(middleOf(sheet, grid, gaps[i]));
  const Rect last = sheet.place(grid.columns() - 1, 0);
  const Rect first = sheet.place(0, grid.rows() - 1);
  const int left = std::min(first.x, last.x),
            right = std::max(first.right(), last.right());
  const int top = std::min(first.y, last.y);
  const int bottom = std::max(first.bottom(), last.bottom());
  const auto discs =
      placeCallouts(places, {left, top, right - left, bottom - top}, 2 * half);
  Canvas& canvas = sheet.canvas();
  for (std::size_t i = 0; i < count; ++i)
    canvas.line(places[i].x(), places[i].y(), discs[i].x(), discs[i].y(), 2.f, kInk);
  const TextStyle style{20, true, kInk};
  for (std::size_t i = 0; i < count; ++i) {
    const int x = static_cast<int>(discs[i].x()), y = static_cast<int>(discs[i].y());
    canvas.fillRound(
        {x - half - 2, y - half - 2, 2 * half + 4, 2 * half + 4}, half + 2, kInk);
    canvas.fillRound({x - half, y - half, 2 * half, 2 * half}, half, kPage);
    const std::string text = std::to_string(i + 1);
    drawText(canvas, x - textWidth(text, style) / 2, y, text, style);
  }
}

} // namespace

void writeGaps(const std::string& path,
               const CellCloud& map,
               const std::vector<GapRegion>& gaps)
{
  const Grid grid(map, "the map of the gaps");
  const auto isOf = [](CellState state) {
    return [state](const PointCell& cell) { return cell.getState() == state; };
  };
  const auto between = std::count_if(map.begin(), map.end(), isOf(CellState::Between));
  const bool outside = std::any_of(map.begin(), map.end(), isOf(CellState::Empty));
  if (gaps.empty() && between == 0)
    throw DataError("there are no gaps to show");
  Light light;
  heightRange(map, light);
  double area = 0;
  for (const GapRegion& gap : gaps)
    area += gap.area;
  const std::size_t listed = std::min(gaps.size(), kMostListed);
  const TextStyle text = CellSheet::text();
  int column = kText; // px
  for (std::size_t i = 0; i < listed; ++i)
    column = std::max(column, kText + textWidth(describe(gaps[i]), text) + kBetween);
  const CellSheet probe(grid, "", [](const PointCell&) { return kPage; });
  const int columns = std::max(1, (probe.right() - probe.left() + kBetween) / column);
  const int lines = static_cast<int>(listed + columns - 1) / columns;
  const bool more = listed < gaps.size();
  CellSheet sheet(
      grid,
      (gaps.size() == 1 ? std::string("1 gap")
                        : std::to_string(gaps.size()) + " gaps") +
          " of the scan, " + areaText(area),
      [&](const PointCell& cell) { return pale(cell, light); },
      72 + (lines + more + (between > 0) + outside) * kLine + 16);
  if (between > 0)
    for (int r = 0; r < grid.rows(); ++r)
      for (int c = 0; c < grid.columns(); ++c)
        if (grid.cell(c, r).getState() == CellState::Between)
          fillHatched(sheet.canvas(),
                      sheet.place(c, r),
                      Hatch::Falling,
                      kBetweenGround,
                      kBetweenInk);
  for (const GapRegion& gap : gaps)
    drawRegion(sheet, grid, gap);
  drawNumbers(sheet, grid, gaps, listed);

  Canvas& canvas = sheet.canvas();
  const int top = sheet.footMiddle() + 50;
  for (std::size_t i = 0; i < listed; ++i) {
    const int x = sheet.left() + static_cast<int>(i) / lines * column;
    const int y = top + static_cast<int>(i) % lines * kLine;
    const Look& look = lookOf(gaps[i]);
    const std::string name = std::to_string(i + 1);
    drawText(canvas, x + 22 - textWidth(name, text), y, name, text);
    fillHatched(canvas, {x + 32, y - 11, 32, 22}, look.hatch, look.ground, look.ink);
    drawText(canvas, x + kText, y, describe(gaps[i]), text);
  }
  if (more)
    drawText(canvas,
             sheet.left(),
             top + lines * kLine,
             "and " + std::to_string(gaps.size() - listed) + " smaller ones",
             text);
  int row = lines + more;
  const auto key = [&](const std::string& words, const auto& paint) {
    const int y = top + row++ * kLine;
    const Rect box{sheet.left() + 32, y - 11, 32, 22};
    canvas.fill({box.x - 1, box.y - 1, box.width + 2, box.height + 2}, kFaintInk);
    paint(box);
    drawText(canvas, sheet.left() + kText, y, words, text);
  };
  if (between > 0) {
    const double cell = std::abs(grid.stepX() * grid.stepY());
    key("bridged between points, " + areaText(double(between) * cell),
        [&](const Rect& box) {
          fillHatched(canvas, box, Hatch::Falling, kBetweenGround, kBetweenInk);
        });
  }
  if (outside)
    key("outside the part's outline, cut as free",
        [&](const Rect& box) { canvas.fill(box, kPage); });
  writePng(path, canvas);
}

} // namespace pointmill
