// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "cloud_extent.h"
#include "panels.h"

#include <pointmill/common/error.h>

#include <algorithm>
#include <cmath>

namespace pointmill::visual {

namespace {

void add(std::vector<Eigen::AlignedBox3d>& boxes, const Eigen::AlignedBox3d& box)
{
  if (!box.isEmpty())
    boxes.push_back(box);
}

} // namespace

View::View(const PreviewScene& s) : scene(s)
{
  has_stock = ((s.stock.max - s.stock.min).array() > 0).all();
  if (has_stock)
    boxes.emplace_back(s.stock.min, s.stock.max);
  if (s.map) {
    map.emplace(*s.map, "the preview's occupancy map");
    add(boxes, map->box());
    has_gaps = std::any_of(s.map->begin(), s.map->end(), [](const PointCell& cell) {
      return cell.getState() == CellState::Gap && std::isfinite(cell.z);
    });
  }
  if (s.milled) {
    milled.emplace(*s.milled, "the preview's milled part");
    add(boxes, milled->box());
  }
  if (s.scan)
    add(boxes, boxOf(*s.scan));
  if (boxes.empty())
    for (const auto& operation : s.operations)
      if (operation.path)
        add(boxes, boxOf(*operation.path));
  if (boxes.empty())
    throw DataError("the preview has nothing to show: no scan, map, stock or path");

  Eigen::AlignedBox3d solid;
  for (const auto& box : boxes)
    solid.extend(box);
  floor = has_stock ? s.stock.min.z() : solid.min().z();
  light.reach = 0.09 * solid.sizes().head<2>().norm();
  light.low = solid.min().z();
  light.high = solid.max().z();
  if (s.scan)
    heightRange(*s.scan, light);
  else if (s.map)
    heightRange(*s.map, light);

  for (const auto& operation : s.operations) {
    if (!operation.path)
      continue;
    add(boxes, boxOf(*operation.path));
    const CLCloud& path = *operation.path;
    for (std::size_t i = 1; i < path.size() && !has_rapids; ++i)
      has_rapids = path[i].getMotion() == Motion::Rapid ||
                   path[i].getMotion() == Motion::Retract;
  }
}

void View::aim(int picture_width, int picture_height, double line_scale)
{
  width = picture_width;
  height = picture_height;
  lines = line_scale;
  const double w = width * Frame::kSuper, h = height * Frame::kSuper;
  const double margin = 0.025 * std::min(w, h);
  camera = fitCamera(boxes, w - 2 * margin, h - 2 * margin);
  camera.middle_x = w / 2;
  camera.middle_y = h / 2;
}

} // namespace pointmill::visual
