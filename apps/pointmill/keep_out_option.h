// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/keep_out.h>

#include <string>
#include <vector>

/// @brief How a keep-out zone is written on the command line, lengths in mm.
extern const char* const kKeepOutSyntax;

/// @brief Reads one zone, as "box:0,0,20,10,15", "cylinder:X,Y,R,TOP" or
/// "polygon:X,Y,X,Y,X,Y,...,TOP". Numbers have a decimal point in every locale; blanks
/// round them are skipped.
/// @throws ParameterError that names the text and what is wrong with it
pointmill::KeepOutZone readKeepOutZone(const std::string& text);

/// @brief All zones of a program call, with the margin [mm].
/// @throws ParameterError, also for a margin that is out of range
pointmill::KeepOut readKeepOut(const std::vector<std::string>& texts, double margin);
