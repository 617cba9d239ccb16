// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "job_scene.h"

#include <pointmill/io/raw_scan.h>
#include <pointmill/io/read_fields.h>
#include <pointmill/mill/check.h>
#include <pointmill/mill/job_record.h>
#include <pointmill/surface/raw_stock.h>
#include <pointmill/viewer/program_path.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace pointmill;

namespace {

namespace fs = std::filesystem;

/// So many cells of stock can be drawn anew while the cut is played.
constexpr double kMostCells = 160'000;

StockField stockBefore(const Criteria& criteria)
{
  const Eigen::Vector3d size = criteria.stock.max - criteria.stock.min;
  const double cell =
      std::max(criteria.cell / 2, std::sqrt(size.x() * size.y() / kMostCells));
  if (criteria.raw)
    return stockOf(criteria.stock,
                   cell,
                   StockField::Bound::Nominal,
                   *criteria.raw,
                   criteria.raw_reach);
  return StockField(criteria.stock, cell, StockField::Bound::Nominal);
}

std::string lower(std::string text)
{
  for (char& c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string
withTool(const std::string& name, int number, const std::vector<Tool>& tools)
{
  const auto tool = std::find_if(
      tools.begin(), tools.end(), [&](const Tool& t) { return t.number == number; });
  if (tool == tools.end())
    return name;
  return name.empty() ? tool->describe() : name + ", " + tool->describe();
}

/// A section of the program has the colour of the operation of its name and tool, where
/// there is one.
std::vector<ViewedSection> sectionsOf(const Program& program, const JobRecord& record)
{
  std::vector<ViewedSection> sections;
  for (const auto& section : program.sections) {
    const auto at = std::find_if(
        record.operations.begin(), record.operations.end(), [&](const auto& o) {
          return o.tool == section.tool && lower(o.name) == lower(section.name);
        });
    const bool known = at != record.operations.end();
    sections.push_back(
        {withTool(known ? at->name : section.name, section.tool, record.criteria.tools),
         known ? at->colour : static_cast<int>(sections.size())});
  }
  return sections;
}

ViewedFinding viewed(const Finding& finding, const Program& program)
{
  ViewedFinding v;
  v.error = finding.severity == Severity::Error;
  v.text = (v.error ? "error " : "warning ") + finding.code + ": " + finding.text;
  if (finding.line > 0)
    v.text += " (" + program.where(finding.line) + ")";
  v.line = finding.line;
  if (finding.place.allFinite() && !finding.place.isZero())
    v.place = finding.place;
  return v;
}

void addPath(ViewerScene& scene,
             const std::string& path,
             const std::vector<RecordedOperation>& operations,
             const std::vector<Tool>& tools)
{
  scene.path = readPoints<PointCL>(path);
  std::size_t first = 0;
  for (const auto& o : operations) {
    scene.operations.push_back(
        {withTool(o.name, o.tool, tools), o.colour, first, o.cl_points});
    first += o.cl_points;
  }
}

} // namespace

ViewerScene sceneOfJob(const std::string& directory,
                       const std::vector<std::string>& programs)
{
  JobRecord record = JobRecord::read(directory);
  const Criteria& criteria = record.criteria;
  const auto in = [&](const char* name) {
    return (fs::path(directory) / name).string();
  };
  ViewerScene scene;
  scene.title = record.scan;
  scene.stock = criteria.stock;
  scene.tolerance = criteria.tolerance;
  scene.part =
      std::make_shared<pcl::PointCloud<pcl::PointXYZ>>(criteria.part->toCloud());
  scene.map = readPoints<PointCell>(in("map.pcd"));

  auto files = openPrograms(programs.empty() ? record.programs : programs);
  auto program = std::make_shared<Program>();
  std::vector<double> ends;
  if (programs.empty()) {
    addPath(scene, in("cl.pcd"), record.operations, criteria.tools);
    scene.deviation = readPoints<pcl::PointXYZI>(in("deviation.pcd"));
    *program = readPrograms(std::move(files), criteria);
    ends = timeOf(*program, criteria).ends;
  }
  else {
    scene.title += ", " + fs::path(programs.front()).filename().string();
    Criteria other = criteria;
    other.form = formOf(files.front(), criteria.form);
    Judgement judgement = judge(std::move(files), other);
    scene.deviation = std::make_shared<pcl::PointCloud<pcl::PointXYZI>>(
        std::move(judgement.verification.deviations));
    record.findings = judgement.verification.findings;
    ends = std::move(judgement.time.ends);
    *program = std::move(judgement.program);
  }
  for (const auto& finding : record.findings)
    scene.findings.push_back(viewed(finding, *program));
  scene.sections = sectionsOf(*program, record);
  scene.player = std::make_shared<CutPlayer>(
      stockBefore(criteria), program, std::move(ends), criteria.tools);
  if (!scene.path)
    addProgramPath(scene);
  return scene;
}

void addScan(ViewerScene& scene, const std::string& path, const std::string& directory)
{
  const JobRecord record = JobRecord::read(directory);
  pcl::PointCloud<pcl::PointXYZ> placed;
  for (const auto& p : readScan(path).points) {
    const Eigen::Vector3d at =
        (record.alignment * (record.mm_per_unit * p).homogeneous()).head<3>();
    const Eigen::Vector3f f = at.cast<float>();
    placed.push_back({f.x(), f.y(), f.z()});
  }
  pcl::PCLPointCloud2::Ptr cloud(new pcl::PCLPointCloud2);
  pcl::toPCLPointCloud2(placed, *cloud);
  scene.clouds.push_back({path, cloud});
}
