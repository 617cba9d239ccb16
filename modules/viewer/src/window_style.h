// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pcl/visualization/interactor_style.h>

#include <functional>
#include <string>

namespace pointmill::viewer {

/// @brief pcl_viewer's mouse and keys, with a say for others before them.
class WindowStyle : public pcl::visualization::PCLVisualizerInteractorStyle {
public:
  static WindowStyle* New();
  vtkTypeMacro(WindowStyle, pcl::visualization::PCLVisualizerInteractorStyle);

  /// @brief Takes a key by its X name; true: it was for it, and PCL does not get it.
  std::function<bool(const std::string& key, bool shift, bool control)> on_key;
  /// @brief Called at each tick of a timer.
  std::function<void()> on_tick;

protected:
  void OnKeyDown() override;
  void OnChar() override;
  void OnTimer() override;

private:
  bool taken_ = false; // the key that is down
};

} // namespace pointmill::viewer
