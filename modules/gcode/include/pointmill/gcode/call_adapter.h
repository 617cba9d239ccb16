// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/gcode/machine_calls.h>

namespace pointmill {

/// @brief Hands every call on to the next, which must outlive it; derived classes
/// change some.
class CallAdapter : public MachineCalls {
public:
  explicit CallAdapter(MachineCalls& next) : next_(next) {}

  void begin(const ProgramHead& head) override { next_.begin(head); }
  void comment(const std::string& text) override { next_.comment(text); }
  void operation(std::size_t number, const std::string& name) override
  {
    next_.operation(number, name);
  }
  void stop() override { next_.stop(); }
  void retract() override { next_.retract(); }
  void changeTool(int number) override { next_.changeTool(number); }
  void spindle(long rpm) override { next_.spindle(rpm); }
  void coolant(bool on) override { next_.coolant(on); }
  void approach(const MachinePosition& to) override { next_.approach(to); }
  void traverse(const MachinePosition& to) override { next_.traverse(to); }
  void straight(const MachinePosition& to, std::int64_t feed) override
  {
    next_.straight(to, feed);
  }
  void arc(const MachineArc& arc, std::int64_t feed) override { next_.arc(arc, feed); }
  void dwell(double seconds) override { next_.dwell(seconds); }
  void end() override { next_.end(); }

private:
  MachineCalls& next_;
};

} // namespace pointmill
