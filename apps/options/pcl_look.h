// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/viewer/viewer.h>

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

/// @brief Declares pcl_viewer's options -ps, -bc and -ax, with two dashes as CLI11
/// wants them, see withTwoDashes(). They set @p look, which must outlive @p app, and
/// whose values are their defaults.
void declarePclLook(CLI::App& app,
                    pointmill::ViewerLook& look,
                    const std::string& group = "Options");

/// @brief Sets what these options say, and nothing else.
void takePclLook(const pointmill::ViewerLook& said, pointmill::ViewerLook& look);

/// @brief The arguments of a program from the last to the first, as CLI11 takes them.
/// Those that are one of @p names but for the first of their two dashes get it: PCL's
/// tools spell long options with one. A value may follow behind '='.
std::vector<std::string>
withTwoDashes(int argc, char** argv, const std::vector<std::string>& names);
