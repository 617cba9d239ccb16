// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/stock.h>
#include <pointmill/common/tool.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pointmill {

/// @brief A tip position in the part frame, in ticks of the program's DecimalGrid.
struct MachinePosition {
  std::int64_t x = 0, y = 0, z = 0;

  bool sameColumn(const MachinePosition& o) const { return x == o.x && y == o.y; }
  bool operator==(const MachinePosition& o) const { return sameColumn(o) && z == o.z; }
};

/// @brief The plane of an arc, by its first and second axis: G17, G18, G19.
enum class ArcPlane { XY, ZX, YZ };

/// @brief An arc of at most a full turn, or a helix, from where the tip is. In ticks.
struct MachineArc {
  MachinePosition to;
  ArcPlane plane = ArcPlane::XY;
  /// As seen against the plane's third axis: G2.
  bool clockwise = false;
  /// The centre minus the start, along the plane's first and second axis: I and J, K
  /// and I, or J and K.
  std::int64_t u = 0, v = 0;
};

/// @brief What a printer must know before the first block.
struct ProgramHead {
  std::string name; ///< of the program, for controls that want one
  std::vector<std::string> comments;
  std::vector<Tool> tools;     ///< in the order of their first use
  double path_tolerance = 0.0; ///< mm; 0: exact path
  std::optional<Stock> stock;  ///< for controls that show it
};

/// @brief The program as machine calls that have no dialect yet. GCodeWriter decides
/// what the machine does and checks it; adapters behind this interface change it, and a
/// printer spells it as a Post says. Each program is from begin() to end().
class MachineCalls {
public:
  virtual ~MachineCalls() = default;

  virtual void begin(const ProgramHead&) {}
  virtual void comment(const std::string&) {}
  /// @brief What follows is operation @p number, from 1, whatever the tool is.
  virtual void operation(std::size_t /*number*/, const std::string& /*name*/) {}
  /// @brief Spindle and coolant off.
  virtual void stop() {}
  /// @brief Straight up to the top of the machine, whatever the part frame is.
  virtual void retract() {}
  /// @brief Loads tool @p number and applies its length; spindle() follows.
  virtual void changeTool(int /*number*/) {}
  /// @brief Clockwise at @p rpm rev/min.
  virtual void spindle(long /*rpm*/) {}
  virtual void coolant(bool /*on*/) {}
  /// @brief After a tool change, when X and Y are not known: first Z, then X and Y.
  virtual void approach(const MachinePosition&) {}
  virtual void traverse(const MachinePosition&) {}
  /// @brief Feed move; @p feed in 1/1000 mm/min.
  virtual void straight(const MachinePosition&, std::int64_t /*feed*/) {}
  /// @brief Feed move on an arc; @p feed in 1/1000 mm/min.
  virtual void arc(const MachineArc&, std::int64_t /*feed*/) {}
  virtual void dwell(double /*seconds*/) {}
  virtual void end() {}
};

} // namespace pointmill
