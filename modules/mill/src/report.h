// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/mill/mill_job.h>

#include <string>

namespace pointmill {

/// @brief The job's report as JSON; see doc/report.md for its members.
std::string reportJson(const MillJob& job, const std::string& scan_name);

} // namespace pointmill
