// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace pointmill {

/// @brief Characters to insert, remove or replace between both (Levenshtein).
inline std::size_t editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

/// @brief The first of @p names that is nearest to @p name; there must be one.
inline const std::string& nearestName(const std::string& name,
                                      const std::vector<std::string>& names)
{
  return *std::min_element(
      names.begin(), names.end(), [&name](const auto& a, const auto& b) {
        return editDistance(name, a) < editDistance(name, b);
      });
}

} // namespace pointmill
