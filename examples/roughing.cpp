// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// PCL's filters and PointMill's in one chain: from a scan to the roughing's CL points.
#include <pointmill/align/z_alignment.h>
#include <pointmill/rough/zigzag_roughing.h>
#include <pointmill/slice/occupancy_map.h>

#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/io/pcd_io.h>

#include <iostream>

// [README]
int main(int argc, char** argv)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr scan(new pcl::PointCloud<pcl::PointXYZ>);
  if (argc != 2 || pcl::io::loadPCDFile(argv[1], *scan) != 0)
    return 1;
  pcl::StatisticalOutlierRemoval<pcl::PointXYZ> strays; // of PCL
  pointmill::ZAlignment<pcl::PointXYZ> align;
  pointmill::OccupancyMap<pcl::PointXYZ> map; // makes a cloud of PointCell
  pointmill::ZigZagRoughing roughing;         // and this one of PointCL
  const auto path = pointmill::run(scan, strays, align, map, roughing);
  std::cout << path->size() << " CL points\n";
}
// [README]
