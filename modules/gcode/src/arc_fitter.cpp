// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "arc_fit.h"

#include <pointmill/gcode/arc_fitter.h>

#include <algorithm>
#include <cmath>

namespace pointmill {

using namespace gcode;

namespace {

constexpr std::size_t longest_run = 512; // chords of one call
/// Far below what controls refuse: Grbl, the strictest, from 0.005 mm.
constexpr double largest_mismatch = 0.002; // mm

Eigen::Vector3d toVector(const MachinePosition& p)
{
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

MachinePosition toPosition(const Eigen::Vector3d& p)
{
  return {static_cast<std::int64_t>(p.x()),
          static_cast<std::int64_t>(p.y()),
          static_cast<std::int64_t>(p.z())};
}

/// The last of known + 1 .. @p most for which `good` holds, doubling and halving the
/// step; @p known where there is none.
template <typename Good>
std::size_t furthest(std::size_t known, std::size_t most, Good&& good)
{
  std::size_t best = known, bad = most + 1;
  for (std::size_t step = 1; best < most; step *= 2) {
    const std::size_t next = std::min(known + step, most);
    if (!good(next)) {
      bad = next;
      break;
    }
    best = next;
  }
  while (bad - best > 1) {
    const std::size_t middle = best + (bad - best) / 2;
    (good(middle) ? best : bad) = middle;
  }
  return best;
}

/// Feeds of the moves that become one: it has the lowest, or one a little below it.
class FeedRange {
public:
  FeedRange(const std::int64_t* feeds, std::size_t count, double drop)
      : highest_(*std::min_element(feeds, feeds + count))
  {
    const auto most = *std::max_element(feeds, feeds + count);
    lowest_ = static_cast<std::int64_t>(std::ceil((1.0 - drop) * double(most)));
  }
  bool empty() const { return lowest_ > highest_; }
  /// That of the call before, so that no F is written, if it may be.
  std::int64_t choose(std::int64_t before) const
  {
    return before >= lowest_ && before <= highest_ ? before : highest_;
  }

private:
  std::int64_t lowest_, highest_;
};

} // namespace

void ArcFitter::emitOne()
{
  const double scale = 1.0 / grid_.value(1);
  ArcLimits limits;
  limits.tolerance = tolerance_ * scale;
  limits.smallest_radius = smallest_radius_ * scale;
  limits.largest_radius = largest_radius_ * scale;
  limits.largest_sweep = largest_sweep_ * std::acos(-1.0) / 180;
  limits.steepest = std::tan(steepest_helix_ * std::acos(-1.0) / 180);
  limits.mismatch = largest_mismatch * scale;

  const std::size_t most = std::min(longest_run, run_.size() - 1 - first_);
  const auto line = [&](std::size_t n) { return Polyline{&run_[first_], n + 1}; };
  const auto feeds = [&](std::size_t n) {
    return FeedRange(&feeds_[first_ + 1], n, feed_drop_);
  };
  double deviation = 0.0;
  std::optional<MachineArc> arc;
  std::size_t count = furthest(1, most, [&](std::size_t n) {
    if (feeds(n).empty())
      return false;
    const double off = straightDeviation(line(n), limits.tolerance);
    if (!std::isfinite(off))
      return false;
    deviation = off;
    return true;
  });
  for (const ArcPlane plane : {ArcPlane::XY, ArcPlane::ZX, ArcPlane::YZ}) {
    if (!arcs_ || !planes_.has(plane))
      continue;
    count = furthest(count, most, [&](std::size_t n) {
      if (feeds(n).empty())
        return false;
      const auto fit = fitArc(line(n), plane, limits);
      if (!fit)
        return false;
      arc = fit->arc;
      deviation = fit->deviation;
      return true;
    });
  }

  feed_ = feeds(count).choose(feed_);
  if (arc) {
    const int w = PlaneAxes(arc->plane).w;
    statistics_.helices_out += run_[first_][w] != run_[first_ + count][w];
  }
  first_ += count;
  statistics_.largest_deviation =
      std::max(statistics_.largest_deviation, deviation / scale);
  if (arc) {
    ++statistics_.arcs_out;
    next_.arc(*arc, feed_);
  }
  else {
    ++statistics_.straights_out;
    next_.straight(toPosition(run_[first_]), feed_);
  }
  if (first_ > 4 * longest_run) { // seldom, so that what remains is seldom moved
    run_.erase(run_.begin(), run_.begin() + static_cast<std::ptrdiff_t>(first_));
    feeds_.erase(feeds_.begin(), feeds_.begin() + static_cast<std::ptrdiff_t>(first_));
    first_ = 0;
  }
}

void ArcFitter::flush()
{
  while (first_ + 1 < run_.size())
    emitOne();
}

void ArcFitter::startAt(const MachinePosition& at)
{
  flush();
  run_.assign(1, toVector(at));
  feeds_.assign(1, 0);
  first_ = 0;
}

void ArcFitter::begin(const ProgramHead& head)
{
  validateParameters(*this, "ArcFitter");
  next_.begin(head);
}

void ArcFitter::comment(const std::string& text)
{
  flush();
  next_.comment(text);
}

void ArcFitter::operation(std::size_t number, const std::string& name)
{
  flush();
  next_.operation(number, name);
}

void ArcFitter::stop()
{
  flush();
  next_.stop();
}

void ArcFitter::retract()
{
  flush();
  run_.clear();
  next_.retract();
}

void ArcFitter::changeTool(int number)
{
  flush();
  run_.clear();
  next_.changeTool(number);
}

void ArcFitter::spindle(long rpm)
{
  flush();
  next_.spindle(rpm);
}

void ArcFitter::coolant(bool on)
{
  flush();
  next_.coolant(on);
}

void ArcFitter::approach(const MachinePosition& to)
{
  startAt(to);
  next_.approach(to);
}

void ArcFitter::traverse(const MachinePosition& to)
{
  startAt(to);
  next_.traverse(to);
}

void ArcFitter::straight(const MachinePosition& to, std::int64_t feed)
{
  ++statistics_.straights_in;
  if (run_.empty()) { // from where is not known
    startAt(to);
    ++statistics_.straights_out;
    next_.straight(to, feed);
    return;
  }
  run_.push_back(toVector(to));
  feeds_.push_back(feed);
  if (run_.size() - 1 - first_ >= longest_run)
    emitOne();
}

void ArcFitter::arc(const MachineArc& arc, std::int64_t feed)
{
  startAt(arc.to);
  next_.arc(arc, feed);
}

void ArcFitter::dwell(double seconds)
{
  flush();
  next_.dwell(seconds);
}

void ArcFitter::end()
{
  flush();
  next_.end();
}

} // namespace pointmill
