// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pointmill::gcode {

/// @brief What stands for the places of a template, by their names.
using Places = std::vector<std::pair<std::string, std::string>>;

/// @brief The names of the places in @p line: "T{tool} M6" has tool, "O{number:5}",
/// which is padded with zeros to 5 characters, number. Throws ParameterError for a
/// brace without its other one and for what is not a name.
std::vector<std::string> placesIn(const std::string& line);

/// @brief @p line with its places filled; each must be among @p places.
std::string fill(const std::string& line, const Places& places);

} // namespace pointmill::gcode
