// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/mill/mill_job.h>

#include <string>
#include <vector>

namespace pointmill {

/// @brief Writes the page that people look at: verdict, set-up sheet, figures, findings
/// and pictures of a job, and a 3D view of its part and paths. See doc/report_page.md.
/// @param path in a folder that is thrown away: a file of a picture may stay in it
/// @param pictures names of those beside it
/// @param written whether there is a program, passed or forced
void writeJobPage(const std::string& path,
                  const MillJob& job,
                  const std::string& scan_name,
                  const std::vector<std::string>& pictures,
                  bool written);

} // namespace pointmill
