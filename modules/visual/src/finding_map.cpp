// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "finding_map.h"

#include "badge.h"
#include "callouts.h"
#include "cloud_extent.h"
#include "plan.h"
#include "relief.h"
#include "ruler.h"
#include "ticks.h"

#include <cmath>

namespace pointmill::visual {

namespace {

using Place = Eigen::Vector2d;

/// Part and stock, and the findings that are not too far from them [mm].
Eigen::AlignedBox2d boxOf(const FindingScene& scene, const std::optional<Grid>& milled)
{
  Eigen::AlignedBox3d solid;
  if (scene.part)
    solid.extend(visual::boxOf(*scene.part));
  else if (milled)
    solid.extend(milled->box());
  Eigen::AlignedBox2d box;
  if (!solid.isEmpty())
    box = {Place(solid.min().head<2>()), Place(solid.max().head<2>())};
  if (((scene.stock.max - scene.stock.min).head<2>().array() > 0).all()) {
    box.extend(Place(scene.stock.min.head<2>()));
    box.extend(Place(scene.stock.max.head<2>()));
  }
  const double near = box.isEmpty() ? std::numeric_limits<double>::infinity()
                                    : 0.3 * box.sizes().norm();
  Eigen::AlignedBox2d all = box;
  for (const auto& mark : scene.findings)
    if (mark.place && mark.place->allFinite() &&
        (box.isEmpty() || box.exteriorDistance(Place(mark.place->head<2>())) < near))
      all.extend(Place(mark.place->head<2>()));
  if (all.isEmpty()) // nothing has a place
    all.extend(Place(0, 0));
  const double room = std::max(0.03 * all.sizes().maxCoeff(), 0.5);
  return {all.min() - Place(room, room), all.max() + Place(room, room)};
}

/// The box in the middle of a rectangle, at the largest scale.
Plan planOf(const Eigen::AlignedBox2d& box, Rect place)
{
  Plan plan;
  const Place size = box.sizes();
  plan.scale = std::min(place.width / size.x(), place.height / size.y());
  const int width = std::min(
      place.width, std::max(place.width / 8, int(std::lround(size.x() * plan.scale))));
  const int height =
      std::min(place.height,
               std::max(place.height / 8, int(std::lround(size.y() * plan.scale))));
  plan.place = {place.x + (place.width - width) / 2,
                place.y + (place.height - height) / 2,
                width,
                height};
  plan.corner = {box.center().x() - 0.5 * width / plan.scale,
                 box.center().y() + 0.5 * height / plan.scale};
  return plan;
}

class Painter {
public:
  Painter(Canvas& canvas, const Plan& plan, const FindingScene& scene, int unit)
      : canvas_(canvas), plan_(plan), scene_(scene), unit_(unit),
        thin_(std::max(1.f, 0.16f * static_cast<float>(unit)))
  {
  }

  void drawStock()
  {
    const Stock& stock = scene_.stock;
    if (!((stock.max - stock.min).head<2>().array() > 0).all())
      return;
    const Place a = stock.min.head<2>(), b = stock.max.head<2>();
    const Place corners[] = {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
    for (int i = 0; i < 4; ++i)
      line(corners[i], corners[(i + 1) % 4], thin_, kStockEdge);
  }

  void drawMoves()
  {
    for (const auto& mark : scene_.findings)
      for (std::size_t i = 1; i < mark.move.size(); ++i) {
        const Eigen::Vector3d &a = mark.move[i - 1], &b = mark.move[i];
        if (a.allFinite() && b.allFinite())
          cased(Place(a.head<2>()), Place(b.head<2>()), kRapid);
      }
  }

  /// The line along which a section is cut, and the tool's outline.
  void drawSection(const Section& section)
  {
    const double u = section.place().x();
    const double half = std::max(0.5 * section.width(), 3.0 * unit_ / plan_.scale);
    cased(section.plane().xy(u - half), section.plane().xy(u + half), kRapid);
    if (!section.tip())
      return;
    constexpr int pieces = 72;
    const Place middle = section.tip()->head<2>();
    const auto at = [&](int i) {
      const double angle = 2 * M_PI * i / pieces;
      return Place(middle +
                   section.tool()->radius() * Place(std::cos(angle), std::sin(angle)));
    };
    for (int i = 0; i < pieces; ++i)
      cased(at(i), at(i + 1), hex(0xE69F00));
  }

  void drawBadges()
  {
    std::vector<Eigen::Vector2f> points;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < scene_.findings.size(); ++i) {
      const auto& place = scene_.findings[i].place;
      if (!place || !place->allFinite())
        continue;
      points.push_back(onPlan(plan_.px(Place(place->head<2>()))));
      numbers.push_back(i);
    }
    const auto badges =
        placeCallouts(points, plan_.place, 3.2f * static_cast<float>(unit_));
    for (std::size_t k = 0; k < badges.size(); ++k) {
      stroke(points[k], badges[k], 2.5f * thin_, kPage);
      stroke(points[k], badges[k], thin_, kInk);
    }
    for (const auto& point : points) {
      stroke(point, point, 0.9f * static_cast<float>(unit_), kPage);
      stroke(point, point, 0.6f * static_cast<float>(unit_), kInk);
    }
    for (std::size_t k = 0; k < badges.size(); ++k)
      drawBadge(canvas_,
                static_cast<int>(std::lround(badges[k].x())),
                static_cast<int>(std::lround(badges[k].y())),
                numbers[k] + 1,
                scene_.findings[numbers[k]].warning,
                unit_);
  }

private:
  /// What lies outside of the plan is marked at its rim.
  Eigen::Vector2f onPlan(const Eigen::Vector2f& at) const
  {
    const Rect& r = plan_.place;
    const Eigen::Vector2f low(r.x + 2, r.y + 2), high(r.right() - 2, r.bottom() - 2);
    return at.cwiseMax(low).cwiseMin(high);
  }
  void stroke(const Eigen::Vector2f& a,
              const Eigen::Vector2f& b,
              float thickness,
              const Rgb& colour)
  {
    canvas_.line(a.x(), a.y(), b.x(), b.y(), thickness, colour);
  }
  void line(const Place& a, const Place& b, float thickness, const Rgb& colour)
  {
    stroke(plan_.px(a), plan_.px(b), thickness, colour);
  }
  /// Seen on any ground.
  void cased(const Place& a, const Place& b, const Rgb& colour)
  {
    line(a, b, 3 * thin_, kPage);
    line(a, b, 1.5f * thin_, colour);
  }

  Canvas& canvas_;
  const Plan& plan_;
  const FindingScene& scene_;
  int unit_;
  float thin_;
};

void drawHeights(Canvas& canvas, int x, int y, const Light& light, int unit)
{
  const TextStyle style{2 * unit, false, kInk};
  const int width = 12 * unit;
  for (int i = 0; i < width; ++i)
    canvas.fill({x + i, y - unit * 3 / 4, 1, unit * 3 / 2},
                heightColour(static_cast<float>(i) / static_cast<float>(width - 1)));
  drawText(canvas,
           x + width + unit,
           y,
           "height " + lowText(light) + " to " + highText(light),
           style);
}

} // namespace

void drawFindingMap(Canvas& canvas,
                    const Rect& card,
                    const FindingScene& scene,
                    const std::optional<Grid>& milled,
                    const std::vector<Section>& sections,
                    int unit)
{
  canvas.fillRound(card, static_cast<float>(unit) * 1.5f, kCard);
  const int left = card.x + 2 * unit, room = card.width - 4 * unit;
  drawText(canvas, left, card.y + 3 * unit, "from above", {unit * 5 / 2, true, kInk});
  const int foot = card.bottom() - 3 * unit, top = card.y + 6 * unit;
  const Plan plan = planOf(boxOf(scene, milled),
                           {left + kTicksLeft * unit,
                            top,
                            room - kTicksLeft * unit,
                            foot - top - (3 + kTicksBelow) * unit});
  const Light light = drawRelief(canvas, plan, scene.part, milled ? &*milled : nullptr);
  Painter painter(canvas, plan, scene, unit);
  canvas.clip(plan.place);
  painter.drawStock();
  painter.drawMoves();
  for (const Section& section : sections)
    painter.drawSection(section);
  canvas.unclip();
  painter.drawBadges();
  drawTicks(canvas, plan, "X", "Y", unit);
  const int used =
      drawScaleBar(canvas, left, foot, room / 4, plan.scale, {2 * unit, false, kInk});
  if (scene.part || milled)
    drawHeights(canvas, left + used + 3 * unit, foot, light, unit);
}

} // namespace pointmill::visual
