// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/gcode/call_adapter.h>

#include <cstddef>

namespace pointmill::gcode {

/// @brief Slows down what is faster than the machine.
class FeedLimiter : public CallAdapter {
public:
  /// @param fastest 1/1000 mm/min
  FeedLimiter(MachineCalls& next, std::int64_t fastest)
      : CallAdapter(next), fastest_(fastest)
  {
  }

  void straight(const MachinePosition& to, std::int64_t feed) override
  {
    CallAdapter::straight(to, limited(feed));
  }
  void arc(const MachineArc& arc, std::int64_t feed) override
  {
    CallAdapter::arc(arc, limited(feed));
  }

  std::size_t slowed() const { return slowed_; }

private:
  std::int64_t limited(std::int64_t feed)
  {
    if (feed <= fastest_)
      return feed;
    ++slowed_;
    return fastest_;
  }

  std::int64_t fastest_;
  std::size_t slowed_ = 0;
};

} // namespace pointmill::gcode
