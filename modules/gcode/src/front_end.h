// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "machine_state.h"

#include <pointmill/gcode/gcode_reader.h>

#include <cstddef>
#include <memory>
#include <string_view>

namespace pointmill::gcode {

/// @brief Understands the lines of one form of program and tells a Machine.
class FrontEnd {
public:
  virtual ~FrontEnd() = default;

  /// @brief Obeys one line; false at the end of the program. Throws DataError with line
  /// and column.
  virtual bool obey(std::string_view text, std::size_t line) = 0;

  /// @brief The text is at its end without the program's.
  virtual void finish() const {}
};

/// @brief That of @p form.
std::unique_ptr<FrontEnd> frontEnd(ProgramForm form, MachineState& machine);

} // namespace pointmill::gcode
