// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "comment_text.h"
#include "line_writer.h"
#include "template_text.h"

#include <pointmill/gcode/decimal_grid.h>
#include <pointmill/gcode/gcode_writer.h>
#include <pointmill/gcode/machine_calls.h>
#include <pointmill/gcode/post.h>

#include <iosfwd>
#include <map>
#include <memory>
#include <string>

namespace pointmill::gcode {

/// @brief What a program is told besides its post.
struct PrinterSettings {
  Unit unit = Unit::Millimetre;
  DecimalGrid grid{4};
  bool numbers = false;
  bool pause_for_tools = false;
  Retract retract = Retract::Machine;
  Corners corners = Corners::Tolerance;
  int number = 1; ///< of the program
};

/// @brief Spells machine calls as a post says: all but the moves, which derived classes
/// spell.
class Printer : public MachineCalls {
public:
  static std::unique_ptr<Printer>
  make(std::ostream& out, const Post& post, const PrinterSettings& settings);

  void begin(const ProgramHead& head) override;
  void comment(const std::string& text) override;
  void operation(std::size_t number, const std::string& name) override;
  void stop() override;
  void retract() override;
  void changeTool(int number) override;
  void spindle(long rpm) override;
  void coolant(bool on) override;
  void approach(const MachinePosition& to) override;
  void dwell(double seconds) override;
  void end() override;

  const LineWriter& lines() const { return lines_; }

protected:
  Printer(std::ostream& out, const Post& post, const PrinterSettings& settings);

  /// @brief What is modal must be written again.
  virtual void forget() = 0;
  /// @brief The tool is at @p to, in rapid motion.
  virtual void approached(const MachinePosition& to) = 0;

  /// @brief Starts a block, with its number, and returns where it goes on.
  char* block();
  /// @brief Appends a word's letter, after a blank where it is not the block's first.
  char* word(char* to, char letter) const;
  char* word(char* to, const std::string& text) const;
  char* coordinate(char* to, char letter, std::int64_t ticks) const;
  /// @brief F, unless it is in force.
  char* feed(char* to, std::int64_t feed);
  void endBlock(char* end) { lines_.endLine(end); }

  const Post post_;
  const DecimalGrid grid_;
  const NumberStyle style_;
  std::int64_t feed_ = 0; ///< in force; 0: none

private:
  void print(const Post::Lines& lines, const Places& more = {});
  void printLine(const std::string& line);
  void printPathMode(double tolerance);
  Places toolPlaces(long rpm) const;
  char* number(char* to);
  bool isComment(const std::string& line) const;
  bool isNumbered(const std::string& line) const;
  std::string coordinateText(std::int64_t ticks) const;
  std::int64_t feedTicks(std::int64_t feed) const;

  const PrinterSettings settings_;
  LineWriter lines_;
  CommentText comments_;
  DecimalGrid feed_grid_;
  double feed_factor_; ///< printed ticks of 1/1000 mm/min
  Places places_;      ///< those that stand everywhere
  std::map<int, std::string> tool_texts_;
  int tool_ = 0;
  bool tool_pending_ = false;   ///< changeTool() waits for its spindle()
  bool tool_known_ = false;     ///< one was called in this program
  const char* first_ = nullptr; ///< of the block, after its number
  int next_number_;
};

} // namespace pointmill::gcode
