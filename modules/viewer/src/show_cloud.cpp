// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/common/point_types.h>
#include <pointmill/viewer/show_cloud.h>

#include <pcl/common/io.h>
#include <pcl/conversions.h>
#include <pcl/visualization/pcl_visualizer.h>

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkLogger.h>
#include <vtkPNGWriter.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace pointmill {
namespace {

using Cloud = pcl::PCLPointCloud2;
using ByField = pcl::visualization::PointCloudColorHandlerGenericField<Cloud>;
using Places = pcl::visualization::PointCloudGeometryHandlerXYZ<Cloud>;

/// Of Okabe and Ito, which people with any colour vision tell apart.
constexpr std::array<std::array<int, 3>, 5> kPalette = {
    {{0, 114, 178}, {230, 159, 0}, {86, 180, 233}, {204, 121, 167}, {0, 158, 115}}};

bool has(const Cloud& cloud, const std::string& field)
{
  return pcl::getFieldIndex(cloud, field) >= 0;
}

bool isRapid(const PointCL& p)
{
  return p.getMotion() == Motion::Rapid || p.getMotion() == Motion::Retract;
}

/// The way from each point to the next of its pass, or of the whole path where it is
/// linked.
vtkSmartPointer<vtkPolyData> linesOf(const CLCloud& path)
{
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const auto lines = vtkSmartPointer<vtkCellArray>::New();
  const auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colours->SetNumberOfComponents(3);
  const bool levels = path.front().level != path.back().level;
  const bool linked = std::any_of(path.begin(), path.end(), isRapid);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const PointCL& p = path[i];
    points->InsertNextPoint(p.x, p.y, p.z);
    if (i == 0 || (!linked && p.label != path[i - 1].label))
      continue;
    const auto end = static_cast<vtkIdType>(i);
    const vtkIdType ends[] = {end - 1, end};
    lines->InsertNextCell(2, ends);
    const auto& c = kPalette[(levels ? p.level : p.label) % kPalette.size()];
    if (isRapid(p))
      colours->InsertNextTuple3(200, 200, 200);
    else
      colours->InsertNextTuple3(c[0], c[1], c[2]);
  }
  auto shape = vtkSmartPointer<vtkPolyData>::New();
  shape->SetPoints(points);
  shape->SetLines(lines);
  shape->GetCellData()->SetScalars(colours);
  return shape;
}

void addPoints(pcl::visualization::PCLVisualizer& viewer,
               const Cloud::ConstPtr& cloud,
               double size)
{
  const Places::ConstPtr places(new Places(cloud));
  // Heights first, which pcl_viewer puts last.
  std::vector<std::string> names{"z"};
  for (const auto& field : cloud->fields)
    if (field.name != "z" && field.name != "_")
      names.push_back(field.name);
  for (const auto& name : names)
    viewer.addPointCloud(cloud,
                         places,
                         ByField::ConstPtr(new ByField(cloud, name)),
                         Eigen::Vector4f::Zero(),
                         Eigen::Quaternionf::Identity(),
                         "cloud");
  viewer.setPointCloudRenderingProperties(
      pcl::visualization::PCL_VISUALIZER_POINT_SIZE, size, "cloud");
}

/// From the front, left and above, as the preview is.
void aim(pcl::visualization::PCLVisualizer& viewer)
{
  viewer.setCameraPosition(-0.5, -0.8, 0.9, 0, 0, 0, 0, 0, 1);
  viewer.resetCamera();
  viewer.getRendererCollection()->GetFirstRenderer()->GetActiveCamera()->Zoom(1.2);
}

/// Never half a picture, and none where it fails.
void savePng(pcl::visualization::PCLVisualizer& viewer, const std::string& path)
{
  const std::string partial = path + ".partial";
  const auto picture = vtkSmartPointer<vtkWindowToImageFilter>::New();
  picture->SetInput(viewer.getRenderWindow());
  picture->ReadFrontBufferOff();
  const auto writer = vtkSmartPointer<vtkPNGWriter>::New();
  writer->SetFileName(partial.c_str());
  writer->SetInputConnection(picture->GetOutputPort());
  writer->Write();
  std::error_code failure;
  std::filesystem::rename(partial, path, failure);
  if (!failure)
    return;
  std::error_code ignored; // it may not be there
  std::filesystem::remove(partial, ignored);
  throw DataError(path + ": cannot be written");
}

} // namespace

void showCloud(const std::string& title, const Cloud& cloud, const CloudView& view)
{
  for (const char* field : {"x", "y", "z"})
    if (!has(cloud, field))
      throw DataError(title + ": the cloud has no field '" + field + "'");
  if (cloud.width * cloud.height == 0)
    throw DataError(title + ": the cloud is empty");
  if (!std::getenv("DISPLAY")) // VTK would end the program
    throw DataError("there is no display to show a cloud on; xvfb-run lends one");
  vtkLogger::SetStderrVerbosity(
      vtkLogger::VERBOSITY_OFF); // PCL uses what is deprecated
  pcl::visualization::PCLVisualizer viewer(title, view.window);
  if (!view.window)
    viewer.getRenderWindow()->SetOffScreenRendering(1);
  viewer.setSize(1200, 900);
  viewer.setBackgroundColor(view.background[0], view.background[1], view.background[2]);
  addPoints(viewer, Cloud::ConstPtr(new Cloud(cloud)), view.point_size);
  if (has(cloud, "motion")) {
    CLCloud path;
    pcl::fromPCLPointCloud2(cloud, path);
    viewer.addModelFromPolyData(linesOf(path), "path");
    viewer.setShapeRenderingProperties(
        pcl::visualization::PCL_VISUALIZER_LINE_WIDTH, 2.0, "path");
  }
  if (view.axes > 0)
    viewer.addCoordinateSystem(view.axes, "axes");
  aim(viewer);
  viewer.setShowFPS(view.window);
  if (!view.png.empty())
    savePng(viewer, view.png);
  if (view.window)
    viewer.spin();
}

} // namespace pointmill
