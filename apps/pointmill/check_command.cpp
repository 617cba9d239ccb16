// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "check_command.h"

#include "post_option.h"

#include <pointmill/io/write_cloud.h>
#include <pointmill/io/write_mesh.h>
#include <pointmill/mill/check.h>
#include <pointmill/mill/result.h>

#include <filesystem>
#include <iostream>
#include <optional>

using namespace pointmill;

namespace {

/// Where of the work reading ends, and where judging does.
constexpr double kReadShare = 0.05, kVerifyShare = 0.9;

/// The stock as it is left: cells as a cloud, or the solid.
void writeMilled(const std::string& path, const CellCloud& milled, double bottom)
{
  if (std::filesystem::path(path).extension() == ".pcd")
    writeCloud(path, milled);
  else
    writeMesh(path, milled, bottom);
}

/// The files that were asked for.
void writeFiles(const CheckCommand& command,
                const Judgement& judgement,
                const Criteria& criteria)
{
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
  command.output.declareQuiet(*check);
  command.output.declareJson(*check);
  return check;
}

int runCheck(const CheckCommand& command, const Watch& watch)
{
  std::optional<ShownProgress> shown(std::in_place, watch, command.output);
  Criteria criteria = [&] {
    const WorkStep step("read", {0.0, kReadShare});
    return Criteria::read(command.directory);
  }();
  criteria.corners_by_control |= command.corners_by_control;
  auto files = openPrograms(command.programs);
  if (!command.post.empty())
    criteria.form = readPost(command.post).form;
  else
    criteria.form = formOf(files.front(), criteria.form);
  Judgement judgement;
  try {
    const WorkStep step("verify", {kReadShare, kVerifyShare});
    judgement = judge(std::move(files), criteria, command.mounted);
  }
  catch (const DataError& e) {
    shown.reset();
    if (command.output.json)
      return writeError(3, "refused", e.what());
    std::cout << forPeople("error unreadable: " + std::string(e.what()) +
                           "\nrefused\n");
    return 3;
  }
  {
    const WorkStep step("files", {kVerifyShare, 1.0});
    writeFiles(command, judgement, criteria);
  }
  shown.reset();
  const bool good = judgement.verification.good();
  const int code = good ? 0 : 3;
  if (command.output.json)
    writeResult(code,
                good ? "passed" : "refused",
                Json::parse(resultJson(judgement, criteria)));
  else if (!command.output.quiet)
    std::cout << forPeople(summaryOf(judgement, criteria));
  return code;
}
