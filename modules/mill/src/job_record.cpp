// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "json_parts.h"

#include <pointmill/common/error.h>
#include <pointmill/mill/job_record.h>

#include <filesystem>
#include <fstream>
#include <limits>

namespace pointmill {
namespace {

using json::Json;

RecordedOperation operationFrom(const Json& json)
{
  return {json.at("name"),
          json.at("parameters").at("tool"),
          json.at("colour"),
          json.at("cl_points")};
}

Finding findingFrom(const Json& json)
{
  Finding finding;
  finding.code = json.at("code");
  finding.text = json.at("text");
  finding.severity =
      json.at("severity") == "error" ? Severity::Error : Severity::Warning;
  finding.line = json.at("line");
  finding.place =
      json.contains("at")
          ? json::vectorFrom(json.at("at"))
          : Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()).eval();
  return finding;
}

} // namespace

JobRecord JobRecord::read(const std::string& directory)
{
  JobRecord record;
  record.criteria = Criteria::read(directory);
  const std::filesystem::path folder(directory);
  const std::string path = (folder / "report.json").string();
  std::ifstream in(path);
  try {
    const Json report = Json::parse(in);
    record.scan = report.at("scan").at("file");
    record.mm_per_unit = report.at("scan").at("mm_per_unit");
    for (int i = 0; i < 16; ++i)
      record.alignment(i / 4, i % 4) = report.at("alignment").at(i);
    for (const auto& file : report.at("program").at("files"))
      record.programs.push_back((folder / file.at("name").get<std::string>()).string());
    for (const auto& operation : report.at("operations"))
      record.operations.push_back(operationFrom(operation));
    for (const auto& finding : report.at("verification").at("findings"))
      record.findings.push_back(findingFrom(finding));
  }
  catch (const Json::exception& e) {
    throw DataError(path + ": is not the report of a job of this version: " + e.what());
  }
  return record;
}

} // namespace pointmill
