// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/surface/stock_field.h>
#include <pointmill/viewer/cut_player.h>
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

/// @brief The stock as a surface over its cells, with sides down to its bottom; each
/// cell has the colour of the operation that last cut it.
class StockSurface {
public:
  /// @param colours of the palette, for each section of the program
  StockSurface(const StockField& field, std::vector<int> colours);

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
  std::vector<int> section_colours_;
  std::vector<char> gone_; // cells of which nothing is left
  vtkNew<vtkFloatArray> coordinates_;
  vtkNew<vtkUnsignedCharArray> colours_;
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkActor> actor_;
};

} // namespace pointmill::viewer
