// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/gcode/call_adapter.h>

#include <pointmill/gcode/decimal_grid.h>
#include <pointmill/gcode/post.h>

#include <optional>

namespace pointmill::gcode {

/// @brief Cuts arcs into what a control takes: pieces of no more than its largest
/// sweep, so that no full circle is left, or chords where it takes no such arc. Ends
/// lie on the ticks, chords within one of them.
class ArcLimiter : public CallAdapter {
public:
  ArcLimiter(MachineCalls& next, const Post& post, const DecimalGrid& grid)
      : CallAdapter(next), post_(post), grid_(grid)
  {
  }

  void retract() override;
  void changeTool(int number) override;
  void approach(const MachinePosition& to) override;
  void traverse(const MachinePosition& to) override;
  void straight(const MachinePosition& to, std::int64_t feed) override;
  /// @brief Throws Error where nothing says from where.
  void arc(const MachineArc& arc, std::int64_t feed) override;

private:
  const Post& post_;
  const DecimalGrid grid_;
  std::optional<MachinePosition> at_;
};

} // namespace pointmill::gcode
