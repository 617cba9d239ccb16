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
  for (std::size_t i = 0; i < scene_.clouds.size(); ++i)
    addCloud(scene_.clouds[i], i);
  // What is marked is seen through everything, from where the rest is seen.
  vtkNew<vtkRenderer> marks;
  marks->SetLayer(1);
  marks->InteractiveOff();
  marks->SetActiveCamera(renderer()->GetActiveCamera());
  window->SetNumberOfLayers(2);
  window->AddRenderer(marks);
  props_ = std::make_unique<SceneProps>(scene_, levels_, renderer(), marks, look_);
  props_->update(look_);
  addAxes();
  props_->aim(look_);
}

void SceneWindow::seek(double seconds)
{
  look_.time = std::clamp(seconds, 0.0, scene_.player->duration());
  scene_.player->seek(look_.time);
}

void SceneWindow::addCloud(const ViewedCloud& viewed, std::size_t number)
{
  using namespace pcl::visualization;
  using Cloud = pcl::PCLPointCloud2;
  using Colours = PointCloudColorHandler<Cloud>;
  const std::string id = std::to_string(number) + " " + viewed.name;
  const PointCloudGeometryHandler<Cloud>::ConstPtr places(
      new PointCloudGeometryHandlerXYZ<Cloud>(viewed.cloud));
  int count = 0;
  const auto add = [&](Colours* handler) {
    const Colours::ConstPtr colours(handler);
    if (!colours->isCapable())
      return false;
    visualizer_->addPointCloud(viewed.cloud,
                               places,
                               colours,
                               Eigen::Vector4f::Zero(),
                               Eigen::Quaternionf::Identity(),
                               id);
    ++count;
    return true;
  };
  // As pcl_viewer has them: key 1 is one colour for each cloud, 2, 3 ... its fields.
  const visual::Rgb& own = visual::kOperations[number % visual::kOperationCount];
  add(new PointCloudColorHandlerCustom<Cloud>(
      viewed.cloud, 255 * own.r, 255 * own.g, 255 * own.b));
  int heights = 0, measured = 0; // which of them are these
  for (const auto& field : viewed.cloud->fields) {
    const bool rgb = field.name == "rgb" || field.name == "rgba";
    const bool added =
        rgb ? add(new PointCloudColorHandlerRGBField<Cloud>(viewed.cloud))
        : field.name == "label"
            ? add(new PointCloudColorHandlerLabelField<Cloud>(viewed.cloud))
            : field.name != "_" && add(new PointCloudColorHandlerGenericField<Cloud>(
                                       viewed.cloud, field.name));
    if (added && field.name == "z")
      heights = count - 1;
    if (added && (rgb || (measured == 0 && field.name == "intensity")))
      measured = count - 1;
  }
  // What was measured beside the places is shown first; else the heights, of several
  // clouds each in its colour.
  const int first = measured > 0 ? measured : scene_.clouds.size() == 1 ? heights : 0;
  visualizer_->updateColorHandlerIndex(id, first);
  if (first == heights)
    visualizer_->setPointCloudRenderingProperties(
        PCL_VISUALIZER_LUT, PCL_VISUALIZER_LUT_VIRIDIS, id);
  visualizer_->setPointCloudRenderingProperties(
      PCL_VISUALIZER_LUT_RANGE, PCL_VISUALIZER_LUT_RANGE_AUTO, id);
  visualizer_->setPointCloudRenderingProperties(
      PCL_VISUALIZER_POINT_SIZE, look_.point_size, id);
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
