// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "print.h"

#include <cmath>

namespace pointmill {

std::string hoursAndMinutes(double minutes)
{
  const double whole = std::floor(minutes + 0.5);
  if (whole < 1)
    return minutes > 0 ? "under 1 min" : "0 min";
  return whole < 60 ? print("%.0f min", whole)
                    : print("%.0f h %02.0f min",
                            std::floor(whole / 60),
                            std::fmod(whole, 60.0));
}

} // namespace pointmill
