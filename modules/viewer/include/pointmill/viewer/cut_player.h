// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/tool.h>
#include <pointmill/gcode/gcode_reader.h>
#include <pointmill/surface/stock_field.h>
#include <pointmill/surface/swept_cutter.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace pointmill {

/// @brief Plays a program: the stock, the tool's place and the line of the program at
/// any moment, forwards and back.
///
/// Every move cuts what its tool sweeps, rapids as well. Going back takes the last of
/// the states that were kept on the way, and cuts from there; so a program is cut once
/// as a whole, and later no more than a kStates-th of it at a time.
class CutPlayer {
public:
  static constexpr std::uint8_t kUncut = 255;
  static constexpr std::size_t kStates = 32;

  /// @param stock before the program
  /// @param ends for each move the seconds from the program's start to its end, see
  /// ProgramTime
  /// @param tools those that the program names; a tool that is not there cuts nothing
  /// @throws DataError where @p ends are not those of the program's moves
  CutPlayer(StockField stock,
            std::shared_ptr<const Program> program,
            std::vector<double> ends,
            std::vector<Tool> tools,
            unsigned threads = 0);

  /// @brief Of the whole program [s].
  double duration() const { return ends_.empty() ? 0.0 : ends_.back(); }
  double time() const { return time_; }

  /// @brief Goes to a moment; before the start or after the end it stops there.
  /// @throws Interrupted, see Watch; it is at the start then
  void seek(double seconds);

  /// @brief The move that is under way, or has just ended.
  std::size_t move() const;
  const Program& program() const { return *program_; }
  /// @brief When a move begins, and is over [s].
  double beginOf(std::size_t move) const { return move == 0 ? 0.0 : ends_[move - 1]; }
  double endOf(std::size_t move) const { return ends_[move]; }
  /// @brief The first move of a line of the program, or of the next that has one; the
  /// last move where there is none.
  std::size_t moveOfLine(std::size_t line) const;
  /// @brief The moment in a line of the program when the tip is nearest to a place, the
  /// end of the line where that is not known.
  double nearestInLine(std::size_t line, const Eigen::Vector3d& place) const;
  /// @brief Which section a move belongs to.
  std::size_t sectionOf(std::size_t move) const;

  /// @brief The tool's tip; a coordinate that the program does not determine is NaN.
  Eigen::Vector3d tip() const;
  /// @brief The tool in the spindle; null where it is none of the tools.
  const Tool* tool() const;

  const StockField& stock() const { return state_.stock; }
  /// @brief The section that last cut each cell, row by row; kUncut where none did.
  const std::vector<std::uint8_t>& cutBy() const { return state_.cut_by; }

private:
  /// How far the program has been cut: moves before `move`, and so much of that one.
  struct State {
    StockField stock;
    std::vector<std::uint8_t> cut_by;
    /// The section that lowered a cell last, if only a little, and how much [mm].
    std::vector<std::uint8_t> touched_by;
    std::vector<float> taken;
    std::size_t move = 0;
    double share = 0.0;
  };
  struct Sweep {
    Eigen::Vector3d a, b;
    const SweptCutter* cutter;
    std::uint8_t section;
  };

  Eigen::Vector3d placeOn(std::size_t move, double share) const;
  double shareAt(double seconds) const;
  void goTo(std::size_t target, double share);
  void forwardTo(std::size_t move, double share);
  void take(std::size_t cell, std::uint8_t section, double depth);
  void cut(const std::vector<Sweep>& sweeps);

  std::shared_ptr<const Program> program_;
  std::vector<double> ends_;
  std::vector<Tool> tools_;
  std::map<int, SweptCutter> cutters_; // by the tool's number
  unsigned threads_;
  std::size_t stride_;
  State state_;
  std::vector<State> kept_; // at 0, stride_, 2 stride_ ... moves
  double time_ = 0.0;
};

} // namespace pointmill
