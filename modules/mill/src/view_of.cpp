// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "view_of.h"

#include "print.h"

#include <algorithm>

namespace pointmill {

ViewScene viewOf(const Judgement& judgement, const Criteria& criteria)
{
  ViewScene scene;
  scene.stock = criteria.stock;
  scene.clearance = std::max(criteria.stock.top(), criteria.keep_out.highestTop());
  scene.milled = &judgement.verification.milled;
  scene.deviation = std::make_shared<pcl::PointCloud<pcl::PointXYZI>>(
      judgement.verification.deviationsInReach());
  scene.tolerance = criteria.tolerance;
  scene.keep_out = &criteria.keep_out;
  scene.tools = criteria.tools;
  scene.program = &judgement.program;
  scene.rapid_rate = criteria.machine.rapid_rate;
  const auto& sections = judgement.program.sections;
  const auto& times = judgement.time.sections;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const ProgramSection& s = sections[i];
    if (i == 0 || s.name != sections[i - 1].name || s.tool != sections[i - 1].tool) {
      ViewPath path;
      path.label = s.name.empty() ? print("line %zu", s.line) : s.name;
      path.label += ", T" + std::to_string(s.tool);
      path.colour = static_cast<int>(scene.paths.size());
      path.tool = s.tool;
      path.first = i == 0 ? 0 : s.move; // with the way to the first
      scene.paths.push_back(path);
    }
    scene.paths.back().last =
        i + 1 < sections.size() ? sections[i + 1].move : judgement.program.moves.size();
    if (i < times.size())
      scene.paths.back().seconds += times[i].total();
  }
  return scene;
}

ViewScene viewOf(const MillJob& job)
{
  ViewScene scene = viewOf(job.judgement(), job.criteria());
  scene.clearance = job.clearancePlane();
  scene.part = &job.map();
  if (scene.paths.size() == job.operations().size())
    for (std::size_t i = 0; i < scene.paths.size(); ++i) {
      const PlannedOperation& planned = job.operations()[i];
      scene.paths[i].label = std::to_string(i + 1) + "  " + planned.operation.name +
                             ", T" + std::to_string(planned.operation.tool.number);
      scene.paths[i].colour = planned.colour;
    }
  return scene;
}

} // namespace pointmill
