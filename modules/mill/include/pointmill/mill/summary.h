// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/mill/mill_job.h>

#include <string>
#include <vector>

namespace pointmill {

/// @brief The few lines that tell a person what a job gives, and what to mind.
/// @param directory where its files are
std::string summaryOf(const MillJob& job, const std::string& directory);

/// @brief What is not wrong but should be known before the machine is started, a line
/// each: sinking between sparse points, deep cuts, a part that is cut free.
std::vector<std::string> warningsOf(const MillJob& job);

} // namespace pointmill
