// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/surface/stock_field.h>
#include <pointmill/viewer/viewer_scene.h>
#include <pointmill/visual/colour.h>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cstdint>
#include <vector>

namespace pointmill::viewer {

/// @brief A colour of the palette on a surface that is lit: paler than lines of it,
/// which are seen on it.
inline visual::Rgb surfaceColour(int colour)
{
  return visual::mix(
      visual::kOperations[colour % visual::kOperationCount], visual::kPage, 0.3f);
}

/// @brief The stock as a surface over its cells, with sides down to its bottom; each
/// cell has the colour of the operation that last cut it.
class StockSurface {
public:
  StockSurface(const StockField& field, const std::vector<ViewedSection>& sections);

  /// @brief Takes over what has been cut, or put back.
  void update(const CutPlayer& player);

  vtkActor* actor() { return actor_; }

private:
  vtkIdType vertex(int column, int row) const
  {
    return static_cast<vtkIdType>(row + 1) * (columns_ + 2) + column + 1;
  }
  bool isGone(int column, int row) const;
  void connect();

  int columns_, rows_;
  float bottom_;
  std::vector<visual::Rgb> palette_; // of the sections
  std::vector<char> gone_;           // cells of which nothing is left
  vtkNew<vtkFloatArray> coordinates_;
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkActor> actor_;
};

} // namespace pointmill::viewer
