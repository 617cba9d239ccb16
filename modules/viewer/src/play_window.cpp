// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "play_window.h"

#include "playback.h"
#include "words.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSliderRepresentation2D.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace pointmill::viewer {

namespace {

constexpr int kTick = 40; // ms
constexpr int kSliderRoom = 46;

/// Calls a function of ours for an event of VTK's, as long as both are there.
class Observation {
public:
  Observation(vtkObject* object, unsigned long event, std::function<void()> body)
      : object_(object), body_(std::move(body))
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&body_);
    command->SetCallback([](vtkObject*, unsigned long, void* data, void*) {
      (*static_cast<std::function<void()>*>(data))();
    });
    tag_ = object_->AddObserver(event, command);
  }
  ~Observation() { object_->RemoveObserver(tag_); }
  Observation(const Observation&) = delete;
  Observation& operator=(const Observation&) = delete;

private:
  vtkSmartPointer<vtkObject> object_;
  std::function<void()> body_;
  unsigned long tag_;
};

} // namespace

bool PlayWindow::drawsInSoftware()
{
  const std::string what = view_.window()->ReportCapabilities();
  return what.find("llvmpipe") != std::string::npos ||
         what.find("softpipe") != std::string::npos;
}

void PlayWindow::redraw()
{
  if (has_slider_) {
    auto* bar =
        static_cast<vtkSliderRepresentation*>(slider_->GetRepresentation()); // NOLINT
    bar->SetValue(view_.look().time);
  }
  if (has_slider_)
    view_.look().playing = timer_.has_value();
  view_.props().update(view_.look(), has_slider_ ? kSliderRoom : 0);
  view_.window()->Render();
}

void PlayWindow::setPlaying(bool playing)
{
  vtkRenderWindowInteractor* interactor = view_.window()->GetInteractor();
  if (timer_)
    interactor->DestroyTimer(*timer_);
  timer_.reset();
  if (!playing)
    return;
  if (view_.look().time >= view_.scene().player->duration())
    view_.seek(0);
  last_tick_ = secondsNow();
  timer_ = interactor->CreateRepeatingTimer(kTick);
}

void PlayWindow::tick()
{
  if (!timer_)
    return;
  const double now = secondsNow();
  constexpr double longest = 0.25; // s; what a slow machine misses it does not make up
  view_.seek(view_.look().time +
             std::min(now - last_tick_, longest) * view_.look().speed);
  last_tick_ = now;
  if (view_.look().time >= view_.scene().player->duration())
    setPlaying(false);
  redraw();
}

void PlayWindow::addSlider()
{
  if (!view_.scene().player || view_.scene().player->program().moves.empty())
    return;
  vtkNew<vtkSliderRepresentation2D> bar;
  bar->SetMinimumValue(0);
  bar->SetMaximumValue(view_.scene().player->duration());
  bar->SetValue(view_.look().time);
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
  slider_->SetInteractor(view_.window()->GetInteractor());
  slider_->SetRepresentation(bar);
  slider_->SetAnimationModeToJump();
  slider_->EnabledOn();
  has_slider_ = true;
}

bool PlayWindow::onKey(const std::string& key, bool shift, bool control)
{
  if (control)
    return false;
  const bool used = changeLook(key, shift, view_.scene(), view_.levels(), view_.look());
  if (used && view_.scene().player && view_.look().time != view_.scene().player->time())
    view_.seek(view_.look().time);
  if (key == "space" && view_.scene().player && view_.scene().player->duration() > 0)
    setPlaying(!timer_);
  else if (key == "h" || key == "H") {
    helped_ = !helped_;
    view_.props().setHelp(helped_ ? Viewer::help() +
                                        "\nh            closes this; the other keys "
                                        "are on the terminal"
                                  : "");
    redraw();
    return !helped_; // PCL prints its own
  }
  else if (!used)
    return false;
  if (movesCamera(key))
    view_.props().aim(view_.look());
  redraw();
  return true;
}

double PlayWindow::sliderValue() const
{
  return static_cast<vtkSliderRepresentation*>( // NOLINT: of no other kind
             slider_->GetRepresentation())
      ->GetValue();
}

void PlayWindow::run(bool playing)
{
  if (drawsInSoftware())
    view_.window()->SetMultiSamples(0); // what is smooth is slow there
  view_.visualizer().createInteractor();
  view_.window()->SetWindowName(view_.scene().title.c_str());
  WindowStyle& style = view_.style();
  style.on_key = [this](const std::string& key, bool shift, bool control) {
    return onKey(key, shift, control);
  };
  style.on_tick = [this] { tick(); };
  addSlider();
  if (has_slider_)
    view_.props().setHint("space plays the cut    t paths    v surface    h all keys");
  else
    view_.props().setHint("h all keys");
  SceneProps& props = view_.props();
  const Observation moves(
      &style, vtkCommand::StartInteractionEvent, [&props] { props.setMoving(true); });
  const Observation rests(&style, vtkCommand::EndInteractionEvent, [this, &props] {
    props.setMoving(false);
    view_.window()->Render();
  });
  const Observation resized(
      view_.window(), vtkCommand::WindowResizeEvent, [&props] { props.layOut(); });
  const Observation dragged(slider_, vtkCommand::InteractionEvent, [this] {
    view_.seek(sliderValue());
    redraw();
  });
  redraw();
  if (playing && has_slider_)
    setPlaying(true);
  view_.window()->GetInteractor()->Start();
  style.on_key = {};
  style.on_tick = {};
}

} // namespace pointmill::viewer
