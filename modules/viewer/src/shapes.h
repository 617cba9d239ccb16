// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>
#include <pointmill/common/stock.h>
#include <pointmill/common/tool.h>
#include <pointmill/visual/deviation_scale.h>
#include <pointmill/visual/occupancy_kind.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vtkActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkProp3D.h>
#include <vtkSmartPointer.h>

#include <utility>

namespace pointmill::viewer {

/// @brief Lines that lie in a surface are seen on it.
inline void drawBehindLines(vtkPolyDataMapper* surface)
{
  surface->SetResolveCoincidentTopologyToPolygonOffset();
  surface->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 2);
}

/// @brief A tool with its tip at the origin: flutes, shank and holder as far as they
/// are given, else as tools of its diameter are made.
vtkSmartPointer<vtkProp3D> toolShape(const Tool& tool);

/// @brief The edges of the stock's box.
vtkSmartPointer<vtkActor> stockEdges(const Stock& stock);

/// @brief The map's colours, paler than in its pictures, so that paths are seen on it.
inline visual::Rgb sheetColour(visual::OccupancyKind kind)
{
  return visual::mix(visual::colourOf(kind), visual::kPage, 0.45f);
}

/// @brief The bi-colour map at a level, as a sheet at its height.
vtkSmartPointer<vtkActor> levelSheet(const CellCloud& map, double level_z);

/// @brief The lowest and the highest of the points [mm].
std::pair<float, float> heightsOf(const pcl::PointCloud<pcl::PointXYZ>& part);

/// @brief The points of the part, coloured by height; lit by the slopes of the map
/// where there is one.
/// @param stride one of so many points is drawn
vtkSmartPointer<vtkActor> partPoints(const pcl::PointCloud<pcl::PointXYZ>& part,
                                     const CellCloud* map,
                                     std::size_t stride = 1);

/// @brief The points coloured by their intensity, each at the height of the milled
/// surface: where they were scanned the higher ones would hide the others. What the map
/// says is covered by others, if there is a map, is left out.
vtkSmartPointer<vtkActor>
deviationPoints(const pcl::PointCloud<pcl::PointXYZI>& deviation,
                const CellCloud* map,
                const visual::DeviationScale& scale,
                std::size_t stride = 1);

/// @brief Where colours of deviations end: what 99 of 100 points keep, but 4 .. 10
/// tolerances.
visual::DeviationScale
deviationScaleOf(const pcl::PointCloud<pcl::PointXYZI>& deviation, double tolerance);

} // namespace pointmill::viewer
