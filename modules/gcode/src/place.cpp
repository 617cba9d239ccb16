// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "place.h"

#include <pointmill/common/error.h>

namespace pointmill::gcode {

void refuse(Place place, const std::string& what)
{
  throw DataError("line " + std::to_string(place.line) + ", column " +
                  std::to_string(place.column) + ": " + what);
}

std::string shown(char c)
{
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x20 && byte < 0x7F)
    return std::string("'") + c + "'";
  const char* const digits = "0123456789ABCDEF";
  return std::string("byte 0x") + digits[byte >> 4] + digits[byte & 15];
}

} // namespace pointmill::gcode
