// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// pm_cl_surface: CLSurface, from a part to the rows of a finishing tool as PointCL.
#include "../pointmill/tool_options.h"
#include "clouds.h"
#include "demo.h"

#include <pointmill/finish/cl_surface.h>

using namespace pointmill;

int main(int argc, char** argv)
{
  Demo demo("pm_cl_surface",
            "CLSurface: raster rows over the cutter-location surface of a part. Chords "
            "between the CL points are not proven: pm_buffer_points does that",
            "part.pcd rows.pcd --tool-diameter 3 --scallop 0.01 --step-over 0.3");
  std::string path;
  bool across = false;
  demo.input("PART", path, "a cloud in its frame, as pm_align writes it");
  demo.output("CL", "PCD of PointCL");
  CLSurface<pcl::PointXYZ> rows;
  demo.parameters(rows, "CLSurface");
  demo.choice<RasterPattern>(
      "--pattern",
      [&](RasterPattern pattern) { rows.setPattern(pattern); },
      {{"zigzag", RasterPattern::ZigZag}, {"one-way", RasterPattern::OneWay}},
      "how the rows follow each other");
  demo.choice<MillingMode>(
      "--milling",
      [&](MillingMode mode) { rows.setMillingMode(mode); },
      {{"climb", MillingMode::Climb}, {"conventional", MillingMode::Conventional}},
      "of one-way rows");
  demo.options().add_flag("--across", across, "a second raster goes across on walls");
  ToolOptions tool("tool");
  tool.declare(demo.options(), "Tool", rows.getTool());
  return demo.run(argc, argv, [&] {
    rows.setTool(tool.toolFrom(rows.getTool()));
    rows.setAcross(across);
    demo.finish(*demo.filter(rows, readPart(path)));
  });
}
