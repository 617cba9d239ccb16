// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "random_program.h"

#include <Eigen/Core>

#include <cmath>
#include <cstdio>
#include <random>

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Writes blocks and keeps the position that their rounded numbers lead to.
class Generator {
public:
  Generator(unsigned seed, bool inches) : engine_(seed)
  {
    text_ = std::string("G17 G90 G94 G91.1 ") + (inches ? "G20" : "G21") +
            "\nT1 M6\nG43 H1\nS1000 M3\nG0 Z20.5\nX1.5 Y2.5\nG1 Z3 F50\n";
    at_ = {1.5, 2.5, 3};
  }

  std::string make(int blocks)
  {
    for (int i = 0; i < blocks; ++i)
      block(die(0, 19));
    return text_ + "M2\n";
  }

private:
  int die(int least, int most)
  {
    return std::uniform_int_distribution<int>(least, most)(engine_);
  }
  double between(double least, double most)
  {
    return std::uniform_real_distribution<double>(least, most)(engine_);
  }

  std::string number(double value)
  {
    char text[40];
    std::snprintf(text, sizeof text, "%.5f", value);
    return text;
  }
  static double rounded(double value) { return std::round(value * 1e5) / 1e5; }

  /// The words to @p to; the axes that @p must_name, and those that move.
  std::string words(const Vector3d& to, unsigned must_name = 0)
  {
    std::string out;
    for (int axis = 0; axis < 3; ++axis) {
      const double way = rounded(to[axis] - at_[axis]);
      if (way == 0 && !((must_name >> axis) & 1u))
        continue;
      const double value = incremental_ ? way : rounded(to[axis]);
      out += std::string(" ") + static_cast<char>('X' + axis) + number(value);
      at_[axis] = incremental_ ? at_[axis] + value : value;
    }
    return out;
  }

  std::string feed()
  {
    return inverse_time_ || die(0, 3) == 0 ? " F" + number(between(1, 900)) : "";
  }

  void line()
  {
    Vector3d to = at_;
    for (int axis = 0; axis < 3; ++axis)
      if (die(0, 1))
        to[axis] = between(-20, 20);
    const bool rapid = die(0, 5) == 0;
    const std::string axes = words(to, 1);
    text_ += (rapid ? "G0" : "G1") + axes + (rapid ? "" : feed()) + "\n";
  }

  /// About a centre at any side, by centre or radius, flat or rising.
  void arc(bool by_radius, bool full)
  {
    const int w = 3 - u_ - v_;
    const double radius = between(1, 8), start = between(-3.1, 3.1);
    const bool clockwise = die(0, 1);
    const Vector2d arm(rounded(radius * std::cos(start)),
                       rounded(radius * std::sin(start)));
    const double sweep = full                     ? 0.0
                         : by_radius && die(0, 1) ? between(3.6, 5.5)
                         : by_radius              ? between(0.4, 2.8)
                                                  : between(0.1, 6.2);
    const double end = std::atan2(arm.y(), arm.x()) + (clockwise ? -sweep : sweep);
    const Vector2d centre = Vector2d(at_[u_], at_[v_]) - arm;
    Vector3d to = at_;
    if (!full) {
      to[u_] = centre.x() + arm.norm() * std::cos(end);
      to[v_] = centre.y() + arm.norm() * std::sin(end);
    }
    if (die(0, 2) == 0)
      to[w] += between(-3, 3);
    std::string block = clockwise ? "G2" : "G3";
    block += words(to, full ? 0 : (1u << u_) | (1u << v_));
    if (by_radius)
      block += " R" + number(sweep > 3 ? -arm.norm() : arm.norm());
    else
      block += std::string(" ") + static_cast<char>('I' + u_) + number(-arm.x()) + " " +
               static_cast<char>('I' + v_) + number(-arm.y());
    text_ += block + feed() + "\n";
  }

  void changePlane()
  {
    u_ = die(0, 2);
    v_ = (u_ + 1) % 3;
    const char* const names[] = {"G17", "G19", "G18"};
    text_ += std::string(names[u_]) + "\n";
  }

  void shift()
  {
    const int axis = die(0, 2);
    const double value = rounded(between(-5, 5));
    text_ += std::string("G92 ") + static_cast<char>('X' + axis) + number(value) + "\n";
    shift_[axis] += at_[axis] - value;
    at_[axis] = value;
  }

  void dropShift()
  {
    text_ += "G92.1\n";
    at_ += shift_;
    shift_.setZero();
  }

  void suspendShift()
  {
    text_ += "G92.2\n";
    at_ += shift_;
    line();
    text_ += "G92.3\n";
    at_ -= shift_;
  }

  /// Over a point of the program to the reference point, and back into the program.
  void returnHome()
  {
    const int axis = die(0, 2);
    Vector3d over = at_;
    over[axis] = between(-20, 20);
    text_ += std::string(die(0, 1) ? "G28" : "G30") + words(over, 1u << axis) + "\n";
    const bool was = incremental_;
    incremental_ = false;
    Vector3d to = at_;
    to[axis] = between(-20, 20);
    text_ += "G90 G0" + words(to, 1u << axis) + "\n";
    incremental_ = was;
    if (was)
      text_ += "G91\n";
  }

  void block(int kind)
  {
    if (kind < 5)
      line();
    else if (kind < 9)
      arc(false, false);
    else if (kind == 9)
      arc(false, true);
    else if (kind < 12)
      arc(true, false);
    else if (kind < 14)
      changePlane();
    else if (kind == 14) {
      incremental_ = !incremental_;
      text_ += incremental_ ? "G91\n" : "G90\n";
    }
    else if (kind == 15) {
      inverse_time_ = !inverse_time_;
      text_ += inverse_time_ ? "G93\n" : "G94\nF120\n";
    }
    else if (kind == 16)
      shift();
    else if (kind == 17)
      die(0, 1) ? dropShift() : suspendShift();
    else if (kind == 18)
      returnHome();
    else
      text_ += "G4 P0.1\n";
  }

  std::mt19937 engine_;
  std::string text_;
  Vector3d at_, shift_ = Vector3d::Zero();
  int u_ = 0, v_ = 1;
  bool incremental_ = false, inverse_time_ = false;
};

} // namespace

std::string randomProgram(unsigned seed, int blocks, bool inches)
{
  return Generator(seed, inches).make(blocks);
}
