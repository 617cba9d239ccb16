// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "word_form.h"

namespace pointmill::gcode {

/// @brief RS-274 as LinuxCNC understands it, with what Fanuc and Haas have besides.
class Rs274Form : public WordForm {
public:
  explicit Rs274Form(MachineState& machine) : Rs274Form(ProgramForm::Rs274, machine) {}

protected:
  Rs274Form(ProgramForm form, MachineState& machine) : WordForm(form, machine) {}

  void dwell() override;
  void setTool() override;
  void setLength() override;
  void setOffset() override;
  void setPath() override;
  void obeyNonModal() override;

  /// @brief The last T word, -1 without one.
  int nextTool() const { return next_tool_; }
  void readTool();

private:
  void moveInMachineFrame(int column);
  void returnHome(bool first_point, int column);
  void shiftFrame(int column);
  void setSmoothness();
  void checkAlone(int column, const char* what) const;

  int next_tool_ = -1;
};

/// @brief Grbl: no tool changer and no tool lengths. A T word before the first cut says
/// what is in the spindle; later ones are obeyed by hand during the next M0. Either way
/// the operator touches off.
class GrblForm : public Rs274Form {
public:
  explicit GrblForm(MachineState& machine);

protected:
  void setTool() override;
  void setLength() override {}
  void setPath() override {}
  void checkTool(int column) const override;
  void pause() override;

private:
  void fit(int column);
};

} // namespace pointmill::gcode
