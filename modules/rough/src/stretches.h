// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

namespace pointmill {

/// @brief Calls take(first, last) for the stretches of [@p begin, @p end) that begin
/// and end where needed(i) holds; those less than @p gap apart are taken as one.
template <typename Needed, typename Take>
void neededStretches(int begin, int end, int gap, Needed&& needed, Take&& take)
{
  bool open = false;
  int first = 0, last = 0;
  for (int i = begin; i < end; ++i) {
    if (!needed(i))
      continue;
    if (open && i - last > gap) {
      take(first, last);
      open = false;
    }
    if (!open)
      first = i;
    open = true;
    last = i;
  }
  if (open)
    take(first, last);
}

} // namespace pointmill
