// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "shapes.h"

#include <pointmill/visual/colour.h>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace pointmill::viewer {

vtkSmartPointer<vtkActor> stockEdges(const Stock& stock)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; ++i)
    points->InsertNextPoint(i & 1 ? stock.max.x() : stock.min.x(),
                            i & 2 ? stock.max.y() : stock.min.y(),
                            i & 4 ? stock.max.z() : stock.min.z());
  vtkNew<vtkCellArray> lines;
  for (vtkIdType i = 0; i < 8; ++i)
    for (const vtkIdType axis : {1, 2, 4})
      if (!(i & axis)) {
        const vtkIdType ends[] = {i, i | axis};
        lines->InsertNextCell(2, ends);
      }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  const visual::Rgb& c = visual::kStockEdge;
  actor->GetProperty()->SetColor(c.r, c.g, c.b);
  actor->GetProperty()->LightingOff();
  return actor;
}

} // namespace pointmill::viewer
