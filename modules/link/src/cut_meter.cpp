// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "steps.h"

#include <pointmill/link/cut_meter.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

/// A layer thinner than this is not cut but rounding [mm].
constexpr double kTouch = 0.01;
/// A layer on less ground than the square of this share of the end's diameter is a
/// splinter, and so is what stands this many times higher than the mean of the ground
/// that is cut with it: under a ball the middle of a layer is twice its mean.
constexpr double kSplinter = 0.05, kOverMean = 2.0;

} // namespace

CutMeter::CutMeter(const Tool& tool, StockField& stock)
    : tool_(tool), stock_(stock), reach_(tool.endDiameter() / 4)
{
}

double
CutMeter::cut(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Motion motion)
{
  const double length = (to - from).norm(), run = (to - from).head<2>().norm();
  const bool entry = motion == Motion::Plunge || motion == Motion::Ramp;
  if (entry != entry_)
    window_.clear();
  entry_ = entry;
  const int pieces = std::max(1, static_cast<int>(std::ceil(length / reach_ - 1e-6)));
  double thickest = 0;
  Eigen::Vector3d at = from;
  for (int i = 1; i <= pieces; ++i) {
    const Eigen::Vector3d next = from + (to - from) * (double(i) / pieces);
    const Cut taken = stock_.cut(tool_, at, next);
    const bool cuts = taken.depth > kTouch;
    (cuts ? figures_.material_length : figures_.air_length) += length / pieces;
    figures_.volume += taken.volume;
    if (cuts && !entry) {
      area_ += std::min(taken.area, tool_.diameter * run / pieces);
      run_ += run / pieces;
    }
    thickest = std::max(
        thickest,
        add({length / pieces, run / pieces, taken.area, taken.volume, taken.axial},
            entry));
    at = next;
  }
  figures_.mean_radial = run_ > 0 ? area_ / run_ : 0.0;
  return thickest;
}

double CutMeter::add(const Piece& piece, bool entry)
{
  window_.push_back(piece);
  Piece sum{};
  auto first = window_.end();
  while (first != window_.begin() && sum.length < reach_ * (1 - 1e-6)) {
    --first;
    sum.length += first->length;
    sum.run += first->run;
    sum.area += first->area;
    sum.volume += first->volume;
    sum.axial = std::max(sum.axial, first->axial);
  }
  window_.erase(window_.begin(), first);
  const double splinter = kSplinter * tool_.endDiameter();
  if (sum.area > splinter * splinter)
    figures_.max_axial = std::max(
        figures_.max_axial, std::min(sum.axial, kOverMean * sum.volume / sum.area));
  // Less way than the reach says too little: a single cell would be a wide cut.
  if (!entry)
    figures_.max_radial =
        std::max(figures_.max_radial,
                 std::min(tool_.diameter, sum.area / std::max(sum.run, reach_)));
  return sum.volume / std::max(sum.length, reach_);
}

CutFigures measureCut(const CLCloud& path, const Tool& tool, StockField& stock)
{
  CutMeter meter(tool, stock);
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (isRapid(path[i].getMotion()))
      meter.lift();
    else
      meter.cut(position(path[i - 1]), position(path[i]), path[i].getMotion());
  }
  return meter.figures();
}

} // namespace pointmill
