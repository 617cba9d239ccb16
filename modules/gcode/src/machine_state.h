// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "arc.h"
#include "place.h"

#include <pointmill/gcode/gcode_reader.h>

#include <Eigen/Core>

#include <limits>
#include <string>
#include <string_view>

namespace pointmill::gcode {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
/// @brief The height of the top of the machine, in every frame; also a blending without
/// bound.
constexpr double unbounded = std::numeric_limits<double>::infinity();
/// Machine heights so near to 0 are its top: homed machines back off by a little.
constexpr double near_top = 10.0; // mm
constexpr double inch = 25.4;     // mm

/// @brief The machine that a program runs on: where its tool is, what is switched on,
/// and what becomes of the program's moves. It knows no words; the forms of programs
/// tell it what theirs mean. Lengths are millimetres of the part frame.
class MachineState {
public:
  MachineState(Program& program,
               const GCodeReader::MoveHandler& handler,
               double chord_error,
               int mounted_tool);

  /// @brief What follows stands in this line.
  void setLine(std::size_t line) { line_ = line; }
  std::size_t line() const { return line_; }
  /// @brief "Operation 2: finishing" begins a section.
  void comment(std::string_view text);
  void end() { program_.ended = true; }
  void usesInches() { program_.inches = true; }

  /// @name Frames
  /// @{
  /// @brief The tip, in parts NaN or infinite as ProgramMove says.
  const Eigen::Vector3d& at() const { return at_; }
  /// @brief Selects the work offset @p name.
  void selectOffset(const std::string& name);
  /// @brief A coordinate of the program is used: at first its frame becomes that of the
  /// part, later it must be that. @p offset is what is in force where none was
  /// selected.
  void enterFrame(Place place, const char* offset = "")
  {
    if (!in_part_frame_)
      fixFrame(place, offset);
  }
  double toPart(int axis, double value) const { return value + shift_[axis]; }
  /// @brief The tip is at @p value of a shifted frame from now on: G92.
  void shiftFrame(int axis, double value, Place place);
  /// @brief Takes the shift back: G92.1 for good, G92.2 until resumeShift().
  void dropShift(bool for_good, Place place);
  void resumeShift(Place place);
  /// @}

  /// @name Tool and spindle
  /// @{
  int tool() const { return tool_; }
  bool toolKnown() const { return tool_known_; }
  /// @brief @p length: its length is in force at once.
  void changeTool(int number, bool length);
  void setLength(bool in_force);
  /// @param direction 1: clockwise, -1: counter-clockwise, 0: off
  void turnSpindle(int direction) { turning_ = direction; }
  bool turns() const { return turning_ != 0; }
  void setSpeed(double rpm) { speed_ = rpm; }
  /// @}

  /// @name Path
  /// @{
  /// @brief Corners may be blended and lines merged by so much [mm].
  void setPath(double blend, double merge);
  /// @brief How corners are taken is left to the machine.
  void leavePath() { path_stated_ = false; }
  /// @}

  /// @name Moves
  /// @{
  bool hasCut() const { return has_cut_; }
  void rapid(const Eigen::Vector3d& to) { emit(to, true, 0.0); }
  /// @brief Refuses feed moves of which the start or the feed is not known; @p word is
  /// how the program calls them.
  void checkFeedMove(double feed, const char* word, Place place) const
  {
    if (!(feed > 0) || !at_.allFinite())
      refuseFeedMove(word, place);
  }
  void straight(const Eigen::Vector3d& to, double feed) { emit(to, false, feed); }
  /// @brief As chords.
  void arc(const Arc& arc, double feed, Place place);
  /// @brief A rapid to a place of the machine: X and Y, where they move, are unknown
  /// after it, Z is @p height, which says so itself.
  void toMachinePlace(bool x, bool y, bool z, double height);
  /// @}

private:
  void fixFrame(Place place, const char* offset);
  [[noreturn]] void refuseFeedMove(const char* word, Place place) const;
  void beginSection(std::string_view name, bool by_comment);
  void emit(const Eigen::Vector3d& to, bool rapid, double feed);
  void loseLength();

  Program& program_;
  const GCodeReader::MoveHandler& handler_;
  const double chord_error_;
  std::size_t line_ = 0;
  std::size_t moves_ = 0;

  Eigen::Vector3d at_ = Eigen::Vector3d::Constant(unknown);
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero(), resting_shift_ = shift_;
  bool shifted_at_first_ = false, shift_rests_ = false;
  std::string offset_, part_offset_; // selected; that of the part
  bool framed_ = false;              // the part's frame is known
  bool in_part_frame_ = false;       // and is the one in force

  int tool_ = 0;
  bool tool_known_ = false, length_ = false;
  int turning_ = 0;
  double speed_ = 0.0;

  bool path_stated_ = false, path_left_ = false;
  bool has_cut_ = false;

  // The section that is open: what began it, and whether it has cut.
  bool section_named_ = false, section_tooled_ = false, section_cut_ = false;
};

} // namespace pointmill::gcode
