// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pointmill {

/// @brief A tip position in the part frame, in ticks of the program's DecimalGrid.
struct MachinePosition {
  std::int64_t x = 0, y = 0, z = 0;

  bool sameColumn(const MachinePosition& o) const { return x == o.x && y == o.y; }
  bool operator==(const MachinePosition& o) const { return sameColumn(o) && z == o.z; }
};

/// @brief What a printer must know before the first block.
struct ProgramHead {
  std::vector<std::string> comments;
  std::vector<Tool> tools;     ///< in the order of their first use
  double path_tolerance = 0.0; ///< mm; 0: exact path
};

/// @brief The program as machine calls that have no dialect yet. GCodeWriter decides
/// what the machine does and checks it; a printer behind this interface only spells it,
/// so a further control needs one more printer and nothing else.
class MachineCalls {
public:
  virtual ~MachineCalls() = default;

  virtual void begin(const ProgramHead&) {}
  virtual void comment(const std::string&) {}
  /// @brief Spindle and coolant off.
  virtual void stop() {}
  /// @brief Straight up to the top of the machine, whatever the part frame is.
  virtual void retract() {}
  /// @brief Loads tool @p number and applies its length.
  virtual void changeTool(int /*number*/) {}
  /// @brief Clockwise at @p rpm rev/min.
  virtual void spindle(long /*rpm*/) {}
  virtual void coolant(bool /*on*/) {}
  /// @brief After a tool change, when X and Y are not known: first Z, then X and Y.
  virtual void approach(const MachinePosition&) {}
  virtual void traverse(const MachinePosition&) {}
  /// @brief Feed move; @p feed in 1/1000 mm/min.
  virtual void straight(const MachinePosition&, std::int64_t /*feed*/) {}
  virtual void end() {}
};

} // namespace pointmill
