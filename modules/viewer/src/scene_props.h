// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "overlay.h"
#include "shapes.h"
#include "stock_surface.h"

#include <pointmill/viewer/viewer.h>

#include <vtkRenderer.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace pointmill::viewer {

/// @brief All that is seen of a scene: makes what a look shows when it is first shown,
/// and keeps it.
class SceneProps {
public:
  SceneProps(const ViewerScene& scene,
             const std::vector<double>& levels,
             vtkRenderer* renderer,
             vtkRenderer* marks,
             const ViewerLook& look);

  /// @brief Shows what @p look says. @param room px at the foot of the view that texts
  /// leave free
  void update(const ViewerLook& look, int room = 0);
  /// @brief What may be done, at the lower right.
  void setHint(const std::string& text) { overlay_.setHint(text); }
  void setHelp(const std::string& text) { overlay_.setHelp(text); }
  /// @brief Puts texts into their places, after a change of the window's size.
  void layOut() { overlay_.layOut(); }

  /// @brief While the view moves, long paths are drawn with fewer points.
  void setMoving(bool moving);

  /// @brief Looks at everything from where @p look says; at a finding from near by.
  void aim(const ViewerLook& look);

private:
  /// Points or lines, and fewer for while the view moves; the same where they are few.
  struct Detailed {
    vtkSmartPointer<vtkActor> full, coarse;
    bool visible = false;
  };
  Detailed
  dots(std::size_t points,
       const std::function<vtkSmartPointer<vtkActor>(std::size_t stride)>& make);
  void showSolid(const ViewerLook& look);
  void showPaths(const ViewerLook& look);
  void showTrail(const ViewerLook& look);
  void showTool(const ViewerLook& look);
  void showLevel(const ViewerLook& look);
  void showFindings(const ViewerLook& look);
  void showTexts(const ViewerLook& look, int room);

  const ViewerScene& scene_;
  const std::vector<double>& levels_;
  vtkRenderer *renderer_, *marks_renderer_;
  Overlay overlay_;
  double diagonal_ = 1.0; // of all that is shown [mm]
  Eigen::AlignedBox3d box_, box_with_paths_;
  std::optional<StockSurface> stock_;
  Detailed part_, deviation_, paths_;
  vtkSmartPointer<vtkActor> edges_, trail_, rapids_, sheet_;
  visual::DeviationScale deviation_scale_{0.02, 0.2};
  bool moving_ = false;
  std::optional<ViewerLook> legends_of_; // that stand there
  std::map<int, vtkSmartPointer<vtkProp3D>> tools_;
  std::optional<double> stock_time_; // of the cut that is shown
  std::vector<vtkSmartPointer<vtkProp>> marks_;
  std::optional<std::size_t> sheet_level_, paths_level_, marked_;
  std::optional<PathColouring> paths_colouring_;
  ViewedPaths paths_shown_ = ViewedPaths::None;
};

} // namespace pointmill::viewer
