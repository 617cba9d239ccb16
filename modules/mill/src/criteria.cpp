// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "criteria_json.h"

#include <pointmill/common/error.h>
#include <pointmill/common/watch.h>
#include <pointmill/io/read_cloud.h>
#include <pointmill/io/write_cloud.h>
#include <pointmill/mill/criteria.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

namespace pointmill {
namespace {

namespace fs = std::filesystem;
using json::Json;

/// A thicker layer at once than this is worth a warning, in diameters of the tool's
/// end.
constexpr double kDeep = 1.5;

Criteria::Points pointsFrom(const fs::path& path, unsigned threads)
{
  checkInterrupted();
  const auto cloud = readCloud(path.string());
  return std::make_shared<PointIndex>(std::vector<PointSource>{pointSource(cloud)},
                                      threads);
}

struct FormName {
  ProgramForm form;
  const char* name;
};
constexpr FormName kForms[] = {{ProgramForm::Rs274, "rs274"},
                               {ProgramForm::Grbl, "grbl"},
                               {ProgramForm::Siemens, "siemens"},
                               {ProgramForm::HeidenhainIso, "heidenhain_iso"},
                               {ProgramForm::Klartext, "klartext"}};

const char* nameOf(ProgramForm form)
{
  return std::find_if(std::begin(kForms),
                      std::end(kForms),
                      [&](const FormName& f) { return f.form == form; })
      ->name;
}

ProgramForm formNamed(const std::string& name)
{
  for (const auto& f : kForms)
    if (name == f.name)
      return f.form;
  throw DataError("report.json: criteria: the form " + name + " is not known");
}

/// The clouds beside the part, which the job writes itself.
struct Beside {
  Criteria::Points Criteria::*points;
  const char* name; ///< in report.json
  const char* file;
};
constexpr Beside kBeside[] = {{&Criteria::model, "model", "model.pcd"},
                              {&Criteria::bridges, "bridges", "bridges.pcd"},
                              {&Criteria::raw, "raw_part", "raw_part.pcd"}};

} // namespace

Verification Criteria::judge(const Program& program) const
{
  ProgramVerifier verifier;
  verifier.setPart(part);
  if (model) {
    verifier.setModel(model);
    verifier.setNoiseAllowance(noise_allowance);
  }
  verifier.setStock(stock);
  if (raw)
    verifier.setRawStock(raw, raw_reach);
  verifier.setTools(tools);
  verifier.setMachine(machine);
  for (const auto& tool : tools)
    verifier.setAxialLimit(tool.number, kDeep * tool.endDiameter());
  verifier.setKeepOut(keep_out);
  // What the control may add by blending corners cannot be seen in the text.
  verifier.setTolerance(gougeLimit());
  verifier.setResidualLimit(residual_limit);
  verifier.setExpectedResidual(left_p90);
  verifier.setCellSize(cell);
  verifier.setFloor(floor);
  verifier.setProtected(bridges);
  verifier.setBlendLimit(corners_by_control ? std::numeric_limits<double>::infinity()
                                            : blend + 1e-9);
  verifier.setNumberOfThreads(threads);
  return verifier.verify(program);
}

std::vector<std::string> Criteria::writeClouds(const std::string& directory) const
{
  std::vector<std::string> names;
  for (const auto& beside : kBeside)
    if (this->*beside.points) {
      names.emplace_back(beside.file);
      writeCloud((fs::path(directory) / beside.file).string(),
                 (this->*beside.points)->toCloud());
    }
  return names;
}

Json json::of(const Criteria& criteria)
{
  Json json = {{"gouge_tolerance_mm", criteria.tolerance},
               {"control_blend_mm", criteria.blend},
               {"corners_by_control", criteria.corners_by_control},
               {"noise_allowance_mm", criteria.noise_allowance},
               {"residual_limit_mm", criteria.residual_limit},
               {"left_p90_mm", number(criteria.left_p90)},
               {"floor_z", criteria.floor},
               {"cell_mm", criteria.cell},
               {"arc_error_mm", criteria.arc_error},
               {"form", nameOf(criteria.form)},
               {"raw_reach_mm", criteria.raw_reach}};
  json["clouds"] = Json{{"part", "part.pcd"}};
  for (const auto& beside : kBeside)
    if (criteria.*beside.points)
      json["clouds"][beside.name] = beside.file;
  return json;
}

Criteria Criteria::read(const std::string& directory)
{
  const fs::path folder(directory);
  const std::string path = (folder / "report.json").string();
  std::ifstream in(path);
  if (!in)
    throw DataError(path + ": cannot be read; --dir names the directory of a job that "
                           "was milled before");
  Criteria criteria;
  Json clouds;
  try {
    const Json report = Json::parse(in);
    const Json& json = report.at("criteria");
    criteria.tolerance = json.at("gouge_tolerance_mm");
    criteria.blend = json.at("control_blend_mm");
    criteria.corners_by_control = json.at("corners_by_control");
    criteria.noise_allowance = json.at("noise_allowance_mm");
    criteria.residual_limit = json.at("residual_limit_mm");
    if (json.at("left_p90_mm").is_number())
      criteria.left_p90 = json.at("left_p90_mm");
    criteria.floor = json.at("floor_z");
    criteria.cell = json.at("cell_mm");
    criteria.arc_error = json.at("arc_error_mm");
    criteria.form = formNamed(json.at("form"));
    criteria.raw_reach = json.at("raw_reach_mm");
    criteria.stock = json::stockFrom(report.at("stock"));
    criteria.keep_out = json::keepOutFrom(report.at("keep_out"));
    criteria.machine = json::machineFrom(report.at("machine"));
    for (const auto& tool : report.at("tools"))
      criteria.tools.push_back(json::toolFrom(tool));
    clouds = json.at("clouds");
    criteria.part = pointsFrom(folder / clouds.at("part").get<std::string>(), 0);
    for (const auto& beside : kBeside)
      if (clouds.contains(beside.name))
        criteria.*beside.points =
            pointsFrom(folder / clouds.at(beside.name).get<std::string>(), 0);
  }
  catch (const Json::exception& e) {
    throw DataError(path + ": is not the report of a job of this version: " + e.what());
  }
  return criteria;
}

} // namespace pointmill
