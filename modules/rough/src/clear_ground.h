// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level.h>
#include <pointmill/rough/material.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pointmill {

/// @brief A clear node and the direction (0 +X, 1 +Y, 2 -X, 3 -Y) in which its
/// neighbour would cut.
struct Front {
  Node at;
  int direction;

  Node beyond() const;
};

/// @brief Where the tool can go on its level without cutting, and where that ground
/// meets what is left to cut.
class ClearGround {
public:
  /// @param side +1: the tool cuts with the material on its right; -1: on its left
  ClearGround(const Level& level, const Material& material, double side);

  /// @brief Radius within which nothing may stand beside a clear move [mm]: the end's,
  /// less what may be brushed.
  double clearRadius() const { return clear_radius_; }
  /// @brief Radius within which something must be left for a node to be worth going to
  /// [mm]. What is further out is a skin.
  double frontRadius() const { return front_radius_; }
  /// @brief Less to cut in one place is a crumb that is not worth a walk [mm2].
  double crumb() const { return crumb_; }

  bool isClear(Node n);
  /// @brief Whether the tool would cut beyond the edge of the clear ground, and no
  /// start from there has failed with the material as it is.
  bool isFront(const Front& edge);
  bool isClear(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
  /// @brief Starting towards @p n has failed.
  void ban(Node n);

  /// @brief The nearest place over clear ground from @p from at which a front begins,
  /// for a tool that is to cut along it; anywhere on one that runs round in a ring.
  /// @param way the nodes that lead there
  std::optional<Front> next(const Eigen::Vector2d& from, std::vector<Node>& way);
  /// @brief The shortest way from @p from to the nearest of the nodes of @p to that
  /// takes no more than @p most cells at a time; empty where there is none.
  std::vector<Eigen::Vector2d>
  brush(const Eigen::Vector2d& from, const std::vector<Node>& to, std::size_t most);
  /// @brief The front nearest to @p from, wherever it is.
  std::optional<Front> anywhere(const Eigen::Vector2d& from);
  /// @brief Where the front that @p front lies on begins, for a tool that is to cut
  /// along it; itself where it runs round in a ring.
  /// @param way the nodes that lead there are added
  Front beginning(const Front& front, std::vector<Node>& way);

private:
  std::size_t keyOf(const Front& edge) const;
  void markBeginning(const Front& front);
  Front before(Front at, std::vector<Node>& way);
  template <typename GoOn>
  Front traced(const Front& front, std::vector<Node>& way, GoOn&& go_on);
  void clearFarOff();
  bool isToCut(Node n);
  bool isCrumb(Node n);
  unsigned standingNear(Node n) const;

  const Level& level_;
  const Material& material_;
  double side_, clear_radius_, front_radius_, crumb_;
  // Nodes known to be clear, and to have no more than a crumb round them: for good, as
  // material is only taken while one looks.
  std::vector<unsigned char> clear_, crumbs_;
  // What stands in the way of a node and what it would cut, as last seen.
  std::vector<Material::Place> obstacle_, work_;
  std::vector<unsigned> seen_, banned_;
  std::vector<unsigned> known_, begins_; // of nodes and directions
  std::vector<unsigned char> done_;      // of these, for good: no fronts any more
  std::vector<std::size_t> from_;
  unsigned search_ = 0;
};

} // namespace pointmill
