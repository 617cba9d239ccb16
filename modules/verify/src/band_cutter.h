// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "layer_gauge.h"
#include "moves.h"
#include "tool_bodies.h"

#include <map>
#include <vector>

namespace pointmill {

/// @brief A tool as the simulation needs it, worked out once.
struct SimulatedTool {
  /// What of a body may touch nothing: a tolerance less wide.
  struct Body {
    const char* code;
    double above; ///< of its end over the tip [mm]
    Tool tool;
    SweptCutter cutter;
  };
  SimulatedTool(const Tool& tool, double tolerance);

  SweptCutter cutter;
  Tool rapid_tool; ///< a tolerance smaller all round: a rapid may touch stock
  SweptCutter rapid_cutter;
  double core; ///< radius of what of a flat end does not cut [mm]; 0: none
  std::vector<Body> bodies;
};

/// @brief Greatest depths [mm] of one kind, by move.
class Depths {
public:
  void note(std::size_t move, double depth)
  {
    double& known = by_move_[move];
    known = std::max(known, depth);
  }
  void take(const Depths& other)
  {
    for (const auto& [move, depth] : other.by_move_)
      note(move, depth);
  }
  const std::map<std::size_t, double>& byMove() const { return by_move_; }

private:
  std::map<std::size_t, double> by_move_;
};

/// @brief What happens in one band, or in all.
struct StockEvents {
  struct Layer {
    double thickness = 0; ///< [mm]
    std::size_t move = 0; ///< the last of those that take it
  };
  explicit StockEvents(std::size_t sections) : layers(sections), volumes(sections) {}
  void take(const StockEvents& other);

  std::map<std::string, Depths> depths; ///< by the code of the finding
  std::vector<Layer> layers;            ///< thickest, by section
  std::vector<double> volumes;          ///< taken [mm3], by section
};

/// @brief Cuts the moves into the rows of one band.
class BandCutter {
public:
  BandCutter(StockField& field,
             int row0,
             int row1,
             const std::vector<SweptMove>& moves,
             const std::map<const Tool*, SimulatedTool>& tools,
             const StockLimits& limits,
             std::size_t sections);

  /// @brief Makes a move; to be called in the program's order.
  void move(std::size_t k);
  /// @brief After the last move.
  void end() { endPiece(); }

  const StockEvents& events() const { return events_; }

private:
  using Vector3d = Eigen::Vector3d;
  /// What was cut on a short way.
  struct Piece {
    const Tool* tool = nullptr;
    Vector3d end = Vector3d::Zero();
    double length = 0, most = 0; // most: no layer is thicker
    std::size_t move = 0;
    std::uint32_t section = 0;
    std::vector<LoweredCell> lowered;
    std::map<std::pair<int, int>, double> sunk; // cells that the core was sunk into
  };

  void rapid(std::size_t k, const SimulatedTool& tool);
  void feed(std::size_t k, const SimulatedTool& tool);
  void bodies(std::size_t k, const SimulatedTool& tool);
  void cut(std::size_t k,
           const SimulatedTool& tool,
           const Vector3d& from,
           const Vector3d& to);
  void sink(std::size_t k,
            const SimulatedTool& tool,
            const Vector3d& from,
            const Vector3d& to,
            std::size_t first);
  void endPiece();
  bool below(double z);

  StockField& field_;
  int row0_, row1_;
  const std::vector<SweptMove>& moves_;
  const std::map<const Tool*, SimulatedTool>& tools_;
  const StockLimits& limits_;
  Vector3d up_; // what may touch the stock is lifted by so much
  double top_;  // no cell of the band is higher
  Piece piece_;
  LayerGauge gauge_;
  StockEvents events_;
};

} // namespace pointmill
