// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/mill/mill_job.h>
#include <pointmill/page/view_scene.h>

namespace pointmill {

/// @brief What the 3D view shows of a judged program: milled part, deviations and the
/// paths of its sections. Those of one operation that follow each other are one path.
ViewScene viewOf(const Judgement& judgement, const Criteria& criteria);

/// @brief The same with what the job knows: the scan's heights, and its operations'
/// names and colours.
ViewScene viewOf(const MillJob& job);

} // namespace pointmill
