// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/viewer/program_path.h>

namespace pointmill {

void addProgramPath(ViewerScene& scene)
{
  const Program& program = scene.player->program();
  auto path = std::make_shared<CLCloud>();
  scene.operations.clear();
  std::uint32_t pass = 0;
  const auto add = [&](const Eigen::Vector3d& at, const ProgramMove& move) {
    PointCL p(at.x(), at.y(), at.z(), move.rapid ? Motion::Rapid : Motion::Cut);
    p.feed = static_cast<float>(move.feed);
    p.label = pass;
    path->push_back(p);
  };
  for (std::size_t i = 0; i < program.moves.size(); ++i) {
    const ProgramMove& move = program.moves[i];
    const std::size_t section = scene.player->sectionOf(i);
    if (section >= scene.operations.size())
      for (std::size_t s = scene.operations.size(); s <= section; ++s) {
        const bool known = s < scene.sections.size();
        scene.operations.push_back({known ? scene.sections[s].name : "program",
                                    known ? scene.sections[s].colour : 0,
                                    path->size(),
                                    0});
      }
    if (!move.to.allFinite())
      continue;
    pass += move.rapid;
    ViewedOperation& operation = scene.operations.back();
    if (operation.count == 0) {
      add(move.from.allFinite() ? move.from : move.to, move);
      path->back().setMotion(Motion::Rapid);
    }
    add(move.to, move);
    operation.count = path->size() - operation.first;
  }
  scene.path = path;
}

} // namespace pointmill
