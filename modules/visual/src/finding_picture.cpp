// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "badge.h"
#include "canvas_png.h"
#include "finding_list.h"
#include "finding_map.h"
#include "section_panel.h"

#include <pointmill/common/error.h>
#include <pointmill/common/parameters.h>
#include <pointmill/visual/finding_picture.h>

#include <algorithm>

namespace pointmill {
namespace {

using namespace visual;

constexpr int kUnits = 200; ///< to the picture's width; all sizes follow
constexpr int kMargin = 3, kBetween = 2, kTitle = 8; ///< units
constexpr int kFirstRow = 78, kNextRow = 66;         ///< heights of cards [units]
constexpr int kCardUnits = 96; ///< to the width of a section alone
constexpr std::size_t kSections = 3;

bool hasPlace(const FindingMark& mark)
{
  return mark.place && mark.place->allFinite();
}

/// Whether two findings are of one cause at one place, so that one section shows both.
bool isSame(const FindingMark& a, const FindingMark& b, const std::vector<Tool>& tools)
{
  if (a.tool != b.tool)
    return false;
  constexpr double same = 1e-3, share = 0.25; // mm, of the tool's diameter
  const double apart = (*a.place - *b.place).norm();
  if (apart < same)
    return true;
  // The points as scanned lie beside those without noise.
  const auto isGouge = [](const FindingMark& m) {
    return m.code == "gouge" || m.code == "scan_gouge";
  };
  if (!(isGouge(a) && isGouge(b)) && (a.where.empty() || a.where != b.where))
    return false;
  return std::any_of(tools.begin(), tools.end(), [&](const Tool& tool) {
    return tool.number == a.tool && apart < share * tool.diameter;
  });
}

/// The findings that get a section, in their order: errors rather than warnings, then
/// the worst, each place once.
std::vector<std::size_t> worstOf(const FindingScene& scene)
{
  const std::vector<FindingMark>& findings = scene.findings;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < findings.size(); ++i)
    if (hasPlace(findings[i]))
      order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const FindingMark &m = findings[a], &n = findings[b];
    return m.warning != n.warning ? n.warning : m.worst > n.worst;
  });
  std::vector<std::size_t> chosen;
  for (const std::size_t i : order) {
    const bool known = std::any_of(chosen.begin(), chosen.end(), [&](std::size_t k) {
      return isSame(findings[k], findings[i], scene.tools);
    });
    if (!known && chosen.size() < kSections)
      chosen.push_back(i);
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::string counted(std::size_t count, const std::string& what)
{
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

struct Verdict {
  std::string text;
  Rgb ink, colour;
};

Verdict verdictOf(const std::vector<FindingMark>& findings)
{
  const auto warnings = static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(), [](const FindingMark& m) {
        return m.warning;
      }));
  const std::size_t errors = findings.size() - warnings;
  if (errors > 0)
    return {"REFUSED: " + counted(errors, "finding") +
                (warnings ? ", " + counted(warnings, "warning") : ""),
            kPage,
            kError};
  if (warnings > 0)
    return {"checked with " + counted(warnings, "warning"), kInk, kWarning};
  return {"checked, nothing found", kPage, hex(0x0072B2)};
}

/// Cards in two columns, row by row.
struct Cards {
  Cards(int width, int u) : unit(u), left(kMargin * u), y(kTitle * u)
  {
    card_width = (width - (2 * kMargin + kBetween) * unit) / 2;
    full_width = 2 * card_width + kBetween * unit;
  }
  /// The next card; the first of a row says how high it is.
  Rect next()
  {
    const int height = (count < 2 ? kFirstRow : kNextRow) * unit;
    const Rect card{
        left + count % 2 * (card_width + kBetween * unit), y, card_width, height};
    if (++count % 2 == 0)
      y += height + kBetween * unit;
    return card;
  }
  bool isRowOpen() const { return count % 2 == 1; }
  /// Room over the whole width, under all cards.
  Rect across(int height)
  {
    if (isRowOpen())
      next();
    const Rect row{left, y, full_width, height};
    y += height + kBetween * unit;
    return row;
  }

  int unit, left, y, card_width, full_width, count = 0;
};

void check(const FindingScene& scene, int width, const Range& range)
{
  checkRange("picture of the findings", "width", width, "px", range);
  for (const Tool& tool : scene.tools)
    tool.validate();
}

} // namespace

void writeFindings(const std::string& path, const FindingScene& scene, int width)
{
  check(scene, width, {1000, 3000});
  const int unit = width / kUnits;
  std::optional<Grid> milled;
  if (scene.milled)
    milled.emplace(*scene.milled, "the milled part");
  const std::vector<std::size_t> worst = worstOf(scene);
  std::vector<Section> sections;
  for (const std::size_t i : worst)
    sections.emplace_back(scene, milled, scene.findings[i]);

  // First where everything goes, as this says how high the picture is.
  Cards cards(width, unit);
  const bool has_map = scene.part || milled || !sections.empty();
  const Rect map = has_map ? cards.next() : Rect();
  std::vector<Rect> places;
  for (std::size_t i = 0; i < sections.size(); ++i)
    places.push_back(cards.next());
  const Key key = sectionKey(scene, sections, cards.full_width, unit);
  FindingList list(scene, cards.card_width, unit);
  const bool beside = cards.isRowOpen() &&
                      list.height() <= (cards.count < 2 ? kFirstRow : kNextRow) * unit;
  Rect list_place;
  if (beside)
    list_place = cards.next();
  else {
    list = FindingList(scene, cards.full_width, unit);
    list_place = cards.across(list.height());
  }
  const Rect key_place = sections.empty() ? Rect() : cards.across(key.height());

  Canvas canvas(width, cards.y + unit, kPage);
  const Verdict verdict = verdictOf(scene.findings);
  const int middle = kTitle * unit / 2;
  const int used = drawPill(canvas,
                            cards.left,
                            middle,
                            verdict.text,
                            {unit * 7 / 2, true, verdict.ink},
                            verdict.colour);
  const TextStyle title{3 * unit, false, kInk};
  drawText(canvas,
           cards.left + used + 2 * unit,
           middle,
           fitText(scene.title, cards.full_width - used - 2 * unit, title),
           title);
  if (has_map)
    drawFindingMap(canvas, map, scene, milled, sections, unit);
  for (std::size_t i = 0; i < sections.size(); ++i)
    drawSection(canvas, places[i], sections[i], worst[i] + 1, unit);
  list.draw(canvas, list_place);
  if (!sections.empty())
    key.draw(canvas, key_place.x, key_place.y);
  writePng(path, canvas);
}

bool writeSection(const std::string& path,
                  const FindingScene& scene,
                  std::size_t finding,
                  int width)
{
  check(scene, width, {500, 2000});
  if (finding >= scene.findings.size())
    throw ParameterError("picture of a finding: there is no finding " +
                         std::to_string(finding));
  if (!hasPlace(scene.findings[finding]))
    return false;
  std::optional<Grid> milled;
  if (scene.milled)
    milled.emplace(*scene.milled, "the milled part");
  std::vector<Section> sections;
  sections.emplace_back(scene, milled, scene.findings[finding]);
  const int unit = width / kCardUnits;
  const Key key = sectionKey(scene, sections, width - 2 * unit, unit);
  const int height = kNextRow * unit;
  Canvas canvas(width, height + key.height() + 2 * unit, kPage);
  drawSection(canvas, {0, 0, width, height}, sections.front(), finding + 1, unit);
  key.draw(canvas, unit, height + unit);
  writePng(path, canvas);
  return true;
}

} // namespace pointmill
