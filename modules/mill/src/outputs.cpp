// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "job_page.h"
#include "print.h"
#include "report.h"

#include <pointmill/common/watch.h>
#include <pointmill/io/write_cloud.h>
#include <pointmill/io/write_file.h>
#include <pointmill/mill/mill_job.h>
#include <pointmill/slice/z_slices.h>
#include <pointmill/surface/curvature.h>
#include <pointmill/visual/curvature_picture.h>
#include <pointmill/visual/deviation_picture.h>
#include <pointmill/visual/gaps_picture.h>
#include <pointmill/visual/heights_picture.h>
#include <pointmill/visual/levels_picture.h>
#include <pointmill/visual/occupancy_picture.h>
#include <pointmill/visual/preview.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <random>
#include <set>

namespace pointmill {
namespace {

namespace fs = std::filesystem;

/// Of the map of the curvature: points of a fit, and cells.
constexpr std::size_t kCurvaturePoints = 60, kCurvatureCells = 40000;

/// A directory beside the real one that is gone when this is, whatever happens.
class Staging {
public:
  explicit Staging(const fs::path& target)
  {
    fs::path parent = fs::absolute(target).lexically_normal();
    if (!parent.has_filename())
      parent = parent.parent_path();
    const std::string name = parent.filename().string();
    parent = parent.parent_path();
    std::error_code failure;
    fs::create_directories(parent, failure);
    std::random_device random;
    path_ = parent / ("." + name + ".partial-" + std::to_string(random()));
    if (failure || !fs::create_directory(path_, failure))
      throw DataError(target.string() + ": cannot be made: " + failure.message());
  }
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  ~Staging()
  {
    std::error_code ignored; // nothing is lost with a directory that nobody named
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

private:
  fs::path path_;
};

std::string text(const char* format, double value)
{
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

/// Three levels that show the part: a quarter, the half and three quarters down.
std::vector<double> shownLevels(const MillJob& job)
{
  ZSlices slices;
  slices.setZLimits(job.floor(), job.stock().top());
  slices.setPitch(job.options().stepDown());
  const auto levels = slices.levels();
  std::vector<double> shown;
  for (const double share : {0.25, 0.5, 0.75}) {
    const double z =
        levels[static_cast<std::size_t>(share * static_cast<double>(levels.size()))];
    if (shown.empty() || shown.back() != z)
      shown.push_back(z);
  }
  return shown;
}

/// Whether the gaps' picture has something to show: a few cells between points are in
/// every scan.
bool hasGaps(const MillJob& job)
{
  if (!job.gaps().empty())
    return true;
  constexpr double substantial = 0.01; // of the part's cells
  std::size_t between = 0, part = 0;
  for (const auto& cell : job.map()) {
    between += cell.getState() == CellState::Between;
    part += cell.getState() != CellState::Empty;
  }
  return double(between) > substantial * double(part);
}

/// The levels that the roughing cuts, from the top down; those to show without one.
std::vector<double> cutLevels(const MillJob& job)
{
  std::set<double, std::greater<>> heights;
  const auto& operations = job.operations();
  if (!operations.empty() && operations.front().operation.name == "roughing") {
    std::map<std::uint32_t, double> lowest;
    for (const auto& p : operations.front().operation.path)
      if (p.getMotion() == Motion::Cut) {
        const auto known = lowest.emplace(p.level, p.z).first;
        known->second = std::min<double>(known->second, p.z);
      }
    for (const auto& level : lowest)
      heights.insert(level.second);
  }
  return heights.empty() ? shownLevels(job)
                         : std::vector<double>(heights.begin(), heights.end());
}

PreviewScene sceneOf(const MillJob& job, const std::string& title)
{
  PreviewScene scene;
  scene.title = title;
  scene.scan = &job.part();
  scene.map = &job.map();
  scene.stock = job.stock();
  scene.milled = &job.verification().milled;
  int number = 0;
  for (const auto& planned : job.operations())
    scene.operations.push_back({std::to_string(++number) + "  " +
                                    planned.operation.name + ", T" +
                                    std::to_string(planned.operation.tool.number),
                                &planned.operation.path,
                                planned.colour});
  const Verification& v = job.verification();
  const Quantiles& off =
      job.surfaceFigures().farthest > 0 ? v.raw_deviation : v.deviation;
  scene.figures = {
      hoursAndMinutes(job.minutes()) + " of milling",
      text("deepest gouge %.4f mm", v.gouge) +
          (job.surfaceFigures().farthest > 0 ? text(", as scanned %.3f mm", v.raw_gouge)
                                             : std::string()),
      text("deviation in reach p5 %+.3f", off.p5) + text(" .. p95 %+.3f mm", off.p95),
      std::to_string(v.rapids_in_stock) + " rapids through stock",
      text("not scanned, protected: %.0f mm\xC2\xB2", job.gapArea()) +
          text(" and %.0f mm\xC2\xB2 between points", job.bridgedArea()),
      text("out of reach or covered: %.1f %% of the points",
           100.0 * static_cast<double>(v.unreachable_points) /
               static_cast<double>(std::max<std::size_t>(1, v.points)))};
  return scene;
}

/// What an earlier job may have left that this one need not have.
const char* const kMayBeOld[] = {"gaps.png",
                                 "occupancy_1.png",
                                 "occupancy_2.png",
                                 "occupancy_3.png",
                                 "findings.png",
                                 "model.pcd",
                                 "bridges.pcd",
                                 "raw_part.pcd",
                                 "refused.png",
                                 "refused.html",
                                 "refused.json"};

/// The files of an earlier job's program, by its report.
std::vector<std::string> programsIn(const fs::path& directory)
{
  std::ifstream in(directory / "report.json");
  auto names = programsOf(in);
  if (names.empty())
    names.emplace_back("program.ngc");
  return names;
}

/// What an earlier job left that must go.
std::vector<std::string> leftIn(const fs::path& directory)
{
  auto names = programsIn(directory);
  names.insert(names.end(), std::begin(kMayBeOld), std::end(kMayBeOld));
  return names;
}

/// Moves files from where they were written to where they are to be.
void install(const fs::path& from,
             const fs::path& directory,
             const std::vector<std::string>& names,
             std::vector<std::string> old)
{
  std::error_code failure;
  fs::create_directories(directory, failure);
  for (const auto& name : names)
    if (fs::is_directory(directory / name))
      throw DataError(directory.string() + ": " + name + " is a directory there");
  // An old program must not stand beside a new part, nor an old picture beside both.
  for (const auto& name : old)
    if (!failure)
      fs::remove(directory / name, failure);
  for (const auto& name : names) {
    if (!failure)
      fs::rename(from / name, directory / name, failure);
    if (failure)
      throw DataError(directory.string() + ": cannot be written: " + failure.message());
  }
}

} // namespace

void MillJob::checkDirectory(const std::string& scan, const std::string& directory)
{
  std::error_code ignored; // what does not exist cannot be the same
  if (directory.empty())
    throw DataError("the output directory has no name");
  if (fs::exists(directory, ignored) && !fs::is_directory(directory, ignored))
    throw DataError(directory +
                    ": is a file; name a directory for the program (-o DIR)");
  for (const char* name :
       {"program.ngc", "part.pcd", "cl.pcd", "preview.png", "report.json"})
    if (fs::equivalent(scan, fs::path(directory) / name, ignored))
      throw DataError(scan + ": would be overwritten; name another directory (-o DIR)");
}

void MillJob::write(const std::string& directory)
{
  if (!passed_)
    throw VerificationError("there is no program that passed its verification");
  checkDirectory(scan_path_, directory);
  Staging staging(directory);
  const auto in = [&](const std::string& name) {
    return (staging.path() / name).string();
  };
  std::vector<std::string> names;
  timed("pictures", [&] {
    int number = 0;
    for (const double level : shownLevels(*this)) {
      names.push_back("occupancy_" + std::to_string(++number) + ".png");
      writeOccupancy(in(names.back()), *map_, level);
    }
    names.push_back("levels.png");
    writeLevels(in("levels.png"), *map_, cutLevels(*this));
    names.push_back("heights.png");
    writeHeights(in("heights.png"), *map_, "heights of the part");
    if (hasGaps(*this)) {
      names.push_back("gaps.png");
      writeGaps(in("gaps.png"), *map_, gaps_);
    }
    names.push_back("curvature.png");
    const CurvatureMap bent = mapCurvature(
        *surface_, *map_, kCurvaturePoints, kCurvatureCells, options_.threads);
    writeCurvature(in("curvature.png"), bent.hollow, bent.ridge, tools());
    names.push_back("preview.png");
    {
      const WorkStep step({0.1, 0.6});
      writePreview(in("preview.png"), sceneOf(*this, scan_name_));
    }
    names.push_back("deviation.png");
    writeDeviation(in("deviation.png"),
                   verification().deviations,
                   options_.tolerance,
                   verification().in_reach);
    if (!verification().findings.empty()) {
      names.push_back("findings.png");
      writeFindings(in("findings.png"), scan_name_, judgement_, criteria_);
    }
  });
  timed("page", [&] {
    writeJobPage(in("report.html"), *this, scan_name_, names, true);
    names.push_back("report.html");
  });
  timed("files", [&] {
    names.push_back("part.pcd");
    writeCloud(in("part.pcd"), *part_);
    for (const auto& name : criteria_.writeClouds(staging.path().string()))
      names.push_back(name);
    names.push_back("map.pcd");
    writeCloud(in("map.pcd"), *map_);
    names.push_back("deviation.pcd");
    writeCloud(in("deviation.pcd"), verification().deviations);
    names.push_back("cl.pcd");
    CLCloud all;
    for (const auto& o : operations_)
      all += o.operation.path;
    writeCloud(in("cl.pcd"), all);
  });
  names.push_back("report.json");
  writeFileAtomically(in("report.json"),
                      [&](std::ostream& out) { out << reportJson(*this, scan_name_); });
  for (const auto& program : programs_) { // last: where it is, the others are
    names.push_back(program.name);
    writeFileAtomically(in(program.name),
                        [&](std::ostream& out) { out << program.text; });
  }
  checkInterrupted(); // from here on it is all or nothing
  install(staging.path(), directory, names, leftIn(directory));
  files_ = names;
}

void MillJob::writeRefusal(const std::string& directory)
{
  if (passed_ || verification().findings.empty())
    throw VerificationError("there is no program that was refused");
  Staging staging(directory);
  const WorkStep step("picture", {done_, 1.0});
  writeFindings(
      (staging.path() / "refused.png").string(), scan_name_, judgement_, criteria_);
  writeFileAtomically((staging.path() / "refused.json").string(),
                      [&](std::ostream& out) { out << reportJson(*this, scan_name_); });
  // What was planned is shown there, lest it be taken for a result beside it.
  const auto in = [&](const std::string& name) {
    return (staging.path() / name).string();
  };
  writePreview(in("preview.png"), sceneOf(*this, scan_name_));
  writeDeviation(in("deviation.png"),
                 verification().deviations,
                 options_.tolerance,
                 verification().in_reach);
  writeJobPage(in("refused.html"),
               *this,
               scan_name_,
               {"refused.png", "preview.png", "deviation.png"},
               false);
  checkInterrupted(); // from here on it is all or nothing
  earlier_program_ = false;
  for (const auto& name : programsIn(directory)) {
    std::error_code failure;
    const fs::path old = fs::path(directory) / name;
    if (!fs::exists(old, failure))
      continue;
    fs::rename(old, old.string() + ".earlier", failure);
    if (failure)
      throw DataError(old.string() + ": cannot be renamed: " + failure.message());
    earlier_program_ = true;
  }
  files_ = {"refused.png", "refused.html", "refused.json"};
  install(staging.path(), directory, files_, {});
}

} // namespace pointmill
