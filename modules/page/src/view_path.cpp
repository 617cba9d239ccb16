// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "view_path.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace pointmill {
namespace {

double secondsOf(const ProgramMove& move, double rapid_rate)
{
  const double rate = move.rapid ? rapid_rate : move.feed;
  const double length = (move.to - move.from).norm();
  return std::isfinite(length) && rate > 0 ? 60 * length / rate : 0.0;
}

double
distance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp(along.dot(p - a) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

void write(std::string& bytes, std::uint64_t number)
{
  for (; number > 127; number >>= 7)
    bytes += static_cast<char>(128 | (number & 127));
  bytes += static_cast<char>(number);
}

void writeSigned(std::string& bytes, std::int64_t number)
{
  write(bytes,
        number < 0 ? 2 * static_cast<std::uint64_t>(-(number + 1)) + 1
                   : 2 * static_cast<std::uint64_t>(number));
}

} // namespace

Strokes
strokesOf(const Program& program, const ViewPath& path, double start, double rapid_rate)
{
  double sum = 0;
  for (std::size_t i = path.first; i < path.last; ++i)
    sum += secondsOf(program.moves[i], rapid_rate);
  const double scale = sum > 0 ? path.seconds / sum : 0.0;
  Strokes strokes;
  double now = start;
  const ProgramMove* before = nullptr;
  for (std::size_t i = path.first; i < path.last; ++i) {
    const ProgramMove& move = program.moves[i];
    const double next = now + scale * secondsOf(move, rapid_rate);
    if (move.from.allFinite() && move.to.allFinite()) {
      auto& list = move.rapid ? strokes.rapids : strokes.feeds;
      if (!before || before->rapid != move.rapid || before->to != move.from)
        list.push_back({{move.from, now}});
      list.back().push_back({move.to, next});
      before = &move;
    }
    else
      before = nullptr;
    now = next;
  }
  return strokes;
}

Stroke simplified(const Stroke& stroke, double off)
{
  if (stroke.size() < 3)
    return stroke;
  std::vector<char> kept(stroke.size(), 0);
  kept.front() = kept.back() = 1;
  std::vector<std::array<std::size_t, 2>> open{{0, stroke.size() - 1}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    std::size_t farthest = a;
    double most = off;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double away = distance(stroke[i].at, stroke[a].at, stroke[b].at);
      if (away > most) {
        most = away;
        farthest = i;
      }
    }
    if (farthest == a)
      continue;
    kept[farthest] = 1;
    open.push_back({a, farthest});
    open.push_back({farthest, b});
  }
  Stroke result;
  for (std::size_t i = 0; i < stroke.size(); ++i)
    if (kept[i])
      result.push_back(stroke[i]);
  return result;
}

std::string packed(const std::vector<Stroke>& strokes, double step)
{
  std::string bytes;
  std::array<std::int64_t, 3> place{};
  std::int64_t time = 0;
  for (const auto& stroke : strokes) {
    write(bytes, stroke.size());
    for (const auto& p : stroke) {
      for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t at = std::llround(p.at[axis] / step);
        auto& last = place[static_cast<std::size_t>(axis)];
        writeSigned(bytes, at - last);
        last = at;
      }
      const std::int64_t now = std::llround(100 * p.seconds);
      writeSigned(bytes, now - time);
      time = now;
    }
  }
  return bytes;
}

} // namespace pointmill
