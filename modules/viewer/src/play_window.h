// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "scene_window.h"

#include <vtkNew.h>
#include <vtkSliderWidget.h>

#include <optional>
#include <string>

namespace pointmill::viewer {

/// @brief A window on the screen: keys, the slider, and the cut as it is played.
class PlayWindow {
public:
  explicit PlayWindow(SceneWindow& view) : view_(view) {}

  /// @brief Returns when the window is closed.
  void run(bool playing);

private:
  bool drawsInSoftware();
  bool onKey(const std::string& key, bool shift, bool control);
  void setPlaying(bool playing);
  void tick();
  void addSlider();
  double sliderValue() const;
  void redraw();

  SceneWindow& view_;
  vtkNew<vtkSliderWidget> slider_;
  bool has_slider_ = false, helped_ = false;
  std::optional<int> timer_;
  double last_tick_ = 0;
};

} // namespace pointmill::viewer
