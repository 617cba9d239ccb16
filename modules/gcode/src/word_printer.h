// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "printer.h"

#include <optional>

namespace pointmill::gcode {

/// @brief Spells moves as words, `G1 X10. F300.`: those that repeat are left out,
/// except after a tool change, where a person may want to start.
class WordPrinter : public Printer {
public:
  WordPrinter(std::ostream& out, const Post& post, const PrinterSettings& settings)
      : Printer(out, post, settings)
  {
  }

  void traverse(const MachinePosition& to) override;
  void straight(const MachinePosition& to, std::int64_t feed) override;
  void arc(const MachineArc& arc, std::int64_t feed) override;

protected:
  void forget() override;
  void approached(const MachinePosition& to) override;

private:
  enum class Mode { None, Rapid, Feed, Clockwise, CounterClockwise };

  char* mode(char* to, Mode mode);
  char* axes(char* to, const MachinePosition& position);
  void selectPlane(ArcPlane plane);
  void writePole(const MachineArc& arc);
  char* centre(char* to, const MachineArc& arc) const;

  Mode mode_ = Mode::None;            ///< none: write it
  ArcPlane plane_ = ArcPlane::XY;     ///< every head has G17
  std::optional<MachinePosition> at_; ///< none: write all axes
};

} // namespace pointmill::gcode
