// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/viewer/viewer_scene.h>

#include <string>
#include <vector>

/// @brief What a job left in its directory, ready to be played.
/// @param programs files of another program, which is judged first; empty: the job's
/// own, with what the job found
/// @throws DataError
pointmill::ViewerScene sceneOfJob(const std::string& directory,
                                  const std::vector<std::string>& programs);

/// @brief Adds a file: a CL cloud and an occupancy map as what they are, anything else
/// as a cloud.
/// @throws DataError
void addFile(pointmill::ViewerScene& scene, const std::string& path);

/// @brief Adds the scan that a job was made from, in the job's part frame.
/// @throws DataError
void addScan(pointmill::ViewerScene& scene,
             const std::string& path,
             const std::string& directory);
