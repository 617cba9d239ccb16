// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>

namespace pointmill {

/// @brief Memory for arrays of millions of numbers: on a cache line's border, in huge
/// pages where the system has them, which spare most of the time that first touches
/// take.
/// @throws std::bad_alloc
void* allocatePages(std::size_t bytes);
void freePages(void* memory);

/// @brief For std::vector: allocatePages(), and elements that stay uninitialised until
/// they are written, so that the thread that writes them first gets their pages.
template <typename T>
struct PageAllocator {
  using value_type = T;
  PageAllocator() = default;
  template <typename U>
  PageAllocator(const PageAllocator<U>&)
  {
  }
  T* allocate(std::size_t n)
  {
    if (n > static_cast<std::size_t>(-1) / sizeof(T))
      throw std::bad_alloc();
    return static_cast<T*>(allocatePages(n * sizeof(T)));
  }
  void deallocate(T* memory, std::size_t) { freePages(memory); }
  template <typename U>
  void construct(U* at)
  {
    ::new (static_cast<void*>(at)) U;
  }
  template <typename U, typename... Args>
  void construct(U* at, Args&&... args)
  {
    ::new (static_cast<void*>(at)) U(std::forward<Args>(args)...);
  }
  bool operator==(const PageAllocator&) const { return true; }
  bool operator!=(const PageAllocator&) const { return false; }
};

} // namespace pointmill
