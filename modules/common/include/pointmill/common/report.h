// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace pointmill {

/// @brief What a stage handled and measured, as named figures in the order they were
/// set
/// ("nan_points" 12, "gap_area_mm2" 3.4, ...). Units are part of the names.
class Report {
public:
  void set(const std::string& name, double value)
  {
    const auto it = find(name);
    if (it == figures_.end())
      figures_.emplace_back(name, value);
    else
      it->second = value;
  }
  /// @brief The figure, or @p otherwise where it was never set.
  double get(const std::string& name, double otherwise = 0.0) const
  {
    const auto it = const_cast<Report*>(this)->find(name);
    return it == figures_.end() ? otherwise : it->second;
  }
  const std::vector<std::pair<std::string, double>>& figures() const
  {
    return figures_;
  }
  void clear() { figures_.clear(); }

private:
  std::vector<std::pair<std::string, double>>::iterator find(const std::string& name)
  {
    return std::find_if(figures_.begin(), figures_.end(), [&](const auto& f) {
      return f.first == name;
    });
  }
  std::vector<std::pair<std::string, double>> figures_;
};

} // namespace pointmill
