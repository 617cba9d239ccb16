// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/mill/mill_job.h>

#include <string>

namespace pointmill {

/// @brief What a job gave, for other programs: one line of JSON, an object whose
/// members doc/command_line.md explains.
/// @param directory where MillJob::write() or MillJob::writeRefusal() put its files
std::string resultJson(const MillJob& job, const std::string& directory);

/// @brief The same of a program that was judged.
std::string resultJson(const Judgement& judgement, const Criteria& criteria);

} // namespace pointmill
