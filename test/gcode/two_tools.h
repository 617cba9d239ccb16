// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "sample.h"

#include <pointmill/gcode/call_adapter.h>

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <utility>

namespace sample {

/// Makes arcs of some straight feed moves, by their number in the program, from 1.
class ArcsInstead : public pointmill::CallAdapter {
public:
  using Arcs = std::map<int, pointmill::MachineArc>;
  ArcsInstead(pointmill::MachineCalls& next, Arcs arcs)
      : CallAdapter(next), arcs_(std::move(arcs))
  {
  }
  void straight(const pointmill::MachinePosition& to, std::int64_t feed) override
  {
    const auto arc = arcs_.find(++count_);
    if (arc == arcs_.end()) {
      CallAdapter::straight(to, feed);
      return;
    }
    arc->second.to = to;
    CallAdapter::arc(arc->second, feed);
  }

private:
  Arcs arcs_;
  int count_ = 0;
};

/// Half a circle in XY, a quarter of a helix, and half a circle in ZX, each in place of
/// a straight move.
inline ArcsInstead::Arcs someArcs(const pointmill::DecimalGrid& grid)
{
  using pointmill::ArcPlane;
  const auto mm = [&grid](double value) { return grid.nearest(value); };
  ArcsInstead::Arcs arcs;
  arcs[2] = {{}, ArcPlane::XY, true, mm(10), 0};  // about 10, 0
  arcs[3] = {{}, ArcPlane::XY, false, 0, mm(10)}; // about 20, 10
  arcs[4] = {{}, ArcPlane::ZX, false, 0, mm(5)};  // about X35 Z-2, over the top
  return arcs;
}

/// Two tools; the moves of the first that someArcs() replaces, and a feed that changes.
inline std::vector<pointmill::Operation> twoTools()
{
  pointmill::Operation rough;
  rough.name = "Rough (all)";
  rough.tool = pointmill::Tool::flat(1, 10.0);
  rough.path.push_back(at(0, 0, 10, Motion::Rapid));
  rough.path.push_back(at(0, 0, 1, Motion::Rapid));
  rough.path.push_back(at(0, 0, -1.5, Motion::Plunge, 300));
  rough.path.push_back(at(20, 0, -1.5, Motion::Cut, 1000));
  rough.path.push_back(at(30, 10, -2, Motion::Cut, 1000));
  rough.path.push_back(at(40, 10, -2, Motion::Cut, 1000));
  rough.path.push_back(at(40, 20.25, -2, Motion::Cut, 812.5));
  rough.path.push_back(at(40, 20.25, 10, Motion::Retract));
  pointmill::Operation finish;
  finish.name = "Finish";
  finish.tool = pointmill::Tool::ball(2, 4.5);
  finish.cutting.spindle = 18000;
  finish.cutting.coolant = false;
  finish.path.push_back(at(-3, 2, 12, Motion::Rapid));
  finish.path.push_back(at(-3, 2, 0.25, Motion::Plunge, 150));
  finish.path.push_back(at(-0.5, 2, 0.25, Motion::Cut, 600));
  finish.path.push_back(at(-0.5, 2, 12, Motion::Retract));
  return {rough, finish};
}

/// For @p post, with clearance plane 10, a stock, and a path tolerance.
inline pointmill::GCodeWriter
plainWriterFor(const pointmill::Post& post,
               pointmill::Unit unit = pointmill::Unit::Millimetre)
{
  pointmill::GCodeWriter writer;
  writer.setPost(post);
  writer.setUnit(unit);
  writer.setProgramName("Bracket");
  writer.setClearancePlane(10);
  writer.setPathTolerance(0.02);
  writer.setStock(pointmill::Stock{{-5, -5, -10}, {45, 25, 0.5}});
  return writer;
}

inline void makeArcs(pointmill::GCodeWriter& writer, const ArcsInstead::Arcs& arcs)
{
  writer.addAdapter([arcs](pointmill::MachineCalls& next) {
    return std::make_unique<ArcsInstead>(next, arcs);
  });
}

inline pointmill::GCodeWriter
writerFor(const pointmill::Post& post,
          pointmill::Unit unit = pointmill::Unit::Millimetre)
{
  auto writer = plainWriterFor(post, unit);
  makeArcs(writer, someArcs(writer.getGrid()));
  return writer;
}

/// The files by their suffixes.
using Files = std::map<std::string, std::ostringstream>;

inline Files files(const pointmill::GCodeWriter& writer,
                   const std::vector<pointmill::Operation>& operations)
{
  Files files;
  writer.write(operations, [&files](const std::string& suffix) -> std::ostream& {
    EXPECT_EQ(files.count(suffix), 0u) << suffix;
    return files[suffix];
  });
  return files;
}

} // namespace sample
