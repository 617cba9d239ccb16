// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/watch.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>
#include <string>

namespace pointmill {
class ProgressLine;
class ProgressTeller;
} // namespace pointmill

using Json = nlohmann::ordered_json;

/// @brief How a command tells what it does and what came of it.
struct OutputOptions {
  bool quiet = false; ///< nothing but errors, or with JSON but the result
  bool json = false;  ///< lines of JSON, see doc/command_line.md

  void declareQuiet(CLI::App& command);
  void declareJson(CLI::App& command);
};

/// @brief While it lives, people at a terminal see how far the computation is, and
/// other programs are told, as the options say.
class ShownProgress {
public:
  ShownProgress(const pointmill::Watch& watch, const OutputOptions& options);
  ~ShownProgress();
  ShownProgress(const ShownProgress&) = delete;
  ShownProgress& operator=(const ShownProgress&) = delete;

private:
  std::unique_ptr<pointmill::ProgressLine> line_;
  std::unique_ptr<pointmill::ProgressTeller> teller_;
};

/// @brief Writes `{"event": event, ...}` in one line to standard output.
void writeEvent(const std::string& event, const Json& members);

/// @brief The last line of a command that did what it was asked for.
void writeResult(int exit_code, const std::string& status, const Json& members);

/// @brief The last line of one that did not. @return @p exit_code
int writeError(int exit_code,
               const std::string& kind,
               const std::string& message,
               const Json& members = Json::object());

/// @brief The text for standard output, with colours where somebody sees them.
std::string forPeople(const std::string& text);

/// @brief Tells on standard error why the program ends, in the same way.
void printError(const std::string& message);
