// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "json_parts.h"

#include <pointmill/mill/mill_job.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace pointmill {

/// @brief The job's report as JSON; see doc/report.md for its members.
std::string reportJson(const MillJob& job, const std::string& scan_name);

namespace json {
/// @brief What was found in a program, and its figures, as in the report.
/// @param tolerance deepest gouge that passes [mm]
Json verification(const Judgement& judgement, double tolerance);
} // namespace json

/// @brief Names of the program's files by a report; none where it is not one.
std::vector<std::string> programsOf(std::istream& report);

} // namespace pointmill
