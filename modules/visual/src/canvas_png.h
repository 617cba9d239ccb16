// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "canvas.h"

#include <string>

namespace pointmill::visual {

/// @brief Writes the picture beside @p path and renames it: whoever reads it never sees
/// half of it.
/// @throws DataError where that fails; nothing is left then
void writePng(const std::string& path, const Canvas& canvas);

} // namespace pointmill::visual
