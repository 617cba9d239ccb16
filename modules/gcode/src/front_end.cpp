// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "front_end.h"

#include "rs274_form.h"
#include "siemens_form.h"

#include <pointmill/common/error.h>

namespace pointmill::gcode {

std::unique_ptr<FrontEnd> frontEnd(ProgramForm form, Machine& machine)
{
  switch (form) {
  case ProgramForm::Rs274:
    return std::make_unique<Rs274Form>(machine);
  case ProgramForm::Grbl:
    return std::make_unique<GrblForm>(machine);
  case ProgramForm::Siemens:
    return std::make_unique<SiemensForm>(machine);
  default:
    throw ParameterError("GCodeReader: this form of program cannot be read yet");
  }
}

} // namespace pointmill::gcode
