// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "output.h"

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

/// @brief What `pointmill check` was told on its command line.
struct CheckCommand {
  std::vector<std::string> programs; ///< in the order of machining
  std::string directory, post, picture, page, deviation, milled;
  int mounted = 0;
  bool corners_by_control = false;
  OutputOptions output;
};

/// @brief Declares the command and its options.
CLI::App* declareCheck(CLI::App& app, CheckCommand& command);

/// @brief Does what the command says. @return the exit code: 0 passed, 3 refused
int runCheck(const CheckCommand& command, const pointmill::Watch& watch);
