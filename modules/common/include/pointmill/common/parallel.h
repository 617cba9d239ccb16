// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <cstddef>
#include <functional>

namespace pointmill {

/// @brief Calls `body(i)` for every i in [0, count) from up to @p threads threads
/// (0: as many as the machine has). Each i is called once; what a body writes must
/// belong to its i alone, so that the result does not depend on the number of threads.
/// The first exception is rethrown here after all threads have stopped.
void parallelFor(std::size_t count,
                 unsigned threads,
                 const std::function<void(std::size_t)>& body);

} // namespace pointmill
