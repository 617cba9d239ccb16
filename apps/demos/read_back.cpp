// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "read_back.h"

#include <algorithm>
#include <cmath>

using namespace pointmill;

namespace {

bool isRapid(const PointCL& p)
{
  return p.getMotion() == Motion::Rapid || p.getMotion() == Motion::Retract;
}

std::string placeOf(const Eigen::Vector3d& p)
{
  return "X" + std::to_string(p.x()) + " Y" + std::to_string(p.y()) + " Z" +
         std::to_string(p.z());
}

/// One printed decimal of lengths, and of feeds.
struct Decimals {
  explicit Decimals(const GCodeWriter& writer)
      : length(writer.getGrid().value(1)), max_feed(writer.getMaxFeed())
  {
    const Post& post = writer.getPost();
    feed = std::pow(10.0, -post.feed_decimals);
    if (writer.getUnit() == Unit::Inch)
      feed *= 25.4 / post.inch_feed_factor;
  }
  /// Rounded to the nearest, Z upwards.
  bool isAt(const Eigen::Vector3d& to, const PointCL& p) const
  {
    const double z = to.z() - p.z;
    return std::abs(to.x() - p.x) <= length / 2 + slack(p.x) &&
           std::abs(to.y() - p.y) <= length / 2 + slack(p.y) && z >= -slack(p.z) &&
           z <= length + slack(p.z);
  }
  /// A float stands for a decimal number half a digit of its own beside it.
  static double slack(float value) { return 1e-9 + 6e-8 * std::abs(double(value)); }
  bool isFeed(double read, double planned) const
  {
    const double wanted = max_feed > 0 ? std::min(planned, max_feed) : planned;
    return std::abs(read - wanted) <= feed + 1e-6 * wanted;
  }
  double length, feed, max_feed;
};

} // namespace

std::string
differenceFrom(const CLCloud& path, const Program& program, const GCodeWriter& writer)
{
  const Decimals decimals(writer);
  const auto& moves = program.moves;
  const auto at = [&](std::size_t move) {
    return program.where(moves[move].line) + ": ";
  };
  std::size_t m = 0; // the move that comes to the path's beginning
  while (m < moves.size() && moves[m].rapid && !decimals.isAt(moves[m].to, path[0]))
    ++m;
  if (m == moves.size() || !moves[m].rapid)
    return "the program does not come to the path's beginning in rapid";
  for (std::size_t i = 1; i < path.size(); ++i) {
    const PointCL& p = path[i];
    const bool next = m + 1 < moves.size() && decimals.isAt(moves[m + 1].to, p) &&
                      moves[m + 1].rapid == isRapid(p);
    if (!next) {
      if (decimals.isAt(moves[m].to, p)) // both are one decimal
        continue;
      return (m + 1 < moves.size() ? at(m + 1) + "goes to " + placeOf(moves[m + 1].to)
                                   : std::string("the program ends before")) +
             ", the path to " + placeOf(p.getVector3fMap().cast<double>());
    }
    ++m;
    if (!isRapid(p) && !decimals.isFeed(moves[m].feed, p.feed))
      return at(m) + "has the feed " + std::to_string(moves[m].feed) +
             ", the path has " + std::to_string(p.feed);
  }
  for (++m; m < moves.size(); ++m)
    if (!moves[m].rapid)
      return at(m) + "feeds on after the path's end";
  return program.ended ? "" : "the program has no end";
}

std::size_t pointsLeftOut(const CLCloud& passes, const CLCloud& path)
{
  std::size_t left_out = 0, from = 0;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const PointCL& p = passes[i];
    const auto place = p.getVector3fMap();
    std::size_t at = from;
    while (at < path.size() && path[at].getVector3fMap() != place)
      ++at;
    if (at < path.size()) {
      from = at;
      continue;
    }
    ++left_out; // with the rest of its pass, so that none is looked for in vain
    while (i + 1 < passes.size() && passes[i + 1].label == p.label) {
      ++left_out;
      ++i;
    }
  }
  return left_out;
}
