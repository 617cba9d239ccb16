// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "camera.h"
#include "frame.h"
#include "grid.h"
#include "layout.h"
#include "shade.h"

#include <pointmill/visual/preview.h>

#include <optional>

namespace pointmill::visual {

/// @brief A scene measured, and how its panels look at it.
struct View {
  /// @throws DataError where the scene has nothing to show or a map is unusable
  explicit View(const PreviewScene& s);

  /// @brief Aims the camera at everything, for pictures of that size [px].
  void aim(int picture_width, int picture_height, double line_scale);

  const PreviewScene& scene;
  std::optional<Grid> map, milled;
  std::vector<Eigen::AlignedBox3d> boxes; ///< of what is shown [mm]
  bool has_stock = false;
  bool has_gaps = false;
  bool has_rapids = false;
  double floor = 0.0; ///< foot of the part's outer walls [mm]
  int width = 0, height = 0;
  double lines = 1.0; ///< thickness of lines, 1 at full size
  Camera camera;
  Light light;
};

Raster scanPanel(const View& view);
Raster pathPanel(const View& view);
Raster milledPanel(const View& view);

Legend scanLegend(const View& view);
Legend pathLegend(const View& view);
Legend milledLegend(const View& view);

} // namespace pointmill::visual
