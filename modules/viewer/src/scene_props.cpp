// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "scene_props.h"

#include "aim.h"
#include "path_lines.h"
#include "scene_texts.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include <algorithm>
#include <cmath>

namespace pointmill::viewer {

namespace {

/// While the view moves, no more points than these are drawn of the paths, and of the
/// part.
constexpr vtkIdType kMovingPath = 60'000, kMovingPart = 60'000;
constexpr double kDash = 1.0 / 120;
/// What the tool did in the last so many seconds is its trail.
constexpr double kTrailSeconds = 20;
constexpr std::size_t kTrailMoves = 4000;

vtkNew<vtkPolyDataMapper> mapperOf(vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  return mapper;
}

vtkIdType pointsOf(vtkActor* actor)
{
  return actor->GetMapper()->GetInputAsDataSet()->GetNumberOfPoints();
}

bool hasVolume(const Stock& stock)
{
  return ((stock.max - stock.min).array() > 0).all();
}

} // namespace

SceneProps::SceneProps(const ViewerScene& scene,
                       const std::vector<double>& levels,
                       vtkRenderer* renderer,
                       vtkRenderer* marks,
                       const ViewerLook& look)
    : scene_(scene), levels_(levels), renderer_(renderer), marks_renderer_(marks),
      overlay_(marks, look.background)
{
  const auto extend = [](Eigen::AlignedBox3d& box, const auto& cloud) {
    for (const auto& p : cloud)
      if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
        box.extend(Eigen::Vector3d(p.x, p.y, p.z));
  };
  double clouds[6]; // which are there already
  renderer_->ComputeVisiblePropBounds(clouds);
  if (clouds[0] <= clouds[1]) {
    box_.extend(Eigen::Vector3d(clouds[0], clouds[2], clouds[4]));
    box_.extend(Eigen::Vector3d(clouds[1], clouds[3], clouds[5]));
  }
  if (hasVolume(scene.stock)) {
    box_.extend(scene.stock.min);
    box_.extend(scene.stock.max);
  }
  if (scene.part)
    extend(box_, *scene.part);
  if (box_.isEmpty() && scene.map)
    extend(box_, *scene.map);
  box_with_paths_ = box_;
  if (scene.path)
    extend(box_with_paths_, *scene.path);
  if (box_.isEmpty())
    box_ = box_with_paths_;
  if (!box_.isEmpty())
    diagonal_ = std::max(box_.diagonal().norm(), 1e-3);
  if (scene.deviation)
    deviation_scale_ = deviationScaleOf(*scene.deviation, scene.tolerance);
}

void SceneProps::update(const ViewerLook& look, int room)
{
  showSolid(look);
  showPaths(look);
  showTrail(look);
  showTool(look);
  showLevel(look);
  showFindings(look);
  showTexts(look, room);
}

void SceneProps::showSolid(const ViewerLook& look)
{
  // The map stands in its place: each would hide half of the other.
  const ViewedSolid solid =
      look.map && scene_.map && look.level ? ViewedSolid::None : look.solid;
  const bool stock = solid == ViewedSolid::Stock && scene_.player;
  if (stock) {
    if (!stock_) {
      stock_.emplace(scene_.player->stock(), scene_.sections);
      renderer_->AddActor(stock_->actor());
    }
    if (stock_time_ != scene_.player->time())
      stock_->update(*scene_.player);
    stock_time_ = scene_.player->time();
  }
  if (stock_) {
    stock_->actor()->SetVisibility(stock);
    // A finding may be at the foot of a wall, or inside.
    stock_->actor()->GetProperty()->SetOpacity(look.finding ? 0.45 : 1.0);
  }

  part_.visible = solid == ViewedSolid::Part && scene_.part;
  if (part_.visible && !part_.full)
    part_ = dots(scene_.part->size(), [&](std::size_t stride) {
      return partPoints(*scene_.part, scene_.map.get(), stride);
    });
  deviation_.visible = solid == ViewedSolid::Deviation && scene_.deviation;
  if (deviation_.visible && !deviation_.full)
    deviation_ = dots(scene_.deviation->size(), [&](std::size_t stride) {
      return deviationPoints(
          *scene_.deviation, scene_.map.get(), deviation_scale_, stride);
    });
  for (auto* actor : {part_.full.Get(),
                      part_.coarse.Get(),
                      deviation_.full.Get(),
                      deviation_.coarse.Get()})
    if (actor)
      actor->GetProperty()->SetPointSize(static_cast<float>(look.point_size));
  setMoving(moving_);
  if (!edges_ && hasVolume(scene_.stock)) {
    edges_ = stockEdges(scene_.stock);
    renderer_->AddActor(edges_);
  }
  if (edges_)
    edges_->SetVisibility(look.box);
}

SceneProps::Detailed SceneProps::dots(
    std::size_t points,
    const std::function<vtkSmartPointer<vtkActor>(std::size_t stride)>& make)
{
  Detailed made;
  made.visible = true;
  made.full = made.coarse = make(1);
  if (points > kMovingPart)
    made.coarse = make(points / kMovingPart + 1);
  renderer_->AddActor(made.full);
  renderer_->AddActor(made.coarse);
  return made;
}

void SceneProps::showPaths(const ViewerLook& look)
{
  const bool shown = scene_.path && (look.paths == ViewedPaths::All ||
                                     look.paths == ViewedPaths::Level);
  paths_.visible = shown;
  setMoving(moving_);
  if (rapids_)
    rapids_->SetVisibility(shown && look.rapids);
  if (!shown)
    return;
  if (paths_.full && paths_shown_ == look.paths && paths_colouring_ == look.colouring &&
      (look.paths == ViewedPaths::All || paths_level_ == look.level))
    return;
  paths_shown_ = look.paths;
  paths_colouring_ = look.colouring;
  paths_level_ = look.level;
  PathFilter filter = [](const PointCL&, std::size_t) { return true; };
  if (look.paths == ViewedPaths::Level && look.level && *look.level < levels_.size()) {
    constexpr double little = 1e-3; // mm
    const double low = levels_[*look.level] - little;
    const double high =
        *look.level > 0 ? levels_[*look.level - 1] - little : scene_.stock.top() + 1e6;
    filter = [low, high](const PointCL& p, std::size_t) {
      return p.z >= low && p.z < high;
    };
  }
  for (auto* old : {paths_.full.Get(), paths_.coarse.Get(), rapids_.Get()})
    if (old)
      renderer_->RemoveActor(old);
  const PathColours colours(scene_, look.colouring);
  const auto lines = [&](double coarse) {
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapperOf(feedLines(scene_, colours, filter, coarse)));
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetLineWidth(1.2f);
    renderer_->AddActor(actor);
    return actor;
  };
  paths_.full = paths_.coarse = lines(0);
  for (double coarse = diagonal_ / 1000; pointsOf(paths_.coarse) > kMovingPath;
       coarse *= 2) {
    if (paths_.coarse != paths_.full)
      renderer_->RemoveActor(paths_.coarse);
    paths_.coarse = lines(coarse);
    if (coarse > diagonal_)
      break; // strips of two points each are all there is
  }
  setMoving(moving_);

  rapids_ = vtkSmartPointer<vtkActor>::New();
  rapids_->SetMapper(mapperOf(rapidDashes(scene_, filter, kDash * diagonal_)));
  const visual::Rgb& ink = visual::kFaintInk;
  rapids_->GetProperty()->SetColor(ink.r, ink.g, ink.b);
  rapids_->GetProperty()->LightingOff();
  rapids_->GetProperty()->SetLineWidth(1.f);
  rapids_->SetVisibility(look.rapids);
  renderer_->AddActor(rapids_);
}

void SceneProps::setMoving(bool moving)
{
  moving_ = moving;
  for (const Detailed* shown : {&paths_, &part_, &deviation_}) {
    if (!shown->full)
      continue;
    const bool two = shown->coarse != shown->full;
    shown->full->SetVisibility(shown->visible && !(moving && two));
    if (two)
      shown->coarse->SetVisibility(shown->visible && moving);
  }
}

void SceneProps::showTrail(const ViewerLook& look)
{
  if (trail_)
    renderer_->RemoveActor(trail_);
  trail_ = nullptr;
  if (look.paths != ViewedPaths::Trail || !scene_.player ||
      scene_.player->program().moves.empty())
    return;
  const CutPlayer& player = *scene_.player;
  const std::size_t last = player.move();
  std::size_t first = last;
  const double since = player.time() - kTrailSeconds * std::max(1.0, look.speed / 20);
  while (first > 0 && last - first < kTrailMoves && player.beginOf(first) > since)
    --first;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const auto& moves = player.program().moves;
  for (std::size_t m = first; m <= last; ++m) {
    const Eigen::Vector3d& a = moves[m].from;
    const Eigen::Vector3d b = m == last ? player.tip() : moves[m].to;
    if (!a.allFinite() || !b.allFinite() || moves[m].rapid)
      continue;
    const vtkIdType ends[] = {points->InsertNextPoint(a.data()),
                              points->InsertNextPoint(b.data())};
    lines->InsertNextCell(2, ends);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  trail_ = vtkSmartPointer<vtkActor>::New();
  trail_->SetMapper(mapperOf(data));
  const visual::Rgb colour = visual::hex(0xD55E00);
  trail_->GetProperty()->SetColor(colour.r, colour.g, colour.b);
  trail_->GetProperty()->LightingOff();
  trail_->GetProperty()->SetLineWidth(2.f);
  renderer_->AddActor(trail_);
}

void SceneProps::showTool(const ViewerLook& look)
{
  for (auto& [number, prop] : tools_)
    prop->SetVisibility(false);
  if (!look.tool || !scene_.player || !scene_.player->tool())
    return;
  const Tool& tool = *scene_.player->tool();
  const Eigen::Vector3d tip = scene_.player->tip();
  if (!tip.allFinite())
    return;
  auto& prop = tools_[tool.number];
  if (!prop) {
    prop = toolShape(tool);
    renderer_->AddViewProp(prop);
  }
  prop->SetPosition(tip.x(), tip.y(), tip.z());
  prop->SetVisibility(true);
}

void SceneProps::showLevel(const ViewerLook& look)
{
  const bool shown =
      look.map && scene_.map && look.level && *look.level < levels_.size();
  if (shown && sheet_level_ != look.level) {
    if (sheet_)
      renderer_->RemoveActor(sheet_);
    sheet_ = levelSheet(*scene_.map, levels_[*look.level]);
    sheet_level_ = look.level;
    renderer_->AddActor(sheet_);
  }
  if (sheet_)
    sheet_->SetVisibility(shown);
}

void SceneProps::showFindings(const ViewerLook& look)
{
  if (!marks_.empty() && marked_ == look.finding)
    return;
  marked_ = look.finding;
  for (auto& mark : marks_)
    marks_renderer_->RemoveViewProp(mark);
  marks_.clear();
  for (std::size_t i = 0; i < scene_.findings.size(); ++i) {
    const ViewedFinding& finding = scene_.findings[i];
    if (!finding.place)
      continue;
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(finding.place->data());
    ball->SetRadius(diagonal_ * (look.finding == i ? 0.006 : 0.004));
    ball->SetThetaResolution(24);
    ball->SetPhiResolution(16);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    const visual::Rgb colour =
        finding.error ? visual::hex(0xB2182B) : visual::hex(0xE69F00);
    actor->GetProperty()->SetColor(colour.r, colour.g, colour.b);
    actor->GetProperty()->SetAmbient(0.5);
    marks_renderer_->AddActor(actor);
    marks_.emplace_back(actor);
  }
}

void SceneProps::showTexts(const ViewerLook& look, int room)
{
  overlay_.setVisible(look.texts);
  overlay_.setTitle(scene_.title);
  overlay_.setMoment(momentText(scene_, levels_, look), room);
  if (!legends_of_ || !sameLegends(*legends_of_, look)) // they look at every point
    overlay_.setLegends(legendsOf(scene_, look, deviation_scale_));
  legends_of_ = look;
  overlay_.layOut();
}

void SceneProps::aim(const ViewerLook& look)
{
  const bool paths = look.paths == ViewedPaths::All || look.paths == ViewedPaths::Level;
  lookFrom(look.from, paths ? box_with_paths_ : box_, look.texts, renderer_);
  if (look.finding && *look.finding < scene_.findings.size() &&
      scene_.findings[*look.finding].place)
    lookAt(*scene_.findings[*look.finding].place, 0.5 * diagonal_, renderer_);
}

} // namespace pointmill::viewer
