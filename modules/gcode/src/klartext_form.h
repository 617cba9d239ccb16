// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "front_end.h"
#include "klartext_line.h"

#include <Eigen/Core>

#include <optional>
#include <string>

namespace pointmill::gcode {

/// @brief Heidenhain's conversational programs.
class KlartextForm : public FrontEnd {
public:
  explicit KlartextForm(MachineState& machine) : machine_(machine) {}

  bool obey(std::string_view text, std::size_t line) override;
  void finish() const override;

private:
  using Word = KlartextLine::Word;

  struct Coordinate {
    double value = 0.0; // mm
    bool incremental = false;
    int column = 0; // 0: not there
  };
  /// The words of a block that moves.
  struct Path {
    Coordinate axes[3], angle; // the angle in degrees
    std::optional<double> radius;
    int direction = 0; // DR+: 1
    bool rapid = false;
    int machine_frame = 0; // 91, 92
    bool stops_spindle = false, ends = false;
  };

  bool execute(const Word& first);
  void checkNumber();
  void beginProgram();
  bool endProgram();
  void callTool();
  void setSpeed(const Word& word);
  void defineCycle();
  void continueCycle();

  Path readPath(const char* allowed, bool by_radius = false);
  bool readCoordinate(const Word& word, Path& path);
  void readFeed(const Word& word, Path& path);
  void readMachineWord(const Word& word, Path& path);
  void finishPath(const Path& path);
  double lengthOf(const Word& word, std::size_t letters) const;
  Eigen::Vector3d target(const Path& path) const;
  double position(const Coordinate& coordinate, int axis) const;

  void moveStraight(const Word& word, const Path& path);
  void moveInMachine(const Word& word, const Path& path);
  void setPole(const Word& word);
  void moveOnArc(const Word& word, const Path& path);
  void moveByRadius(const Word& word, const Path& path);
  void moveByAngle(const Word& word, const Path& path);
  Eigen::Vector2d poleFor(const Word& word) const;
  void checkArc(const Word& word, const Path& path) const;

  MachineState& machine_;
  KlartextLine line_;
  int number_ = -1; // of the last block
  std::string name_;
  double unit_ = 1.0, feed_unit_ = 1.0;
  double feed_ = 0.0; // mm/min
  int plane_ = 170;   // of the pole
  Eigen::Vector3d pole_ = Eigen::Vector3d::Constant(unknown);
  bool continued_ = false; // the last line ended with `~`
  int cycle_ = 0;          // that is being defined
  bool ended_ = false;     // M30 was read
};

} // namespace pointmill::gcode
