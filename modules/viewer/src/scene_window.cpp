// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "scene_window.h"

#include "words.h"

#include <vtkAxesActor.h>
#include <vtkCaptionActor2D.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkRendererCollection.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>

namespace pointmill::viewer {

using pcl::visualization::PCLVisualizer;

namespace {

constexpr int kSamples = 8; // of a pixel, against jagged edges

} // namespace

SceneWindow::SceneWindow(const ViewerScene& scene,
                         const std::vector<double>& levels,
                         const ViewerLook& look,
                         const vtkSmartPointer<vtkRenderWindow>& window,
                         int width,
                         int height)
    : scene_(scene), levels_(levels), look_(look),
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

void SceneWindow::seek(double seconds)
{
  look_.time = std::clamp(seconds, 0.0, scene_.player->duration());
  scene_.player->seek(look_.time);
}

void SceneWindow::addCloud(const ViewedCloud& viewed)
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
  // As pcl_viewer has them: keys 1, 2, 3 ... choose one. What a scanner measured beside
  // the places is shown first.
  add(new PointCloudColorHandlerGenericField<pcl::PCLPointCloud2>(viewed.cloud, "z"));
  int count = 1, first = 0;
  for (const auto& field : viewed.cloud->fields) {
    if (field.name == "z" || field.name == "_")
      continue;
    const bool rgb = field.name == "rgb" || field.name == "rgba";
    if (rgb)
      add(new PointCloudColorHandlerRGBField<pcl::PCLPointCloud2>(viewed.cloud));
    else if (field.name == "label")
      add(new PointCloudColorHandlerLabelField<pcl::PCLPointCloud2>(viewed.cloud));
    else
      add(new PointCloudColorHandlerGenericField<pcl::PCLPointCloud2>(viewed.cloud,
                                                                      field.name));
    if (rgb || (field.name == "intensity" && first == 0))
      first = count;
    ++count;
  }
  visualizer_->updateColorHandlerIndex(viewed.name, first);
  if (first == 0) // else the fields' own colours are kept
    visualizer_->setPointCloudRenderingProperties(
        PCL_VISUALIZER_LUT, PCL_VISUALIZER_LUT_VIRIDIS, viewed.name);
  visualizer_->setPointCloudRenderingProperties(
      PCL_VISUALIZER_POINT_SIZE, look_.point_size, viewed.name);
}

void SceneWindow::addAxes()
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

} // namespace pointmill::viewer
