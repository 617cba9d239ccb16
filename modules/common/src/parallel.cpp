// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/parallel.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace pointmill {
namespace {
constexpr unsigned kMostThreads = 256;
}

void parallelFor(std::size_t count,
                 unsigned threads,
                 const std::function<void(std::size_t)>& body)
{
  parallelFor(count, threads, {}, body);
}

void parallelFor(std::size_t count,
                 unsigned threads,
                 Share share,
                 const std::function<void(std::size_t)>& body)
{
  if (threads == 0)
    threads = std::max(1u, std::thread::hardware_concurrency());
  threads = std::min(threads, kMostThreads);
  threads = static_cast<unsigned>(std::min<std::size_t>(threads, count));
  const WorkStep whole(share);
  const auto run = [&](std::size_t i) {
    const WorkStep step({double(i) / double(count), double(i + 1) / double(count)});
    body(i);
  };
  if (threads <= 1) {
    for (std::size_t i = 0; i < count; ++i)
      run(i);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    try {
      for (std::size_t i; (i = next.fetch_add(1)) < count;)
        run(i);
    }
    catch (...) {
      next = count;
      const std::lock_guard<std::mutex> lock(failure_mutex);
      if (!failure)
        failure = std::current_exception();
    }
  };
  std::vector<std::thread> pool;
  try {
    for (unsigned t = 1; t < threads; ++t)
      pool.emplace_back([&, watch = detail::here().watch] {
        detail::here() = {watch, 0.0, 0.0}; // it may stop, but tells nothing
        work();
      });
  }
  catch (const std::system_error&) {
    // the machine gives no more threads; those that there are do the work
  }
  work();
  for (auto& thread : pool)
    thread.join();
  if (failure)
    std::rethrow_exception(failure);
}

} // namespace pointmill
