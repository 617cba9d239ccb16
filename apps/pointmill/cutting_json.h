// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "cutting_command.h"

#include <nlohmann/json.hpp>

/// @brief Cutting data for other programs, see doc/command_line.md.
nlohmann::ordered_json cuttingJson(const CuttingCommand& command,
                                   const pointmill::CutSetting& cut,
                                   const pointmill::CuttingData& data);

/// @brief The materials and their data.
nlohmann::ordered_json materialsJson();
