// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pointmill {

/// @brief Closed interval of the values that a parameter may take.
struct Range {
  double low;
  double high;
};

/// @brief One parameter as a report shows it.
struct ParameterValue {
  std::string name;
  double value;
  std::string unit;
  Range range;
  std::string meaning;
};

/// @brief Throws ParameterError naming stage, parameter, value, unit and range unless
/// `range.low <= value <= range.high`. NaN is always refused.
void checkRange(const std::string& stage,
                const std::string& name,
                double value,
                const std::string& unit,
                Range range);

/// @brief The parameters that @p stage declares in its member template
/// `parameters(visitor)`, in that order.
template <typename StageT>
std::vector<ParameterValue> listParameters(const StageT& stage)
{
  std::vector<ParameterValue> list;
  // The one list serves readers and writers, so it is not const itself.
  const_cast<StageT&>(stage).parameters([&](const char* name,
                                            auto& value,
                                            const char* unit,
                                            Range range,
                                            const char* meaning) {
    list.push_back({name, static_cast<double>(value), unit, range, meaning});
  });
  return list;
}

/// @brief Checks every parameter that @p stage declares; see checkRange().
template <typename StageT>
void validateParameters(const StageT& stage, const std::string& name)
{
  for (const auto& p : listParameters(stage))
    checkRange(name, p.name, p.value, p.unit, p.range);
}

} // namespace pointmill
