// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <cstdint>
#include <string>

/// @brief Writes the scan that the benchmarks mill, `z = 10 + 4 sin(x/9) cos(y/11) +
/// 2 sin(x/4 + y/6)` over 100 x 100 mm at @p count random places, as a binary PCD file;
/// the same bytes at every run. It is streamed, so that its size needs no memory.
/// @param noise standard deviation of the heights [mm]
/// @throws std::runtime_error where the file cannot be written
void writeFreeformScan(const std::string& path, std::uint64_t count, double noise);
