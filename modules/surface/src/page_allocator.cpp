// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/surface/page_allocator.h>

#include <cstdlib>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace pointmill {
namespace {
constexpr std::size_t kLine = 64, kHugePage = std::size_t(1) << 21;
}

void* allocatePages(std::size_t bytes)
{
  const std::size_t step = bytes >= kHugePage ? kHugePage : kLine;
  const std::size_t whole = (bytes + step - 1) / step * step;
  void* memory = std::aligned_alloc(step, whole);
  if (!memory || whole < bytes)
    throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  if (step == kHugePage)
    madvise(memory, whole, MADV_HUGEPAGE); // a wish; nothing is lost without
#endif
  return memory;
}

void freePages(void* memory)
{
  std::free(memory);
}

} // namespace pointmill
