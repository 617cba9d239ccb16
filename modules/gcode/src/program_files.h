// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "printer.h"

#include <cstddef>
#include <memory>
#include <string>

namespace pointmill::gcode {

/// @brief The end of the line: each begin() opens the next file, with a printer.
class ProgramFiles : public MachineCalls {
public:
  /// @brief How many files there will be, and of what.
  struct Series {
    std::size_t count = 1;
    bool of_one_tool = false; ///< each
  };

  ProgramFiles(const GCodeWriter::Opener& open,
               const Post& post,
               const PrinterSettings& settings,
               Series series);

  void begin(const ProgramHead& head) override;
  void comment(const std::string& text) override { printer_->comment(text); }
  void operation(std::size_t number, const std::string& name) override
  {
    printer_->operation(number, name);
  }
  void stop() override { printer_->stop(); }
  void retract() override { printer_->retract(); }
  void changeTool(int number) override { printer_->changeTool(number); }
  void spindle(long rpm) override { printer_->spindle(rpm); }
  void coolant(bool on) override { printer_->coolant(on); }
  void approach(const MachinePosition& to) override { printer_->approach(to); }
  void traverse(const MachinePosition& to) override { printer_->traverse(to); }
  void straight(const MachinePosition& to, std::int64_t feed) override
  {
    printer_->straight(to, feed);
  }
  void arc(const MachineArc& arc, std::int64_t feed) override
  {
    printer_->arc(arc, feed);
  }
  void dwell(double seconds) override { printer_->dwell(seconds); }
  void end() override;

  /// @brief Lines of the file that is open.
  std::size_t linesOfThis() const { return printer_->lines().lines(); }
  std::size_t files() const { return files_; }
  std::size_t lines() const { return lines_; }
  std::size_t bytes() const { return bytes_; }
  std::size_t longest() const { return longest_; }

private:
  const GCodeWriter::Opener& open_;
  const Post& post_;
  PrinterSettings settings_;
  Series series_;
  std::unique_ptr<Printer> printer_;
  std::size_t files_ = 0, lines_ = 0, bytes_ = 0, longest_ = 0;
};

} // namespace pointmill::gcode
