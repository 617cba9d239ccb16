// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "json_parts.h"

#include <pointmill/mill/criteria.h>

namespace pointmill::json {

/// @brief What Criteria::read() does not find elsewhere in the report.
Json of(const Criteria& criteria);

} // namespace pointmill::json
