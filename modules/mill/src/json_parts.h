// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/keep_out.h>
#include <pointmill/common/machine.h>
#include <pointmill/common/stock.h>
#include <pointmill/common/tool.h>

#include <nlohmann/json.hpp>

#include <Eigen/Core>

namespace pointmill::json {

using Json = nlohmann::ordered_json;

/// @brief JSON has no NaN and no infinity.
Json number(double value);
Json vector(const Eigen::Vector3d& v);
/// @throws nlohmann::json::exception
Eigen::Vector3d vectorFrom(const Json& json);

/// @name What the report holds for people and a later check reads again
/// @{
Json of(const Tool& tool);
Json of(const Stock& stock);
Json of(const KeepOut& keep_out);
Json of(const Machine& machine);
/// @throws nlohmann::json::exception where a member is missing or of another kind
Tool toolFrom(const Json& json);
Stock stockFrom(const Json& json);
KeepOut keepOutFrom(const Json& json);
Machine machineFrom(const Json& json);
/// @}

} // namespace pointmill::json
