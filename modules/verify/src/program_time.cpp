// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/common/parameters.h>
#include <pointmill/common/watch.h>
#include <pointmill/verify/program_time.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace pointmill {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Moves that turn by less than this go straight on: it is what the rounding of
/// coordinates turns short lines by [rad].
constexpr double kStraight = 1e-3;

/// One move as the planner sees it; speeds are squared [mm2/s2].
struct Leg {
  std::size_t move = 0;
  double length = 0.0; ///< mm
  double cruise = 0.0; ///< what is programmed
  double entry = 0.0;  ///< at its start
};

/// How far the path may leave a corner [mm]; nothing: it stops there.
std::optional<double>
cornerDeviation(const Program& program, const Machine& machine, CornerMode mode)
{
  const bool told = mode == CornerMode::Program && program.blend >= 0;
  const double deviation = told ? program.blend : machine.junction_deviation;
  if (mode == CornerMode::ExactStop || deviation == 0)
    return std::nullopt;
  return deviation;
}

/// An arc, which the reader cut into chords, is one block.
bool sameArc(const ProgramMove& a, const ProgramMove& b)
{
  return !a.rapid && !b.rapid && a.line == b.line;
}

class Planner {
public:
  Planner(const Program& program, const Machine& machine, CornerMode mode)
      : program_(program), machine_(machine),
        deviation_(cornerDeviation(program, machine, mode))
  {
  }

  /// Appends a move that has a length. @param stop whether the tool rests before it
  void add(std::size_t move, double length, bool stop)
  {
    const double speed = speedOf(program_.moves[move]);
    Leg leg{move, length, speed * speed, 0.0};
    if (!legs_.empty() && !stop)
      leg.entry =
          std::min({legs_.back().cruise, leg.cruise, junction(legs_.back(), leg)});
    legs_.push_back(leg);
  }

  /// mm/s
  double speedOf(const ProgramMove& move) const
  {
    const double most = machine_.max_feed > 0 ? machine_.max_feed : machine_.rapid_rate;
    return (move.rapid ? machine_.rapid_rate : std::min(move.feed, most)) / 60;
  }

  /// Calls visit(move, seconds) for each move.
  template <typename Visit>
  void run(Visit&& visit)
  {
    reachable();
    for (std::size_t i = 0; i < legs_.size(); ++i)
      visit(legs_[i].move, seconds(legs_[i], exit(i)));
  }

private:
  double exit(std::size_t i) const
  {
    return i + 1 < legs_.size() ? legs_[i + 1].entry : 0.0;
  }

  /// Lowers the speeds at the junctions to what can be braked from, and reached.
  void reachable()
  {
    const double twice = 2 * machine_.acceleration;
    for (std::size_t i = legs_.size(); i-- > 0;)
      legs_[i].entry = std::min(legs_[i].entry, exit(i) + twice * legs_[i].length);
    for (std::size_t i = 1; i < legs_.size(); ++i)
      legs_[i].entry =
          std::min(legs_[i].entry, legs_[i - 1].entry + twice * legs_[i - 1].length);
  }

  /// Squared speed at which the corner between two moves is passed.
  double junction(const Leg& before, const Leg& after) const
  {
    const ProgramMove &a = program_.moves[before.move], &b = program_.moves[after.move];
    const Eigen::Vector3d in = (a.to - a.from) / before.length,
                          out = (b.to - b.from) / after.length;
    // Of half the turn; by sum and difference, since a cosine near 1 knows no angle.
    const double sine = (out - in).norm() / 2, cosine = (out + in).norm() / 2;
    if (sine < 1e-12)
      return kInfinity;
    const double shorter = std::min(before.length, after.length);
    double radius = shorter / 2 * cosine / sine;
    if (!sameArc(a, b)) {
      if (deviation_ && radius > 0)
        radius = std::min(radius, *deviation_ * cosine * (1 + cosine) / (sine * sine));
      else if (!deviation_ && 2 * sine > kStraight)
        return 0.0;
    }
    return machine_.acceleration * radius;
  }

  /// Of a move that speeds up, cruises and brakes; without the cruise where it is too
  /// short.
  double seconds(const Leg& leg, double exit) const
  {
    const double a = machine_.acceleration;
    const double peak = std::min(leg.cruise, (leg.entry + exit) / 2 + a * leg.length);
    const double top = std::sqrt(peak);
    const double ramps = (2 * peak - leg.entry - exit) / (2 * a);
    return (2 * top - std::sqrt(leg.entry) - std::sqrt(exit)) / a +
           std::max(0.0, leg.length - ramps) / top;
  }

  const Program& program_;
  const Machine& machine_;
  const std::optional<double> deviation_;
  std::vector<Leg> legs_;
};

/// Which section each move belongs to, asked in their order.
class Sections {
public:
  explicit Sections(const Program& program) : program_(program) {}
  std::size_t count() const
  {
    return std::max<std::size_t>(1, program_.sections.size());
  }
  std::size_t of(std::size_t move)
  {
    while (at_ + 1 < program_.sections.size() &&
           program_.sections[at_ + 1].move <= move)
      ++at_;
    return at_;
  }

private:
  const Program& program_;
  std::size_t at_ = 0;
};

/// Whether the tool of a move has first to be loaded. The one that the reader was told
/// to be mounted is there.
bool needsChange(const Program& program, std::size_t move)
{
  const int tool = program.moves[move].tool;
  if (tool == 0)
    return false;
  if (move == 0)
    return !program.tools.empty() && program.tools.front() == tool;
  return tool != program.moves[move - 1].tool;
}

} // namespace

void ProgramTimeOptions::validate() const
{
  checkRange("program time", "tool change", tool_change, "s", {0, 3600});
}

SectionTime& SectionTime::operator+=(const SectionTime& other)
{
  cutting += other.cutting;
  rapid += other.rapid;
  tool_change += other.tool_change;
  unhindered += other.unhindered;
  unknown_moves += other.unknown_moves;
  return *this;
}

ProgramTime programTime(const Program& program,
                        const Machine& machine,
                        const ProgramTimeOptions& options)
{
  machine.validate();
  options.validate();
  Planner planner(program, machine, options.corners);
  Sections sections(program);
  ProgramTime time;
  time.sections.resize(sections.count());
  time.ends.assign(program.moves.size(), 0.0); // what each takes, at first

  bool stop = true;
  for (std::size_t i = 0; i < program.moves.size(); ++i) {
    if (i % 4096 == 0)
      checkInterrupted();
    const ProgramMove& move = program.moves[i];
    SectionTime& section = time.sections[sections.of(i)];
    if (needsChange(program, i)) {
      section.tool_change += options.tool_change;
      time.ends[i] += options.tool_change;
      stop = true;
    }
    // The control waits for the spindle.
    stop |= i > 0 && move.spindle != program.moves[i - 1].spindle;
    const double length = (move.to - move.from).norm();
    if (!std::isfinite(length)) {
      ++section.unknown_moves;
      stop = true;
    }
    else if (length > 0) {
      if (!move.rapid && !(move.feed > 0))
        throw DataError(program.where(move.line) + ": a feed move without a feed");
      planner.add(i, length, stop);
      section.unhindered += length / planner.speedOf(move);
      stop = false;
    }
  }

  Sections again(program);
  planner.run([&](std::size_t i, double seconds) {
    SectionTime& section = time.sections[again.of(i)];
    (program.moves[i].rapid ? section.rapid : section.cutting) += seconds;
    time.ends[i] += seconds;
  });
  std::partial_sum(time.ends.begin(), time.ends.end(), time.ends.begin());
  for (const SectionTime& section : time.sections)
    time.total += section;
  return time;
}

} // namespace pointmill
