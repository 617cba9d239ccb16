// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "level_moves.h"

#include <cmath>

namespace pointmill::visual {
namespace {

MoveKind kindOf(Motion motion)
{
  switch (motion) {
  case Motion::Rapid:
  case Motion::Retract:
    return MoveKind::Rapid;
  case Motion::Plunge:
  case Motion::Ramp:
  case Motion::LeadIn:
    return MoveKind::Entry;
  case Motion::Link:
  case Motion::LeadOut:
    return MoveKind::Link;
  case Motion::Cut:
    break;
  }
  return MoveKind::Cut;
}

bool isPlace(const PointCL& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

} // namespace

LevelMoves movesOfLevel(const CLCloud& path, std::uint32_t level)
{
  LevelMoves all;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const PointCL &a = path[i - 1], &b = path[i];
    if (b.level != level || !isPlace(a) || !isPlace(b))
      continue;
    const LevelMove move{{a.x, a.y}, {b.x, b.y}, kindOf(b.getMotion()), all.length};
    const bool feeds = move.kind != MoveKind::Rapid;
    if (feeds && kindOf(a.getMotion()) == MoveKind::Rapid)
      all.entries.push_back(move.from);
    if (feeds)
      all.length += (move.to - move.from).norm();
    all.moves.push_back(move);
  }
  return all;
}

} // namespace pointmill::visual
