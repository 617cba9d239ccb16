// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

/// @brief The number @p value with its present value as the default.
inline CLI::Option* numberOption(CLI::App& app,
                                 const std::string& name,
                                 double& value,
                                 const std::string& unit,
                                 const std::string& help)
{
  return app.add_option(name, value, help)->type_name(unit)->capture_default_str();
}

/// @brief An option that takes one of a few names, and calls @p set with its value.
template <typename Value>
CLI::Option* choice(CLI::App& app,
                    const std::string& name,
                    const std::function<void(Value)>& set,
                    const std::vector<std::pair<std::string, Value>>& choices,
                    const std::string& help)
{
  std::string names;
  for (const auto& c : choices)
    names += (names.empty() ? "" : "|") + c.first;
  return app
      .add_option_function<std::string>(
          name,
          [=](const std::string& given) {
            for (const auto& c : choices)
              if (c.first == given) {
                set(c.second);
                return;
              }
            throw CLI::ValidationError(name, "must be " + names + ", not " + given);
          },
          help)
      ->type_name(names);
}

/// @brief The same for a variable.
template <typename Value>
CLI::Option* choice(CLI::App& app,
                    const std::string& name,
                    Value& value,
                    const std::vector<std::pair<std::string, Value>>& choices,
                    const std::string& help)
{
  return choice<Value>(
      app, name, [&value](Value chosen) { value = chosen; }, choices, help);
}
