// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/parameters.h>
#include <pointmill/gcode/decimal_grid.h>

#include <charconv>
#include <cmath>

namespace pointmill {

DecimalGrid::DecimalGrid(int decimals) : decimals_(decimals), scale_(1)
{
  checkRange("DecimalGrid", "decimals", decimals, "", {1, 6});
  for (int i = 0; i < decimals; ++i)
    scale_ *= 10;
}

std::int64_t DecimalGrid::nearest(double value) const
{
  return static_cast<std::int64_t>(std::floor(value * double(scale_) + 0.5));
}

std::int64_t DecimalGrid::atOrAbove(float value) const
{
  // Exact: a float times 10^6 has at most 44 significant bits.
  const double scaled = double(value) * double(scale_);
  const double near = std::floor(scaled + 0.5);
  // The second condition matters above 100 mm, where floats are coarser than the grid.
  if (static_cast<float>(near / double(scale_)) == value &&
      std::abs(near - scaled) < 0.05)
    return static_cast<std::int64_t>(near);
  return static_cast<std::int64_t>(std::ceil(scaled));
}

char* DecimalGrid::write(char* to, std::int64_t ticks) const
{
  if (ticks < 0) {
    *to++ = '-';
    ticks = -ticks;
  }
  to = std::to_chars(to, to + max_chars - 8, ticks / scale_).ptr;
  *to++ = '.';
  auto rest = static_cast<std::uint32_t>(ticks % scale_);
  for (auto place = static_cast<std::uint32_t>(scale_ / 10); rest != 0; place /= 10) {
    *to++ = static_cast<char>('0' + rest / place);
    rest %= place;
  }
  return to;
}

} // namespace pointmill
