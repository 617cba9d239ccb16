// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "output.h"

#include "colours.h"
#include "progress/progress_line.h"
#include "progress/terminal.h"

#include <unistd.h>

#include <cmath>
#include <iostream>

using namespace pointmill;

namespace {

constexpr double kPeriod = 1.0; // s, between two events

/// No more digits than mean something.
double rounded(double value, double digits)
{
  return std::round(value * digits) / digits;
}

Json of(const Progress& progress)
{
  Json json = {{"stage", progress.stage},
               {"share", rounded(progress.share, 1e4)},
               {"seconds", rounded(progress.seconds, 10)},
               {"seconds_left", nullptr}};
  if (progress.left)
    json["seconds_left"] = rounded(*progress.left, 10);
  return json;
}

} // namespace

void OutputOptions::declareQuiet(CLI::App& command)
{
  command.add_flag("-q,--quiet", quiet, "print nothing but errors");
}

void OutputOptions::declareJson(CLI::App& command)
{
  command.add_flag("--json", json, "print lines of JSON, for other programs");
}

ShownProgress::ShownProgress(const Watch& watch, const OutputOptions& options)
{
  if (options.quiet)
    return;
  if (options.json)
    teller_ =
        std::make_unique<ProgressTeller>(watch, kPeriod, [](const Progress& progress) {
          writeEvent("progress", of(progress));
        });
  else
    line_ = std::make_unique<ProgressLine>(watch);
}

ShownProgress::~ShownProgress() = default;

void writeEvent(const std::string& event, const Json& members)
{
  Json line = {{"event", event}};
  line.update(members);
  // Names of files may be in any encoding, JSON is in UTF-8.
  std::cout << line.dump(-1, ' ', false, Json::error_handler_t::replace) << std::endl;
}

void writeResult(int exit_code, const std::string& status, const Json& members)
{
  Json result = {{"exit_code", exit_code}, {"status", status}};
  result.update(members);
  writeEvent("result", result);
}

int writeError(int exit_code,
               const std::string& kind,
               const std::string& message,
               const Json& members)
{
  Json error = {{"exit_code", exit_code}, {"status", kind}, {"message", message}};
  error.update(members);
  writeEvent("error", error);
  return exit_code;
}

std::string forPeople(const std::string& text)
{
  return takesColours(STDOUT_FILENO) ? coloured(text) : text;
}

void printError(const std::string& message)
{
  const std::string text = "pointmill: " + message + "\n";
  std::cerr << (takesColours(STDERR_FILENO) ? coloured(text) : text);
}
