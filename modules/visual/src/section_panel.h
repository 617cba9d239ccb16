// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "canvas.h"
#include "key.h"
#include "section.h"

namespace pointmill::visual {

/// @brief Draws a section into @p card: over it the finding's number and text and where
/// it is cut, then part, stock and tool in one scale, with ticks in millimetres.
void drawSection(Canvas& canvas,
                 const Rect& card,
                 const Section& section,
                 std::size_t number,
                 int unit);

/// @brief Says what the colours of these sections mean.
Key sectionKey(const FindingScene& scene,
               const std::vector<Section>& sections,
               int room,
               int unit);

} // namespace pointmill::visual
