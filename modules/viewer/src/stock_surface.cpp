// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "stock_surface.h"

#include "shapes.h"

#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>

namespace pointmill::viewer {

namespace {

/// What is less high over the bottom is nothing [mm].
constexpr float kNothing = 1e-3f;

} // namespace

StockSurface::StockSurface(const StockField& field,
                           const std::vector<ViewedSection>& sections)
    : columns_(field.columns()), rows_(field.rows()),
      bottom_(static_cast<float>(field.stock().min.z())),
      gone_(static_cast<std::size_t>(columns_) * rows_, 0)
{
  for (const auto& section : sections)
    palette_.push_back(surfaceColour(section.colour));
  // A ring of vertices round the cells stands on the stock's sides, at its bottom.
  const Stock& stock = field.stock();
  const double half = field.cellSize() / 2;
  coordinates_->SetNumberOfComponents(3);
  coordinates_->SetNumberOfTuples(vertex(columns_, rows_) + 1);
  colours_->SetNumberOfComponents(3);
  colours_->SetNumberOfTuples(coordinates_->GetNumberOfTuples());
  for (int row = -1; row <= rows_; ++row)
    for (int column = -1; column <= columns_; ++column) {
      const double x =
          std::clamp(field.x(column), stock.min.x(), field.x(columns_ - 1) + half);
      const double y =
          std::clamp(field.y(row), stock.min.y(), field.y(rows_ - 1) + half);
      const vtkIdType v = vertex(column, row);
      coordinates_->SetTuple3(v, x, y, bottom_);
      const visual::Rgb& c = visual::kRawStock;
      colours_->SetTuple3(
          v, visual::toByte(c.r), visual::toByte(c.g), visual::toByte(c.b));
    }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates_);
  data_->SetPoints(points);
  data_->GetPointData()->SetScalars(colours_);
  connect();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data_);
  drawBehindLines(mapper);
  actor_->SetMapper(mapper);
  actor_->GetProperty()->SetInterpolationToFlat(); // edges stay edges
  actor_->GetProperty()->SetAmbient(0.42);
  actor_->GetProperty()->SetDiffuse(0.65);
}

bool StockSurface::isGone(int column, int row) const
{
  return column < 0 || row < 0 || column >= columns_ || row >= rows_ ||
         gone_[static_cast<std::size_t>(row) * columns_ + column];
}

void StockSurface::connect()
{
  vtkNew<vtkCellArray> quads;
  for (int row = -1; row < rows_; ++row)
    for (int column = -1; column < columns_; ++column) {
      if (isGone(column, row) && isGone(column + 1, row) && isGone(column, row + 1) &&
          isGone(column + 1, row + 1))
        continue;
      const vtkIdType corners[] = {vertex(column, row),
                                   vertex(column + 1, row),
                                   vertex(column + 1, row + 1),
                                   vertex(column, row + 1)};
      quads->InsertNextCell(4, corners);
    }
  data_->SetPolys(quads);
}

void StockSurface::update(const CutPlayer& player)
{
  const StockField& field = player.stock();
  const auto& cut_by = player.cutBy();
  bool holes_changed = false;
  float* xyz = coordinates_->GetPointer(0);
  unsigned char* rgb = colours_->GetPointer(0);
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const std::size_t cell = static_cast<std::size_t>(row) * columns_ + column;
      const auto v = static_cast<std::size_t>(vertex(column, row));
      const auto z = static_cast<float>(field.height(column, row));
      xyz[3 * v + 2] = z;
      const char gone = z <= bottom_ + kNothing;
      holes_changed |= gone != gone_[cell];
      gone_[cell] = gone;
      const visual::Rgb& c =
          cut_by[cell] < palette_.size() ? palette_[cut_by[cell]] : visual::kRawStock;
      rgb[3 * v] = visual::toByte(c.r);
      rgb[3 * v + 1] = visual::toByte(c.g);
      rgb[3 * v + 2] = visual::toByte(c.b);
    }
  if (holes_changed)
    connect();
  coordinates_->Modified();
  data_->GetPoints()->Modified();
  colours_->Modified();
  data_->Modified();
}

} // namespace pointmill::viewer
