// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// pm_buffer_points: BufferPoints, from CL points to chords that keep a tolerance.
#include "../pointmill/tool_options.h"
#include "clouds.h"
#include "demo.h"

#include <pointmill/finish/buffer_points.h>

using namespace pointmill;

int main(int argc, char** argv)
{
  Demo demo(
      "pm_buffer_points",
      "BufferPoints: splits the chords of a CL cloud until they are proven to keep "
      "the tolerance over the part's points",
      "rows.pcd part.pcd cl.pcd --tool-diameter 3 --inside-tolerance 0.005");
  std::string path, part;
  demo.input("ROWS", path, "PCD of PointCL, as pm_cl_surface writes it");
  demo.input("PART", part, "the cloud that it was made from");
  demo.output("CL", "PCD of PointCL");
  BufferPoints<pcl::PointXYZ> buffer;
  demo.parameters(buffer, "BufferPoints");
  const Tool standard = Tool::ball(1, 3.0);
  ToolOptions tool("tool");
  tool.declare(demo.options(), "Tool", standard);
  return demo.run(argc, argv, [&] {
    buffer.setTool(tool.toolFrom(standard));
    buffer.setSurface(readPart(part));
    demo.finish(*demo.filter(buffer, readPoints<PointCL>(path, "pm_cl_surface")));
  });
}
