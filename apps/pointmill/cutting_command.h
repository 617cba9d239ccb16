// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "output.h"
#include "tool_options.h"

#include <pointmill/common/cutting_data.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

/// @brief What `pointmill cutting` was told on its command line.
struct CuttingCommand {
  pointmill::CutSetting cut;
  pointmill::Machine machine;
  ToolOptions tool{""};
  std::string material;
  std::string kind = "roughing";
  std::optional<double> length, volume; ///< to mill [mm], [cm3]
  bool list = false, hss = false;
  OutputOptions output;
};

/// @brief Declares the command and its options.
CLI::App* declareCutting(CLI::App& app, CuttingCommand& command);

/// @brief Does what the command says. @return the exit code
int runCutting(const CuttingCommand& command);
