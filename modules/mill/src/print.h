// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/print.h>

#include <string>

namespace pointmill {

/// @brief "2 h 05 min", "35 min", to the nearest minute, as the page's script does.
std::string hoursAndMinutes(double minutes);

} // namespace pointmill
