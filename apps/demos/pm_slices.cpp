// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// pm_slices: ZSlices and PointRecovery, what stands above one level or all of them.
#include "clouds.h"
#include "demo.h"

#include <pointmill/slice/point_recovery.h>
#include <pointmill/slice/z_slices.h>

#include <pcl/common/common.h>

using namespace pointmill;

int main(int argc, char** argv)
{
  Demo demo("pm_slices",
            "ZSlices and PointRecovery: the points of a part above a level, projected "
            "onto it; without --level of all levels, whose number is the label",
            "part.pcd slices.pcd --pitch 2");
  std::string path;
  double pitch = 0, diameter = 10;
  demo.input("PART", path, "a cloud in its frame, as pm_align writes it");
  demo.output("SLICES", "PCD of PointXYZL");
  PointRecovery<pcl::PointXYZ> recovery;
  demo.parameters(recovery, "PointRecovery");
  numberOption(demo.options(), "--pitch", pitch, "MM", "between levels; 0: 0.3 d / 4");
  numberOption(demo.options(), "--diameter", diameter, "MM", "d, of the cutter");
  return demo.run(argc, argv, [&] {
    const auto part = readPart(path);
    std::vector<double> levels{recovery.getLevel()};
    if (!demo.has("--level")) {
      pcl::PointXYZ low, high;
      pcl::getMinMax3D(*part, low, high);
      ZSlices slices;
      slices.setZLimits(low.z, high.z);
      slices.setPitch(pitch > 0 ? pitch : ZSlices::pitchForDiameter(diameter));
      levels = slices.levels();
    }
    pcl::PointCloud<pcl::PointXYZL> all;
    for (std::size_t k = 0; k < levels.size(); ++k) {
      recovery.setLevel(levels[k]);
      const auto points = pointmill::run(part, recovery);
      for (const auto& p : *points)
        all.push_back({p.x, p.y, p.z, static_cast<std::uint32_t>(k)});
      demo.print("level_" + std::to_string(k + 1),
                 "Z" + std::to_string(levels[k]) + ", " +
                     std::to_string(points->size()) + " points");
    }
    demo.finish(all);
  });
}
