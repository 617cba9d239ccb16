// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "pass_linker.h"

namespace pointmill {

using Eigen::Vector3d;
using Kind = Transition::Kind;

void PassLinker::add(const PlannedPass& pass)
{
  const Transition transition = plan(pass);
  if (transition.entry.kind == EntryKind::Impossible) {
    ++tally_.skipped;
    return;
  }
  go(transition, *pass.points.front());
  for (std::size_t i = 1; i < pass.way.size(); ++i) {
    checkInterrupted(); // all may be one pass
    path_.add(pass.way[i], pass.points[i]->getMotion(), *pass.points[i]);
  }
  last_ = pass.way;
  ++tally_.passes;
}

void PassLinker::finish()
{
  if (path_.empty())
    return;
  leadOut();
  const Vector3d from = path_.at();
  path_.add({from.x(), from.y(), around_.clearance}, Motion::Retract, path_.last());
  ++tally_.retracts;
}

Transition PassLinker::plan(const PlannedPass& pass)
{
  Transition way{Kind::Plane, around_.clearance, 0, {}};
  if (path_.empty())
    way.entry = entries_.into(pass.way);
  else
    way = transitions_.best(path_.at(), pass.way);
  if (way.kind == Kind::Stay || way.entry.kind == EntryKind::Impossible)
    return way;
  leadOut(); // the pass is left: arcs have a use
  leadIn(pass, way.entry);
  return path_.empty() ? way : transitions_.over(path_.at(), way.entry);
}

void PassLinker::leadIn(const PlannedPass& pass, Entry& entry)
{
  const bool level = entry.kind == EntryKind::Open || entry.kind == EntryKind::Outside;
  if (!level || pass.way.size() < 2 || pass.points[1]->getMotion() != Motion::Cut)
    return;
  const auto arc = arcs_.into(pass.way);
  if (arc.empty())
    return;
  entry.kind = EntryKind::Open;
  entry.steps = {{arc.front() + Vector3d(0, 0, kNothing), Motion::Plunge},
                 {arc.front(), Motion::Plunge}};
  for (std::size_t i = 1; i < arc.size(); ++i)
    entry.steps.push_back({arc[i], Motion::LeadIn});
  ++tally_.lead_ins;
}

void PassLinker::leadOut()
{
  if (last_.empty() || path_.last().getMotion() != Motion::Cut)
    return;
  const auto arc = arcs_.outOf(last_);
  for (std::size_t i = 1; i < arc.size(); ++i)
    path_.add(arc[i], Motion::LeadOut, path_.last());
  tally_.lead_outs += !arc.empty();
  last_.clear();
}

void PassLinker::go(const Transition& transition, const PointCL& like)
{
  const Entry& entry = transition.entry;
  goSideways(transition, like);
  const Vector3d& to = entry.from();
  const double down = transitions_.rapidDown(entry);
  if (down < path_.last().z)
    path_.add({to.x(), to.y(), down}, Motion::Rapid, like);
  if (transitions_.isAir(to))
    path_.addThroughAir(to, like);
  for (const auto& step : entry.steps)
    path_.add(step.to, step.motion, like);
  count(entry);
}

void PassLinker::goSideways(const Transition& transition, const PointCL& like)
{
  const Vector3d& to = transition.entry.from();
  const double height = transition.height;
  const Vector3d over(to.x(), to.y(), height);
  if (path_.empty()) {
    path_.add(over, Motion::Rapid, like);
    return;
  }
  const Vector3d from = path_.at();
  const Vector3d up(from.x(), from.y(), height);
  switch (transition.kind) {
  case Kind::Plane:
    path_.add(up, Motion::Retract, like);
    path_.add(over, Motion::Rapid, like);
    ++tally_.retracts;
    break;
  case Kind::Rapid:
    path_.add(up, Motion::Rapid, like);
    path_.add(over, Motion::Rapid, like);
    ++tally_.lifts;
    break;
  case Kind::Lift:
    path_.add(up, Motion::Rapid, like);
    path_.add(over, Motion::Link, like);
    ++tally_.lifts;
    break;
  case Kind::Stay:
    path_.add(up, Motion::Link, like);
    path_.add(over, Motion::Link, like);
    ++tally_.links;
    break;
  }
}

void PassLinker::count(const Entry& entry)
{
  tally_.outside += entry.kind == EntryKind::Outside;
  tally_.helices += entry.kind == EntryKind::Helix;
  tally_.ramps += entry.kind == EntryKind::Ramp;
  tally_.plunges += entry.kind == EntryKind::Plunge;
}

} // namespace pointmill
