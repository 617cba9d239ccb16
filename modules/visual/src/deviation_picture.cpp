// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "canvas_png.h"
#include "cell_sheet.h"
#include "cloud_extent.h"
#include "ruler.h"
#include <pointmill/visual/deviation_scale.h>

#include <pointmill/common/error.h>
#include <pointmill/common/parameters.h>
#include <pointmill/common/watch.h>
#include <pointmill/visual/deviation_picture.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace pointmill {
namespace {

using namespace visual;
using Points = pcl::PointCloud<pcl::PointXYZI>;

constexpr int kFinest = 1400; ///< cells along the longer side, at most
constexpr int kFoot = 284;    ///< px
constexpr int kScale = 170;   ///< px, of the histogram and its bar
constexpr int kBins = 60;     ///< of the histogram

/// What is shown: the points, and which of them a tool can reach.
struct Judged {
  bool reached(std::size_t i) const { return in_reach.empty() || in_reach[i]; }

  const Points& points;
  const std::vector<bool>& in_reach;
};

bool hasPlace(const pcl::PointXYZI& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

std::string text(const char* format, double value)
{
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

/// An empty map of square cells over a box, each at its centre.
CellCloud mapOver(const Eigen::AlignedBox3d& box, double cell)
{
  const auto count = [&](int axis) {
    return std::max(2, static_cast<int>(std::ceil(box.sizes()[axis] / cell)));
  };
  CellCloud map;
  map.width = count(0);
  map.height = count(1);
  map.resize(std::size_t(map.width) * map.height);
  map.width = count(0); // resize() made a row of it
  map.height = count(1);
  for (std::uint32_t r = 0; r < map.height; ++r)
    for (std::uint32_t c = 0; c < map.width; ++c) {
      map.at(c, r).x = static_cast<float>(box.min().x() + (c + 0.5) * cell);
      map.at(c, r).y = static_cast<float>(box.min().y() + (r + 0.5) * cell);
    }
  return map;
}

template <typename Body>
void eachPoint(const Points& points,
               const Eigen::AlignedBox3d& box,
               double cell,
               CellCloud& map,
               const Body& body)
{
  const auto index = [&](double value, double low, std::uint32_t count) {
    return std::min(static_cast<std::uint32_t>((value - low) / cell), count - 1);
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    checkInterrupted();
    const auto& p = points[i];
    if (hasPlace(p))
      body(map.at(index(p.x, box.min().x(), map.width),
                  index(p.y, box.min().y(), map.height)),
           i);
  }
}

/// Edge of a cell that nearly always holds a point where there is part [mm].
double cellFor(const Points& points, const Eigen::AlignedBox3d& box)
{
  constexpr int coarse = 100;
  const double longer = box.sizes().head<2>().maxCoeff(), edge = longer / coarse;
  CellCloud map = mapOver(box, edge);
  std::size_t count = 0, covered = 0;
  eachPoint(points, box, edge, map, [&](PointCell& cell, std::size_t) {
    ++count;
    covered += cell.count++ == 0;
  });
  const double area = static_cast<double>(covered) * edge * edge;
  return std::max(1.5 * std::sqrt(area / static_cast<double>(count)), longer / kFinest);
}

/// The deviation in reach that is farthest off in each cell, NaN where no tool came;
/// `count` tells these from cells without a point, the state Gap those that only hold
/// points out of reach.
CellCloud mapOf(const Judged& judged, const Eigen::AlignedBox3d& box, double edge)
{
  CellCloud map = mapOver(box, edge);
  eachPoint(judged.points, box, edge, map, [&](PointCell& cell, std::size_t i) {
    if (cell.count++ == 0)
      cell.setState(CellState::Gap);
    if (!judged.reached(i))
      return;
    cell.setState(CellState::Occupied);
    const float off = judged.points[i].intensity;
    if (!std::isnan(off) && !(std::abs(off) <= std::abs(cell.z)))
      cell.z = off;
  });
  return map;
}

/// Cells that just missed the points around them take the mean of their neighbours.
CellCloud closed(const CellCloud& map)
{
  checkInterrupted();
  CellCloud out = map;
  for (std::uint32_t r = 1; r + 1 < map.height; ++r)
    for (std::uint32_t c = 1; c + 1 < map.width; ++c) {
      if (map.at(c, r).count > 0)
        continue;
      int full = 0, known = 0, reached = 0;
      double sum = 0;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) {
          const PointCell& near = map.at(c + i, r + j);
          full += near.count > 0;
          reached += near.getState() == CellState::Occupied;
          if (near.count > 0 && std::isfinite(near.z)) {
            sum += near.z;
            ++known;
          }
        }
      if (full >= 5) {
        out.at(c, r).count = 1;
        out.at(c, r).setState(reached > 0 ? CellState::Occupied : CellState::Gap);
        out.at(c, r).z = known ? static_cast<float>(sum / known) : out.at(c, r).z;
      }
    }
  return out;
}

struct Figures {
  Figures(const Judged& judged, double tolerance)
  {
    checkInterrupted();
    for (std::size_t i = 0; i < judged.points.size(); ++i) {
      const auto& p = judged.points[i];
      if (!hasPlace(p))
        continue;
      ++all;
      hidden += !judged.reached(i);
      if (!judged.reached(i) || !std::isfinite(p.intensity))
        continue;
      values.push_back(p.intensity);
      kept += std::abs(static_cast<double>(p.intensity)) <= tolerance;
    }
    std::sort(values.begin(), values.end());
    std::vector<float> sizes;
    for (const float value : values)
      sizes.push_back(std::abs(value));
    if (sizes.empty())
      return;
    const std::size_t nearly_all = (sizes.size() - 1) * 99 / 100;
    std::nth_element(sizes.begin(), sizes.begin() + nearly_all, sizes.end());
    most = sizes[nearly_all];
  }
  std::size_t cut() const { return values.size(); }
  /// What @p percent of the deviations are below [mm].
  double below(std::size_t percent) const
  {
    return values[std::min(cut() - 1, cut() * percent / 100)];
  }
  static std::string share(std::size_t part, std::size_t of)
  {
    return text("%.1f %%", 100.0 * static_cast<double>(part) / static_cast<double>(of));
  }

  std::size_t all = 0, kept = 0;
  std::size_t hidden = 0;    ///< out of reach
  std::vector<float> values; ///< in reach and cut, ascending [mm]
  double most = 0;           ///< that 99 of 100 are at most off [mm]
};

/// A round length that is at least @p length.
double roundUp(double length)
{
  for (const double more : {1.0, 2.0, 2.5})
    if (niceLength(length * more) >= length)
      return niceLength(length * more);
  return length;
}

/// Histogram and bar of the colours, in a rectangle.
void drawScale(Canvas& canvas,
               const Rect& r,
               const std::vector<float>& values,
               const DeviationScale& scale)
{
  checkInterrupted();
  std::array<std::size_t, kBins> bins{};
  const auto share = [&](double deviation) { // 0 .. 1 along the bar
    return std::clamp(0.5 + 0.5 * deviation / scale.range, 0.0, 1.0);
  };
  for (const float value : values)
    ++bins[std::min(kBins - 1, static_cast<int>(share(value) * kBins))];
  const std::size_t highest = *std::max_element(bins.begin(), bins.end());
  constexpr int bar = 18, room = 34; // px, of the bar and of the numbers under it
  const int top = r.bottom() - room - bar;
  for (int x = 0; x < r.width; ++x) {
    const double at = (x + 0.5) / r.width;
    const Rgb colour = scale.at((2 * at - 1) * scale.range);
    canvas.fill({r.x + x, top, 1, bar}, colour);
    const std::size_t count = bins[std::min(kBins - 1, static_cast<int>(at * kBins))];
    const int height = static_cast<int>(
        std::ceil(static_cast<double>(top - r.y - 4) * static_cast<double>(count) /
                  static_cast<double>(std::max<std::size_t>(highest, 1))));
    canvas.fill({r.x + x, top - 4 - height, 1, height}, mix(colour, kInk, 0.12f));
  }
  const TextStyle style{16, false, kInk};
  // Left of its tick, about it, or right of it.
  const auto mark = [&](double deviation, double aside, const std::string& label) {
    const int x = r.x + static_cast<int>(std::lround(share(deviation) * r.width));
    canvas.fill({x - 1, top - 3, 2, bar + 9}, kInk);
    const int half = textWidth(label, style) / 2;
    drawText(canvas,
             x - half + static_cast<int>(aside * (half - 4)),
             top + bar + 18,
             label,
             style);
  };
  const int between = static_cast<int>(r.width * scale.tolerance / (2 * scale.range));
  mark(0, 0, between > 2 * style.size ? "0" : ""); // else told by what is about it
  mark(-scale.tolerance, -1, text("%.3g", -scale.tolerance));
  mark(scale.tolerance, 1, text("+%.3g", scale.tolerance));
  mark(-scale.range, 0, text("%.3g", -scale.range));
  mark(scale.range, 0, text("+%.3g mm", scale.range));
}

double rangeOf(const Figures& figures, double tolerance)
{
  return std::clamp(roundUp(figures.most), 4 * tolerance, 10 * tolerance);
}

} // namespace

double deviationRange(const pcl::PointCloud<pcl::PointXYZI>& deviation,
                      double tolerance)
{
  return rangeOf(Figures({deviation, {}}, tolerance), tolerance);
}

void writeDeviation(const std::string& path,
                    const pcl::PointCloud<pcl::PointXYZI>& deviation,
                    double tolerance,
                    const std::vector<bool>& in_reach,
                    const std::string& title)
{
  checkRange("picture of the deviation", "tolerance", tolerance, "mm", {1e-4, 10});
  const Eigen::AlignedBox3d box = boxOf(deviation);
  if (box.isEmpty() || !(box.sizes().head<2>().minCoeff() > 0))
    throw DataError("the deviation has no points that span an area");
  if (!in_reach.empty() && in_reach.size() != deviation.size())
    throw DataError("it is not known of each deviation whether it is in reach");
  const Judged judged{deviation, in_reach};
  const Figures figures(judged, tolerance);
  const DeviationScale scale{tolerance, rangeOf(figures, tolerance)};
  const CellCloud map = closed(mapOf(judged, box, cellFor(deviation, box)));
  const Grid grid(map, "the map of the deviation");
  CellSheet sheet(
      grid,
      title,
      [&](const PointCell& cell) {
        return cell.count == 0                     ? kPage
               : cell.getState() == CellState::Gap ? kOutOfReach
               : std::isnan(cell.z)                ? kNeverCut
                                                   : scale.at(cell.z);
      },
      kFoot);

  Canvas& canvas = sheet.canvas();
  const TextStyle style = CellSheet::text();
  const int x = sheet.left(), first = sheet.footMiddle();
  constexpr int line = 32; // px
  int row = 0;
  if (figures.cut() > 0) {
    const auto between = [&](const char* which, std::size_t low, std::size_t high) {
      return which + text(" %+.3f", figures.below(low)) +
             text(" to %+.3f mm", figures.below(high));
    };
    for (const auto& words :
         {"in reach: " + Figures::share(figures.kept, figures.cut()) +
              text(" within %.3g mm", tolerance),
          between("p5 to p95:", 5, 95),
          between("p1 to p99:", 1, 99)})
      drawText(canvas, x, first + ++row * line, words, style);
  }
  const auto counted = [&](const Rgb& colour, const char* what, std::size_t count) {
    const int y = first + ++row * line;
    canvas.fill({x, y - 9, 18, 18}, colour);
    drawText(canvas, x + 28, y, what + Figures::share(count, figures.all), style);
  };
  counted(kNeverCut, "no tool came: ", figures.all - figures.hidden - figures.cut());
  counted(kOutOfReach, "out of reach or covered: ", figures.hidden);
  if (figures.cut() > 0)
    drawText(canvas,
             x,
             first + ++row * line,
             "vertical distances, with the scan's noise in them; gouges are measured "
             "along the tool",
             {17, false, kFaintInk});
  constexpr int width = 440, end = 40; // px; half of the last number reaches over it
  drawScale(canvas,
            {sheet.right() - width - end, first - 16, width, kScale},
            figures.values,
            scale);
  writePng(path, canvas);
}

} // namespace pointmill
