// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/common/parallel.h>
#include <pointmill/common/watch.h>
#include <pointmill/viewer/cut_player.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pointmill {

namespace {

constexpr int kRowsPerBand = 16;
/// So few are cut sooner than threads are started for them.
constexpr std::size_t kFewSweeps = 16;
/// What takes less, as rounding and overlapping passes do, did not cut the cell [mm].
constexpr float kRounding = 5e-3f;

} // namespace

CutPlayer::CutPlayer(StockField stock,
                     std::shared_ptr<const Program> program,
                     std::vector<double> ends,
                     std::vector<Tool> tools,
                     unsigned threads)
    : program_(std::move(program)), ends_(std::move(ends)), tools_(std::move(tools)),
      threads_(threads), stride_(0), state_{std::move(stock), {}, {}, {}, 0, 0.0}
{
  if (ends_.size() != program_->moves.size())
    throw DataError("the times are not those of the program's moves: " +
                    std::to_string(ends_.size()) + " for " +
                    std::to_string(program_->moves.size()));
  for (const Tool& tool : tools_)
    cutters_.try_emplace(tool.number, tool);
  const std::size_t cells =
      static_cast<std::size_t>(state_.stock.columns()) * state_.stock.rows();
  state_.cut_by.assign(cells, kUncut);
  state_.touched_by.assign(cells, kUncut);
  state_.taken.assign(cells, 0.f);
  stride_ = std::max<std::size_t>(1, (program_->moves.size() + kStates - 1) / kStates);
  kept_.push_back(state_);
}

void CutPlayer::seek(double seconds)
{
  time_ = std::clamp(seconds, 0.0, duration());
  if (ends_.empty())
    return;
  try {
    goTo(move(), shareAt(time_));
  }
  catch (...) { // a field that is cut in part is none
    state_ = kept_.front();
    time_ = 0;
    throw;
  }
}

void CutPlayer::goTo(std::size_t target, double share)
{
  const bool back =
      target < state_.move || (target == state_.move && share < state_.share);
  const std::size_t kept = std::min(target / stride_, kept_.size() - 1);
  if (back || kept > state_.move / stride_)
    state_ = kept_[kept];
  const WorkStep step("cutting the stock", {0.0, 1.0});
  const std::size_t first = state_.move;
  while (true) {
    const std::size_t next = (state_.move / stride_ + 1) * stride_;
    if (next > target)
      break;
    step.reach(double(state_.move - first) / double(target - first));
    forwardTo(next, 0.0);
    if (kept_.size() == next / stride_)
      kept_.push_back(state_);
  }
  forwardTo(target, share);
}

std::size_t CutPlayer::move() const
{
  if (ends_.empty())
    return 0;
  const auto end = std::lower_bound(ends_.begin(), ends_.end(), time_);
  return std::min<std::size_t>(end - ends_.begin(), ends_.size() - 1);
}

std::size_t CutPlayer::moveOfLine(std::size_t line) const
{
  const auto& moves = program_->moves;
  const auto at = std::lower_bound(
      moves.begin(), moves.end(), line, [](const ProgramMove& m, std::size_t l) {
        return m.line < l;
      });
  return std::min<std::size_t>(at - moves.begin(),
                               moves.empty() ? 0 : moves.size() - 1);
}

double CutPlayer::nearestInLine(std::size_t line, const Eigen::Vector3d& place) const
{
  const auto& moves = program_->moves;
  double best = moves.empty() ? 0.0 : ends_[moveOfLine(line)];
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t m = moveOfLine(line); m < moves.size() && moves[m].line == line;
       ++m) {
    const Eigen::Vector3d a = moves[m].from, way = moves[m].to - a;
    if (!way.allFinite() || !a.allFinite())
      continue;
    const double length2 = way.squaredNorm();
    const double share =
        length2 > 0 ? std::clamp((place - a).dot(way) / length2, 0.0, 1.0) : 1.0;
    const double distance = (a + share * way - place).norm();
    if (distance < nearest) {
      nearest = distance;
      best = beginOf(m) + share * (ends_[m] - beginOf(m));
    }
  }
  return best;
}

std::size_t CutPlayer::sectionOf(std::size_t move) const
{
  const auto& sections = program_->sections;
  const auto next = std::upper_bound(
      sections.begin(),
      sections.end(),
      move,
      [](std::size_t m, const ProgramSection& s) { return m < s.move; });
  return next == sections.begin() ? 0 : next - sections.begin() - 1;
}

Eigen::Vector3d CutPlayer::placeOn(std::size_t move, double share) const
{
  const ProgramMove& m = program_->moves[move];
  Eigen::Vector3d place;
  for (int i = 0; i < 3; ++i) // what is known of only one end counts on all the way
    place[i] = std::isfinite(m.from[i]) && std::isfinite(m.to[i])
                   ? m.from[i] + share * (m.to[i] - m.from[i])
               : std::isfinite(m.to[i]) ? m.to[i]
                                        : std::numeric_limits<double>::quiet_NaN();
  return place;
}

double CutPlayer::shareAt(double seconds) const
{
  const double begin = beginOf(move()), end = endOf(move());
  return end > begin ? std::clamp((seconds - begin) / (end - begin), 0.0, 1.0) : 1.0;
}

Eigen::Vector3d CutPlayer::tip() const
{
  if (ends_.empty())
    return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  return placeOn(move(), shareAt(time_));
}

const Tool* CutPlayer::tool() const
{
  if (ends_.empty())
    return nullptr;
  const int number = program_->moves[move()].tool;
  const auto at = std::find_if(tools_.begin(), tools_.end(), [&](const Tool& tool) {
    return tool.number == number;
  });
  return at == tools_.end() ? nullptr : &*at;
}

void CutPlayer::forwardTo(std::size_t move, double share)
{
  std::vector<Sweep> sweeps;
  const auto add = [&](std::size_t m, double from, double to) {
    const auto cutter = cutters_.find(program_->moves[m].tool);
    const Eigen::Vector3d a = placeOn(m, from), b = placeOn(m, to);
    if (from < to && cutter != cutters_.end() && a.allFinite() && b.allFinite() &&
        std::min(a.z(), b.z()) < state_.stock.stock().top())
      sweeps.push_back(
          {a,
           b,
           &cutter->second,
           static_cast<std::uint8_t>(std::min<std::size_t>(sectionOf(m), kUncut - 1))});
  };
  if (state_.move < move) {
    add(state_.move, state_.share, 1.0);
    for (std::size_t m = state_.move + 1; m < move; ++m)
      add(m, 0.0, 1.0);
    state_.share = 0.0;
  }
  if (move < program_->moves.size() && share > 0.0)
    add(move, state_.share, share);
  cut(sweeps);
  state_.move = move;
  state_.share = share;
}

void CutPlayer::take(std::size_t cell, std::uint8_t section, double depth)
{
  // In sum, since a move may come as any number of short ones.
  if (state_.touched_by[cell] != section)
    state_.taken[cell] = 0.f;
  state_.touched_by[cell] = section;
  state_.taken[cell] += static_cast<float>(depth);
  if (state_.taken[cell] > kRounding)
    state_.cut_by[cell] = section;
}

void CutPlayer::cut(const std::vector<Sweep>& sweeps)
{
  StockField& field = state_.stock;
  const int rows = field.rows();
  const auto cutRows = [&](int row0, int row1) {
    // A cell more to each side, which costs nothing: what is near enough is the field's
    // to say.
    const double low = field.y(row0) - field.cellSize();
    const double high = field.y(row1 - 1) + field.cellSize();
    std::vector<LoweredCell> lowered;
    for (const Sweep& s : sweeps) {
      const double reach = s.cutter->radius();
      if (std::max(s.a.y(), s.b.y()) + reach < low ||
          std::min(s.a.y(), s.b.y()) - reach > high)
        continue;
      lowered.clear();
      field.cut(*s.cutter, s.a, s.b, row0, row1, &lowered);
      for (const LoweredCell& cell : lowered)
        take(static_cast<std::size_t>(cell.row) * field.columns() + cell.column,
             s.section,
             cell.depth);
    }
  };
  const int bands = (rows + kRowsPerBand - 1) / kRowsPerBand;
  if (sweeps.size() <= kFewSweeps)
    cutRows(0, rows);
  else
    parallelFor(static_cast<std::size_t>(bands), threads_, [&](std::size_t band) {
      const int row0 = static_cast<int>(band) * kRowsPerBand;
      cutRows(row0, std::min(rows, row0 + kRowsPerBand));
    });
}

} // namespace pointmill
