// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "path_colours.h"

#include <vtkActor2D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <array>
#include <string>
#include <vector>

namespace pointmill::viewer {

/// @brief A legend: its title, and a swatch and a text for each entry, or a bar where
/// colours run into each other.
struct Legend {
  std::string title;
  std::vector<LegendEntry> entries;
  bool bar = false;
};

/// @brief What is written over the view: a title, what the moment is, legends down the
/// right side, and a text of several lines on demand.
class Overlay {
public:
  Overlay(vtkRenderer* renderer, const visual::Rgb& background);

  void setTitle(const std::string& text) { title_->SetInput(text.c_str()); }
  /// @brief Lines at the lower left, over @p room px that something else takes.
  void setMoment(const std::string& text, int room);
  /// @brief One line at the lower right.
  void setHint(const std::string& text) { hint_->SetInput(text.c_str()); }
  void setLegends(std::vector<Legend> legends)
  {
    legends_ = std::move(legends);
    drawn_for_ = {};
  }
  /// @brief In the middle; empty: nothing.
  void setHelp(const std::string& text);
  void setVisible(bool visible) { visible_ = visible; }
  /// @brief Puts everything into its place; after any change, and of the window's size.
  void layOut();

private:
  vtkSmartPointer<vtkTextActor> text(int size, bool bold);
  void place(vtkTextActor* actor, double x, double y, bool right = false);
  void drawLegends(int width, int height, double scale);

  vtkRenderer* renderer_;
  visual::Rgb ink_, faint_, paper_;
  bool visible_ = true;
  int room_ = 0;
  vtkSmartPointer<vtkTextActor> title_, moment_, hint_, help_;
  std::vector<Legend> legends_;
  std::array<int, 3> drawn_for_{}; // width, height, visible; what legends stand for
  std::vector<vtkSmartPointer<vtkProp>> legend_props_;
};

} // namespace pointmill::viewer
