// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "display.h"
#include "levels.h"
#include "offscreen_window.h"
#include "play_window.h"
#include "playback.h"
#include "words.h"

#include <pointmill/common/error.h>
#include <pointmill/common/parameters.h>
#include <pointmill/visual/png.h>

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkWindowToImageFilter.h>

namespace pointmill {

using namespace viewer;

namespace {

/// Draws one picture, which is not counted, and then so many.
template <typename Change>
double perSecond(int frames, vtkRenderWindow* window, const Change& change)
{
  window->Render();
  const double begin = secondsNow();
  for (int i = 0; i < frames; ++i) {
    change(i);
    window->Render();
  }
  return frames / (secondsNow() - begin);
}

} // namespace

Viewer::Viewer(ViewerScene scene, const ViewerLook& look)
    : scene_(std::move(scene)), look_(look), levels_(levelsOf(scene_))
{
  if (scene_.player) {
    if (look_.speed <= 0)
      look_.speed = suitableSpeed(scene_.player->duration());
    if (look_.finding && *look_.finding < scene_.findings.size())
      look_.time = momentOf(scene_, scene_.findings[*look_.finding], look_.time);
    scene_.player->seek(look_.time);
    look_.time = scene_.player->time();
  }
}

const std::vector<double>& Viewer::levels() const
{
  return levels_;
}

const std::string& Viewer::help()
{
  return keysHelp();
}

void Viewer::show(int width, int height, bool playing)
{
  if (!hasDisplay())
    throw Error("there is no display to open a window on; pictures need none");
  SceneWindow view(
      scene_, levels_, look_, vtkSmartPointer<vtkRenderWindow>::New(), width, height);
  PlayWindow(view).run(playing);
}

void Viewer::screenshot(const std::string& path, int width, int height)
{
  checkRange("screenshot", "width", width, "px", {64, 8192});
  checkRange("screenshot", "height", height, "px", {64, 8192});
  SceneWindow view(
      scene_, levels_, look_, makeOffscreenWindow(width, height), width, height);
  view.window()->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(view.window());
  picture->SetInputBufferTypeToRGB();
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  picture->Update();
  visual::writePng(path, picture->GetOutput());
}

double Viewer::framesPerSecond(int width, int height, int frames, bool moving)
{
  SceneWindow view(
      scene_, levels_, look_, makeOffscreenWindow(width, height), width, height);
  view.props().setMoving(moving);
  if (moving)
    view.window()->SetMultiSamples(0);
  return perSecond(frames, view.window(), [&](int) {
    view.renderer()->GetActiveCamera()->Azimuth(360.0 / frames);
  });
}

double Viewer::playedPerSecond(int width, int height, int frames)
{
  if (!scene_.player)
    throw DataError("there is no program to play");
  SceneWindow view(
      scene_, levels_, look_, makeOffscreenWindow(width, height), width, height);
  view.window()->SetMultiSamples(0);
  const double middle = scene_.player->duration() / 2;
  const auto show = [&](double seconds) {
    view.seek(seconds);
    view.props().update(view.look());
  };
  show(middle);
  return perSecond(frames, view.window(), [&](int i) { show(middle + 0.5 * i); });
}

} // namespace pointmill
