// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "shapes.h"

#include <pointmill/common/error.h>
#include <pointmill/visual/occupancy_kind.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

namespace pointmill::viewer {

vtkSmartPointer<vtkActor> levelSheet(const CellCloud& map, double level_z)
{
  if (map.height < 2 || map.width < 2)
    throw DataError("the map to show is not organised, or has less than 2 x 2 cells");
  const int columns = static_cast<int>(map.width), rows = static_cast<int>(map.height);
  vtkNew<vtkImageData> image;
  image->SetDimensions(columns, rows, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int row = 0; row < rows; ++row) {
    auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(0, row, 0));
    for (int column = 0; column < columns; ++column) {
      const visual::Rgb c =
          sheetColour(visual::occupancyAt(map.at(column, row), level_z));
      *pixel++ = visual::toByte(c.r);
      *pixel++ = visual::toByte(c.g);
      *pixel++ = visual::toByte(c.b);
    }
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOff();

  const PointCell &first = map.front(), &last = map.back();
  const double dx = (last.x - first.x) / (columns - 1) / 2;
  const double dy = (last.y - first.y) / (rows - 1) / 2;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(first.x - dx, first.y - dy, level_z);
  plane->SetPoint1(last.x + dx, first.y - dy, level_z);
  plane->SetPoint2(first.x - dx, last.y + dy, level_z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  drawBehindLines(mapper);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  actor->GetProperty()->LightingOff();
  return actor;
}

} // namespace pointmill::viewer
