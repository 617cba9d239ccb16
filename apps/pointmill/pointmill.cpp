// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// pointmill: from the scan of a part to the program that mills it.
// Exit codes: 0 good, 1 usage, 2 bad input, 3 refused by verification.
#include "check_command.h"
#include "cutting_command.h"
#include "mill_command.h"

#include <pointmill/common/error.h>
#include <pointmill/common/version.h>

#include <exception>
#include <iostream>

int main(int argc, char** argv)
{
  CLI::App app{
      "Mills 3D scans: PCL filters from a point cloud to a checked NC program"};
  app.set_version_flag("--version", std::string("pointmill ") + pointmill::version);
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
    if (mill_command->parsed())
      return runMill(mill);
    if (check_command->parsed())
      return runCheck(check);
    if (cutting_command->parsed())
      return runCutting(cutting);
  }
  catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) // --help, --version
      return app.exit(e);
    const auto used = app.get_subcommands();
    std::cerr << "pointmill: " << e.what() << " (pointmill "
              << (used.empty() ? "" : used.front()->get_name() + " ") << "--help)\n";
    return 1;
  }
  catch (const Interrupted& e) {
    std::cerr << "pointmill: " << e.what() << '\n';
    return 130;
  }
  catch (const pointmill::VerificationError& e) {
    std::cerr << "pointmill: " << e.what() << '\n';
    return 3;
  }
  catch (const pointmill::ParameterError& e) {
    std::cerr << "pointmill: " << e.what() << '\n';
    return 1;
  }
  catch (const std::exception& e) {
    std::cerr << "pointmill: " << e.what() << '\n';
    return 2;
  }
  return 0;
}
