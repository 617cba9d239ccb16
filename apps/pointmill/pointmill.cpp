// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// pointmill: from the scan of a part to the program that mills it.
// Exit codes: 0 good, 1 usage, 2 bad input, 3 refused by verification, 128 and a
// signal's number where one stopped it: 130 after Ctrl-C.
#include "check_command.h"
#include "cutting_command.h"
#include "mill_command.h"
#include "progress/stop_on_signal.h"

#include <pointmill/common/error.h>
#include <pointmill/common/version.h>

#include <algorithm>
#include <exception>
#include <string>
#include <string_view>

using namespace pointmill;

namespace {

/// Errors of the command line are to be told in JSON too, so it is not asked.
bool wantsJson(int argc, char** argv)
{
  return std::any_of(
      argv, argv + argc, [](std::string_view word) { return word == "--json"; });
}

/// What is missing is told before what is unknown, though a misspelt option may well be
/// what is missing.
std::string whatIsWrong(const CLI::ParseError& e, const CLI::App& app)
{
  if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::RequiredError))
    for (const std::string& word : app.remaining(true))
      if (word.size() > 1 && word[0] == '-')
        return "unknown option " + word;
  return e.what();
}

int run(int argc, char** argv, const Watch& watch)
{
  CLI::App app{
      "Mills 3D scans: PCL filters from a point cloud to a checked NC program"};
  app.set_version_flag("--version", std::string("pointmill ") + version);
  app.require_subcommand(1);
  app.get_formatter()->column_width(44);
  MillCommand mill;
  CLI::App* mill_command = declareMill(app, mill);
  CheckCommand check;
  CLI::App* check_command = declareCheck(app, check);
  CuttingCommand cutting;
  CLI::App* cutting_command = declareCutting(app, cutting);
  try {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) // --help, --version
      return app.exit(e);
    const auto used = app.get_subcommands();
    throw ParameterError(whatIsWrong(e, app) + " (pointmill " +
                         (used.empty() ? "" : used.front()->get_name() + " ") +
                         "--help)");
  }
  if (mill_command->parsed())
    return runMill(mill, watch);
  if (check_command->parsed())
    return runCheck(check, watch);
  if (cutting_command->parsed())
    return runCutting(cutting);
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  Watch watch;
  const StopOnSignal stop(watch);
  const auto fail = [&](int code, const char* kind, const std::string& message) {
    if (wantsJson(argc, argv))
      return writeError(code, kind, message);
    printError(message);
    return code;
  };
  try {
    return run(argc, argv, watch);
  }
  catch (const Interrupted&) {
    return fail(interruptedExitCode(),
                "interrupted",
                "interrupted; nothing is left half written");
  }
  catch (const VerificationError& e) {
    return fail(3, "refused", e.what());
  }
  catch (const ParameterError& e) {
    return fail(1, "usage", e.what());
  }
  catch (const std::exception& e) {
    return fail(2, "input", e.what());
  }
}
