// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "scallop.h"

#include <Eigen/Geometry>

namespace pointmill {
namespace {

using Eigen::Vector3d;

constexpr double kMostReach = 8; // stations to each side that a mean is taken of

/// The tool's way near a station, as a parabola in u through the neighbouring ones.
struct Way {
  Vector3d at;
  double slope, bend;

  Way(const Row& row, std::size_t i, double step)
      : at(static_cast<double>(i) * step, row.v, row[i].tip), slope(0), bend(0)
  {
    const bool before = i > 0 && row.has(i - 1), after = row.has(i + 1);
    const double here = row[i].tip;
    const double rise = after ? (row[i + 1].tip - here) / step : 0;
    const double fall = before ? (here - row[i - 1].tip) / step : 0;
    if (before && after) {
      slope = 0.5 * (rise + fall);
      bend = (rise - fall) / step;
    }
    else
      slope = rise + fall;
  }
  Vector3d tangent() const { return {1, 0, slope}; }
  Vector3d operator()(double du) const
  {
    return at + Vector3d(du, 0, (slope + 0.5 * bend * du) * du);
  }
  /// Where it crosses the plane through @p c with normal @p feed, as far as the
  /// parabola holds.
  Vector3d crossing(const Vector3d& c, const Vector3d& feed, double step) const
  {
    const double along = tangent().dot(feed);
    const double du = along > 0 ? (c - at).dot(feed) / along : 0;
    return (*this)(std::clamp(du, -step, step));
  }
};

Cusp cuspAt(
    const Row& low, const Row& middle, const Row& high, std::size_t i, double step)
{
  const Way here(middle, i, step);
  const Vector3d feed = here.tangent().normalized();
  const Vector3d a = Way(low, i, step).crossing(here.at, feed, step);
  const Vector3d b = Way(high, i, step).crossing(here.at, feed, step);
  const Vector3d across = (b - a) - (b - a).dot(feed) * feed;
  const double chord = across.norm();
  const Vector3d up = feed.cross(across / chord);
  const double farther = std::max((here.at - a).norm(), (here.at - b).norm());
  return {chord,
          (here.at - 0.5 * (a + b)).dot(up),
          farther / chord,
          low[i].touches && middle[i].touches && high[i].touches};
}

double shrink(double value, double by)
{
  return std::copysign(std::max(0.0, std::abs(value) - by), value);
}

/// Mean sagitta of the certain cusps within `reach` of each, and their number.
struct Mean {
  double value;
  std::size_t count;
};
Mean meanAround(const std::vector<Cusp>& cusps, std::size_t i, std::size_t reach)
{
  Mean mean{0, 0};
  const std::size_t last = std::min(cusps.size() - 1, i + reach);
  for (std::size_t k = i - std::min(i, reach); k <= last; ++k)
    if (cusps[k].certain) {
      mean.value += cusps[k].sagitta;
      ++mean.count;
    }
  mean.value /= static_cast<double>(std::max<std::size_t>(1, mean.count));
  return mean;
}

} // namespace

std::vector<Cusp> cusps(const Row& low, const Row& middle, const Row& high, double step)
{
  std::vector<Cusp> all;
  all.reserve(middle.stations.size());
  for (std::size_t k = 0; k < middle.stations.size(); ++k)
    all.push_back(cuspAt(low, middle, high, middle.first + k, step));
  return all;
}

double roughness(const std::vector<std::vector<Cusp>>& rows)
{
  std::vector<double> differences;
  for (const auto& row : rows)
    for (std::size_t i = 1; i + 1 < row.size(); ++i)
      if (row[i - 1].certain && row[i].certain && row[i + 1].certain)
        differences.push_back(
            std::abs(row[i - 1].sagitta - 2 * row[i].sagitta + row[i + 1].sagitta));
  if (differences.empty())
    return 0;
  const auto middle = differences.begin() + differences.size() / 2;
  std::nth_element(differences.begin(), middle, differences.end());
  // Of a normal distribution; the weights 1, -2, 1 multiply its deviation by sqrt(6).
  return 1.4826 * *middle / std::sqrt(6.0);
}

std::vector<double>
scallops(const std::vector<Cusp>& cusps, double r, double step, double noise)
{
  const auto reach =
      static_cast<std::size_t>(std::min(kMostReach, std::ceil(r / step)));
  std::vector<double> heights;
  heights.reserve(cusps.size());
  for (std::size_t i = 0; i < cusps.size(); ++i) {
    const Cusp& cusp = cusps[i];
    if (!(cusp.chord < 2 * r)) {
      heights.push_back(r);
      continue;
    }
    double sagitta = cusp.sagitta;
    if (cusp.certain) {
      const Mean mean = meanAround(cusps, i, reach);
      sagitta = std::abs(sagitta - mean.value) <= 3 * noise
                    ? shrink(mean.value,
                             2 * noise / std::sqrt(static_cast<double>(mean.count)))
                    : shrink(sagitta, 3 * noise);
    }
    const double half = cusp.chord / 2;
    heights.push_back(std::clamp(r - std::sqrt(r * r - half * half) - sagitta, 0.0, r));
  }
  return heights;
}

} // namespace pointmill
