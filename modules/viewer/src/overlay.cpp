// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "overlay.h"

#include "words.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <sstream>

namespace pointmill::viewer {

namespace {

constexpr int kTitle = 20, kText = 15, kMargin = 16; // px, of a view 800 px high

/// Rectangles on the screen, each with colours for its lower and its upper edge.
class Boxes {
public:
  Boxes() { colours_->SetNumberOfComponents(3); }
  void add(double x,
           double y,
           double w,
           double h,
           const visual::Rgb& low,
           const visual::Rgb& high)
  {
    const vtkIdType corners[] = {points_->InsertNextPoint(x, y, 0),
                                 points_->InsertNextPoint(x + w, y, 0),
                                 points_->InsertNextPoint(x + w, y + h, 0),
                                 points_->InsertNextPoint(x, y + h, 0)};
    cells_->InsertNextCell(4, corners);
    for (const auto* c : {&low, &low, &high, &high})
      colours_->InsertNextTuple3(
          visual::toByte(c->r), visual::toByte(c->g), visual::toByte(c->b));
  }
  vtkSmartPointer<vtkActor2D> actor()
  {
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_);
    data->SetPolys(cells_);
    data->GetPointData()->SetScalars(colours_);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<vtkActor2D>::New();
    actor->SetMapper(mapper);
    return actor;
  }

private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkUnsignedCharArray> colours_;
};

/// VTK's fonts have no more, in this version, through this class.
std::string plain(const std::string& text)
{
  std::string out;
  for (const char c : text)
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) // one mark for a character
      out += static_cast<unsigned char>(c) < 0x80 ? c : '?';
  return out;
}

} // namespace

Overlay::Overlay(vtkRenderer* renderer, const visual::Rgb& background)
    : renderer_(renderer), ink_(inkOn(background)),
      faint_(isDark(background) ? visual::kRule : visual::kFaintInk),
      paper_(background), title_(text(kTitle, true)), moment_(text(kText, false)),
      hint_(text(kText, false)), help_(text(kText, false))
{
  vtkTextProperty* box = help_->GetTextProperty();
  box->SetFontFamilyToCourier();
  box->SetBackgroundColor(paper_.r, paper_.g, paper_.b);
  box->SetBackgroundOpacity(1.0);
  box->SetFrame(true);
  box->SetFrameColor(faint_.r, faint_.g, faint_.b);
  for (auto* actor : {title_.Get(), moment_.Get(), hint_.Get(), help_.Get()})
    renderer_->AddActor2D(actor);
}

vtkSmartPointer<vtkTextActor> Overlay::text(int size, bool bold)
{
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  vtkTextProperty* property = actor->GetTextProperty();
  property->SetFontFamilyToArial();
  property->SetFontSize(size);
  property->SetBold(bold);
  property->SetColor(ink_.r, ink_.g, ink_.b);
  property->SetLineSpacing(1.15);
  property->SetBackgroundColor(paper_.r, paper_.g, paper_.b); // lest lines cross it
  property->SetBackgroundOpacity(0.8);
  actor->SetInput("");
  return actor;
}

void Overlay::setMoment(const std::string& text, int room)
{
  moment_->SetInput(plain(text).c_str());
  room_ = room;
}

void Overlay::setHelp(const std::string& text)
{
  std::string lines; // with room to the frame
  std::istringstream in(plain(text));
  for (std::string line; std::getline(in, line);)
    lines += (lines.empty() ? " \n  " : "  \n  ") + line;
  help_->SetInput(lines.empty() ? "" : (lines + "  \n ").c_str());
}

void Overlay::place(vtkTextActor* actor, double x, double y, bool right)
{
  if (right)
    actor->GetTextProperty()->SetJustificationToRight();
  actor->SetPosition(x, y);
}

void Overlay::layOut()
{
  const int* size = renderer_->GetSize();
  const int width = size[0], height = size[1];
  const double scale = std::clamp(height / 800.0, 0.7, 3.0);
  const auto px = [&](int v) { return static_cast<int>(v * scale); };
  title_->GetTextProperty()->SetFontSize(px(kTitle));
  moment_->GetTextProperty()->SetFontSize(px(kText));
  hint_->GetTextProperty()->SetFontSize(px(kText));
  hint_->GetTextProperty()->SetColor(faint_.r, faint_.g, faint_.b);
  place(hint_, width - px(kMargin), px(kMargin) + room_, true);
  help_->GetTextProperty()->SetFontSize(px(kText));
  title_->GetTextProperty()->SetVerticalJustificationToTop();
  place(title_, px(kMargin), height - px(kMargin));
  place(moment_, px(kMargin), px(kMargin) + room_);
  double size_of_help[2] = {0, 0};
  help_->GetSize(renderer_, size_of_help);
  place(help_, (width - size_of_help[0]) / 2, (height - size_of_help[1]) / 2);
  const auto shown = [&](vtkTextActor* actor) {
    actor->SetVisibility(visible_ && actor->GetInput() && *actor->GetInput());
  };
  shown(title_);
  shown(moment_);
  shown(hint_);
  shown(help_);
  const std::array<int, 3> now = {width, height, visible_};
  if (now == drawn_for_)
    return;
  drawn_for_ = now;
  for (const auto& prop : legend_props_)
    renderer_->RemoveViewProp(prop);
  legend_props_.clear();
  if (visible_)
    drawLegends(width, height, scale);
}

void Overlay::drawLegends(int width, int height, double scale)
{
  const double line = 24 * scale, swatch = 14 * scale, margin = kMargin * scale;
  const double left_of_text = 8 * scale;
  double y = height - margin;
  Boxes boxes;
  const auto write = [&](const std::string& words, double x, double at, bool bold) {
    auto actor = text(static_cast<int>(kText * scale), bold);
    actor->SetInput(plain(words).c_str());
    actor->GetTextProperty()->SetVerticalJustificationToCentered();
    place(actor, x, at, true);
    renderer_->AddActor2D(actor);
    legend_props_.emplace_back(actor);
  };
  const double right = width - margin;
  for (const Legend& legend : legends_) {
    y -= line / 2;
    write(legend.title, right, y, true);
    y -= line;
    const double top = y;
    for (auto entry = legend.bar ? legend.entries.end() - 1 : legend.entries.begin();
         !legend.entries.empty();) {
      write(entry->text, right - swatch - left_of_text, y, false);
      if (!legend.bar)
        boxes.add(right - swatch,
                  y - swatch / 2,
                  swatch,
                  swatch,
                  entry->colour,
                  entry->colour);
      y -= line;
      if (legend.bar ? entry == legend.entries.begin()
                     : entry == legend.entries.end() - 1)
        break;
      legend.bar ? --entry : ++entry;
    }
    if (legend.bar)
      for (std::size_t i = 0; i + 1 < legend.entries.size(); ++i)
        boxes.add(right - swatch,
                  top - line * static_cast<double>(legend.entries.size() - 1 - i),
                  swatch,
                  line,
                  legend.entries[i].colour,
                  legend.entries[i + 1].colour);
    y -= line / 2;
  }
  auto actor = boxes.actor();
  renderer_->AddActor2D(actor);
  legend_props_.emplace_back(actor);
}

} // namespace pointmill::viewer
