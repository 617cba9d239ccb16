// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "levels.h"

#include <pointmill/common/error.h>
#include <pointmill/viewer/add_cloud.h>

#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include <algorithm>

namespace pointmill {

namespace {

bool has(const pcl::PCLPointCloud2& cloud, std::initializer_list<const char*> fields)
{
  return std::all_of(fields.begin(), fields.end(), [&](const char* field) {
    return pcl::getFieldIndex(cloud, field) >= 0;
  });
}

/// Only the points that have a place: PCL shows clouds with others at wrong ones.
pcl::PCLPointCloud2::Ptr finite(const pcl::PCLPointCloud2& cloud)
{
  pcl::PointCloud<pcl::PointXYZ> places;
  pcl::fromPCLPointCloud2(cloud, places);
  pcl::Indices kept;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i].getVector3fMap().allFinite())
      kept.push_back(static_cast<pcl::index_t>(i));
  pcl::PCLPointCloud2::Ptr out(new pcl::PCLPointCloud2);
  pcl::copyPointCloud(cloud, kept, *out);
  out->is_dense = true;
  return out;
}

} // namespace

void addCloud(ViewerScene& scene,
              const std::string& name,
              const pcl::PCLPointCloud2::Ptr& cloud)
{
  if (!has(*cloud, {"x", "y", "z"}))
    throw DataError(name + ": the cloud has no fields x, y and z");
  if (cloud->width * cloud->height == 0)
    throw DataError(name + ": the cloud is empty");
  if (has(*cloud, {"feed", "label", "level", "motion"})) {
    CLCloud path = scene.path ? *scene.path : CLCloud();
    CLCloud more;
    pcl::fromPCLPointCloud2(*cloud, more);
    const auto number = static_cast<int>(scene.operations.size());
    scene.operations.push_back({name, number, path.size(), more.size()});
    path += more;
    scene.path = std::make_shared<CLCloud>(std::move(path));
  }
  else if (has(*cloud, {"label", "count"}) && cloud->height > 1 && cloud->width > 1) {
    auto map = std::make_shared<CellCloud>();
    pcl::fromPCLPointCloud2(*cloud, *map);
    scene.map = map;
    CellCloud cells; // whatever stands for the height of cells that have none
    for (const PointCell& cell : *map)
      if (cell.getState() != CellState::Empty)
        cells.push_back(cell);
    pcl::PCLPointCloud2 shown;
    pcl::toPCLPointCloud2(cells, shown);
    if (!cells.empty())
      scene.clouds.push_back({name, finite(shown)});
  }
  else
    scene.clouds.push_back({name, finite(*cloud)});
}

ViewerLook lookFor(const ViewerScene& scene)
{
  ViewerLook look;
  look.paths = ViewedPaths::All;
  const std::vector<double> levels = viewer::levelsOf(scene);
  if (scene.operations.size() == 1)
    look.colouring = levels.size() > 1 ? PathColouring::Level : PathColouring::Pass;
  if (scene.map && !scene.path) {
    look.map = true;
    look.level = levels.size() / 2;
  }
  return look;
}

} // namespace pointmill
