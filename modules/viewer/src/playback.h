// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/viewer/viewer.h>

#include <string>
#include <vector>

namespace pointmill::viewer {

/// @brief What a key does to the look; nothing of it is drawn here. It sets
/// ViewerLook::time where it goes to another moment.
/// @param key by its X name
/// @return whether the key is one of the viewer's
bool changeLook(const std::string& key,
                bool shift,
                const ViewerScene& scene,
                const std::vector<double>& levels,
                ViewerLook& look);

/// @brief When the program does what was found; @p otherwise where nobody knows.
double
momentOf(const ViewerScene& scene, const ViewedFinding& finding, double otherwise);

/// @brief Whether the camera goes elsewhere by the key.
bool movesCamera(const std::string& key);

/// @brief The keys and what they do, a line each.
const std::string& keysHelp();

/// @brief How much faster than the machine a program is played so that it takes about a
/// minute.
double suitableSpeed(double duration);

} // namespace pointmill::viewer
