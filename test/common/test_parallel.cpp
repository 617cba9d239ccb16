// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/parallel.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

TEST(Parallel, EveryIndexOnceWhateverTheThreads)
{
  for (unsigned threads : {0u, 1u, 2u, 7u}) {
    std::vector<int> calls(1000, 0);
    pointmill::parallelFor(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(1000, 1)) << threads << " threads";
  }
}

TEST(Parallel, AnExceptionReachesTheCaller)
{
  EXPECT_THROW(pointmill::parallelFor(100,
                                      3,
                                      [](std::size_t i) {
                                        if (i == 42)
                                          throw std::runtime_error("42");
                                      }),
               std::runtime_error);
}
