// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/mill/mill_job.h>
#include <pointmill/page/html.h>

namespace pointmill::page {

/// @brief What the one who sets up the machine needs: the stock and how it lies, the
/// datum, heights, clamps, tools and cutting data.
/// @param written whether there is a program
Html setupSheet(const MillJob& job, bool written);

} // namespace pointmill::page
