// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "front_end.h"

#include "heidenhain_iso_form.h"
#include "klartext_form.h"

#include "rs274_form.h"
#include "siemens_form.h"

#include <pointmill/common/error.h>

namespace pointmill::gcode {

std::unique_ptr<FrontEnd> frontEnd(ProgramForm form, MachineState& machine)
{
  switch (form) {
  case ProgramForm::Rs274:
    return std::make_unique<Rs274Form>(machine);
  case ProgramForm::Grbl:
    return std::make_unique<GrblForm>(machine);
  case ProgramForm::Siemens:
    return std::make_unique<SiemensForm>(machine);
  case ProgramForm::HeidenhainIso:
    return std::make_unique<HeidenhainIsoForm>(machine);
  case ProgramForm::Klartext:
    return std::make_unique<KlartextForm>(machine);
  }
  throw ParameterError("GCodeReader: there is no such form of program");
}

} // namespace pointmill::gcode
