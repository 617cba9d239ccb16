// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/watch.h>

#include <cstddef>
#include <functional>

namespace pointmill {

/// @brief Calls `body(i)` for every i in [0, count) from up to @p threads threads
/// (0: as many as the machine has). Each i is called once; what a body writes must
/// belong to its i alone, so that the result does not depend on the number of threads.
/// The first exception is rethrown here after all threads have stopped.
///
/// The caller's Watch watches all of them, and stops them between two bodies.
void parallelFor(std::size_t count,
                 unsigned threads,
                 const std::function<void(std::size_t)>& body);

/// @brief The same, telling the Watch how far it is.
/// @param share what all of it is of the WorkStep around it; steps that are taken in a
/// body divide that body's part
void parallelFor(std::size_t count,
                 unsigned threads,
                 Share share,
                 const std::function<void(std::size_t)>& body);

} // namespace pointmill
