// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/slice/distance_field.h>

#include <cmath>
#include <limits>

namespace pointmill {
namespace {

constexpr double kFar = 1e20;

/// out[q] = min over p of (q - p)^2 + f[p], by the lower envelope of the parabolas.
void envelope(const std::vector<double>& f,
              std::vector<double>& out,
              std::vector<int>& apex,
              std::vector<double>& border)
{
  const int n = static_cast<int>(f.size());
  int k = 0;
  apex[0] = 0;
  border[0] = -kFar;
  border[1] = kFar;
  for (int q = 1; q < n; ++q) {
    const auto meets = [&](int p) {
      return ((f[q] + double(q) * q) - (f[p] + double(p) * p)) / (2.0 * (q - p));
    };
    double s = meets(apex[k]);
    while (k > 0 && s <= border[k])
      s = meets(apex[--k]);
    apex[++k] = q;
    border[k] = s;
    border[k + 1] = kFar;
  }
  k = 0;
  for (int q = 0; q < n; ++q) {
    while (border[k + 1] < q)
      ++k;
    out[q] = double(q - apex[k]) * (q - apex[k]) + f[apex[k]];
  }
}

} // namespace

std::vector<float>
distanceField(const std::vector<unsigned char>& mask, int columns, int rows)
{
  std::vector<double> squared(mask.size());
  for (std::size_t i = 0; i < mask.size(); ++i)
    squared[i] = mask[i] ? 0.0 : kFar;
  const auto pass =
      [&](int lines, int length, std::size_t line_step, std::size_t step) {
        std::vector<double> f(length), out(length), border(length + 2);
        std::vector<int> apex(length + 1);
        for (int line = 0; line < lines; ++line) {
          double* at = &squared[line * line_step];
          for (int i = 0; i < length; ++i)
            f[i] = at[i * step];
          envelope(f, out, apex, border);
          for (int i = 0; i < length; ++i)
            at[i * step] = out[i];
        }
      };
  if (!mask.empty()) {
    pass(columns, rows, 1, static_cast<std::size_t>(columns));
    pass(rows, columns, static_cast<std::size_t>(columns), 1);
  }
  std::vector<float> distance(mask.size());
  for (std::size_t i = 0; i < mask.size(); ++i)
    distance[i] = squared[i] >= kFar ? std::numeric_limits<float>::infinity()
                                     : static_cast<float>(std::sqrt(squared[i]));
  return distance;
}

} // namespace pointmill
