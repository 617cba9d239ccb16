// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "clear_ground.h"
#include "high_speed_entry.h"
#include "high_speed_walk.h"

#include <pointmill/common/report.h>

namespace pointmill {

/// @brief How one level is to be cut.
struct HighSpeedSettings {
  double side;       ///< +1: material on the right; -1: on the left
  double ramp_slope; ///< of entries into material, down per length
  double layer;      ///< the level above has cleared so far above this one [mm]
};

/// @brief Clears one level with walks of constant engagement.
class HighSpeedPlan {
public:
  HighSpeedPlan(const Level& level, const HighSpeedSettings& settings);

  std::vector<LevelPath> clear();
  /// @brief Adds what was done and what is left.
  void report(Report& figures) const;

private:
  bool cutFrom(const Front& first, const std::vector<Node>& way, bool linked);
  Walk bestWalk(const Pose& start);
  void follow(const Walk& walk);
  bool enter();
  Node middleOf(const std::vector<Node>& nodes, double room) const;
  std::vector<Node> takePiece(std::vector<unsigned char>& open, Node first) const;
  bool sweepUp(const std::vector<Node>& places);
  void skim();
  bool skimAlong(const std::vector<Eigen::Vector2d>& wall);
  bool boreHelix(Node centre);
  bool rampAlong(const std::vector<Node>& piece);
  void begin();
  void add(const Eigen::Vector2d& at, Motion motion);
  void addEntry(const std::vector<Eigen::Vector3d>& way);
  Descent descentOver(const std::vector<Eigen::Vector2d>& track) const;
  double areaUnder(const std::vector<Node>& nodes, double enough);
  bool wouldCut(const std::vector<Eigen::Vector2d>& way);

  const Level& level_;
  HighSpeedSettings settings_;
  Material material_;
  Walker walker_;
  ClearGround ground_;
  std::vector<LevelPath> paths_;
  std::optional<Pose> tool_;
  std::vector<unsigned char> no_entry_;
  double cut_ = 0, linked_ = 0, ramped_ = 0, slots_ = 0, narrow_ = 0;
  int helices_ = 0;
};

} // namespace pointmill
