// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "report.h"

#include <pointmill/mill/result.h>
#include <pointmill/mill/summary.h>

#include <filesystem>

namespace pointmill {
namespace {

using json::Json;

/// Names may be in any encoding, JSON is in UTF-8.
std::string lineOf(const Json& json)
{
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json filesJson(const MillJob& job, const std::string& directory)
{
  Json files = Json::array();
  for (const auto& name : job.files())
    files.push_back((std::filesystem::path(directory) / name).string());
  return files;
}

Json operationsJson(const MillJob& job)
{
  Json operations = Json::array();
  for (const auto& o : job.operations())
    operations.push_back({{"name", o.operation.name},
                          {"tool", o.operation.tool.number},
                          {"cl_points", o.figures.cl_points},
                          {"cutting_mm", json::number(o.figures.cutting_length)},
                          {"minutes", json::number(o.figures.minutes)}});
  return operations;
}

} // namespace

std::string resultJson(const MillJob& job, const std::string& directory)
{
  Json result = {{"directory", directory},
                 {"files", filesJson(job, directory)},
                 {"points", job.part().size()},
                 {"part_mm", json::vector(job.partSize())},
                 {"minutes", json::number(job.minutes())},
                 {"lines", job.programFigures().lines},
                 {"operations", operationsJson(job)},
                 {"verification",
                  json::verification(job.judgement(), job.criteria().gougeLimit())},
                 {"warnings", warningsOf(job)}};
  return lineOf(result);
}

std::string resultJson(const Judgement& judgement, const Criteria& criteria)
{
  Json sections = Json::array();
  const auto& judged = judgement.verification.sections;
  const auto& times = judgement.time.sections;
  for (std::size_t i = 0; i < judged.size(); ++i) {
    const SectionFigures& s = judged[i];
    sections.push_back({{"name", s.name},
                        {"line", s.line},
                        {"tool", s.tool},
                        {"feed_mm", json::number(s.feed_length)},
                        {"volume_removed_mm3", json::number(s.volume)},
                        {"axial_depth_mm", json::number(s.axial_depth)}});
    if (i < times.size())
      sections.back()["minutes"] = json::number(times[i].total() / 60);
  }
  const Json result = {
      {"minutes", json::number(judgement.time.total.total() / 60)},
      {"sections", sections},
      {"verification", json::verification(judgement, criteria.gougeLimit())}};
  return lineOf(result);
}

} // namespace pointmill
