// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "program_files.h"
#include <pointmill/gcode/call_adapter.h>

#include <optional>
#include <string>

namespace pointmill::gcode {

/// @brief Ends a program that gets too long and begins the next one where it was left.
/// From three quarters of the lines on it waits for a rapid on the clearance plane;
/// where none comes, the tool is lifted from the cut. Straight up and down its own
/// column there is nothing that it has not cut: a tool is nowhere wider higher up.
class ProgramSplitter : public CallAdapter {
public:
  struct Settings {
    std::size_t max_lines = 0;
    std::int64_t clearance = 0;    ///< ticks
    std::int64_t soft_landing = 0; ///< where feed begins, above the cut [ticks]
  };

  ProgramSplitter(ProgramFiles& next, const Post& post, const Settings& settings);

  void begin(const ProgramHead& head) override;
  void operation(std::size_t number, const std::string& name) override;
  void changeTool(int number) override;
  void spindle(long rpm) override;
  void coolant(bool on) override;
  void approach(const MachinePosition& to) override;
  void traverse(const MachinePosition& to) override;
  void straight(const MachinePosition& to, std::int64_t feed) override;
  void arc(const MachineArc& arc, std::int64_t feed) override;

private:
  bool isFull() const;
  bool isLong() const;
  void close();
  /// @brief Begins the next program, up to its first position.
  void reopen(const MachinePosition& first);
  void interrupt(std::int64_t feed);

  ProgramFiles& files_;
  Settings settings_;
  std::size_t reserve_; ///< lines of what cannot be told apart, and of the end
  ProgramHead head_;
  std::size_t operation_ = 0;
  std::string operation_name_;
  int tool_ = 0;
  long rpm_ = 0;
  bool coolant_ = false;
  MachinePosition at_;
};

} // namespace pointmill::gcode
