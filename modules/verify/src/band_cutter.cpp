// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "band_cutter.h"

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

/// What a tool takes at once is what it takes on this share of its diameter.
constexpr double kPiece = 0.25;
/// Whoever meets less of the stock does not meet it [mm].
constexpr double kMeets = 0.01;
/// Of a flat end this share of the radius does not cut.
constexpr double kCore = 0.5;
/// A flat end may be pressed into a skin [mm], or as deep as its middle is on a ramp of
/// this slope, which flat end mills are taken to bear: some 6 degrees.
constexpr double kSkin = 0.1, kRamp = 0.1;
/// Deeper than this share of its diameter it must not go at all: what lies between is
/// worth a warning, as most flat end mills cut over their centre.
constexpr double kPressed = 0.1;

Tool shrunk(const Tool& tool, double e)
{
  Tool small = tool;
  small.diameter = std::max(0.0, tool.diameter - 2 * e);
  small.corner_radius = std::max(0.0, tool.corner_radius - e);
  small.tip_diameter = std::max(0.0, tool.tip_diameter - 2 * e);
  return small;
}

} // namespace

SimulatedTool::SimulatedTool(const Tool& tool, double tolerance)
    : cutter(tool), rapid_tool(shrunk(tool, tolerance)), rapid_cutter(rapid_tool),
      core(kCore * tool.flatRadius())
{
  for (const auto& body : bodiesOf(tool)) {
    const Tool cylinder = shrunk(body.asTool(), tolerance);
    bodies.push_back({body.code, body.above, cylinder, SweptCutter(cylinder)});
  }
}

void StockEvents::take(const StockEvents& other)
{
  for (const auto& [code, list] : other.depths)
    depths[code].take(list);
  for (std::size_t s = 0; s < layers.size(); ++s) {
    const Layer& layer = other.layers[s];
    if (layer.thickness > layers[s].thickness ||
        (layer.thickness == layers[s].thickness && layer.move < layers[s].move))
      layers[s] = layer;
    volumes[s] += other.volumes[s];
  }
}

BandCutter::BandCutter(StockField& field,
                       int row0,
                       int row1,
                       const std::vector<SweptMove>& moves,
                       const std::map<const Tool*, SimulatedTool>& tools,
                       const StockLimits& limits,
                       std::size_t sections)
    : field_(field), row0_(row0), row1_(row1), moves_(moves), tools_(tools),
      limits_(limits), up_(0, 0, limits.tolerance), top_(field.highestIn(row0, row1)),
      events_(sections)
{
}

void BandCutter::move(std::size_t k)
{
  const SimulatedTool& tool = tools_.at(moves_[k].tool);
  if (moves_[k].rapid)
    rapid(k, tool);
  else
    feed(k, tool);
  if (!tool.bodies.empty())
    bodies(k, tool);
}

bool BandCutter::below(double z)
{
  if (z >= top_)
    return false;
  top_ = field_.highestIn(row0_, row1_); // it may have been cut since
  return z < top_;
}

void BandCutter::rapid(std::size_t k, const SimulatedTool& tool)
{
  const SweptMove& m = moves_[k];
  const Vector3d low = m.a.cwiseMin(m.b) + up_;
  if (!below(low.z()))
    return;
  double depth = 0;
  if (m.mayBend())
    depth = field_.depthIn(tool.rapid_tool, low, m.a.cwiseMax(m.b) + up_, row0_, row1_);
  depth = std::max(
      depth, field_.cut(tool.rapid_cutter, m.a + up_, m.b + up_, row0_, row1_).depth);
  if (depth > kMeets)
    events_.depths["rapid_in_stock"].note(k, depth);
}

/// In pieces where it is long; short ones that follow each other make up one piece.
void BandCutter::feed(std::size_t k, const SimulatedTool& tool)
{
  const SweptMove& m = moves_[k];
  const double longest = kPiece * m.tool->diameter;
  const double r = m.tool->radius() + field_.cellSize();
  const double bottom = field_.y(row0_) - r, top = field_.y(row1_ - 1) + r;
  const double length = (m.b - m.a).norm();
  const double count = std::max(1.0, std::ceil(length / longest));
  Vector3d from = m.a;
  for (double i = 1; i <= count; ++i) {
    const Vector3d to = i < count ? m.a + (i / count) * (m.b - m.a) : m.b;
    if (std::max(from.y(), to.y()) > bottom && std::min(from.y(), to.y()) < top) {
      if (piece_.tool != m.tool || piece_.end != from || piece_.section != m.section ||
          piece_.length + length / count > longest)
        endPiece();
      piece_.tool = m.tool;
      piece_.section = m.section;
      piece_.end = to;
      piece_.length += length / count;
      cut(k, tool, from, to);
    }
    from = to;
  }
}

void BandCutter::cut(std::size_t k,
                     const SimulatedTool& tool,
                     const Vector3d& from,
                     const Vector3d& to)
{
  const std::size_t first = piece_.lowered.size();
  const Cut taken = field_.cut(tool.cutter, from, to, row0_, row1_, &piece_.lowered);
  if (!(taken.depth > 0))
    return;
  piece_.move = k;
  piece_.most += taken.depth;
  events_.volumes[piece_.section] += taken.volume;
  const double descent = from.z() - to.z();
  if (tool.core > 0 && descent > limits_.ramp_slope * (to - from).head<2>().norm())
    sink(k, tool, from, to, first);
}

/// What the middle of a flat end, which does not cut, is pressed into: cells under it
/// all the way down.
void BandCutter::sink(std::size_t k,
                      const SimulatedTool& tool,
                      const Vector3d& from,
                      const Vector3d& to,
                      std::size_t first)
{
  const double reach = std::max(tool.core, std::sqrt(0.5) * field_.cellSize());
  double deepest = 0;
  for (std::size_t i = first; i < piece_.lowered.size(); ++i) {
    const LoweredCell& cell = piece_.lowered[i];
    const Eigen::Vector2d at(field_.x(cell.column), field_.y(cell.row));
    if ((at - from.head<2>()).norm() > reach || (at - to.head<2>()).norm() > reach)
      continue;
    double& depth = piece_.sunk[{cell.row, cell.column}];
    depth += cell.depth;
    deepest = std::max(deepest, depth);
  }
  const double borne = std::max(kSkin, 2 * kRamp * tool.core);
  if (deepest > borne)
    events_
        .depths[deepest > std::max(borne, kPressed * piece_.tool->diameter)
                    ? "plunge"
                    : "pressed_in"]
        .note(k, deepest);
}

void BandCutter::bodies(std::size_t k, const SimulatedTool& tool)
{
  const SweptMove& m = moves_[k];
  for (const auto& body : tool.bodies) {
    const Vector3d up = up_ + Vector3d(0, 0, body.above);
    const Vector3d low = m.a.cwiseMin(m.b) + up;
    if (!below(low.z()))
      continue;
    const double depth =
        m.mayBend()
            ? field_.depthIn(body.tool, low, m.a.cwiseMax(m.b) + up, row0_, row1_)
            : field_.depthAlong(body.cutter, m.a + up, m.b + up, row0_, row1_);
    if (depth > kMeets)
      events_.depths[body.code].note(k, depth);
  }
}

void BandCutter::endPiece()
{
  if (piece_.tool) {
    StockEvents::Layer& thickest = events_.layers[piece_.section];
    if (piece_.most > thickest.thickness) {
      const double thickness =
          gauge_.thickness(piece_.lowered, piece_.tool->diameter, field_.cellSize());
      if (thickness > thickest.thickness)
        thickest = {thickness, piece_.move};
    }
  }
  piece_.tool = nullptr;
  piece_.length = piece_.most = 0;
  piece_.lowered.clear();
  piece_.sunk.clear();
}

} // namespace pointmill
