// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <utility>

/// @brief What was said of one tool on the command line, in whatever order.
struct ToolOptions {
  explicit ToolOptions(std::string beginning) : name(std::move(beginning)) {}

  std::string name; ///< the options' common beginning, as "finish", or none
  std::optional<std::string> type;
  std::optional<double> diameter, corner, taper, tip, flute_length, shank, stick_out,
      holder;
  std::optional<int> flutes;

  /// @brief What the option is called that ends with @p ending, as "-type".
  std::string option(const std::string& ending) const;

  /// @brief Declares `--NAME-type`, `--NAME-diameter` and so on.
  /// @param standard the tool that it is without them, for the help
  void
  declare(CLI::App& app, const std::string& group, const pointmill::Tool& standard);

  /// @brief The tool that was described; what was not said is as in @p standard.
  /// @throws ParameterError where an option is missing or does not befit the type
  pointmill::Tool toolFrom(const pointmill::Tool& standard) const;
};
