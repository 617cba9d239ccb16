// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/watch.h>

#include <exception>

namespace pointmill {

detail::Place& detail::here() noexcept
{
  static thread_local Place place;
  return place;
}

void checkInterrupted()
{
  const Watch* watch = detail::here().watch;
  if (watch && watch->stopped())
    throw Interrupted();
}

Watch::Watch() : around_(detail::here())
{
  detail::here() = {this, 0.0, 1.0};
}

Watch::~Watch()
{
  detail::here() = around_;
}

std::string Watch::stage() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return stage_;
}

WorkStep::WorkStep(Share share)
    : around_(detail::here()), mine_(around_), exceptions_(std::uncaught_exceptions())
{
  checkInterrupted();
  const double length = around_.end - around_.begin;
  mine_.begin = around_.begin + share.begin * length;
  mine_.end = around_.begin + share.end * length;
  detail::here() = mine_;
  tell(mine_.begin);
}

WorkStep::WorkStep(const std::string& stage, Share share) : WorkStep(share)
{
  if (!mine_.watch)
    return;
  const std::lock_guard<std::mutex> lock(mine_.watch->mutex_);
  mine_.watch->stage_ = stage;
}

WorkStep::~WorkStep()
{
  if (std::uncaught_exceptions() == exceptions_)
    tell(mine_.end);
  detail::here() = around_;
}

void WorkStep::reach(double share) const
{
  checkInterrupted();
  tell(mine_.begin + (mine_.end - mine_.begin) * share);
}

// Only one thread of those that a Watch has may tell it anything: all others' steps are
// of no length, see parallelFor().
void WorkStep::tell(double place) const noexcept
{
  if (mine_.watch && mine_.end > mine_.begin && place > mine_.watch->share_)
    mine_.watch->share_ = place;
}

} // namespace pointmill
