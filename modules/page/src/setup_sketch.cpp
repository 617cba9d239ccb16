// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "svg.h"
#include "view_field.h"

#include <pointmill/page/setup_sketch.h>
#include <pointmill/visual/palette.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pointmill {
namespace {

using svg::line;
using svg::print;
using svg::text;

/// All sizes in units of the SVG, of which the page is about 760 wide.
constexpr double kLeft = 94, kRight = 212, kTop = 82, kWide = 440, kHigh = 400;
constexpr double kBetween = 122;   ///< the views, with the dimension of the width
constexpr double kLeastWide = 180; ///< the views, for what is written beside them
constexpr double kArrow = 46;      ///< an axis of the datum
constexpr double kHeading = 60;    ///< of a view, above it and any arrow in it
constexpr double kLabel = 19;      ///< from one label to the next
constexpr double kNarrow = 62;     ///< dimensions have their length beside them
constexpr int kBands = 10;         ///< of heights
constexpr int kCells = 160;        ///< of the part's outline

std::string length(double value)
{
  return print("%.3f", value);
}

std::string height(double z)
{
  return print("Z%.3f", z + 0.0);
}

class Sketch {
public:
  explicit Sketch(const SetupScene& scene) : scene_(scene)
  {
    box_.extend(scene.stock.min.head<2>());
    box_.extend(scene.stock.max.head<2>());
    const Eigen::Vector2d size = box_.sizes();
    if (scene.keep_out) { // a zone far away must not make the stock tiny
      const Eigen::AlignedBox2d near(box_.min() - 0.4 * size, box_.max() + 0.4 * size);
      for (const auto& zone : scene.keep_out->zones()) {
        const Eigen::AlignedBox2d seen =
            near.intersection(Eigen::AlignedBox2d(zone.min(), zone.max()));
        if (!seen.isEmpty())
          box_.extend(seen);
      }
    }
    box_.extend(Eigen::Vector2d::Zero()); // the datum may be beside the stock
    low_ = std::min({scene.stock.min.z(), scene.lowest, 0.0});
    high_ = std::max({scene.clearance, scene.stock.max.z(), 0.0});
    scale_ =
        std::min(kWide / box_.sizes().x(), kHigh / (box_.sizes().y() + high_ - low_));
    wide_ = std::max(box_.sizes().x() * scale_, kLeastWide);
    front_ = kTop + box_.sizes().y() * scale_ + kBetween;
    // The names of the heights stand beside all that is drawn.
    names_ = std::max(kLeft + wide_ + 24, x(0) + kArrow + 22);
    bottom_ = front_ + (high_ - low_) * scale_;
  }

  Html draw()
  {
    outline();
    top();
    front();
    heights();
    datum(x(0), z(0), "Z"); // over the lines of the heights
    const double wide = names_ + kRight, high = std::max(bottom_, last_) + 24;
    return Html::markup(
               print("<svg class=\"sketch\" viewBox=\"0 0 %.0f %.0f\" role=\"img\" "
                     "style=\"--wide:%.0fpx;--cut:%.3f\" "
                     "aria-label=\"Stock and part from above and from the front, with "
                     "the "
                     "datum, dimensions in mm\">\n",
                     wide,
                     high,
                     1.13 * wide,
                     wide / std::max(names_, dimensions_)) +
               "<defs><pattern id=\"hatch\" width=\"7\" height=\"7\" "
               "patternTransform=\"rotate(45)\" patternUnits=\"userSpaceOnUse\"><path "
               "class=\"hatch\" d=\"M0 0V7\"/></pattern>" +
               print("<clipPath id=\"sketch-top\"><rect x=\"%.1f\" y=\"%.1f\" "
                     "width=\"%.1f\" height=\"%.1f\"/></clipPath></defs>\n",
                     x(box_.min().x()),
                     y(box_.max().y()),
                     box_.sizes().x() * scale_,
                     box_.sizes().y() * scale_) +
               svg_ + "</svg>\n") +
           element("ul class=\"heights\"", list_);
  }

private:
  double x(double mm) const { return kLeft + (mm - box_.min().x()) * scale_ + shift(); }
  double y(double mm) const { return kTop + (box_.max().y() - mm) * scale_; }
  double z(double mm) const { return front_ + (high_ - mm) * scale_; }
  /// Narrow stock stands in the middle.
  double shift() const { return 0.5 * (wide_ - box_.sizes().x() * scale_); }

  void rectangle(const char* kind, double x0, double y0, double x1, double y1)
  {
    svg_ += print("<rect class=\"%s\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" "
                  "height=\"%.1f\"/>\n",
                  kind,
                  x0,
                  y0,
                  x1 - x0,
                  y1 - y0);
  }

  /// The part from above, in bands of its height, and its outline from the front.
  void outline()
  {
    if (!scene_.part)
      return;
    const Eigen::Vector2d low = scene_.part_min.head<2>(),
                          high = scene_.part_max.head<2>();
    const CellGrid grid = CellGrid::covering(
        low,
        high,
        std::max((high - low).maxCoeff() / kCells, CellGrid::of(*scene_.part).cell));
    const FieldValues heights = heightsAt(grid, *scene_.part);
    const double floor = scene_.part_min.z();
    const double band = std::max(scene_.part_max.z() - floor, 1e-6) / kBands;
    const auto bandOf = [&](int c, int r) {
      const float z = heights[grid.index(c, r)];
      return std::isfinite(z)
                 ? std::clamp(static_cast<int>((z - floor) / band), 0, kBands - 1)
                 : -1;
    };
    std::vector<std::string> bands(kBands);
    std::vector<double> profile(static_cast<std::size_t>(grid.columns), floor);
    const auto left = [&](int c) { return x(grid.x0 + c * grid.cell); };
    const auto right = [&](int c) { // the last column may reach over the part
      return x(std::min(grid.x0 + c * grid.cell, high.x()));
    };
    for (int r = 0; r < grid.rows; ++r) {
      const double bottom = y(grid.y0 + r * grid.cell),
                   top = y(std::min(grid.y0 + (r + 1) * grid.cell, high.y()));
      for (int begin = 0, c = 0; c < grid.columns; ++c) {
        const int here = bandOf(c, r);
        if (here >= 0) {
          auto& highest = profile[static_cast<std::size_t>(c)];
          highest = std::max<double>(highest, heights[grid.index(c, r)]);
        }
        if (c + 1 < grid.columns && bandOf(c + 1, r) == here)
          continue;
        if (here >= 0)
          bands[static_cast<std::size_t>(here)] += print("M%.1f %.1fH%.1fV%.1fH%.1fZ",
                                                         left(begin),
                                                         bottom,
                                                         right(c + 1),
                                                         top,
                                                         left(begin));
        begin = c + 1;
      }
    }
    for (int i = 0; i < kBands; ++i)
      if (!bands[static_cast<std::size_t>(i)].empty())
        above_ += "<path shape-rendering=\"crispEdges\" fill=\"" +
                  heightColour((i + 0.5) / kBands) + "\" d=\"" +
                  bands[static_cast<std::size_t>(i)] + "\"/>\n";
    before_ = print("<path class=\"part\" d=\"M%.1f %.1f", x(low.x()), z(floor));
    for (int c = 0; c < grid.columns; ++c)
      before_ +=
          print("V%.1fH%.1f", z(profile[static_cast<std::size_t>(c)]), right(c + 1));
    before_ += print("V%.1fZ\"/>\n", z(floor));
  }

  void part(const std::string& drawn, double x0, double y0, double x1, double y1)
  {
    if (drawn.empty())
      rectangle("part", x0, y0, x1, y1);
    svg_ += drawn;
  }

  void top()
  {
    const Stock& s = scene_.stock;
    svg_ += text(x(box_.min().x()), kTop - kHeading, "from above", "class=\"view\"");
    rectangle("stock", x(s.min.x()), y(s.max.y()), x(s.max.x()), y(s.min.y()));
    part(above_,
         x(scene_.part_min.x()),
         y(scene_.part_max.y()),
         x(scene_.part_max.x()),
         y(scene_.part_min.y()));
    rectangle("edge", x(s.min.x()), y(s.max.y()), x(s.max.x()), y(s.min.y()));
    zones();
    datum(x(0), y(0), "Y");
    const double below = y(box_.min().y()) + 30, beside = x(box_.min().x()) - 30;
    across(
        x(s.min.x()), x(s.max.x()), below, y(s.min.y()), length(s.max.x() - s.min.x()));
    upright(y(s.max.y()),
            y(s.min.y()),
            beside,
            x(s.min.x()),
            length(s.max.y() - s.min.y()));
    // Where the datum is no edge of the stock, how far it is from it.
    const double least = 5e-4;
    if (std::abs(s.min.x()) > least)
      across(x(std::min(0.0, s.min.x())),
             x(std::max(0.0, s.min.x())),
             y(box_.max().y()) - 16,
             y(0),
             length(std::abs(s.min.x())));
    if (std::abs(s.min.y()) > least) {
      dimensions_ = x(box_.max().x()) + 90;
      upright(y(std::max(0.0, s.min.y())),
              y(std::min(0.0, s.min.y())),
              x(box_.max().x()) + 22,
              x(0),
              length(std::abs(s.min.y())));
    }
  }

  void zones()
  {
    if (!scene_.keep_out || scene_.keep_out->empty())
      return;
    svg_ += "<g clip-path=\"url(#sketch-top)\">\n";
    int number = 0;
    std::string names;
    for (const auto& zone : scene_.keep_out->zones()) {
      const auto& corners = zone.corners();
      if (zone.radius() > 0)
        svg_ += print("<circle class=\"zone\" cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"/>\n",
                      x(corners[0].x()),
                      y(corners[0].y()),
                      zone.radius() * scale_);
      else {
        svg_ += "<polygon class=\"zone\" points=\"";
        for (const auto& c : corners)
          svg_ += print("%.1f,%.1f ", x(c.x()), y(c.y()));
        svg_ += "\"/>\n";
      }
      names += text(x((zone.min().x() + zone.max().x()) / 2),
                    y((zone.min().y() + zone.max().y()) / 2) + 4,
                    "K" + std::to_string(++number),
                    "class=\"zone-name\"");
    }
    svg_ += names + "</g>\n";
  }

  /// How high the zones are, as outlines: they stand before what matters.
  void zonesBefore()
  {
    if (!scene_.keep_out)
      return;
    int number = 0;
    for (const auto& zone : scene_.keep_out->zones()) {
      ++number;
      const double from = std::max(zone.min().x(), box_.min().x()),
                   to = std::min(zone.max().x(), box_.max().x());
      if (from >= to || zone.top() <= low_)
        continue;
      rectangle("zone-before", x(from), z(std::min(zone.top(), high_)), x(to), z(low_));
      svg_ += text(x((from + to) / 2),
                   z(zone.top()) - 4,
                   "K" + std::to_string(number),
                   "class=\"zone-name\"");
    }
  }

  void front()
  {
    const Stock& s = scene_.stock;
    svg_ +=
        text(x(box_.min().x()), front_ - kHeading, "from the front", "class=\"view\"");
    rectangle("stock", x(s.min.x()), z(s.max.z()), x(s.max.x()), z(s.min.z()));
    part(before_,
         x(scene_.part_min.x()),
         z(scene_.part_max.z()),
         x(scene_.part_max.x()),
         z(scene_.part_min.z()));
    rectangle("edge", x(s.min.x()), z(s.max.z()), x(s.max.x()), z(s.min.z()));
    zonesBefore();
    upright(z(s.max.z()),
            z(s.min.z()),
            x(box_.min().x()) - 30,
            x(s.min.x()),
            length(s.max.z() - s.min.z()));
  }

  /// The heights that matter, with their names beside the front view.
  void heights()
  {
    struct Mark {
      double z;
      std::string name;
      const char* kind;
    };
    std::vector<Mark> marks{{scene_.clearance, "clearance plane", "plane"},
                            {scene_.stock.max.z(), "top of the stock", "level"},
                            {0.0, "datum", "level"},
                            {scene_.lowest, "lowest tip", "tip"},
                            {scene_.stock.min.z(), "bottom of the stock", "level"}};
    std::stable_sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) {
      return a.z > b.z;
    });
    const double from = x(box_.min().x()) - 6, to = x(box_.max().x()) + 10;
    const double at = names_;
    // They stand apart, about where they belong.
    std::vector<double> places;
    for (const auto& mark : marks)
      places.push_back(
          std::max(z(mark.z), places.empty() ? front_ - 20 : places.back() + kLabel));
    for (std::size_t i = 0; i < marks.size(); ++i) {
      svg_ += line(marks[i].kind, from, z(marks[i].z), to, z(marks[i].z));
      svg_ += line("leader", to, z(marks[i].z), at - 5, places[i]);
      svg_ += text(at,
                   places[i] + 4.5,
                   height(marks[i].z) + "  " + marks[i].name,
                   "class=\"height\"");
      list_ += element(
          "li",
          Html::markup(std::string("<svg viewBox=\"0 0 40 8\" aria-hidden=\"true\">") +
                       line(marks[i].kind, 0, 4, 40, 4) + "</svg>") +
              height(marks[i].z) + "  " + marks[i].name);
    }
    last_ = places.back() + 8;
  }

  /// The mark of the datum, with its axes to the right and up.
  void datum(double px, double py, const char* up)
  {
    constexpr double r = 7, axis = kArrow;
    svg_ += "<g class=\"datum\">";
    svg_ += print("<path d=\"M%.1f %.1fh%.1fm-6 -4l6 4l-6 4M%.1f %.1fv%.1fm-4 6l4 "
                  "-6l4 6\"/>",
                  px,
                  py,
                  axis,
                  px,
                  py,
                  -axis);
    svg_ += print("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"/>", px, py, r);
    svg_ += print("<path class=\"quarter\" d=\"M%.1f %.1fh%.1fa%.1f %.1f 0 0 0 %.1f "
                  "%.1fzM%.1f %.1fh%.1fa%.1f %.1f 0 0 0 %.1f %.1fz\"/>",
                  px,
                  py,
                  r,
                  r,
                  r,
                  -r,
                  -r,
                  px,
                  py,
                  -r,
                  r,
                  r,
                  r,
                  r);
    svg_ +=
        text(px + axis + 5, py + 5, "X") + text(px + 6, py - axis + 8, up) + "</g>\n";
  }

  /// A dimension from x0 to x1 at the height y, of things at the height @p things.
  void across(double x0, double x1, double at, double things, const std::string& what)
  {
    const double beyond = at > things ? 5 : -5;
    svg_ += line("dimension", x0, things, x0, at + beyond) +
            line("dimension", x1, things, x1, at + beyond) +
            line("dimension", x0, at, x1, at) + tick(x0, at) + tick(x1, at);
    svg_ += x1 - x0 < kNarrow ? text(x1 + 9, at + 4, what)
                              : text((x0 + x1) / 2, at - 5, what, "class=\"length\"");
  }
  void upright(double y0, double y1, double at, double things, const std::string& what)
  {
    const double beyond = at > things ? 5 : -5;
    svg_ += line("dimension", things, y0, at + beyond, y0) +
            line("dimension", things, y1, at + beyond, y1) +
            line("dimension", at, y0, at, y1) + tick(at, y0) + tick(at, y1);
    if (y1 - y0 < kNarrow)
      svg_ += text(at + (beyond < 0 ? -9 : 9),
                   (y0 + y1) / 2 + 4.5,
                   what,
                   beyond < 0 ? "class=\"end\"" : "");
    else
      svg_ += text(at - 6,
                   (y0 + y1) / 2,
                   what,
                   print("class=\"length\" transform=\"rotate(-90 %.1f %.1f)\"",
                         at - 6,
                         (y0 + y1) / 2));
  }
  static std::string tick(double px, double py)
  {
    return line("tick", px - 4, py + 4, px + 4, py - 4);
  }

  const SetupScene& scene_;
  Eigen::AlignedBox2d box_;
  double low_ = 0, high_ = 0, scale_ = 1, front_ = 0, bottom_ = 0, last_ = 0;
  double wide_ = kWide;
  double names_ = 0, dimensions_ = 0; ///< where the heights' names begin, these end
  std::string svg_, above_, before_;
  Html list_; ///< of the heights, where there is no room for them in the drawing
};

} // namespace

Html setupSketch(const SetupScene& scene)
{
  return Sketch(scene).draw();
}

} // namespace pointmill
