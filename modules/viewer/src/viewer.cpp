// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/viewer/viewer.h>

#include "levels.h"
#include "offscreen_window.h"
#include "playback.h"
#include "scene_props.h"
#include "window_style.h"
#include "words.h"

#include <pointmill/common/error.h>
#include <pointmill/common/parameters.h>

#include <pointmill/visual/png.h>

#include <pcl/visualization/pcl_visualizer.h>

#include <vtkAxesActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCaptionActor2D.h>
#include <vtkCommand.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

namespace pointmill {

using namespace viewer;
using pcl::visualization::PCLVisualizer;

namespace {

constexpr int kSamples = 8; // of a pixel, against jagged edges
constexpr int kTick = 40;   // ms
constexpr int kSliderRoom = 46;

double secondsNow()
{
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

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

/// Calls a function of ours for an event of VTK's.
template <typename Body>
vtkSmartPointer<vtkCallbackCommand> callback(Body& body)
{
  auto command = vtkSmartPointer<vtkCallbackCommand>::New();
  command->SetClientData(&body);
  command->SetCallback([](vtkObject*, unsigned long, void* data, void*) {
    (*static_cast<Body*>(data))();
  });
  return command;
}

} // namespace

/// A view of the scene on PCL's visualizer, in a window that is shown or is not.
class Viewer::Window {
public:
  Window(const Viewer& viewer,
         const vtkSmartPointer<vtkRenderWindow>& window,
         int width,
         int height)
      : scene_(viewer.scene_), look_(viewer.look_), levels_(viewer.levels_),
        style_(vtkSmartPointer<WindowStyle>::New())
  {
    // Of what PCL does, VTK 9.1 warns at length that a later version will not have it.
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_ERROR);
    window->SetSize(width, height);
    window->SetMultiSamples(kSamples);
    int argc = 0;
    visualizer_ = std::make_unique<PCLVisualizer>(argc,
                                                  nullptr,
                                                  vtkSmartPointer<vtkRenderer>::New(),
                                                  window,
                                                  scene_.title,
                                                  style_,
                                                  false);
    window->SetSize(width, height);
    visualizer_->setShowFPS(false);
    const visual::Rgb& page = look_.background;
    visualizer_->setBackgroundColor(page.r, page.g, page.b);
    for (const auto& viewed : scene_.clouds)
      addCloud(viewed);
    props_ = std::make_unique<SceneProps>(scene_, levels_, renderer(), look_);
    props_->update(look_);
    addAxes();
    props_->aim(look_);
  }

  vtkRenderer* renderer()
  {
    return visualizer_->getRendererCollection()->GetFirstRenderer();
  }
  vtkRenderWindow* window() { return visualizer_->getRenderWindow(); }

  void setMoving(bool moving) { props_->setMoving(moving); }
  /// Another moment, not yet drawn.
  void show(double seconds)
  {
    seek(seconds);
    props_->update(look_);
  }
  void run(bool playing);

private:
  void addCloud(const ViewedCloud& viewed)
  {
    using namespace pcl::visualization;
    PointCloudGeometryHandler<pcl::PCLPointCloud2>::Ptr place(
        new PointCloudGeometryHandlerXYZ<pcl::PCLPointCloud2>(viewed.cloud));
    const auto add = [&](PointCloudColorHandler<pcl::PCLPointCloud2>* colour) {
      PointCloudColorHandler<pcl::PCLPointCloud2>::Ptr handler(colour);
      if (handler->isCapable())
        visualizer_->addPointCloud(viewed.cloud,
                                   place,
                                   handler,
                                   Eigen::Vector4f::Zero(),
                                   Eigen::Quaternionf::Identity(),
                                   viewed.name);
    };
    // As pcl_viewer has them: keys 1, 2, 3 ... choose one.
    add(new PointCloudColorHandlerGenericField<pcl::PCLPointCloud2>(viewed.cloud, "z"));
    for (const auto& field : viewed.cloud->fields) {
      if (field.name == "rgb" || field.name == "rgba")
        add(new PointCloudColorHandlerRGBField<pcl::PCLPointCloud2>(viewed.cloud));
      else if (field.name == "label")
        add(new PointCloudColorHandlerLabelField<pcl::PCLPointCloud2>(viewed.cloud));
      else if (field.name != "z")
        add(new PointCloudColorHandlerGenericField<pcl::PCLPointCloud2>(viewed.cloud,
                                                                        field.name));
    }
    visualizer_->setPointCloudRenderingProperties(
        PCL_VISUALIZER_POINT_SIZE, look_.point_size, viewed.name);
  }

  void addAxes()
  {
    if (look_.axes < 0)
      return;
    double b[6];
    renderer()->ComputeVisiblePropBounds(b);
    const double length =
        look_.axes > 0 ? look_.axes : 0.12 * std::max(b[1] - b[0], b[3] - b[2]);
    vtkNew<vtkAxesActor> axes;
    axes->SetTotalLength(length, length, length);
    axes->SetShaftTypeToCylinder();
    axes->SetCylinderRadius(0.02);
    axes->SetNormalizedLabelPosition(1.25, 1.25, 1.25);
    for (auto* caption : {axes->GetXAxisCaptionActor2D(),
                          axes->GetYAxisCaptionActor2D(),
                          axes->GetZAxisCaptionActor2D()}) {
      caption->GetTextActor()->SetTextScaleModeToNone();
      vtkTextProperty* text = caption->GetCaptionTextProperty();
      text->SetFontSize(18);
      const visual::Rgb ink = inkOn(look_.background);
      text->SetColor(ink.r, ink.g, ink.b);
      text->ItalicOff();
      text->ShadowOff();
    }
    renderer()->AddActor(axes);
  }

  bool drawsInSoftware()
  {
    const std::string what = window()->ReportCapabilities();
    return what.find("llvmpipe") != std::string::npos ||
           what.find("softpipe") != std::string::npos;
  }
  bool onKey(const std::string& key, bool shift, bool control);
  void seek(double seconds);
  void setPlaying(bool playing);
  void tick();
  void addSlider();
  void redraw();

  ViewerScene scene_;
  ViewerLook look_;
  const std::vector<double>& levels_;
  vtkSmartPointer<WindowStyle> style_;
  std::unique_ptr<PCLVisualizer> visualizer_;
  std::unique_ptr<SceneProps> props_;
  vtkNew<vtkSliderWidget> slider_;
  bool has_slider_ = false, helped_ = false;
  std::optional<int> timer_;
  double last_tick_ = 0;
};

void Viewer::Window::seek(double seconds)
{
  look_.time = std::clamp(seconds, 0.0, scene_.player->duration());
  scene_.player->seek(look_.time);
}

void Viewer::Window::redraw()
{
  if (has_slider_) {
    auto* bar =
        static_cast<vtkSliderRepresentation*>(slider_->GetRepresentation()); // NOLINT
    bar->SetValue(look_.time);
  }
  props_->update(look_, has_slider_ ? kSliderRoom : 0);
  window()->Render();
}

void Viewer::Window::setPlaying(bool playing)
{
  vtkRenderWindowInteractor* interactor = window()->GetInteractor();
  if (timer_)
    interactor->DestroyTimer(*timer_);
  timer_.reset();
  if (!playing)
    return;
  if (look_.time >= scene_.player->duration())
    seek(0);
  last_tick_ = secondsNow();
  timer_ = interactor->CreateRepeatingTimer(kTick);
}

void Viewer::Window::tick()
{
  if (!timer_)
    return;
  const double now = secondsNow();
  constexpr double longest = 0.25; // s; what a slow machine misses it does not make up
  seek(look_.time + std::min(now - last_tick_, longest) * look_.speed);
  last_tick_ = now;
  if (look_.time >= scene_.player->duration())
    setPlaying(false);
  redraw();
}

void Viewer::Window::addSlider()
{
  if (!scene_.player || scene_.player->program().moves.empty())
    return;
  vtkNew<vtkSliderRepresentation2D> bar;
  bar->SetMinimumValue(0);
  bar->SetMaximumValue(scene_.player->duration());
  bar->SetValue(look_.time);
  bar->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedDisplay();
  bar->GetPoint1Coordinate()->SetValue(0.02, 0.035);
  bar->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedDisplay();
  bar->GetPoint2Coordinate()->SetValue(0.98, 0.035);
  bar->SetSliderLength(0.012);
  bar->SetSliderWidth(0.022);
  bar->SetTubeWidth(0.006);
  bar->SetEndCapLength(0.002);
  bar->SetEndCapWidth(0.012);
  bar->ShowSliderLabelOff();
  const auto paint = [](vtkProperty2D* property, const visual::Rgb& c) {
    property->SetColor(c.r, c.g, c.b);
  };
  paint(bar->GetTubeProperty(), visual::kStockEdge);
  paint(bar->GetCapProperty(), visual::kStockEdge);
  paint(bar->GetSliderProperty(), visual::kOperations[0]);
  paint(bar->GetSelectedProperty(), visual::kOperations[1]);
  slider_->SetInteractor(window()->GetInteractor());
  slider_->SetRepresentation(bar);
  slider_->SetAnimationModeToJump();
  slider_->EnabledOn();
  has_slider_ = true;
}

bool Viewer::Window::onKey(const std::string& key, bool shift, bool control)
{
  if (control)
    return false;
  const bool used = changeLook(key, shift, scene_, levels_, look_);
  if (used && scene_.player && look_.time != scene_.player->time())
    seek(look_.time);
  if (key == "space" && scene_.player && scene_.player->duration() > 0)
    setPlaying(!timer_);
  else if (key == "h" || key == "H") {
    helped_ = !helped_;
    props_->setHelp(helped_
                        ? Viewer::help() + "\nh            closes this; the other keys "
                                           "are on the terminal"
                        : "");
    redraw();
    return !helped_; // PCL prints its own
  }
  else if (!used)
    return false;
  if (movesCamera(key))
    props_->aim(look_);
  redraw();
  return true;
}

void Viewer::Window::run(bool playing)
{
  if (drawsInSoftware())
    window()->SetMultiSamples(0); // what is smooth is slow there
  visualizer_->createInteractor();
  vtkRenderWindowInteractor* interactor = window()->GetInteractor();
  window()->SetWindowName(scene_.title.c_str());
  style_->on_key = [this](const std::string& key, bool shift, bool control) {
    return onKey(key, shift, control);
  };
  style_->on_tick = [this] { tick(); };
  props_->setHint("space plays the cut    t paths    v surface    h all keys");
  addSlider();
  auto dragged = [this] {
    auto* bar =
        static_cast<vtkSliderRepresentation*>(slider_->GetRepresentation()); // NOLINT
    seek(bar->GetValue());
    redraw();
  };
  auto moves = [this] { setMoving(true); };
  auto rests = [this] {
    setMoving(false);
    window()->Render();
  };
  style_->AddObserver(vtkCommand::StartInteractionEvent, callback(moves));
  style_->AddObserver(vtkCommand::EndInteractionEvent, callback(rests));
  auto resized = [this] { props_->layOut(); };
  slider_->AddObserver(vtkCommand::InteractionEvent, callback(dragged));
  window()->AddObserver(vtkCommand::WindowResizeEvent, callback(resized));
  redraw();
  if (playing && scene_.player)
    setPlaying(true);
  interactor->Start();
}

Viewer::Viewer(ViewerScene scene, const ViewerLook& look)
    : scene_(std::move(scene)), look_(look), levels_(levelsOf(scene_))
{
  if (scene_.player) {
    if (look_.speed <= 0)
      look_.speed = suitableSpeed(scene_.player->duration());
    scene_.player->seek(look_.time);
    look_.time = scene_.player->time();
  }
}

Viewer::~Viewer() = default;

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
  if (!std::getenv("DISPLAY"))
    throw Error("there is no display to open a window on; --screenshot needs none");
  Window(*this, vtkSmartPointer<vtkRenderWindow>::New(), width, height).run(playing);
}

void Viewer::screenshot(const std::string& path, int width, int height)
{
  checkRange("screenshot", "width", width, "px", {64, 8192});
  checkRange("screenshot", "height", height, "px", {64, 8192});
  Window window(*this, makeOffscreenWindow(width, height), width, height);
  window.window()->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window.window());
  picture->SetInputBufferTypeToRGB();
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  picture->Update();
  visual::writePng(path, picture->GetOutput());
}

double Viewer::framesPerSecond(int width, int height, int frames, bool moving)
{
  Window window(*this, makeOffscreenWindow(width, height), width, height);
  window.setMoving(moving);
  if (moving)
    window.window()->SetMultiSamples(0);
  return perSecond(frames, window.window(), [&](int) {
    window.renderer()->GetActiveCamera()->Azimuth(360.0 / frames);
  });
}

double Viewer::playedPerSecond(int width, int height, int frames)
{
  if (!scene_.player)
    throw DataError("there is no program to play");
  Window window(*this, makeOffscreenWindow(width, height), width, height);
  window.window()->SetMultiSamples(0);
  const double middle = scene_.player->duration() / 2;
  window.show(middle);
  return perSecond(
      frames, window.window(), [&](int i) { window.show(middle + 0.5 * i); });
}

} // namespace pointmill
