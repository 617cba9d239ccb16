// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "entries.h"
#include "lead_arcs.h"
#include "path_builder.h"
#include "transitions.h"

#include <cstddef>
#include <vector>

namespace pointmill {

/// @brief A pass as it is handed in: what it is like and where it goes.
struct PlannedPass {
  std::vector<const PointCL*> points;
  std::vector<Eigen::Vector3d> way;
};

/// @brief Puts pass after pass on a path, with what lies between them.
class PassLinker {
public:
  struct Tally {
    std::size_t passes = 0, skipped = 0;
    std::size_t links = 0, lifts = 0, retracts = 0;
    std::size_t outside = 0, helices = 0, ramps = 0, plunges = 0;
    std::size_t lead_ins = 0, lead_outs = 0;
  };

  PassLinker(PathBuilder& path,
             const Surroundings& around,
             const Entries& entries,
             const LeadArcs& arcs,
             const Transitions& transitions)
      : path_(path), around_(around), entries_(entries), arcs_(arcs),
        transitions_(transitions)
  {
  }

  void add(const PlannedPass& pass);
  /// @brief Out of the last pass and up to the clearance plane.
  void finish();

  const Tally& tally() const { return tally_; }

private:
  Transition plan(const PlannedPass& pass);
  void leadIn(const PlannedPass& pass, Entry& entry);
  void leadOut();
  void go(const Transition& transition, const PointCL& like);
  void goSideways(const Transition& transition, const PointCL& like);
  void count(const Entry& entry);

  PathBuilder& path_;
  const Surroundings& around_;
  const Entries& entries_;
  const LeadArcs& arcs_;
  const Transitions& transitions_;
  std::vector<Eigen::Vector3d> last_; // way of the last pass, empty where it was left
  Tally tally_;
};

} // namespace pointmill
