// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "canvas.h"
#include "section.h"

#include <vector>

namespace pointmill::visual {

/// @brief Draws the part from above into @p card, with the number of each finding that
/// has a place, the ways of the tool that they name, and where the sections are cut.
/// @param milled is shown where there are no points
void drawFindingMap(Canvas& canvas,
                    const Rect& card,
                    const FindingScene& scene,
                    const std::optional<Grid>& milled,
                    const std::vector<Section>& sections,
                    int unit);

} // namespace pointmill::visual
