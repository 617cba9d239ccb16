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

/// The feeds that a call may have for the moves that it replaces: the lowest of them,
/// or a little less.
class FeedRange {
public:
  FeedRange(const std::int64_t* feeds, std::size_t count, double drop)
      : highest_(*std::min_element(feeds, feeds + count))
  {
    const auto fastest = static_cast<double>(*std::max_element(feeds, feeds + count));
    lowest_ = static_cast<std::int64_t>(std::ceil((1.0 - drop) * fastest));
  }
  bool empty() const { return lowest_ > highest_; }
  /// That of the call before, if it may be, so that no F is written.
  std::int64_t choose(std::int64_t before) const
  {
    return before >= lowest_ && before <= highest_ ? before : highest_;
  }

private:
  std::int64_t lowest_, highest_;
};

/// The call that replaces the most moves of a run, from its first one on.
class LongestCall {
public:
  /// @p feeds of the moves to points 1, 2, ... of @p run.
  LongestCall(const Polyline& run, const std::int64_t* feeds, double feed_drop)
      : run_(run), feeds_(feeds), feed_drop_(feed_drop)
  {
  }

  void tryStraight(double tolerance)
  {
    count_ = furthest(count_, run_.size - 1, [&](std::size_t n) {
      const double off = straightDeviation(line(n), tolerance);
      if (feeds(n).empty() || !std::isfinite(off))
        return false;
      deviation_ = off;
      return true;
    });
  }

  void tryArc(ArcPlane plane, const ArcLimits& limits)
  {
    count_ = furthest(count_, run_.size - 1, [&](std::size_t n) {
      if (feeds(n).empty())
        return false;
      const auto fit = fitArc(line(n), plane, limits);
      if (fit) {
        arc_ = fit->arc;
        deviation_ = fit->deviation;
      }
      return fit.has_value();
    });
  }

  std::size_t count() const { return count_; }
  const std::optional<MachineArc>& arc() const { return arc_; }
  double deviation() const { return deviation_; }
  FeedRange feeds() const { return feeds(count_); }

private:
  Polyline line(std::size_t n) const { return {run_.points, n + 1}; }
  FeedRange feeds(std::size_t n) const { return {feeds_, n, feed_drop_}; }

  Polyline run_;
  const std::int64_t* feeds_;
  double feed_drop_;
  std::size_t count_ = 1;
  std::optional<MachineArc> arc_; ///< none: straight
  double deviation_ = 0.0;
};

} // namespace

void ArcFitter::emitOne()
{
  const double scale = 1.0 / grid_.value(1); // ticks in a millimetre
  const double rad = std::acos(-1.0) / 180;
  ArcLimits limits;
  limits.tolerance = tolerance_ * scale;
  limits.smallest_radius = smallest_radius_ * scale;
  limits.largest_radius = largest_radius_ * scale;
  limits.largest_sweep = largest_sweep_ * rad;
  limits.mismatch = largest_mismatch * scale;
  limits.floor = floor_ * scale;

  const std::size_t left = std::min(run_.size() - first_, longest_run + 1);
  LongestCall call({&run_[first_], left}, &feeds_[first_ + 1], feed_drop_);
  call.tryStraight(limits.tolerance);
  for (const ArcPlane plane : {ArcPlane::XY, ArcPlane::ZX, ArcPlane::YZ}) {
    limits.steepest = helices_.of(plane) ? std::tan(steepest_helix_ * rad) : 0.0;
    if (arcs_ && planes_.of(plane))
      call.tryArc(plane, limits);
  }

  feed_ = call.feeds().choose(feed_);
  hand(call.count(), call.arc());
  statistics_.largest_deviation =
      std::max(statistics_.largest_deviation, call.deviation() / scale);
}

void ArcFitter::hand(std::size_t count, const std::optional<MachineArc>& arc)
{
  const auto from = run_[first_], to = run_[first_ + count];
  if (arc) {
    const int w = axesOf(arc->plane).w;
    statistics_.helices_out += from[w] != to[w];
    ++statistics_.arcs_out;
    next_.arc(*arc, feed_);
  }
  else {
    ++statistics_.straights_out;
    next_.straight(toPosition(to), feed_);
  }
  first_ += count;
  if (first_ < 4 * longest_run)
    return; // what remains is seldom moved
  run_.erase(run_.begin(), run_.begin() + static_cast<std::ptrdiff_t>(first_));
  feeds_.erase(feeds_.begin(), feeds_.begin() + static_cast<std::ptrdiff_t>(first_));
  first_ = 0;
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
  checkRange(
      "ArcFitter", "smallest_radius", smallest_radius_, "mm", {0.01, largest_radius_});
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
    feed_ = feed;
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
  feed_ = feed;
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
