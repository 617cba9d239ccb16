// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "shapes.h"

#include <pointmill/visual/colour.h>

#include <vtkAssembly.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRotationalExtrusionFilter.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pointmill::viewer {

namespace {

constexpr int kFacets = 48;        // round the axis
constexpr int kOutlinePlaces = 33; // of the cutter's end

using Outline = std::vector<Eigen::Vector2d>; // radius and height over the tip

vtkSmartPointer<vtkActor> turned(const Outline& outline, const visual::Rgb& colour)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(static_cast<int>(outline.size()));
  for (const auto& p : outline)
    line->InsertCellPoint(points->InsertNextPoint(p.x(), 0, p.y()));
  vtkNew<vtkPolyData> profile;
  profile->SetPoints(points);
  profile->SetLines(line);
  vtkNew<vtkRotationalExtrusionFilter> turn;
  turn->SetInputData(profile);
  turn->SetResolution(kFacets);
  turn->CappingOff();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(turn->GetOutputPort());
  normals->SetFeatureAngle(35);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour.r, colour.g, colour.b);
  actor->GetProperty()->SetAmbient(0.25);
  actor->GetProperty()->SetDiffuse(0.65);
  actor->GetProperty()->SetSpecular(0.35);
  actor->GetProperty()->SetSpecularPower(30);
  return actor;
}

Outline cylinder(double radius, double foot, double top)
{
  return {{0, foot}, {radius, foot}, {radius, top}, {0, top}};
}

} // namespace

vtkSmartPointer<vtkProp3D> toolShape(const Tool& tool)
{
  const CutterProfile profile = tool.profile();
  const double radius = profile.radius();
  const double rim = profile.height(radius);
  const double flutes =
      std::max(tool.flute_length > 0 ? tool.flute_length : 2.5 * tool.diameter, rim);
  const double shank = tool.shank_diameter > 0 ? tool.shank_diameter / 2 : radius;
  const double face =
      std::max(tool.stick_out > 0 ? tool.stick_out : flutes + tool.diameter, flutes);

  Outline end;
  for (int i = 0; i < kOutlinePlaces; ++i) { // closer where a round end is steep
    const double share = static_cast<double>(i) / (kOutlinePlaces - 1);
    const double r = std::min(radius, radius * std::sin(share * M_PI / 2));
    end.emplace_back(r, profile.height(r));
  }
  end.emplace_back(radius, flutes);
  end.emplace_back(0, flutes);
  auto assembly = vtkSmartPointer<vtkAssembly>::New();
  assembly->AddPart(turned(end, visual::hex(0xD9A441)));
  if (face > flutes)
    assembly->AddPart(turned(cylinder(shank, flutes, face), visual::hex(0x8E99A4)));
  if (tool.holder_diameter > 0)
    assembly->AddPart(
        turned(cylinder(tool.holder_diameter / 2, face, face + tool.holder_diameter),
               visual::hex(0x4A5561)));
  return assembly;
}

} // namespace pointmill::viewer
