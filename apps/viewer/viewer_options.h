// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/viewer/viewer.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

/// @brief What `pointmill_viewer` was told on its command line.
struct ViewerOptions {
  std::vector<std::string> inputs, programs;
  std::string scan, screenshot, at;
  pointmill::ViewerLook look;
  std::optional<pointmill::ViewedSolid> solid;
  std::optional<pointmill::ViewedPaths> paths;
  std::optional<pointmill::PathColouring> colouring;
  std::optional<std::size_t> level, finding; ///< counting from 1
  bool play = false, map = false, quiet = false;
  bool no_rapids = false, no_tool = false, no_box = false, no_texts = false,
       no_axes = false;
  int width = 1280, height = 800;
};

/// @brief Declares the options.
void declare(CLI::App& app, ViewerOptions& options);

/// @brief What is shown of the scene: what was asked for, else what there is.
/// @throws ParameterError where there is no such level, finding or moment
pointmill::ViewerLook lookOf(const ViewerOptions& options,
                             const pointmill::ViewerScene& scene);
