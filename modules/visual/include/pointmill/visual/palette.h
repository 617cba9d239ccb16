// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <string>

namespace pointmill {

/// @name The pictures' colours as "#rrggbb", for what is shown beside them
/// @{

/// @brief Of an operation, PreviewOperation::colour or its place in the list.
std::string operationColour(int number);

/// @brief Of a height, @p share from 0 (lowest) to 1.
std::string heightColour(double share);

/// @brief Of a deviation from the part, with the scale that deviationRange() tells
/// [mm].
std::string deviationColour(double deviation, double tolerance, double range);

/// @brief Of what no tool came to.
std::string neverCutColour();
/// @}

} // namespace pointmill
