// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/operation.h>
#include <pointmill/gcode/decimal_grid.h>
#include <pointmill/gcode/gcode_writer.h>
#include <pointmill/gcode/machine_calls.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pointmill::gcode {

/// @brief What the machine does for operations, call by call, and whether it may.
class MachiningPlan {
public:
  MachiningPlan(const std::vector<Operation>& operations, const GCodeWriter& settings);

  /// @brief Operations that make up one program, [first, last).
  struct Part {
    std::size_t first, last;
  };
  /// @brief The programs that are to be written: one, or one for each tool.
  std::vector<Part> parts() const;

  /// @brief Says all of them to @p calls. Throws ParameterError, DataError.
  GCodeWriter::Statistics run(const ProgramHead& head, MachineCalls& calls);

private:
  bool hasSameTool(std::size_t index) const;
  std::string where() const;
  [[noreturn]] void refuse(std::size_t point, const std::string& why) const;
  void checkOperation() const;
  std::vector<Tool> toolsOf(const Part& part);
  MachinePosition position(std::size_t point) const;
  std::int64_t feed(std::size_t point) const;

  void runPart(const Part& part);
  void runOperation(bool first);
  void startTool(const Operation& operation, const MachinePosition& first);
  void continueTool(const Operation& operation, const MachinePosition& first);
  void runPoint(std::size_t point);
  void traverse(const MachinePosition& to);
  void retract();

  const std::vector<Operation>& operations_;
  const DecimalGrid grid_;
  const DecimalGrid feed_grid_{3};
  const std::int64_t clearance_;
  const bool low_rapids_;
  const bool one_tool_;     ///< in each program
  const bool retracts_;     ///< rather than staying on the clearance plane
  const bool speeds_alone_; ///< the speed can change without a tool change
  MachineCalls* calls_ = nullptr;
  std::size_t index_ = 0; ///< of the operation
  MachinePosition at_;
  long spindle_ = 0;
  bool coolant_ = false;
  GCodeWriter::Statistics statistics_;
};

} // namespace pointmill::gcode
