// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pointmill {

/// @brief What may lower a surface, the most promising first: a heap of lower bounds.
/// Whoever takes from it stops as soon as no bound is below what is there already.
class Candidates {
public:
  struct Candidate {
    double bound;
    std::uint32_t id;
  };

  void clear() { heap_.clear(); }
  void add(double bound, std::size_t id)
  {
    heap_.push_back({bound, static_cast<std::uint32_t>(id)});
  }
  /// @brief Forgets those above @p limit and puts the others in order; then they can be
  /// taken.
  void order(double limit)
  {
    heap_.erase(std::remove_if(heap_.begin(),
                               heap_.end(),
                               [&](const Candidate& c) { return c.bound > limit; }),
                heap_.end());
    std::make_heap(heap_.begin(), heap_.end(), later);
  }

  /// @brief Adds one to those in order.
  void push(double bound, std::size_t id)
  {
    add(bound, id);
    std::push_heap(heap_.begin(), heap_.end(), later);
  }

  bool empty() const { return heap_.empty(); }
  const Candidate& best() const { return heap_.front(); }
  Candidate take()
  {
    std::pop_heap(heap_.begin(), heap_.end(), later);
    const Candidate candidate = heap_.back();
    heap_.pop_back();
    return candidate;
  }

private:
  static bool later(const Candidate& a, const Candidate& b)
  {
    return a.bound > b.bound || (a.bound == b.bound && a.id > b.id);
  }
  std::vector<Candidate> heap_;
};

} // namespace pointmill
