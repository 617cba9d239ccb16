// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// pm_rough: the strategies of roughing, from a map or a part to PointCL.
#include "../pointmill/tool_options.h"
#include "clouds.h"
#include "strategies.h"

#include <pointmill/slice/occupancy_map.h>

using namespace pointmill;

int main(int argc, char** argv)
{
  Demo demo(
      "pm_rough",
      "LevelRoughing: clears the stock round a part level by level, by one of six "
      "strategies",
      "map.pcd cl.pcd --strategy zigzag --step-down 2");
  std::string path, strategy = "offset";
  demo.input("MAP", path, "of pm_occupancy; or a part, which is mapped and kept exact");
  demo.output("CL", "PCD of PointCL");
  Strategies strategies(demo);
  demo.oneOf("--strategy", strategy, strategies.named, "how it goes over a level");
  demo.choice<MillingMode>(
      "--milling",
      [&](MillingMode mode) { strategies.high_speed.setMillingMode(mode); },
      {{"climb", MillingMode::Climb}, {"conventional", MillingMode::Conventional}},
      "of high-speed");
  OccupancyMap<pcl::PointXYZ> map;
  demo.parameters(map, "OccupancyMap", "a part");
  ToolOptions tool("tool");
  tool.declare(demo.options(), "Tool", strategies.offset.getTool());
  return demo.run(argc, argv, [&] {
    const bool mapped = isMap(path);
    demo.use({strategy, mapped ? "a map" : "a part"});
    LevelRoughing& roughing = *strategies.named.at(strategy);
    roughing.setTool(tool.toolFrom(roughing.getTool()));
    const auto part = mapped ? nullptr : readPart(path);
    if (part)
      roughing.setPart(indexOf(*part));
    const auto cells = mapped ? readMap(path) : demo.filter(map, part);
    demo.finish(*demo.filter(roughing, cells));
  });
}
