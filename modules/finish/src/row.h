// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/finish/raster.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pointmill {

/// `count` places that cover [low, high] evenly, at most `step` apart.
struct Places {
  double low, step;
  std::size_t count;
  Places(double from, double to, double most)
      : low(from), step(most),
        count(static_cast<std::size_t>(std::ceil(std::max(0.0, to - from) / most)) + 1)
  {
    if (count > 1)
      step = (to - from) / static_cast<double>(count - 1);
  }
  double operator[](std::size_t i) const { return low + static_cast<double>(i) * step; }
};

/// The raster's own coordinates: u along the rows, v across them, to their left.
struct RowFrame {
  Eigen::Vector2d along, across;

  explicit RowFrame(double degrees);
  Eigen::Vector2d xy(double u, double v) const { return u * along + v * across; }
  /// The extent along @p axis of the rectangle low .. high.
  static Span extent(const Eigen::Vector2d& axis,
                     const Eigen::Vector3d& low,
                     const Eigen::Vector3d& high);
};

/// The tool at one place of a row.
struct Station {
  double tip;            ///< the floor where the tool touches nothing
  float nx, ny;          ///< of the normal at the contact, in XY
  bool touches;          ///< and may be cut
  bool kept_out = false; ///< it touches, but a keep-out zone is too near
};

/// Stations `first` .. `last` of a row, both included.
struct Stretch {
  std::size_t first, last;
};

/// The tool at consecutive stations of one row.
struct Row {
  double v = 0;
  std::size_t first = 0;
  std::vector<Station> stations;

  bool has(std::size_t i) const { return i >= first && i - first < stations.size(); }
  const Station& operator[](std::size_t i) const { return stations[i - first]; }
};

/// A cut piece of a row, in the sense of u.
struct Pass {
  double v;
  CLCloud path;
};

/// Drops rows onto the surface and cuts passes from them.
class RowMaker {
public:
  RowMaker(const SurfaceModel& surface, const Raster& raster, double degrees);

  const RowFrame& frame() const { return frame_; }
  /// Where rows may lie, across them.
  Span width() const { return width_; }
  /// The stations that all rows share.
  const Places& stations() const { return stations_; }

  Row drop(double v, Stretch stretch) const;

  /// The parts of @p stretch of the row at @p v that lie inside the boundary, to the
  /// next stations outwards.
  std::vector<Stretch> within(double v, Stretch stretch) const;

  /// Adds the passes of that stretch of @p row: inside the boundary, whose ends they
  /// meet exactly, wherever the tool touches and keeps out of all zones.
  /// @return length that it would have cut if there were no zones [mm]
  double cut(const Row& row, Stretch stretch, std::vector<Pass>& passes) const;

private:
  struct Place {
    double u;
    Station station;
  };

  Station dropAt(double u, double v) const;
  Station stationOf(double u, double v, const Contact& contact) const;
  bool clear(double u0, double u1, double v) const;
  bool clear(const Place& a, const Place& b, double v) const;
  Place rim(Place touching, double apart, double v) const;
  void add(const Place& place, double v, CLCloud& path) const;

  const SurfaceModel& surface_;
  Tool grown_;
  double allowance_, floor_;
  Boundary boundary_;
  KeepOut keep_out_;
  CutterProfile cutter_;
  RowFrame frame_;
  Span width_;
  Places stations_;
};

} // namespace pointmill
