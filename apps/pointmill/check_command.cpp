// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "check_command.h"

#include "post_option.h"

#include <pointmill/io/write_cloud.h>
#include <pointmill/io/write_mesh.h>
#include <pointmill/mill/check.h>

#include <filesystem>
#include <iostream>

using namespace pointmill;

namespace {

/// The stock as it is left: cells as a cloud, or the solid.
void writeMilled(const std::string& path, const CellCloud& milled, double bottom)
{
  if (std::filesystem::path(path).extension() == ".pcd")
    writeCloud(path, milled);
  else
    writeMesh(path, milled, bottom);
}

} // namespace

CLI::App* declareCheck(CLI::App& app, CheckCommand& command)
{
  CLI::App* check = app.add_subcommand(
      "check", "judge any program by the part, tools and stock of an earlier job");
  check->add_option("PROGRAM", command.programs, "its files, in the order of machining")
      ->required();
  check->add_option("--dir", command.directory, "of a job that mill wrote")
      ->type_name("DIR")
      ->required();
  check->add_option("--post", command.post, "control it is written for: " + postHelp())
      ->type_name("POST")
      ->default_str("told by its text, else the job's");
  check
      ->add_option_function<std::string>(
          "--corners",
          [&command](const std::string& by) {
            command.corners_by_control = by == "control";
          },
          "control: let it round corners as it is set, which nothing here can check")
      ->type_name("tolerance|control")
      ->check(CLI::IsMember({"tolerance", "control"}))
      ->default_str("tolerance");
  check
      ->add_option("--tool",
                   command.mounted,
                   "number of the tool that is in the spindle at the start")
      ->type_name("N");
  check->add_option("--picture", command.picture, "write a picture of the findings")
      ->type_name("PNG");
  check
      ->add_option(
          "--report", command.page, "write a page with figures, findings and a 3D view")
      ->type_name("HTML");
  check
      ->add_option(
          "--deviation",
          command.deviation,
          "write what is left over each point of the scan as a cloud (intensity, mm)")
      ->type_name("PCD");
  check
      ->add_option(
          "--milled", command.milled, "write what the program leaves of the stock")
      ->type_name("PLY|STL|PCD");
  check->add_flag("-q,--quiet", command.quiet, "print nothing but errors");
  return check;
}

int runCheck(const CheckCommand& command)
{
  Criteria criteria = Criteria::read(command.directory);
  criteria.corners_by_control |= command.corners_by_control;
  auto files = openPrograms(command.programs);
  if (!command.post.empty())
    criteria.form = readPost(command.post).form;
  else
    criteria.form = formOf(files.front(), criteria.form);
  Judgement judgement;
  try {
    judgement = judge(std::move(files), criteria, command.mounted);
  }
  catch (const DataError& e) {
    std::cout << "error unreadable: " << e.what() << "\nrefused\n";
    return 3;
  }
  const Verification& v = judgement.verification;
  const std::string title =
      std::filesystem::path(command.programs.front()).filename().string();
  if (!command.picture.empty())
    writeFindings(command.picture, title, judgement, criteria);
  if (!command.page.empty())
    writeCheckPage(command.page, title, judgement, criteria);
  if (!command.deviation.empty())
    writeCloud(command.deviation, v.deviations);
  if (!command.milled.empty())
    writeMilled(command.milled, v.milled, criteria.stock.min.z());
  if (!command.quiet)
    std::cout << summaryOf(judgement, criteria);
  return v.good() ? 0 : 3;
}
