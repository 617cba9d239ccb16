// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "arc.h"
#include "block.h"
#include "codes.h"
#include "line_reader.h"

#include <pointmill/common/parameters.h>
#include <pointmill/gcode/gcode_reader.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {

using namespace gcode;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double machine_top = std::numeric_limits<double>::infinity();
constexpr double farthest = 1e5; // mm
constexpr double inch = 25.4;    // mm

/// The machine: what the words so far have set.
class Machine {
public:
  Machine(Program& program, const GCodeReader::MoveHandler& handler, double chord_error)
      : program_(program), handler_(handler), chord_error_(chord_error)
  {
  }

  /// False at the end of the program.
  bool execute(const Block& block)
  {
    block_ = &block;
    sortCodes();
    setUnits();
    setFeedAndSpeed();
    changeTool();
    runSpindle();
    setModes();
    move();
    return !endsProgram();
  }

private:
  using Code = Block::Code;

  [[noreturn]] void fail(int column, const std::string& what) const
  {
    block_->fail(column, what);
  }
  [[noreturn]] void fail(char letter, const std::string& what) const
  {
    block_->fail(block_->column(letter), what);
  }
  bool has(char letter) const { return block_->has(letter); }
  const Code* code(Group group) const { return codes_[group]; }
  bool is(Group group, int tenths) const
  {
    return codes_[group] && codes_[group]->tenths == tenths;
  }

  void sortCodes()
  {
    std::fill(codes_, codes_ + group_count, nullptr);
    for (int i = 0; i < block_->gCount(); ++i)
      sort('G', block_->g(i), groupOfG(block_->g(i).tenths));
    for (int i = 0; i < block_->mCount(); ++i)
      sort('M', block_->m(i), groupOfM(block_->m(i).tenths));
    checkParameters();
  }

  void sort(char letter, const Code& word, Group group)
  {
    if (group == NoGroup)
      fail(word.column, refusal(letter, word.tenths));
    if (codes_[group])
      fail(word.column,
           codeName(letter, word.tenths) + " and " +
               codeName(letter, codes_[group]->tenths) + ": two " + groupName(group) +
               " words in one block");
    codes_[group] = &word;
  }

  /// Words that only mean something beside another one.
  void checkParameters() const
  {
    if (has('P') && !is(NonModal, 40) && !is(PathMode, 640))
      fail('P', "P without G4 or G64");
    if (has('P') && is(NonModal, 40) && is(PathMode, 640))
      fail('P', "P for both G4 and G64");
    if (has('Q') && !is(PathMode, 640))
      fail('Q', "Q without G64");
    if (has('H') && !is(Length, 430))
      fail('H', "H without G43");
  }

  double unit(char letter) const
  {
    if (unit_ == 0.0)
      fail(letter, std::string(1, letter) + " before G20 or G21: its unit is unknown");
    return unit_;
  }

  double length(char letter) const
  {
    const double value = block_->value(letter) * unit(letter);
    if (std::abs(value) > farthest)
      fail(letter, std::string(1, letter) + " is beyond 100 m");
    return value;
  }

  int whole(char letter, int most) const
  {
    const double value = block_->value(letter);
    if (value < 0 || value > most || value != std::floor(value))
      fail(letter,
           std::string(1, letter) + " must be a whole number, 0 .. " +
               std::to_string(most));
    return static_cast<int>(value);
  }

  void setUnits()
  {
    if (!code(Units))
      return;
    const bool inches = is(Units, 200);
    const double now = inches ? inch : 1.0;
    // Controls disagree on which unit such an F has.
    if (has('F') && unit_ != 0.0 && unit_ != now)
      fail('F', "F in a block that changes the unit");
    unit_ = now;
    program_.inches |= inches;
  }

  void setFeedAndSpeed()
  {
    if (has('F')) {
      feed_ = length('F');
      if (!(feed_ > 0))
        fail('F', "F must be above 0");
    }
    if (has('S')) {
      speed_ = block_->value('S');
      if (speed_ < 0)
        fail('S', "S must not be negative");
    }
  }

  void changeTool()
  {
    if (has('T'))
      next_tool_ = whole('T', 999999);
    if (!code(ToolChange))
      return;
    if (next_tool_ < 0)
      fail(code(ToolChange)->column, "M6 without a T word");
    tool_ = next_tool_;
    tool_known_ = true;
    program_.tools.push_back(tool_);
    turning_ = 0;
    length_offset_ = false; // it was the other tool's
    // The machine may have gone to its place for tool changes.
    at_.x() = at_.y() = unknown;
    loseLength();
  }

  /// The tip's Z after another tool or offset is unknown, unless it is above all.
  void loseLength()
  {
    if (at_.z() != machine_top)
      at_.z() = unknown;
  }

  void runSpindle()
  {
    if (is(Spindle, 30))
      turning_ = 1;
    else if (is(Spindle, 40))
      turning_ = -1;
    else if (is(Spindle, 50))
      turning_ = 0;
  }

  void setModes()
  {
    if (is(NonModal, 40)) {
      if (!has('P') || block_->value('P') < 0)
        fail(code(NonModal)->column, "G4 needs P, at least 0 seconds");
    }
    if (code(Plane))
      plane_ = code(Plane)->tenths;
    if (code(Length))
      setLength();
    if (code(Offset)) {
      const int offset = code(Offset)->tenths;
      if (offset_ != 0 && offset != offset_)
        fail(code(Offset)->column,
             codeName('G', offset) + " after " + codeName('G', offset_) +
                 ": only one work offset is supported");
      offset_ = offset;
    }
    if (code(PathMode))
      setPathMode();
    if (code(Distance))
      incremental_ = is(Distance, 910);
    if (code(MotionMode))
      mode_ = code(MotionMode)->tenths;
  }

  void setLength()
  {
    if (is(Length, 430) && has('H')) {
      const int h = whole('H', 999999);
      if (tool_known_ && h != tool_)
        fail('H',
             "H" + std::to_string(h) + " is not the length of tool " +
                 std::to_string(tool_));
    }
    length_offset_ = is(Length, 430);
    loseLength();
  }

  void setPathMode()
  {
    double blend = 0.0, merge = 0.0;
    if (is(PathMode, 640)) {
      blend = merge = has('P') ? length('P') : machine_top;
      if (has('Q'))
        merge = length('Q');
      if (blend < 0 || merge < 0)
        fail(code(PathMode)->column, "G64 with a negative tolerance");
    }
    program_.blend = std::max(program_.blend, blend);
    program_.merge = std::max(program_.merge, merge);
  }

  void move()
  {
    char word = 0;
    const bool axes = block_->hasAny("XYZ", word);
    const bool arc = mode_ == 20 || mode_ == 30;
    char extra = 0;
    const bool extras = block_->hasAny("IJKR", extra);
    if (extras && !arc)
      fail(extra, std::string(1, extra) + " without G2 or G3");
    if (is(NonModal, 530)) {
      moveInMachine(axes);
      return;
    }
    if (!axes && !extras) {
      if (arc && code(MotionMode))
        fail(code(MotionMode)->column, codeName('G', mode_) + " without its words");
      return;
    }
    if (is(NonModal, 40))
      fail(axes ? word : extra, "G4 beside motion");
    if (mode_ == 800)
      fail(word, std::string(1, word) + " without G0, G1, G2 or G3");
    const int column = code(MotionMode) ? code(MotionMode)->column
                                        : block_->column(axes ? word : extra);
    const Eigen::Vector3d to = target();
    if (offset_ == 0)
      offset_ = 540;
    if (mode_ == 0) {
      emit(to, true);
      return;
    }
    checkFeedMove(column);
    if (arc)
      moveOnArc(to, column);
    else
      emit(to, false);
  }

  Eigen::Vector3d target() const
  {
    Eigen::Vector3d to = at_;
    for (int axis = 0; axis < 3; ++axis) {
      const char letter = static_cast<char>('X' + axis);
      if (!has(letter))
        continue;
      const double value = length(letter);
      if (incremental_ && !std::isfinite(at_[axis]))
        fail(letter, std::string("G91: ") + letter + " from an unknown position");
      to[axis] = incremental_ ? at_[axis] + value : value;
    }
    return to;
  }

  void checkFeedMove(int column) const
  {
    const std::string name = codeName('G', mode_);
    for (int axis = 0; axis < 3; ++axis)
      if (!std::isfinite(at_[axis]))
        fail(column,
             name + " from an unknown position: " + static_cast<char>('X' + axis) +
                 " is not set");
    if (!(feed_ > 0))
      fail(column, name + " without a feed: no F so far");
  }

  void moveInMachine(bool axes)
  {
    const int column = code(NonModal)->column;
    if (mode_ != 0)
      fail(column, "G53 is supported with G0 only");
    if (incremental_)
      fail(column, "G53 in incremental mode, G91");
    if (!axes)
      fail(column, "G53 without X, Y or Z");
    Eigen::Vector3d to = at_;
    for (int axis = 0; axis < 3; ++axis)
      if (has(static_cast<char>('X' + axis)))
        to[axis] = unknown;
    if (has('Z') && length('Z') == 0.0)
      to.z() = machine_top;
    emit(to, true);
  }

  void moveOnArc(const Eigen::Vector3d& to, int column)
  {
    Arc arc;
    arc.from = at_;
    arc.to = to;
    arc.clockwise = mode_ == 20;
    arc.u = plane_ == 170 ? 0 : plane_ == 180 ? 2 : 1;
    arc.v = plane_ == 170 ? 1 : plane_ == 180 ? 0 : 2;
    arc.w = 3 - arc.u - arc.v;
    if (has('R'))
      setCentreByRadius(arc, column);
    else
      setCentreByOffsets(arc, column);

    const double a = arc.startRadius(), b = arc.endRadius(), off = std::abs(a - b);
    if (!(std::min(a, b) > 1e-6))
      fail(column, "the arc's radius is 0");
    // Grbl's rule, the strictest one known.
    if (off > 0.5 || (off > 0.005 && off > 0.001 * a))
      fail(column,
           "the arc's radius is " + std::to_string(a) + " mm at its start and " +
               std::to_string(b) + " mm at its end");
    const std::size_t n = arc.chords(chord_error_);
    for (std::size_t i = 1; i <= n; ++i)
      emit(arc.point(i, n), false);
  }

  void setCentreByOffsets(Arc& arc, int column) const
  {
    const char along = static_cast<char>('I' + arc.w);
    if (has(along))
      fail(along,
           std::string(1, along) + " does not belong to plane " +
               codeName('G', plane_));
    const char u = static_cast<char>('I' + arc.u), v = static_cast<char>('I' + arc.v);
    if (!has(u) && !has(v))
      fail(column, "an arc without centre or radius");
    arc.centre = {at_[arc.u] + (has(u) ? length(u) : 0.0),
                  at_[arc.v] + (has(v) ? length(v) : 0.0)};
  }

  void setCentreByRadius(Arc& arc, int column) const
  {
    char other = 0;
    if (block_->hasAny("IJK", other))
      fail(other, std::string(1, other) + " beside R");
    const double radius = length('R');
    const Eigen::Vector2d from(arc.from[arc.u], arc.from[arc.v]);
    const Eigen::Vector2d chord = Eigen::Vector2d(arc.to[arc.u], arc.to[arc.v]) - from;
    const double half = chord.norm() / 2;
    if (half < 1e-6)
      fail(column, "an arc with R must not end where it starts");
    const double r = std::abs(radius);
    // A half circle whose ends were rounded apart is still one.
    if (half > r + 0.005)
      fail('R', "R is too small to reach the end of the arc");
    const double height = std::sqrt(std::max(0.0, r * r - half * half));
    const bool left = arc.clockwise == (radius < 0);
    const Eigen::Vector2d normal(-chord.y(), chord.x());
    arc.centre = from + chord / 2 + normal * ((left ? height : -height) / (2 * half));
  }

  void emit(const Eigen::Vector3d& to, bool rapid)
  {
    ProgramMove m;
    m.from = at_;
    m.to = to;
    m.feed = rapid ? 0.0 : feed_;
    m.spindle = turning_ == 0 ? 0.0 : turning_ * speed_;
    m.line = block_->line();
    m.tool = tool_;
    m.rapid = rapid;
    m.from_known = at_.allFinite();
    m.length_offset = length_offset_;
    handler_(m);
    at_ = to;
  }

  bool endsProgram()
  {
    if (is(Stop, 20) || is(Stop, 300))
      program_.ended = true;
    return program_.ended;
  }

  Program& program_;
  const GCodeReader::MoveHandler& handler_;
  const double chord_error_;
  const Block* block_ = nullptr;
  const Code* codes_[group_count] = {};

  Eigen::Vector3d at_ = Eigen::Vector3d::Constant(unknown);
  double unit_ = 0.0; // mm; 0: not said yet
  double feed_ = 0.0; // mm/min
  double speed_ = 0.0;
  int turning_ = 0;
  int tool_ = 0, next_tool_ = -1;
  bool tool_known_ = false;
  bool incremental_ = false;
  int plane_ = 170;
  int mode_ = 800;
  int offset_ = 0;
  bool length_offset_ = false;
};

Program interpret(LineReader& lines,
                  double chord_error,
                  const GCodeReader::MoveHandler& handler)
{
  checkRange("GCodeReader", "chord error", chord_error, "mm", {1e-6, 1});
  Program program;
  Machine machine(program, handler, chord_error);
  Block block;
  bool started = false, percent = false;
  std::string_view text;
  while (lines.next(text)) {
    block.parse(text, lines.lines());
    if (block.isPercent()) {
      if (started || percent)
        break;
      percent = true;
    }
    else if (!block.isEmpty()) {
      started = true;
      if (!machine.execute(block))
        break;
    }
  }
  program.lines = lines.lines();
  return program;
}

} // namespace

Program GCodeReader::read(std::istream& in, const MoveHandler& handler) const
{
  LineReader lines(in);
  return interpret(lines, chord_error_, handler);
}

Program GCodeReader::read(std::istream& in) const
{
  LineReader lines(in);
  std::vector<ProgramMove> moves;
  Program program = interpret(lines, chord_error_, [&](const ProgramMove& m) {
    // Doubling would need three times the memory of a large program; memory that is
    // reserved and not used costs nothing.
    if (moves.size() == moves.capacity()) {
      const auto size = static_cast<double>(moves.size());
      const double share = lines.progress();
      if (size >= 1024 && share > 0.0)
        moves.reserve(static_cast<std::size_t>(size * std::min(1.1 / share, 64.0)) +
                      64);
    }
    moves.push_back(m);
  });
  program.moves = std::move(moves);
  return program;
}

} // namespace pointmill
