// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/viewer/viewer_scene.h>
#include <pointmill/visual/colour.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace pointmill {

/// @brief Which surface stands in the middle of the view.
enum class ViewedSolid {
  Stock,     ///< as it is at the moment that is shown
  Part,      ///< the points of the scan
  Deviation, ///< the same, coloured by what the program leaves or takes too much
  None
};

/// @brief Which of the CL points are shown.
enum class ViewedPaths {
  All,
  Level, ///< those between the level that is shown and the next one up
  Trail, ///< what the tool did last, at the moment that is shown
  None
};

/// @brief What the colours of paths tell.
enum class PathColouring { Operation, Pass, Level, Motion, Feed, Height };

/// @brief Where the camera stands.
enum class ViewedFrom { Iso, Top, Front, Back, Left, Right };

/// @brief What of a scene is shown, and how. Keys and options change it.
struct ViewerLook {
  ViewedSolid solid = ViewedSolid::Stock;
  ViewedPaths paths = ViewedPaths::All;
  PathColouring colouring = PathColouring::Operation;
  ViewedFrom from = ViewedFrom::Iso;
  bool rapids = true;
  bool tool = true;
  bool map = false; ///< the bi-colour map at the level that is shown
  bool box = true;  ///< outline of the stock
  bool texts = true;
  /// Counts from the top; nothing: none is chosen.
  std::optional<std::size_t> level;
  std::optional<std::size_t> finding; ///< that is looked at
  double time = 0.0;                  ///< of the program [s]
  double speed = 0.0;                 ///< of playing it; 0: all of it in a minute
  std::optional<bool> playing;        ///< in a window: whether it plays
  double point_size = 3.0;            ///< px
  double axes = 0.0; ///< length [mm]; 0: a share of the part; less: none
  visual::Rgb background = visual::kPage;
};

/// @brief Shows a scan, its map, paths, the stock and what became of it: in a window
/// that takes pcl_viewer's mouse and keys and some more (see help()), or as a picture,
/// for which no display is needed.
class Viewer {
public:
  Viewer(ViewerScene scene, const ViewerLook& look);

  /// @brief Opens a window, and returns when it is closed.
  /// @param playing whether the program plays from the beginning
  /// @throws Error where there is no display
  void show(int width, int height, bool playing = false);

  /// @brief Writes a PNG. The same scene and look give the same picture on one machine.
  /// @param width,height [px], 64 .. 8192
  /// @throws ParameterError, DataError where @p path cannot be written
  void screenshot(const std::string& path, int width, int height);

  /// @brief Draws the scene so many times while the camera goes round, and tells the
  /// pictures per second; @p moving as while the mouse turns it, with coarser paths.
  double framesPerSecond(int width, int height, int frames, bool moving);

  /// @brief The same while the program is played from its middle on, half a second of
  /// it a picture.
  double playedPerSecond(int width, int height, int frames);

  /// @brief The heights of the levels that can be shown, from the top [mm].
  const std::vector<double>& levels() const;

  /// @brief The keys that this viewer adds to pcl_viewer's, a line each.
  static const std::string& help();

private:
  ViewerScene scene_;
  ViewerLook look_;
  std::vector<double> levels_;
};

} // namespace pointmill
