// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "height_field.h"

#include <pointmill/common/watch.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pointmill::visual {

namespace {

constexpr double kSteep = 2.0; // rise per run from which a quad is a wall

/// Slope from the two differences at a cell: their mean on smooth ground, the gentler
/// one at an edge, so that edges stay crisp.
double slope(float before, float here, float after, double step)
{
  const double back = (static_cast<double>(here) - before) / step;
  const double ahead = (static_cast<double>(after) - here) / step;
  if (std::isnan(back))
    return std::isnan(ahead) ? 0.0 : ahead;
  if (std::isnan(ahead))
    return back;
  if (std::abs(ahead - back) < 0.7)
    return 0.5 * (ahead + back);
  return std::abs(ahead) < std::abs(back) ? ahead : back;
}

class Painter {
public:
  Painter(Frame& frame, const Camera& camera, const Grid& grid, const FieldLook& look)
      : frame_(frame), camera_(camera), grid_(grid),
        look_(look), rows_{std::vector<Vertex>(grid.columns()),
                           std::vector<Vertex>(grid.columns())},
        full_{std::vector<char>(grid.columns() + 1, 0),
              std::vector<char>(grid.columns() + 1, 0)}
  {
  }

  void run()
  {
    project(0);
    for (int r = 0; r < grid_.rows(); ++r) {
      checkInterrupted();
      if (r + 1 < grid_.rows())
        project(r + 1);
      std::vector<char>& full = full_[r & 1];
      for (int c = 0; c + 1 < grid_.columns(); ++c)
        full[c + 1] = isQuad(c, r);
      for (int c = 0; c + 1 < grid_.columns(); ++c)
        if (full[c + 1])
          quad(c, r);
      if (look_.raw != Surface::None)
        outerWalls(r);
    }
  }

private:
  // full_[r & 1][c + 1]: whether the quad right of and above cell (c, r) exists.
  bool isQuad(int c, int r) const
  {
    return std::isfinite(grid_.z(c, r) + grid_.z(c + 1, r) + grid_.z(c, r + 1) +
                         grid_.z(c + 1, r + 1));
  }

  void project(int r)
  {
    for (int c = 0; c < grid_.columns(); ++c) {
      const float z = grid_.z(c, r);
      if (!std::isfinite(z))
        continue;
      Vertex& v = rows_[r & 1][c];
      v.at = camera_.project(grid_.x(c), grid_.y(r), z);
      const double gx = slope(grid_.z(c - 1, r), z, grid_.z(c + 1, r), grid_.stepX());
      const double gy = slope(grid_.z(c, r - 1), z, grid_.z(c, r + 1), grid_.stepY());
      v.normal = camera_.toView(Eigen::Vector3d(-gx, -gy, 1.0).normalized());
    }
  }

  Surface look(int c, int r) const
  {
    bool gap = false, raw = true;
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        const PointCell& cell = grid_.cell(c + i, r + j);
        gap |= cell.getState() == CellState::Gap;
        raw &= cell.z >= look_.raw_z;
      }
    if (gap && look_.gap != Surface::None)
      return look_.gap;
    return raw ? look_.raw : look_.top;
  }

  /// Direction in which the ground falls around a quad or an edge, seen over a few
  /// cells: the cells' staircase alone would make round walls flicker.
  Eigen::Vector3d fall(int c, int r, bool outline) const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const float here = grid_.z(c, r);
    for (int j = -2; j <= 3; ++j)
      for (int i = -2; i <= 3; ++i) {
        const float z = grid_.z(c + i, r + j);
        const double value = outline ? (std::isfinite(z) ? 1.0 : 0.0)
                                     : (std::isfinite(z) ? z - here : 0.0);
        sum -= value * Eigen::Vector3d(
                           (i - 0.5) * grid_.stepX(), (j - 0.5) * grid_.stepY(), 0.0);
      }
    return sum;
  }

  void quad(int c, int r)
  {
    const Surface what = look(c, r);
    if (what == Surface::None)
      return;
    Vertex a = rows_[r & 1][c], b = rows_[r & 1][c + 1];
    Vertex d = rows_[(r + 1) & 1][c], e = rows_[(r + 1) & 1][c + 1];
    const double za = grid_.z(c, r), zb = grid_.z(c + 1, r);
    const double zd = grid_.z(c, r + 1), ze = grid_.z(c + 1, r + 1);
    const double rise = std::max({za, zb, zd, ze}) - std::min({za, zb, zd, ze});
    const double run = std::min(std::abs(grid_.stepX()), std::abs(grid_.stepY()));
    if (rise > kSteep * run) {
      const Eigen::Vector3d down = fall(c, r, false);
      if (down.norm() > 0) {
        const Eigen::Vector3d n =
            down.normalized() * (rise / run) + Eigen::Vector3d::UnitZ();
        a.normal = b.normal = d.normal = e.normal = camera_.toView(n.normalized());
      }
    }
    // Along the diagonal that bends less.
    if (std::abs(za - ze) <= std::abs(zb - zd)) {
      frame_.triangle(a, b, e, what);
      frame_.triangle(a, e, d, what);
    }
    else {
      frame_.triangle(a, b, d, what);
      frame_.triangle(b, e, d, what);
    }
  }

  /// Walls where a quad ends and no other goes on.
  void outerWalls(int r)
  {
    const std::vector<char>&here = full_[r & 1], &below = full_[(r + 1) & 1];
    for (int c = 0; c < grid_.columns(); ++c) {
      const bool last_column = c + 1 == grid_.columns();
      const char now = last_column ? 0 : here[c + 1];
      const char under = last_column || r == 0 ? 0 : below[c + 1];
      if (!last_column && now != under)
        wall(rows_[r & 1][c], rows_[r & 1][c + 1], c, r);
      if (r + 1 < grid_.rows() && now != here[c])
        wall(rows_[r & 1][c], rows_[(r + 1) & 1][c], c, r);
    }
  }

  void wall(Vertex a, Vertex b, int c, int r)
  {
    a.normal = b.normal = camera_.toView(fall(c, r, true).normalized());
    Vertex a0 = foot(a), b0 = foot(b);
    frame_.triangle(a, b, b0, look_.raw);
    frame_.triangle(a, b0, a0, look_.raw);
  }

  Vertex foot(Vertex v) const
  {
    // Straight down: neither the pixel's column nor the distance over ground changes.
    const double z = camera_.heightAt(v.at.x(), v.at.y(), v.at.z());
    const double drop = std::max(0.0, z - look_.floor);
    v.at.y() += static_cast<float>(drop * camera_.up.z() * camera_.scale);
    v.at.z() -= static_cast<float>(drop * camera_.eye.z());
    return v;
  }

  Frame& frame_;
  const Camera& camera_;
  const Grid& grid_;
  const FieldLook& look_;
  std::array<std::vector<Vertex>, 2> rows_; // of rows r and r + 1
  std::array<std::vector<char>, 2> full_;
};

} // namespace

void drawField(Frame& frame,
               const Camera& camera,
               const Grid& grid,
               const FieldLook& look)
{
  Painter(frame, camera, grid, look).run();
}

} // namespace pointmill::visual
