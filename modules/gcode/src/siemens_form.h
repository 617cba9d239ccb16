// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "word_form.h"

namespace pointmill::gcode {

/// @brief Siemens 840D.
class SiemensForm : public WordForm {
public:
  explicit SiemensForm(MachineState& machine) : WordForm(ProgramForm::Siemens, machine)
  {
  }

protected:
  void dwell() override;
  double feedUnit(bool inches) const override;
  void setTool() override;
  void setLength() override;
  void setPath() override;
  void obeyNonModal() override;

private:
  /// How corners are taken: exactly, without a bound (G64), within `CTOL` (G642) or
  /// within `ADIS` of a corner (G641).
  enum class Corners { NotSaid, Exact, Free, Tolerance, Distance };

  void statePath();
  void applyOffsetNumber();

  int next_tool_ = -1;
  int offset_number_ = 0; // D; 0: none
  Corners corners_ = Corners::NotSaid;
  double tolerance_ = 0.0, distance_ = 0.0; // mm; 0: not said
};

} // namespace pointmill::gcode
