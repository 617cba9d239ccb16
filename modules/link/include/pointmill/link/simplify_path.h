// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/stage.h>
#include <pointmill/common/tolerance_band.h>
#include <pointmill/surface/point_index.h>

#include <memory>

namespace pointmill {

/// @brief Leaves out CL points that a path can do without: each chord of the result
/// leads as far along its pass (`label`) as it can while every point that it skips
/// stays within the tolerance band of it, and no point of the part gets deeper into the
/// tool than the band allows, proven over the whole chord (PointIndex::gouge). That
/// gives the fewest points whenever parts of a good chord are good chords.
///
/// What is left is a choice of the points that came in. A point where the feed, the
/// level or the kind of motion changes stays. Together with BufferPoints the errors
/// outside add up, those inside do not, as they are measured from the part.
class SimplifyPath : public Filter<PointCL> {
public:
  SimplifyPath() : Filter<PointCL>("SimplifyPath") {}

  void setTool(const Tool& tool) { tool_ = tool; }
  /// @brief The part's points (and what bridges their gaps), and what is left on them.
  void setPart(std::shared_ptr<const PointIndex> part, double allowance)
  {
    part_ = std::move(part);
    allowance_ = allowance;
  }
  /// @brief How far a chord may pass from the points that it skips, beneath them or
  /// above [mm].
  void setTolerance(const ToleranceBand& band) { band_ = band; }
  const ToleranceBand& getTolerance() const { return band_; }
  /// @brief No chord is made longer than this [mm].
  void setLongestChord(double longest) { longest_ = longest; }
  double getLongestChord() const { return longest_; }
  void setNumberOfThreads(unsigned threads) { threads_ = threads; }

  template <typename V>
  void parameters(V&& v)
  {
    v("inside_tolerance",
      band_.inside,
      "mm",
      Range{0, 10},
      "how far a chord may pass beneath what it skips, or cut in");
    v("outside_tolerance",
      band_.outside,
      "mm",
      Range{0, 10},
      "how far a chord may pass above what it skips");
    v("longest_chord", longest_, "mm", Range{0.01, 1e4}, "no chord is made longer");
    v("allowance", allowance_, "mm", Range{0, 20}, "material left on the part");
  }

protected:
  void checkParameters() const override;
  void apply(CLCloud& output) override;

private:
  Tool tool_ = Tool::ball(1, 3.0);
  std::shared_ptr<const PointIndex> part_;
  double allowance_ = 0.0, longest_ = 10.0;
  ToleranceBand band_{0.01, 0.01};
  unsigned threads_ = 0;
};

} // namespace pointmill
