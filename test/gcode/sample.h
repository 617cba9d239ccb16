// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/operation.h>
#include <pointmill/gcode/gcode_writer.h>

#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

/// @brief Programs for the tests of this folder.
namespace sample {

using pointmill::Motion;

inline pointmill::PointCL at(double x, double y, double z, Motion how, float feed = 0.f)
{
  pointmill::PointCL p(x, y, z, how);
  p.feed = feed;
  return p;
}

/// One tool, a pocket's worth of moves; clearance plane 10.
inline pointmill::Operation small(int tool = 1)
{
  pointmill::Operation op;
  op.name = "Rough";
  op.tool = pointmill::Tool::flat(tool, 10.0);
  op.path.push_back(at(0, 0, 10, Motion::Rapid));
  op.path.push_back(at(0, 0, 1, Motion::Rapid));
  op.path.push_back(at(0, 0, -1.5, Motion::Plunge, 300));
  op.path.push_back(at(20, 0, -1.5, Motion::Cut, 1000));
  op.path.push_back(at(20, 20.25, -1.5, Motion::Cut, 1000));
  op.path.push_back(at(20, 20.25, 10, Motion::Retract));
  return op;
}

/// @p points random CL points by @p tools tools, with every kind of move.
inline std::vector<pointmill::Operation> random(int points, int tools, unsigned seed)
{
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> side(-150, 150), depth(-40, 5);
  std::uniform_int_distribution<int> die(0, 19);
  std::vector<pointmill::Operation> list;
  for (int t = 0; t < tools; ++t) {
    pointmill::Operation op;
    op.name = "Operation for tool " + std::to_string(t + 1);
    op.tool = pointmill::Tool::ball(t + 1, 6.0);
    op.cutting.coolant = t % 2 == 0;
    double x = side(engine), y = side(engine);
    op.path.push_back(at(x, y, 12.5, Motion::Rapid));
    while (static_cast<int>(op.path.size()) < points / tools) {
      const int kind = die(engine);
      if (kind == 0) {
        op.path.push_back(at(x, y, 12.5, Motion::Retract));
        x = side(engine);
        y = side(engine);
        op.path.push_back(at(x, y, 12.5, Motion::Rapid));
        op.path.push_back(at(x, y, depth(engine), Motion::Plunge, 250.5f));
        continue;
      }
      if (kind > 2)
        x += side(engine) * 1e-3;
      if (kind > 4)
        y += side(engine) * 1e-2;
      op.path.push_back(at(x, y, depth(engine), Motion::Cut, 800.f + float(kind / 10)));
    }
    op.path.push_back(at(x, y, 12.5, Motion::Retract));
    list.push_back(op);
  }
  return list;
}

inline std::string write(const std::vector<pointmill::Operation>& operations,
                         double clearance)
{
  pointmill::GCodeWriter writer;
  writer.setClearancePlane(clearance);
  std::ostringstream out;
  writer.write(operations, out);
  return out.str();
}

} // namespace sample
