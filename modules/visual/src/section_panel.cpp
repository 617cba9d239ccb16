// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "section_panel.h"

#include "badge.h"
#include "plan.h"
#include "ruler.h"
#include "ticks.h"
#include "wrap.h"

#include <cmath>
#include <cstdio>

namespace pointmill::visual {

namespace {

using Body = ToolOutline::Body;

constexpr Rgb kMaterial = hex(0xD5DCE3);
constexpr Rgb kMaterialEdge = hex(0x7A8794);
constexpr Rgb kPartPoint = hex(0x0072B2);
constexpr Rgb kGougedPoint = kError;
constexpr Rgb kCutter = hex(0xE69F00);
constexpr Rgb kShank = hex(0x9A7B4F);
constexpr Rgb kHolder = hex(0x6B5B4B);
constexpr float kSheer = 0.45f; ///< how much the tool covers what is in it

Rgb colourOf(Body body)
{
  return body == Body::Holder ? kHolder : body == Body::Shank ? kShank : kCutter;
}

/// A length for people: as many digits as tell.
std::string millimetres(double length)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3f mm", length);
  return text;
}

void line(Canvas& canvas,
          const Eigen::Vector2f& a,
          const Eigen::Vector2f& b,
          float thickness,
          const Rgb& colour)
{
  canvas.line(a.x(), a.y(), b.x(), b.y(), thickness, colour);
}

void dashed(Canvas& canvas,
            const Eigen::Vector2f& a,
            const Eigen::Vector2f& b,
            float dash,
            float thickness)
{
  const float length = (b - a).norm();
  for (float at = 0; at < length; at += 1.7f * dash)
    line(canvas,
         a + (b - a) * (at / length),
         a + (b - a) * (std::min(at + dash, length) / length),
         thickness,
         kStockEdge);
}

/// An arrow's head with its point at @p at, that points along @p along.
void arrow(Canvas& canvas,
           const Eigen::Vector2f& at,
           const Eigen::Vector2f& along,
           float size,
           float thickness)
{
  const Eigen::Vector2f across(-along.y(), along.x());
  for (const float side : {-0.4f, 0.4f})
    line(canvas, at, at - size * (along - side * across), thickness, kInk);
}

class Painter {
public:
  Painter(Canvas& canvas, const Plan& plan, const Section& section, int unit)
      : canvas_(canvas), plan_(plan), section_(section), unit_(unit),
        thick_(std::max(1.5f, 0.22f * static_cast<float>(unit))),
        points_(section.points(grown()))
  {
  }
  void run()
  {
    canvas_.fill(plan_.place, kPage);
    canvas_.clip(plan_.place);
    drawMaterial();
    drawStock();
    drawTool();
    drawPoints();
    drawDimension();
    drawPlace();
    drawScale();
    canvas_.unclip();
  }

private:
  const Rect& place() const { return plan_.place; }

  void drawMaterial()
  {
    double last = std::numeric_limits<double>::quiet_NaN();
    for (int x = place().x; x < place().right(); ++x) {
      const double z = section_.milledAt(plan_.mm(x, 0).x());
      const float y = plan_.px(Eigen::Vector2d(0, z)).y();
      if (std::isfinite(z))
        for (int row = std::max(place().y, static_cast<int>(std::floor(y)));
             row < place().bottom();
             ++row)
          canvas_.blend(x, row, kMaterial, static_cast<float>(row) + 1 - y);
      const float before = plan_.px(Eigen::Vector2d(0, last)).y();
      if (std::isfinite(z) && std::isfinite(last))
        canvas_.line(static_cast<float>(x) - 0.5f,
                     before,
                     static_cast<float>(x) + 0.5f,
                     y,
                     thick_,
                     kMaterialEdge);
      last = z;
    }
  }

  void drawStock()
  {
    const auto box = section_.stock();
    if (!box)
      return;
    // Places far outside would take many dashes that nobody sees.
    const Eigen::AlignedBox2d seen = box->intersection(grown());
    if (seen.isEmpty())
      return;
    const Eigen::Vector2f a = plan_.px(seen.min()), b = plan_.px(seen.max());
    const float dash = 1.2f * static_cast<float>(unit_);
    for (const float x : {a.x(), b.x()})
      dashed(canvas_, {x, b.y()}, {x, a.y()}, dash, thick_);
    for (const float y : {a.y(), b.y()})
      dashed(canvas_, {a.x(), y}, {b.x(), y}, dash, thick_);
  }

  void drawTool()
  {
    if (!section_.tip())
      return;
    const auto scale = static_cast<float>(plan_.scale);
    for (int y = place().y; y < place().bottom(); ++y)
      for (int x = place().x; x < place().right(); ++x) {
        const Eigen::Vector2d p = plan_.mm(x, y);
        const float depth =
            static_cast<float>(section_.toolDepth(p.x(), p.y())) * scale;
        if (depth < -2 * thick_)
          continue;
        const Rgb colour = colourOf(section_.toolAt(p.x(), p.y()));
        canvas_.blend(x, y, colour, kSheer * std::clamp(depth + 0.5f, 0.f, 1.f));
        canvas_.blend(x,
                      y,
                      mix(colour, kInk, 0.45f),
                      std::clamp(0.5f * thick_ + 0.5f - std::abs(depth), 0.f, 1.f));
      }
  }

  void drawPoints()
  {
    const float apart = plan_.px(section_.reach());
    const auto unit = static_cast<float>(unit_);
    const float size = std::clamp(0.5f * apart, 0.35f * unit, 0.9f * unit);
    for (const bool inside : {false, true})
      for (const auto& p : points_)
        if (p.inside == inside) {
          const Eigen::Vector2f at = plan_.px(p.at);
          if (inside)
            line(canvas_, at, at, 1.5f * size, kPage);
          line(canvas_,
               at,
               at,
               inside ? 1.25f * size : size,
               inside ? kGougedPoint : kPartPoint);
        }
  }

  /// The place itself: a ring.
  void drawPlace()
  {
    const Eigen::Vector2f at = plan_.px(section_.place());
    const float radius = 0.8f * static_cast<float>(unit_);
    const int reach = static_cast<int>(radius + thick_ + 1);
    for (int y = static_cast<int>(at.y()) - reach; y <= at.y() + reach; ++y)
      for (int x = static_cast<int>(at.x()) - reach; x <= at.x() + reach; ++x) {
        const float away = std::hypot(static_cast<float>(x) + 0.5f - at.x(),
                                      static_cast<float>(y) + 0.5f - at.y());
        canvas_.blend(x, y, kInk, 0.5f * thick_ + 0.5f - std::abs(away - radius));
      }
  }

  void drawDimension()
  {
    if (!section_.dimension())
      return;
    const Dimension& d = *section_.dimension();
    const Eigen::Vector2f a = plan_.px(d.from), b = plan_.px(d.to);
    const float length = (b - a).norm(), head = 1.3f * static_cast<float>(unit_);
    const Eigen::Vector2f along =
        length > 0 ? Eigen::Vector2f((b - a) / length) : Eigen::Vector2f(0, 1);
    const Eigen::Vector2f across(-along.y(), along.x());
    line(canvas_, a, b, thick_, kInk);
    // A line across the end that is no point of the part.
    line(canvas_, b - head * across, b + head * across, thick_, kInk);
    if (length > 4 * head) {
      arrow(canvas_, a, -along, head, thick_);
      arrow(canvas_, b, along, head, thick_);
      drawLength(a, b, millimetres(d.length));
      return;
    }
    // From outside, where there is no room between.
    const Eigen::Vector2f before = a - 3 * head * along, after = b + 3 * head * along;
    line(canvas_, before, a, thick_, kInk);
    line(canvas_, b, after, thick_, kInk);
    arrow(canvas_, a, along, head, thick_);
    arrow(canvas_, b, -along, head, thick_);
    drawLength(before, after, millimetres(d.length));
  }

  /// Writes @p text beside the dimension line from @p a to @p b, where it covers
  /// neither the line nor, if there is such a place, points.
  void drawLength(const Eigen::Vector2f& a,
                  const Eigen::Vector2f& b,
                  const std::string& text)
  {
    const TextStyle style{unit_ * 12 / 5, true, kInk};
    const auto unit = static_cast<float>(unit_);
    const Eigen::Vector2f half(0.5f * static_cast<float>(textWidth(text, style)) + unit,
                               1.8f * unit);
    const Eigen::Vector2f middle = 0.5f * (a + b);
    Eigen::Vector2f best(static_cast<float>(place().right()) - half.x() - unit,
                         static_cast<float>(place().y) + half.y() + unit);
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    constexpr int directions = 12;
    for (const float away : {3.f, 5.f, 8.f})
      for (int i = 0; i < directions; ++i) {
        const float angle =
            2 * static_cast<float>(M_PI) * static_cast<float>(i) / directions;
        const Eigen::Vector2f at =
            middle + Eigen::Vector2f(std::cos(angle) * (half.x() + away * unit),
                                     std::sin(angle) * (half.y() + away * unit));
        if (!hasRoom(at, half + Eigen::Vector2f(unit, unit)) ||
            coversLine(at, half + Eigen::Vector2f(unit, unit), a, b))
          continue;
        const std::size_t covered = pointsUnder(at, half + Eigen::Vector2f(unit, unit));
        if (covered < fewest) {
          fewest = covered;
          best = at;
        }
      }
    line(canvas_, middle, best, 0.6f * thick_, kInk);
    const Rect box{static_cast<int>(best.x() - half.x()),
                   static_cast<int>(best.y() - half.y()),
                   static_cast<int>(2 * half.x()),
                   static_cast<int>(2 * half.y())};
    canvas_.fillRound(box, 0.6f * unit, kInk);
    const int rim = std::max(1, unit_ / 5);
    canvas_.fillRound(
        {box.x + rim, box.y + rim, box.width - 2 * rim, box.height - 2 * rim},
        0.5f * unit,
        kPage);
    drawText(canvas_, box.x + unit_, static_cast<int>(best.y()), text, style);
  }

  /// Whether a box about a place is in sight, and over the scale bar.
  bool hasRoom(const Eigen::Vector2f& at, const Eigen::Vector2f& half) const
  {
    const Rect& r = place();
    return at.x() - half.x() >= static_cast<float>(r.x) &&
           at.x() + half.x() <= static_cast<float>(r.right()) &&
           at.y() - half.y() >= static_cast<float>(r.y) &&
           at.y() + half.y() <= static_cast<float>(r.bottom() - 4 * unit_);
  }
  static bool coversLine(const Eigen::Vector2f& at,
                         const Eigen::Vector2f& half,
                         const Eigen::Vector2f& a,
                         const Eigen::Vector2f& b)
  {
    constexpr int pieces = 40;
    for (int i = 0; i <= pieces; ++i) {
      const Eigen::Vector2f p = a + (b - a) * (static_cast<float>(i) / pieces);
      if (((p - at).array().abs() < half.array()).all())
        return true;
    }
    return false;
  }
  std::size_t pointsUnder(const Eigen::Vector2f& at, const Eigen::Vector2f& half) const
  {
    return static_cast<std::size_t>(
        std::count_if(points_.begin(), points_.end(), [&](const Section::Point& p) {
          return ((plan_.px(p.at) - at).array().abs() < half.array()).all();
        }));
  }

  void drawScale()
  {
    const TextStyle style{2 * unit_, false, kInk};
    const int room = 18 * unit_, y = place().bottom() - 2 * unit_ - unit_ / 2;
    // Its size is known once it is drawn, here out of sight.
    const int used = drawScaleBar(
        canvas_, place().x, place().bottom() + 4 * unit_, room, plan_.scale, style);
    // To the right, where it would hide the end of the tool.
    const bool hides = section_.tip() && plan_.px(section_.tipPlace()).x() <
                                             static_cast<float>(place().x + room);
    const int x = hides ? place().right() - used - 2 * unit_ : place().x + 2 * unit_;
    canvas_.fillRound({x - unit_, y - unit_ * 3 / 2, used + 2 * unit_, 3 * unit_},
                      0.6f * static_cast<float>(unit_),
                      kPage);
    drawScaleBar(canvas_, x, y, room, plan_.scale, style);
  }

  /// What is seen, and a little more [mm].
  Eigen::AlignedBox2d grown() const
  {
    const Eigen::Vector2d low = plan_.mm(place().x, place().bottom());
    const Eigen::Vector2d high = plan_.mm(place().right(), place().y);
    const Eigen::Vector2d more = Eigen::Vector2d::Constant(2 * unit_ / plan_.scale);
    return {low - more, high + more};
  }

  Canvas& canvas_;
  const Plan& plan_;
  const Section& section_;
  int unit_;
  float thick_;
  std::vector<Section::Point> points_;
};

Plan planOf(const Section& section, const Rect& place)
{
  Plan plan;
  plan.place = place;
  plan.scale = std::min(place.width / section.width(),
                        place.height / (section.width() * Section::kHeightShare));
  const Eigen::Vector2d half(0.5 * place.width / plan.scale,
                             0.5 * place.height / plan.scale);
  // In the middle, but as much higher as what is below it needs.
  constexpr double below = 2 * 0.98 - 1; // of the half
  const double up = std::max(0.0, section.drop() - below * half.y());
  plan.corner = section.place() + Eigen::Vector2d(-half.x(), half.y() - up);
  return plan;
}

} // namespace

void drawSection(Canvas& canvas,
                 const Rect& card,
                 const Section& section,
                 std::size_t number,
                 int unit)
{
  const FindingMark& mark = section.mark();
  canvas.fillRound(card, static_cast<float>(unit) * 1.5f, kCard);
  const int left = card.x + 2 * unit, room = card.width - 4 * unit;
  const TextStyle code{unit * 5 / 2, true, kInk}, text{2 * unit, false, kInk},
      faint{2 * unit, false, kFaintInk};
  int y = card.y + 3 * unit;
  drawBadge(canvas, left + unit * 3 / 2, y, number, mark.warning, unit);
  const std::string tool =
      section.tool() ? fitText(section.tool()->describe(), room / 2, faint) : "";
  const int beside = 4 * unit, tool_room = textWidth(tool, faint);
  drawText(canvas, left + room - tool_room, y, tool, faint);
  drawText(canvas,
           left + beside,
           y,
           fitText(mark.code, room - beside - tool_room - 2 * unit, code),
           code);
  y += 3 * unit;
  for (const auto& row : wrapText(mark.text, room, 2, text)) {
    drawText(canvas, left, y, row, text);
    y += unit * 5 / 2;
  }
  if (!section.dimension() && !mark.note.empty())
    for (const auto& row : wrapText(mark.note, room, 2, text)) {
      drawText(canvas, left, y, row, text);
      y += unit * 5 / 2;
    }
  char reach[48];
  std::snprintf(reach, sizeof reach, ", points within %.2g mm", section.reach());
  drawText(canvas,
           left,
           y,
           fitText("section " + section.plane().where + reach, room, faint),
           faint);
  y += 2 * unit;
  const Rect place{left + kTicksLeft * unit,
                   y,
                   room - kTicksLeft * unit,
                   card.bottom() - y - (1 + kTicksBelow) * unit};
  const Plan plan = planOf(section, place);
  Painter(canvas, plan, section, unit).run();
  drawTicks(canvas, plan, section.plane().axis, "Z", unit);
}

Key sectionKey(const FindingScene& scene,
               const std::vector<Section>& sections,
               int room,
               int unit)
{
  const auto dot = [](const Rgb& colour) {
    return [colour](Canvas& canvas, const Rect& r) {
      const auto y = static_cast<float>(r.y) + 0.5f * static_cast<float>(r.height);
      const auto size = 0.6f * static_cast<float>(r.height);
      for (const float share : {0.2f, 0.8f}) {
        const float x = static_cast<float>(r.x) + share * static_cast<float>(r.width);
        canvas.line(x, y, x, y, size, colour);
      }
    };
  };
  const auto anyTool = [&](const auto& has) {
    return std::any_of(sections.begin(), sections.end(), [&](const Section& section) {
      return section.tip() && has(*section.tool());
    });
  };
  std::vector<Key::Item> items;
  if (scene.part) {
    items.push_back({"points of the part", 3 * unit, dot(kPartPoint)});
    if (anyTool([](const Tool&) { return true; }))
      items.push_back({"points inside the tool", 3 * unit, dot(kGougedPoint)});
  }
  if (scene.milled)
    items.push_back({"left of the stock", 2 * unit, paintBox(kMaterial)});
  const auto sheer = [](const Rgb& colour) { return mix(kPage, colour, kSheer); };
  if (anyTool([](const Tool&) { return true; }))
    items.push_back({"tool", 2 * unit, paintBox(sheer(kCutter))});
  if (anyTool([](const Tool& t) { return t.shank_diameter > 0; }))
    items.push_back({"shank", 2 * unit, paintBox(sheer(kShank))});
  if (anyTool([](const Tool& t) { return t.holder_diameter > 0; }))
    items.push_back({"holder", 2 * unit, paintBox(sheer(kHolder))});
  if (((scene.stock.max - scene.stock.min).array() > 0).all())
    items.push_back({"raw stock", 4 * unit, [unit](Canvas& canvas, const Rect& r) {
                       const auto y = static_cast<float>(r.y) +
                                      0.5f * static_cast<float>(r.height);
                       dashed(canvas,
                              {static_cast<float>(r.x), y},
                              {static_cast<float>(r.right()), y},
                              1.2f * static_cast<float>(unit),
                              0.22f * static_cast<float>(unit));
                     }});
  return {std::move(items), room, unit};
}

} // namespace pointmill::visual
