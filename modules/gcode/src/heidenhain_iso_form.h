// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "word_form.h"

#include <Eigen/Core>

namespace pointmill::gcode {

/// @brief DIN/ISO as Heidenhain's controls have it: a T word calls the tool with its
/// length, and arcs turn about a pole that was set before.
class HeidenhainIsoForm : public WordForm {
public:
  explicit HeidenhainIsoForm(MachineState& machine)
      : WordForm(ProgramForm::HeidenhainIso, machine)
  {
  }

  bool obey(std::string_view text, std::size_t line) override;

protected:
  void dwell() override;
  double feedUnit(bool inches) const override { return inches ? inch / 10 : 1.0; }
  void setTool() override;
  void setPath() override;
  void obeyNonModal() override;
  void setPole() override;
  Eigen::Vector2d centre(ArcAxes axes, int column) const override;

private:
  bool readHead(std::string_view text, std::size_t line);

  bool begun_ = false;
  Eigen::Vector3d pole_ = Eigen::Vector3d::Constant(unknown);
};

} // namespace pointmill::gcode
