// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "text.h"

#include <string>
#include <vector>

namespace pointmill::visual {

/// @brief Breaks a text between its words into lines of at most @p width px. What does
/// not fit into @p most lines, and a word that fits into none, ends with "...".
std::vector<std::string>
wrapText(const std::string& text, int width, std::size_t most, const TextStyle& style);

} // namespace pointmill::visual
