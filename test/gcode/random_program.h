// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <string>

/// @brief A program of @p blocks random motions and changes of mode: lines, arcs and
/// helices in all planes by centre and by radius, full circles, absolute and
/// incremental, inverse time, shifted frames, returns to the reference point.
std::string randomProgram(unsigned seed, int blocks, bool inches);
