// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "line_writer.h"

#include <pointmill/gcode/decimal_grid.h>
#include <pointmill/gcode/machine_calls.h>

#include <optional>
#include <string>

namespace pointmill::gcode {

/// @brief Spells machine calls as RS-274 for LinuxCNC: words that repeat are left out,
/// except after a tool change, where a person may want to start.
class LinuxCncPrinter : public MachineCalls {
public:
  LinuxCncPrinter(std::ostream& out, int decimals) : lines_(out), grid_(decimals) {}

  void begin(const ProgramHead& head) override;
  void comment(const std::string& text) override;
  void stop() override;
  void retract() override;
  void changeTool(int number) override;
  void spindle(long rpm) override;
  void coolant(bool on) override;
  void approach(const MachinePosition& to) override;
  void traverse(const MachinePosition& to) override;
  void straight(const MachinePosition& to, std::int64_t feed) override;
  void end() override;

  const LineWriter& lines() const { return lines_; }

private:
  void move(char mode, const MachinePosition& to, std::int64_t feed);

  LineWriter lines_;
  DecimalGrid grid_;
  DecimalGrid feed_grid_{3};
  char mode_ = 0;                     ///< '0' or '1' of the last G word; 0: write it
  std::int64_t feed_ = 0;             ///< 0: write it
  std::optional<MachinePosition> at_; ///< none: write all axes
};

} // namespace pointmill::gcode
