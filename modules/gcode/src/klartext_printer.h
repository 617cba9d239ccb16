// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "printer.h"

#include <Eigen/Core>

#include <optional>

namespace pointmill::gcode {

/// @brief Spells moves in Heidenhain's conversational form: `L X+10 F300`, and arcs as
/// `CC X+0 Y+0`, `CP IPA-90 DR-`.
class KlartextPrinter : public Printer {
public:
  KlartextPrinter(std::ostream& out, const Post& post, const PrinterSettings& settings)
      : Printer(out, post, settings)
  {
  }

  void traverse(const MachinePosition& to) override;
  void straight(const MachinePosition& to, std::int64_t feed) override;
  void arc(const MachineArc& arc, std::int64_t feed) override;

protected:
  void forget() override { at_.reset(); }
  void approached(const MachinePosition& to) override;

private:
  /// Where an arc has really ended: an angle has decimals too. Along u and v [ticks].
  struct ArcEnd {
    ArcPlane plane;
    Eigen::Vector2d at;
  };

  char* line(const MachinePosition& to);
  bool isAt(const MachinePosition& to) const;
  bool isStale(int axis) const;
  bool isOff() const;
  Eigen::Vector2d start(ArcPlane plane) const;

  std::optional<MachinePosition> at_; ///< none: write all axes
  std::optional<ArcEnd> arc_end_;     ///< of the block before
};

} // namespace pointmill::gcode
