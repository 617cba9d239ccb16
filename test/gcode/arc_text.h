// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/gcode/decimal_grid.h>
#include <pointmill/gcode/machine_calls.h>

#include <string>

/// @brief Spells feed moves, rapids and arcs as RS-274, in the plainest way: no more
/// than what a test of arcs needs.
class ArcText : public pointmill::MachineCalls {
public:
  explicit ArcText(int decimals) : grid_(decimals) { text = "G21 G90 G91.1 G94\n"; }

  void comment(const std::string& words) override { text += "(" + words + ")\n"; }
  void approach(const pointmill::MachinePosition& to) override { traverse(to); }
  void traverse(const pointmill::MachinePosition& to) override
  {
    mode("G0");
    point(to);
    text += "\n";
  }
  void straight(const pointmill::MachinePosition& to, std::int64_t feed) override
  {
    mode("G1");
    point(to);
    rate(feed);
  }
  void arc(const pointmill::MachineArc& arc, std::int64_t feed) override
  {
    const auto plane = static_cast<std::size_t>(arc.plane);
    const char* const names[] = {"G17 ", "G18 ", "G19 "};
    const char* const offsets[] = {"IJ", "KI", "JK"};
    if (plane != plane_)
      text += names[plane_ = plane];
    mode(arc.clockwise ? "G2" : "G3");
    point(arc.to);
    word(offsets[plane][0], arc.u);
    word(offsets[plane][1], arc.v);
    rate(feed);
  }
  void end() override { text += "M2\n"; }

  std::string text;

private:
  void mode(const std::string& name)
  {
    if (name != mode_)
      text += name;
    mode_ = name;
  }
  void word(char letter, std::int64_t ticks)
  {
    char number[pointmill::DecimalGrid::max_chars];
    if (text.back() != '\n' && text.back() != ' ')
      text += ' ';
    text += letter;
    text.append(number, grid_.write(number, ticks));
  }
  void point(const pointmill::MachinePosition& to)
  {
    if (to.x != at_.x)
      word('X', to.x);
    if (to.y != at_.y)
      word('Y', to.y);
    if (to.z != at_.z)
      word('Z', to.z);
    at_ = to;
  }
  void rate(std::int64_t feed)
  {
    if (feed != feed_) {
      char number[pointmill::DecimalGrid::max_chars];
      text += " F";
      text.append(number, pointmill::DecimalGrid(3).write(number, feed));
      feed_ = feed;
    }
    text += "\n";
  }

  pointmill::DecimalGrid grid_;
  std::size_t plane_ = 0;
  std::string mode_;
  std::int64_t feed_ = 0;
  pointmill::MachinePosition at_{INT64_MAX, INT64_MAX, INT64_MAX};
};
