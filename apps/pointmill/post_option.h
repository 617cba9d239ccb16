// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/gcode/post.h>

#include <string>

/// @brief What `--post` takes, for its help.
std::string postHelp();

/// @brief The post of that name, or the one that a file describes.
/// @throws ParameterError, DataError
pointmill::Post readPost(const std::string& name);
