// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "feed_steps.h"

#include "steps.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace pointmill {
namespace {

/// What a change of feed is worth [min]: it ends an arc or a merged move, and one block
/// more takes so long on a serial line of 115200 baud.
constexpr double kChange = 0.005 / 60;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The quickest choice of a rung for each move, found from the first to the last: the
/// best way to any rung either stays on it or comes from the best of all.
class RungChoice {
public:
  explicit RungChoice(const std::vector<float>& rungs)
      : rungs_(rungs), cost_(rungs.size(), 0.0)
  {
  }

  /// The next move: so long [mm], no faster than @p most.
  void add(double length, float most)
  {
    const auto best = static_cast<std::size_t>(
        std::min_element(cost_.begin(), cost_.end()) - cost_.begin());
    const double change = cost_[best] + kChange;
    best_.push_back(static_cast<std::uint16_t>(best));
    for (std::size_t k = 0; k < rungs_.size(); ++k) {
      const bool changes = change < cost_[k];
      changes_.push_back(changes);
      cost_[k] = rungs_[k] > most ? kInfinity
                                  : (changes ? change : cost_[k]) + length / rungs_[k];
    }
  }

  /// The rungs of all moves, backwards.
  template <typename Take>
  void backwards(Take&& take) const
  {
    auto k = static_cast<std::size_t>(std::min_element(cost_.begin(), cost_.end()) -
                                      cost_.begin());
    for (std::size_t i = best_.size(); i-- > 0;) {
      take(rungs_[k]);
      if (changes_[i * rungs_.size() + k])
        k = best_[i];
    }
  }

private:
  const std::vector<float>& rungs_;
  std::vector<double> cost_;
  std::vector<std::uint16_t> best_; // before each move
  std::vector<bool> changes_;       // for each move, each rung
};

} // namespace

std::vector<float> feedLadder(const Cutting& cutting, double lowest, double share)
{
  std::vector<double> exact{cutting.feed, rampFeed(cutting), cutting.plunge_feed};
  std::sort(exact.begin(), exact.end(), std::greater<>());
  exact.push_back(std::min(lowest, exact.back()));
  std::vector<float> rungs;
  for (std::size_t i = 0; i + 1 < exact.size(); ++i)
    for (double feed = exact[i]; feed > exact[i + 1]; feed *= 1 - share)
      rungs.push_back(static_cast<float>(feed));
  rungs.push_back(static_cast<float>(exact.back()));
  return rungs;
}

void stepFeeds(CLCloud& path, const Cutting& cutting, double share)
{
  double lowest = kInfinity;
  for (const auto& p : path)
    if (!isRapid(p.getMotion()) && p.feed > 0)
      lowest = std::min<double>(lowest, p.feed);
  const auto rungs = feedLadder(cutting, lowest, share);
  RungChoice choice(rungs);
  std::vector<std::size_t> moves;
  for (std::size_t i = 1; i < path.size(); ++i)
    if (!isRapid(path[i].getMotion())) {
      moves.push_back(i);
      choice.add((position(path[i]) - position(path[i - 1])).norm(), path[i].feed);
    }
  choice.backwards([&](float feed) {
    path[moves.back()].feed = feed;
    moves.pop_back();
  });
}

} // namespace pointmill
