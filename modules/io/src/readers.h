// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "source.h"

#include <pointmill/io/raw_scan.h>

#include <cstdint>
#include <vector>

namespace pointmill::detail {

// Each takes all points, non-finite ones too, and throws DataError; what holds for
// every format is checked once in readScan().
RawScan readPcd(const Source& source);
/// @brief Throws as readPcd() does, but does not look at the values of binary data:
/// afterwards PCL's reader, which trusts any header, may be let at the file.
void checkPcd(const Source& source);
RawScan readPly(const Source& source);
RawScan readObj(const Source& source);
RawScan readStl(const Source& source);
RawScan readText(const Source& source);

/// @brief Appends a polygon as triangles around its first corner.
inline void addFan(const std::vector<std::uint32_t>& corners, RawScan& scan)
{
  for (std::size_t i = 2; i < corners.size(); ++i)
    scan.faces.push_back({corners[0], corners[i - 1], corners[i]});
}

} // namespace pointmill::detail
