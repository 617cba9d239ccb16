// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// pm_slices: ZSlices and PointRecovery, what stands above one level or all of them.
#include "clouds.h"
#include "demo.h"

#include <pointmill/slice/point_recovery.h>

using namespace pointmill;

int main(int argc, char** argv)
{
  Demo demo("pm_slices",
            "ZSlices and PointRecovery: the points of a part above a level, projected "
            "onto it; without --level of all levels, whose number is the label, 1 at "
            "the top",
            "part.pcd slices.pcd --pitch 2");
  std::string path;
  double diameter = 10;
  demo.input("PART", path, "a cloud in its frame, as pm_align writes it");
  demo.output("SLICES", "PCD of PointXYZL");
  ZSlices slices;
  demo.parameters(slices, "ZSlices");
  PointRecovery<pcl::PointXYZ> recovery;
  demo.parameters(recovery, "PointRecovery");
  auto* level = demo.options().get_option("--level");
  auto* pitch = demo.options().get_option("--pitch")->excludes(level);
  numberOption(demo.options(), "--diameter", diameter, "MM", "d: pitch 0.3 d / 4")
      ->check(CLI::PositiveNumber)
      ->excludes(level)
      ->excludes(pitch);
  return demo.run(argc, argv, [&] {
    const auto part = readPart(path);
    if (demo.has("--diameter"))
      slices.setPitchForDiameter(diameter);
    const std::vector<double> levels = demo.has("--level")
                                           ? std::vector<double>{recovery.getLevel()}
                                           : levelsOf(*part, slices);
    const auto start = Demo::Clock::now();
    pcl::PointCloud<pcl::PointXYZL> all;
    std::vector<std::string> found;
    for (std::uint32_t number = 1; number <= levels.size(); ++number) {
      recovery.setLevel(levels[number - 1]);
      const auto points = pointmill::run(part, recovery);
      for (const auto& p : *points)
        all.push_back({p.x, p.y, p.z, number});
      found.push_back("Z" + std::to_string(recovery.getLevel()) + ", " +
                      std::to_string(points->size()) + " points");
    }
    demo.printRun(part->size(), all.size(), start);
    for (std::size_t i = 0; i < found.size(); ++i)
      demo.print("level_" + std::to_string(i + 1), found[i]);
    demo.finish(all);
  });
}
