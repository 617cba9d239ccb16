// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "output.h"
#include "tool_options.h"

#include <pointmill/mill/mill_options.h>

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// @brief What `pointmill mill` was told on its command line.
struct MillCommand {
  pointmill::MillOptions options;
  const CLI::App* app = nullptr; ///< that declares the options
  ToolOptions rough_tool{"rough"}, semi_tool{"semi"}, finish_tool{"finish"};
  std::string scan, directory;
  std::optional<double> rest_diameter;
  std::vector<double> stock_box, travel; ///< X0 Y0 Z0 X1 Y1 Z1
  std::string material;
  std::vector<std::string> keep_out;
  double keep_out_margin = pointmill::KeepOut().margin();
  std::vector<double> polygon; ///< X and Y in turn
  std::vector<std::pair<double, double>> through_holes;
  OutputOptions output;
  bool no_square = false, keep_strays = false, no_coolant = false;
  bool no_arcs = false;
};

/// @name The options of `mill` by their groups
/// @{
void declareScan(CLI::App& mill, MillCommand& command);
void declareAccuracy(CLI::App& mill, MillCommand& command);
void declareSetUp(CLI::App& mill, MillCommand& command);
void declareMachine(CLI::App& mill, MillCommand& command);
void declareProgram(CLI::App& mill, MillCommand& command);
void declareOperations(CLI::App& mill, MillCommand& command);
/// @}

/// @brief Declares the command and its options.
CLI::App* declareMill(CLI::App& app, MillCommand& command);

/// @brief Does what the command says. @return the exit code
int runMill(MillCommand& command, const pointmill::Watch& watch);
