// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/parameters.h>
#include <pointmill/gcode/decimal_grid.h>

#include <charconv>
#include <cmath>

namespace pointmill {

DecimalGrid::DecimalGrid(int decimals, double unit) : decimals_(decimals), scale_(1)
{
  checkRange("DecimalGrid", "decimals", decimals, "", {0, 6});
  checkRange("DecimalGrid", "unit", unit, "mm", {1e-3, 1e3});
  for (int i = 0; i < decimals; ++i)
    scale_ *= 10;
  per_mm_ = double(scale_) / unit;
}

std::int64_t DecimalGrid::nearest(double value) const
{
  return static_cast<std::int64_t>(std::floor(value * per_mm_ + 0.5));
}

std::int64_t DecimalGrid::atOrAbove(float value) const
{
  // Exact in millimetres: a float times 10^6 has at most 44 significant bits.
  const double scaled = double(value) * per_mm_;
  const double near = std::floor(scaled + 0.5);
  // The second condition matters above 100 mm, where floats are coarser than the grid.
  if (static_cast<float>(near / per_mm_) == value && std::abs(near - scaled) < 0.05)
    return static_cast<std::int64_t>(near);
  return static_cast<std::int64_t>(std::ceil(scaled));
}

char* DecimalGrid::write(char* to, std::int64_t ticks, NumberStyle style) const
{
  if (ticks < 0) {
    *to++ = '-';
    ticks = -ticks;
  }
  else if (style.plus)
    *to++ = '+';
  const std::int64_t whole = ticks / scale_;
  auto rest = static_cast<std::uint32_t>(ticks % scale_);
  if (whole != 0 || rest == 0 || style.leading_zero)
    to = std::to_chars(to, to + max_chars - 8, whole).ptr;
  if (rest != 0 || style.point)
    *to++ = '.';
  for (auto place = static_cast<std::uint32_t>(scale_ / 10); rest != 0; place /= 10) {
    *to++ = static_cast<char>('0' + rest / place);
    rest %= place;
  }
  return to;
}

std::string DecimalGrid::text(std::int64_t ticks, NumberStyle style) const
{
  std::string text(max_chars, '\0');
  char* const begin = text.data();
  text.resize(static_cast<std::size_t>(write(begin, ticks, style) - begin));
  return text;
}

} // namespace pointmill
