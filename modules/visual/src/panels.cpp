// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "panels.h"

#include "cloud_extent.h"
#include "height_field.h"
#include "line_layer.h"
#include "ruler.h"
#include "splat.h"

#include <pointmill/common/watch.h>

#include <cmath>

namespace pointmill::visual {

namespace {

constexpr std::uint8_t kRapidStyle = kOperationCount + 1;
constexpr std::uint8_t kStockStyle = kOperationCount + 2;

/// Which colour of the palette an operation has.
int colourOf(const PreviewScene& scene, std::size_t i)
{
  const int own = scene.operations[i].colour;
  return (own >= 0 ? own : static_cast<int>(i)) % kOperationCount;
}

bool isAir(const PointCL& p)
{
  return p.getMotion() == Motion::Rapid || p.getMotion() == Motion::Retract;
}

bool isPlace(const PointCL& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Lines thinner than a pixel of the picture let dense passes shine through.
int lineWidth(const View& view, double subpixels)
{
  return std::max(1, static_cast<int>(std::lround(subpixels * view.lines)));
}

std::vector<LineLayer::Style> styles(float feed_alpha, float rapid_alpha)
{
  std::vector<LineLayer::Style> list;
  for (const Rgb& colour : kOperations)
    list.push_back({colour, feed_alpha, true});
  list.push_back({kRapid, rapid_alpha, false});
  list.push_back({kStockEdge, 0.9f, false});
  return list;
}

void drawStock(LineLayer& layer, const View& view)
{
  if (!view.has_stock)
    return;
  const Eigen::Vector3d corner[2] = {view.scene.stock.min, view.scene.stock.max};
  const auto at = [&](int x, int y, int z) {
    return view.camera.project(corner[x].x(), corner[y].y(), corner[z].z());
  };
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const int width = lineWidth(view, 3);
      layer.line(at(0, i, j), at(1, i, j), kStockStyle, 1.f, width);
      layer.line(at(i, 0, j), at(i, 1, j), kStockStyle, 1.f, width);
      layer.line(at(i, j, 0), at(i, j, 1), kStockStyle, 1.f, width);
    }
}

/// The moves in material, or those in the air.
void drawPath(LineLayer& layer,
              const View& view,
              const CLCloud& path,
              std::uint8_t style,
              bool air)
{
  const Eigen::Vector3f lamp =
      view.camera.toView(Eigen::Vector3d(-0.5, 0.5, 0.7).normalized());
  const auto mm = static_cast<float>(1.0 / view.camera.scale);
  const int feed_width = lineWidth(view, 3), rapid_width = lineWidth(view, 2);
  const float dash = static_cast<float>(5 * Frame::kSuper * view.lines);
  Eigen::Vector3f before = Eigen::Vector3f::Zero();
  bool known = false;
  for (const PointCL& p : path) {
    checkInterrupted();
    const bool place = isPlace(p);
    const Eigen::Vector3f now =
        place ? view.camera.project(p.x, p.y, p.z) : Eigen::Vector3f::Zero();
    if (place && known && isAir(p) == air) {
      if (air)
        layer.dashed(before, now, kRapidStyle, rapid_width, dash);
      else {
        // Lit like a hair, so that slopes show in dense passes.
        Eigen::Vector3f along = now - before;
        along.x() *= mm;
        along.y() *= -mm; // px run down
        const float length = along.norm();
        const float c = length > 0 ? along.dot(lamp) / length : 0.f;
        layer.line(before,
                   now,
                   style,
                   0.75f + 0.25f * std::sqrt(std::max(0.f, 1 - c * c)),
                   feed_width);
      }
    }
    before = now;
    known = place;
  }
}

Frame emptyFrame(const View& view)
{
  return {view.width, view.height};
}

float stepOf(const View& view)
{
  const std::optional<Grid>& grid = view.map ? view.map : view.milled;
  return grid ? static_cast<float>(
                    std::max(std::abs(grid->stepX()), std::abs(grid->stepY())))
              : 0.f;
}

} // namespace

Raster scanPanel(const View& view)
{
  Frame frame = emptyFrame(view);
  if (view.map) {
    FieldLook look;
    look.gap = Surface::Gap;
    if (!view.scene.scan)
      look.top = Surface::Scan;
    drawField(frame, view.camera, *view.map, look);
  }
  if (view.scene.scan)
    drawPoints(frame, view.camera, *view.scene.scan, Surface::Scan);
  Raster raster = shade(frame, view.camera, view.light);
  LineLayer layer(frame, 0.f);
  drawStock(layer, view);
  layer.copyTo(raster, raster, styles(1.f, 1.f));
  return raster;
}

Raster pathPanel(const View& view)
{
  Frame frame = emptyFrame(view);
  FieldLook look;
  look.top = look.raw = Surface::Faint;
  look.floor = view.floor;
  if (view.map)
    drawField(frame, view.camera, *view.map, look);
  else if (view.milled)
    drawField(frame, view.camera, *view.milled, look);
  else if (view.scene.scan)
    drawPoints(frame, view.camera, *view.scene.scan, Surface::Faint);
  Raster raster = shade(frame, view.camera, view.light);

  const float bias = std::max(
      1.6f * stepOf(view), 2.f * static_cast<float>(Frame::kSuper / view.camera.scale));
  LineLayer layer(frame, bias);
  const auto& operations = view.scene.operations;
  const Raster part = raster;
  // In machining order: what the last operation leaves is what matters most.
  for (std::size_t i = 0; i < operations.size(); ++i) {
    if (!operations[i].path)
      continue;
    const auto style = static_cast<std::uint8_t>(colourOf(view.scene, i) + 1);
    layer.clear();
    drawPath(layer, view, *operations[i].path, style, false);
    const float share = std::max(layer.coverage(style), 1e-3f);
    const bool last = i + 1 == operations.size();
    layer.copyTo(raster,
                 part,
                 styles(last ? 0.9f : std::clamp(0.25f / share, 0.55f, 0.85f), 1.f));
  }
  layer.clear();
  for (const auto& operation : operations)
    if (operation.path)
      drawPath(layer, view, *operation.path, kRapidStyle, true);
  // Many retracts must not hide what they come from.
  const float share = std::max(layer.coverage(kRapidStyle), 1e-3f);
  layer.copyTo(raster, part, styles(1.f, std::clamp(0.07f / share, 0.28f, 0.85f)));
  layer.clear();
  drawStock(layer, view);
  layer.copyTo(raster, part, styles(1.f, 1.f));
  return raster;
}

Raster milledPanel(const View& view)
{
  Frame frame = emptyFrame(view);
  if (!view.milled)
    return shade(frame, view.camera, view.light);
  FieldLook look;
  look.top = Surface::Machined;
  look.raw = Surface::RawStock;
  if (view.has_stock)
    look.raw_z = view.scene.stock.top() - 1e-3;
  look.floor = view.floor;
  drawField(frame, view.camera, *view.milled, look);
  Raster raster = shade(frame, view.camera, view.light);
  LineLayer layer(frame, 1.1f * stepOf(view));
  drawStock(layer, view);
  layer.copyTo(raster, raster, styles(1.f, 1.f));
  return raster;
}

Legend scanLegend(const View& view)
{
  Legend legend;
  if (view.scene.scan || view.map)
    legend.push_back({LegendItem::Mark::Heights,
                      kInk,
                      "height " + lowText(view.light) + " to " + highText(view.light)});
  if (view.has_gaps)
    legend.push_back({LegendItem::Mark::Hatched, kGap, "gap, not scanned: protected"});
  return legend;
}

Legend pathLegend(const View& view)
{
  Legend legend;
  for (std::size_t i = 0; i < view.scene.operations.size(); ++i)
    legend.push_back({LegendItem::Mark::Line,
                      kOperations[colourOf(view.scene, i)],
                      view.scene.operations[i].label});
  if (view.has_rapids)
    // First where not all fit, as it explains every operation.
    legend.insert(legend.size() >= 2 * kLegendRows ? legend.begin() : legend.end(),
                  {LegendItem::Mark::Dashed, kRapid, "rapid and retract"});
  return legend;
}

Legend milledLegend(const View& view)
{
  Legend legend;
  if (view.milled) {
    legend.push_back({LegendItem::Mark::Box, kMachined, "machined"});
    legend.push_back({LegendItem::Mark::Box, kRawStock, "raw stock"});
  }
  if (view.milled && view.has_stock) {
    const Eigen::Vector3d size = view.scene.stock.max - view.scene.stock.min;
    legend.push_back({LegendItem::Mark::Line,
                      kStockEdge,
                      "stock " + number(size.x()) + " x " + number(size.y()) + " x " +
                          number(size.z()) + " mm"});
  }
  return legend;
}

} // namespace pointmill::visual
