// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "level_ground.h"

#include "grid.h"

#include <cmath>
#include <optional>
#include <vector>

namespace pointmill::visual {
namespace {

/// How much of each pixel the tool's end sweeps, 0 .. 1.
class Sweep {
public:
  Sweep(const Plan& plan, const LevelMoves& moves, double radius)
      : place_(plan.place),
        share_(static_cast<std::size_t>(place_.width) * place_.height, 0.f)
  {
    for (const auto& m : moves.moves)
      if (m.kind != MoveKind::Rapid)
        add(plan.px(m.from), plan.px(m.to), plan.px(radius));
  }
  float at(int x, int y) const { return share_[index(x, y)]; }

private:
  std::size_t index(int x, int y) const
  {
    return static_cast<std::size_t>(y - place_.y) * place_.width + (x - place_.x);
  }
  void add(const Eigen::Vector2f& a, const Eigen::Vector2f& b, float radius)
  {
    const Eigen::Vector2f along = b - a;
    const float length2 = std::max(along.squaredNorm(), 1e-12f);
    const float reach = radius + 1;
    const auto first = [&](float low, int from) {
      return std::max(from, static_cast<int>(std::floor(low - reach)));
    };
    const auto last = [&](float high, int to) {
      return std::min(to - 1, static_cast<int>(std::ceil(high + reach)));
    };
    const int right = last(std::max(a.x(), b.x()), place_.right());
    const int bottom = last(std::max(a.y(), b.y()), place_.bottom());
    for (int y = first(std::min(a.y(), b.y()), place_.y); y <= bottom; ++y)
      for (int x = first(std::min(a.x(), b.x()), place_.x); x <= right; ++x) {
        const Eigen::Vector2f p = Eigen::Vector2f(x + 0.5f, y + 0.5f) - a;
        const float t = std::clamp(p.dot(along) / length2, 0.f, 1.f);
        float& share = share_[index(x, y)];
        share = std::max(share,
                         std::clamp(radius + 0.5f - (p - t * along).norm(), 0.f, 1.f));
      }
  }

  Rect place_;
  std::vector<float> share_;
};

/// Places between the middles of a grid's cells, for a smooth outline of a set of them.
class Blend {
public:
  Blend(const Grid& grid, const Eigen::Vector2d& p)
  {
    const double u = (p.x() - grid.x(0)) / grid.stepX();
    const double v = (p.y() - grid.y(0)) / grid.stepY();
    column_ = static_cast<int>(std::floor(u));
    row_ = static_cast<int>(std::floor(v));
    u_ = u - column_;
    v_ = v - row_;
  }
  /// The mean of value(column, row) over the four cells around, by their nearness.
  template <typename Value>
  double operator()(Value&& value) const
  {
    return (1 - v_) *
               ((1 - u_) * value(column_, row_) + u_ * value(column_ + 1, row_)) +
           v_ * ((1 - u_) * value(column_, row_ + 1) +
                 u_ * value(column_ + 1, row_ + 1));
  }

private:
  int column_, row_;
  double u_, v_;
};

/// How much of a pixel is inside, where a set of cells blends to @p mean: 0.5 on its
/// outline.
float inside(double mean, double cell_px)
{
  return static_cast<float>(
      std::clamp((mean - 0.5) * std::max(cell_px, 1.0) + 0.5, 0.0, 1.0));
}

bool has(const Grid& grid, int column, int row)
{
  return column >= 0 && row >= 0 && column < grid.columns() && row < grid.rows();
}

/// Part that stands above the level; a gap whose height is not known is protected.
struct Above {
  const Grid& grid;
  double z;

  bool gap(int c, int r) const
  {
    return has(grid, c, r) && grid.cell(c, r).getState() == CellState::Gap &&
           !(grid.cell(c, r).z <= z);
  }
  bool part(int c, int r) const
  {
    return has(grid, c, r) && grid.cell(c, r).getState() != CellState::Gap &&
           grid.cell(c, r).z > z;
  }
};

/// Lighter or darker by the slope of the heights, lit from the upper left; in whole
/// tones, which keep the hue and the file small.
float light(const Grid& grid, const Blend& blend)
{
  const auto slope = [&](int dc, int dr) {
    return blend([&](int c, int r) {
      const double d = double(grid.z(c + dc, r + dr)) - grid.z(c - dc, r - dr);
      const double step = 2 * std::abs(dc ? grid.stepX() : grid.stepY());
      return std::isfinite(d) ? std::clamp(d / step, -2.0, 2.0) : 0.0;
    });
  };
  const double lit = (slope(1, 0) * (grid.stepX() > 0 ? 1 : -1) -
                      slope(0, 1) * (grid.stepY() > 0 ? 1 : -1)) /
                     std::sqrt(2.0);
  return static_cast<float>(std::round(3 * std::clamp(lit, -1.0, 1.0)) / (kTones - 1));
}

Rgb lit(const Rgb& colour, float light)
{
  return colour + Rgb{light, light, light};
}

} // namespace

Rgb gapColour(int x, int y)
{
  return (x + y) / 3 % 3 == 0 ? mix(kProtected, kPage, 0.45f) : kProtected;
}

void drawGround(Canvas& canvas,
                const Plan& plan,
                const LevelScene& scene,
                const LevelMoves& moves,
                double z)
{
  const Grid map(*scene.map, "the occupancy map");
  std::optional<Grid> standing;
  if (scene.standing)
    standing.emplace(*scene.standing, "the standing stock");
  const Sweep sweep(plan, moves, scene.tool.endDiameter() / 2);
  const Above above{map, z};
  const double map_px = plan.px(std::abs(map.stepX()));
  const Eigen::Vector2d low = scene.stock.min.head<2>(),
                        high = scene.stock.max.head<2>();
  for (int y = plan.place.y; y < plan.place.bottom(); ++y)
    for (int x = plan.place.x; x < plan.place.right(); ++x) {
      const Eigen::Vector2d at = plan.mm(x, y);
      const Blend blend(map, at);
      const float shade = light(map, blend);
      if ((at.array() >= low.array()).all() && (at.array() <= high.array()).all()) {
        float stands = z < scene.stock.top() ? 1.f : 0.f;
        if (standing)
          stands = inside(Blend(*standing, at)([&](int c, int r) {
                            c = std::clamp(c, 0, standing->columns() - 1);
                            r = std::clamp(r, 0, standing->rows() - 1);
                            return standing->z(c, r) > z + kTouch ? 1 : 0;
                          }),
                          plan.px(std::abs(standing->stepX())));
        const Rgb swept = lit(kSwept, shade);
        canvas.set(x,
                   y,
                   mix(mix(kCutAway, kStanding, stands),
                       mix(kCutAway, swept, stands),
                       sweep.at(x, y)));
      }
      const double part = blend([&](int c, int r) { return above.part(c, r); });
      const double gap = blend([&](int c, int r) { return above.gap(c, r); });
      if (part + gap > 0)
        canvas.blend(x,
                     y,
                     gap > part ? gapColour(x, y) : lit(kPartAbove, shade),
                     inside(part + gap, map_px));
    }
}

} // namespace pointmill::visual
