// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "path_lines.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace pointmill::viewer {

namespace {

/// Calls body(before, arriving, operation) for each move.
template <typename Body>
void forEachMove(const ViewerScene& scene, const Body& body)
{
  const CLCloud& path = *scene.path;
  for (std::size_t o = 0; o < scene.operations.size(); ++o) {
    const ViewedOperation& operation = scene.operations[o];
    const std::size_t end = std::min(path.size(), operation.first + operation.count);
    for (std::size_t i = operation.first + 1; i < end; ++i)
      body(path[i - 1], path[i], o);
  }
}

/// Grows line strips point by point.
class Strips {
public:
  Strips()
  {
    colours_->SetNumberOfComponents(3);
    colours_->SetName("colour");
  }
  bool open() const { return open_; }
  void begin(const PointCL& p, const visual::Rgb& colour)
  {
    end();
    open_ = true;
    first_ = coordinates_->GetNumberOfTuples();
    add(p, colour);
  }
  void add(const PointCL& p, const visual::Rgb& colour)
  {
    coordinates_->InsertNextTuple3(p.x, p.y, p.z);
    colours_->InsertNextTuple3(
        visual::toByte(colour.r), visual::toByte(colour.g), visual::toByte(colour.b));
  }
  void end()
  {
    const vtkIdType last = coordinates_->GetNumberOfTuples();
    if (open_ && last - first_ > 1) {
      cells_->InsertNextCell(static_cast<int>(last - first_));
      for (vtkIdType i = first_; i < last; ++i)
        cells_->InsertCellPoint(i);
    }
    open_ = false;
  }
  vtkSmartPointer<vtkPolyData> take()
  {
    end();
    vtkNew<vtkPoints> points;
    points->SetData(coordinates_);
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetLines(cells_);
    data->GetPointData()->SetScalars(colours_);
    return data;
  }

private:
  static vtkSmartPointer<vtkFloatArray> triples()
  {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetNumberOfComponents(3);
    return array;
  }
  vtkSmartPointer<vtkFloatArray> coordinates_ = triples();
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkCellArray> cells_;
  vtkIdType first_ = 0;
  bool open_ = false;
};

float distance(const PointCL& a, const PointCL& b)
{
  return (a.getVector3fMap() - b.getVector3fMap()).norm();
}

} // namespace

vtkSmartPointer<vtkPolyData> feedLines(const ViewerScene& scene,
                                       const PathColours& colours,
                                       const PathFilter& shown,
                                       double coarse)
{
  // Passes that nothing links yet are as many lines.
  const bool linked = std::any_of(scene.path->begin(), scene.path->end(), isRapid);
  Strips strips;
  const PointCL* drawn = nullptr; // the strip's last point
  const PointCL* skipped = nullptr;
  visual::Rgb colour;
  std::size_t in = 0;
  const auto finish = [&] {
    if (skipped && strips.open())
      strips.add(*skipped, colour);
    skipped = nullptr;
    strips.end();
  };
  forEachMove(scene,
              [&](const PointCL& before, const PointCL& p, std::size_t operation) {
                if (isRapid(p) || !shown(p, operation)) {
                  finish();
                  return;
                }
                const visual::Rgb now = colours.of(p, operation);
                // A colour that jumps begins a strip of its own, lest it be blended.
                const bool goes_on = strips.open() && operation == in &&
                                     before.label == p.label &&
                                     (colours.isGradual() || same(now, colour));
                if (!goes_on) {
                  finish();
                  const bool leap = !linked && before.label != p.label;
                  strips.begin(leap ? p : before, now);
                  drawn = leap ? &p : &before;
                }
                colour = now;
                in = operation;
                if (distance(*drawn, p) < coarse) {
                  skipped = &p;
                  return;
                }
                skipped = nullptr;
                strips.add(p, now);
                drawn = &p;
              });
  finish();
  return strips.take();
}

vtkSmartPointer<vtkPolyData>
rapidDashes(const ViewerScene& scene, const PathFilter& shown, double dash)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> cells;
  forEachMove(
      scene, [&](const PointCL& before, const PointCL& p, std::size_t operation) {
        if (!isRapid(p) || !shown(p, operation))
          return;
        const Eigen::Vector3f a = before.getVector3fMap(), b = p.getVector3fMap();
        const float length = (b - a).norm();
        if (!(length > 0.f))
          return;
        // An odd number of pieces, of which every other one is drawn: both ends show.
        const int pieces = 2 * std::min(500, static_cast<int>(length / (2 * dash))) + 1;
        for (int i = 0; i < pieces; i += 2) {
          const auto at = [&](int k) {
            const Eigen::Vector3f place =
                a + (b - a) * (static_cast<float>(k) / static_cast<float>(pieces));
            return coordinates->InsertNextTuple(place.data());
          };
          const vtkIdType ends[] = {at(i), at(i + 1)};
          cells->InsertNextCell(2, ends);
        }
      });
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

} // namespace pointmill::viewer
