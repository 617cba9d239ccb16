// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// pm_occupancy: OccupancyMap, from a part to its map of PointCell.
#include "clouds.h"
#include "demo.h"

#include <pointmill/slice/occupancy_map.h>
#include <pointmill/visual/heights_picture.h>
#include <pointmill/visual/occupancy_picture.h>

using namespace pointmill;

int main(int argc, char** argv)
{
  Demo demo("pm_occupancy",
            "OccupancyMap: the highest point of each square cell of a part; finds the "
            "gaps of the scan and treats them",
            "part.pcd map.pcd --cell-size 0.3 --png level.png --level -5");
  std::string path;
  double level = 0;
  std::vector<std::pair<double, double>> holes;
  demo.input("PART", path, "a cloud in its frame, as pm_align writes it");
  demo.output("MAP", "PCD of PointCell");
  OccupancyMap<pcl::PointXYZ> map;
  demo.parameters(map, "OccupancyMap");
  demo.choice<GapPolicy>(
      "--gaps",
      [&](GapPolicy policy) { map.setGapPolicy(policy); },
      {{"bridge", GapPolicy::Bridge},
       {"keep", GapPolicy::Keep},
       {"mill", GapPolicy::Mill}},
      "what becomes of holes of the scan");
  demo.options()
      .add_option(
          "--through-hole", holes, "a place in a gap that is a hole of the part")
      ->type_name("X Y")
      ->type_size(2)
      ->expected(-1);
  numberOption(
      demo.options(), "--level", level, "MM", "of --png, a map; else it shows heights");
  return demo.run(argc, argv, [&] {
    std::vector<Eigen::Vector2d> places;
    for (const auto& [x, y] : holes)
      places.emplace_back(x, y);
    map.setThroughHoles(places);
    const auto cells = demo.filter(map, readPart(path));
    for (const auto& gap : map.getGaps())
      demo.print("gap_mm2", std::to_string(gap.area));
    if (const std::string png = demo.takePng(); demo.has("--level") && !png.empty())
      writeOccupancy(png, *cells, level);
    else if (!png.empty())
      writeHeights(png, *cells);
    demo.finish(withoutNan(*cells));
  });
}
