// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "scene_props.h"
#include "window_style.h"

#include <pointmill/viewer/viewer.h>

#include <pcl/visualization/pcl_visualizer.h>

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <memory>
#include <vector>

namespace pointmill::viewer {

/// @brief A view of a scene on PCL's visualizer, in a window that is shown or is not.
class SceneWindow {
public:
  /// @param scene,levels must live as long as this
  SceneWindow(const ViewerScene& scene,
              const std::vector<double>& levels,
              const ViewerLook& look,
              const vtkSmartPointer<vtkRenderWindow>& window,
              int width,
              int height);

  pcl::visualization::PCLVisualizer& visualizer() { return *visualizer_; }
  vtkRenderWindow* window() { return visualizer_->getRenderWindow(); }
  vtkRenderer* renderer()
  {
    return visualizer_->getRendererCollection()->GetFirstRenderer();
  }
  WindowStyle& style() { return *style_; }
  SceneProps& props() { return *props_; }
  /// @brief What is shown; props() must be told of changes.
  ViewerLook& look() { return look_; }
  const ViewerScene& scene() const { return scene_; }
  const std::vector<double>& levels() const { return levels_; }

  /// @brief Goes to a moment of the program, which is not yet drawn.
  void seek(double seconds);

private:
  void addCloud(const ViewedCloud& viewed, std::size_t number);
  void addAxes();

  const ViewerScene& scene_;
  const std::vector<double>& levels_;
  ViewerLook look_;
  vtkSmartPointer<WindowStyle> style_;
  std::unique_ptr<pcl::visualization::PCLVisualizer> visualizer_;
  std::unique_ptr<SceneProps> props_;
};

} // namespace pointmill::viewer
