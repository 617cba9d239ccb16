// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "finding_list.h"

#include "badge.h"
#include "wrap.h"

#include <numeric>

namespace pointmill::visual {

namespace {

constexpr std::size_t kMost = 60; ///< entries; the report has them all
constexpr std::size_t kFew = 12;  ///< up to here texts have three lines, then one
constexpr int kPad = 2, kBadge = 4, kBetween = 4, kHead = 6; ///< units

} // namespace

FindingList::FindingList(const FindingScene& scene, int width, int unit)
    : unit_(unit), columns_(width > 120 * unit && scene.findings.size() > 1 ? 2 : 1),
      column_width_((width - (2 * kPad + (columns_ - 1) * kBetween) * unit) / columns_)
{
  const auto& all = scene.findings;
  const std::size_t shown = std::min(all.size(), kMost);
  const TextStyle style{2 * unit, false, kInk};
  for (std::size_t i = 0; i < shown; ++i) {
    const FindingMark& mark = all[i];
    entries_.push_back({i + 1,
                        mark.warning,
                        mark.code,
                        mark.where,
                        wrapText(mark.text,
                                 column_width_ - kBadge * unit,
                                 all.size() > kFew ? 1 : 3,
                                 style)});
  }
  left_out_ = all.size() - shown;
}

int FindingList::heightOf(const Entry& entry) const
{
  return (4 * unit_) + static_cast<int>(entry.text.size()) * (unit_ * 5 / 2);
}

std::size_t FindingList::split() const
{
  int all = 0;
  for (const auto& entry : entries_)
    all += heightOf(entry);
  std::size_t i = 0;
  for (int used = 0; columns_ > 1 && i < entries_.size() && 2 * used < all; ++i)
    used += heightOf(entries_[i]);
  return columns_ > 1 ? i : entries_.size();
}

int FindingList::height() const
{
  int first = 0, second = 0;
  for (std::size_t i = 0; i < entries_.size(); ++i)
    (i < split() ? first : second) += heightOf(entries_[i]);
  return (kHead + kPad) * unit_ + std::max(first, second) + (left_out_ ? 3 * unit_ : 0);
}

void FindingList::draw(Canvas& canvas, const Rect& card) const
{
  canvas.fillRound(card, static_cast<float>(unit_) * 1.5f, kCard);
  const int left = card.x + kPad * unit_, top = card.y + kHead * unit_;
  drawText(canvas, left, card.y + 3 * unit_, "findings", {unit_ * 5 / 2, true, kInk});
  const TextStyle code{2 * unit_, true, kInk}, text{2 * unit_, false, kInk},
      faint{2 * unit_, false, kFaintInk};
  int x = left, y = top;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry& entry = entries_[i];
    if (i == split()) {
      x += column_width_ + kBetween * unit_;
      y = top;
    }
    const int middle = y + unit_ * 3 / 2, beside = x + kBadge * unit_;
    drawBadge(canvas, x + unit_ * 3 / 2, middle, entry.number, entry.warning, unit_);
    const std::string where = fitText(entry.where, column_width_ / 2, faint);
    const int where_width = textWidth(where, faint);
    const int room = column_width_ - kBadge * unit_ - where_width - 2 * unit_;
    drawText(canvas, beside, middle, fitText(entry.code, room, code), code);
    drawText(canvas, x + column_width_ - where_width, middle, where, faint);
    int row = middle + unit_ * 11 / 4;
    for (const auto& line : entry.text) {
      drawText(canvas, beside, row, line, text);
      row += unit_ * 5 / 2;
    }
    y += heightOf(entry);
  }
  if (left_out_)
    drawText(canvas,
             left,
             card.bottom() - 3 * unit_,
             "and " + std::to_string(left_out_) + " more; the report lists them",
             faint);
}

} // namespace pointmill::visual
