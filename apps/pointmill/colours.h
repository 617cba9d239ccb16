// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <string>

/// @brief @p text with a few words in colour and the heads of tables in bold. It says
/// nothing that its words do not say: who sees no colours misses nothing.
std::string coloured(const std::string& text);
