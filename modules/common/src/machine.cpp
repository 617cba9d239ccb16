// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/common/machine.h>
#include <pointmill/common/parameters.h>

namespace pointmill {

void Machine::validate() const
{
  const std::string who = "machine";
  checkRange(who, "rapid rate", rapid_rate, "mm/min", {10, 1e6});
  checkRange(who, "max feed", max_feed, "mm/min", {0, 1e6});
  checkRange(who, "min spindle", min_spindle, "rev/min", {0, 1e6});
  checkRange(who, "max spindle", max_spindle, "rev/min", {0, 1e6});
  checkRange(who, "power", power, "W", {0, 1e6});
  checkRange(who, "acceleration", acceleration, "mm/s2", {1, 1e6});
  checkRange(who, "junction deviation", junction_deviation, "mm", {1e-4, 1});
  if (max_spindle > 0 && min_spindle > max_spindle)
    throw ParameterError(who + ": the slowest spindle speed is above the fastest");
  if (travel && !((travel->max - travel->min).minCoeff() > 0))
    throw ParameterError(who + ": the travel has no volume: X0 Y0 Z0 X1 Y1 Z1");
}

} // namespace pointmill
