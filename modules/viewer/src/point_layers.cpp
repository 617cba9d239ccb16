// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "shapes.h"

#include <pointmill/visual/deviation_picture.h>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace pointmill::viewer {

namespace {

using visual::Rgb;

/// Points with a colour each, and normals where they are lit.
class Dots {
public:
  explicit Dots(bool lit)
  {
    coordinates_->SetNumberOfComponents(3);
    colours_->SetNumberOfComponents(3);
    normals_->SetNumberOfComponents(3);
    lit_ = lit;
  }
  template <typename PointT>
  void add(const PointT& p, const Rgb& colour, const Eigen::Vector3f& normal)
  {
    cells_->InsertNextCell(1);
    cells_->InsertCellPoint(coordinates_->InsertNextTuple(p.data));
    colours_->InsertNextTuple3(
        visual::toByte(colour.r), visual::toByte(colour.g), visual::toByte(colour.b));
    if (lit_)
      normals_->InsertNextTuple(normal.data());
  }
  vtkSmartPointer<vtkActor> actor()
  {
    vtkNew<vtkPoints> points;
    points->SetData(coordinates_);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetVerts(cells_);
    data->GetPointData()->SetScalars(colours_);
    if (lit_)
      data->GetPointData()->SetNormals(normals_);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetLighting(lit_);
    actor->GetProperty()->SetAmbient(0.3);
    actor->GetProperty()->SetDiffuse(0.7);
    return actor;
  }

private:
  bool lit_;
  vtkNew<vtkFloatArray> coordinates_, normals_;
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkCellArray> cells_;
};

/// The slopes of a map, on either side of a step towards the side that is less steep.
class Slopes {
public:
  explicit Slopes(const CellCloud& map) : map_(map)
  {
    const PointCell &first = map.front(), &last = map.back();
    step_x_ = (last.x - first.x) / static_cast<float>(map.width - 1);
    step_y_ = (last.y - first.y) / static_cast<float>(map.height - 1);
  }
  /// Whether a point lies more than a cell's edge under the highest of its cell.
  bool covers(float x, float y, float z) const
  {
    const float top = height(column(x), row(y));
    return !std::isnan(top) && z < top - std::abs(step_x_);
  }
  Eigen::Vector3f normalAt(float x, float y) const
  {
    const int c = column(x), r = row(y);
    const float sx = slope(height(c - 1, r), height(c, r), height(c + 1, r), step_x_);
    const float sy = slope(height(c, r - 1), height(c, r), height(c, r + 1), step_y_);
    return Eigen::Vector3f(-sx, -sy, 1.f).normalized();
  }

private:
  int column(float x) const
  {
    return static_cast<int>(std::lround((x - map_.front().x) / step_x_));
  }
  int row(float y) const
  {
    return static_cast<int>(std::lround((y - map_.front().y) / step_y_));
  }
  float height(int c, int r) const
  {
    return c < 0 || r < 0 || c >= static_cast<int>(map_.width) ||
                   r >= static_cast<int>(map_.height)
               ? std::numeric_limits<float>::quiet_NaN()
               : map_.at(c, r).z;
  }
  static float slope(float before, float here, float after, float step)
  {
    const float back = (here - before) / step, ahead = (after - here) / step;
    if (std::isnan(back) || std::isnan(ahead))
      return std::isnan(back) ? (std::isnan(ahead) ? 0.f : ahead) : back;
    constexpr float steep = 3.f;
    if (std::abs(back) < steep && std::abs(ahead) < steep)
      return (back + ahead) / 2;
    return std::abs(back) < std::abs(ahead) ? back : ahead;
  }

  const CellCloud& map_;
  float step_x_, step_y_;
};

} // namespace

std::pair<float, float> heightsOf(const pcl::PointCloud<pcl::PointXYZ>& part)
{
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (const auto& p : part)
    if (std::isfinite(p.z)) {
      low = std::min(low, p.z);
      high = std::max(high, p.z);
    }
  return {low, high};
}

vtkSmartPointer<vtkActor> partPoints(const pcl::PointCloud<pcl::PointXYZ>& part,
                                     const CellCloud* map,
                                     std::size_t stride)
{
  const auto [low, high] = heightsOf(part);
  const bool lit = map && map->width > 1 && map->height > 1;
  std::optional<Slopes> slopes;
  if (lit)
    slopes.emplace(*map);
  Dots dots(lit);
  for (std::size_t i = 0; i < part.size(); i += stride) {
    const auto& p = part[i];
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
      dots.add(p,
               visual::heightColour(high > low ? (p.z - low) / (high - low) : 0.5f),
               lit ? slopes->normalAt(p.x, p.y) : Eigen::Vector3f::UnitZ().eval());
  }
  return dots.actor();
}

vtkSmartPointer<vtkActor>
deviationPoints(const pcl::PointCloud<pcl::PointXYZI>& deviation,
                const CellCloud* map,
                const visual::DeviationScale& scale,
                std::size_t stride)
{
  Dots dots(false);
  std::optional<Slopes> slopes;
  if (map && map->width > 1 && map->height > 1)
    slopes.emplace(*map);
  for (std::size_t i = 0; i < deviation.size(); i += stride) {
    pcl::PointXYZI p = deviation[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z) ||
        (slopes && slopes->covers(p.x, p.y, p.z)))
      continue;
    const Rgb colour =
        std::isnan(p.intensity) ? visual::kNeverCut : scale.at(p.intensity);
    p.z += std::isnan(p.intensity) ? 0.f : p.intensity;
    dots.add(p, colour, Eigen::Vector3f::UnitZ());
  }
  return dots.actor();
}

visual::DeviationScale
deviationScaleOf(const pcl::PointCloud<pcl::PointXYZI>& deviation, double tolerance)
{
  return {tolerance, deviationRange(deviation, tolerance)};
}

} // namespace pointmill::viewer
