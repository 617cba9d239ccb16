// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "band_cutter.h"

#include <pointmill/common/parallel.h>
#include <pointmill/surface/stock_field.h>

#include <algorithm>

namespace pointmill {
namespace {

constexpr int kRowsPerBand = 8;
/// An operation that takes less takes nothing [mm3]: what rounding leaves.
constexpr double kNoVolume = 0.1;

/// How far from the axis the tool or one of its bodies comes below `top` on a move.
double reachBelow(double top, const SweptMove& m, const SimulatedTool& tool)
{
  double reach = m.tool->radius();
  for (const auto& body : tool.bodies)
    if (std::min(m.a.z(), m.b.z()) + body.above < top)
      reach = std::max(reach, body.cutter.radius());
  return reach;
}

/// The stock as it is cut, band by band: what happens does not depend on the threads.
StockEvents cutAll(StockField& field,
                   const std::vector<SweptMove>& moves,
                   const StockLimits& limits,
                   std::size_t sections,
                   unsigned threads)
{
  const int count = (field.rows() + kRowsPerBand - 1) / kRowsPerBand;
  std::map<const Tool*, SimulatedTool> tools;
  for (const auto& m : moves)
    tools.try_emplace(m.tool, *m.tool, limits.tolerance);
  const Stock& stock = field.stock();
  Bands bands(stock.min.y(), kRowsPerBand * field.cellSize(), count);
  for (std::size_t k = 0; k < moves.size(); ++k) {
    const SweptMove& m = moves[k];
    bands.add(k, m.a.y(), m.b.y(), reachBelow(stock.top(), m, tools.at(m.tool)));
  }
  std::vector<StockEvents> events(static_cast<std::size_t>(count),
                                  StockEvents(sections));
  parallelFor(events.size(), threads, {0.1, 1.0}, [&](std::size_t band) {
    const int row0 = static_cast<int>(band) * kRowsPerBand;
    const int row1 = std::min(field.rows(), row0 + kRowsPerBand);
    BandCutter cutter(field, row0, row1, moves, tools, limits, sections);
    for (const auto k : bands[band]) {
      checkInterrupted();
      cutter.move(k);
    }
    cutter.end();
    events[band] = cutter.events();
  });
  StockEvents all(sections);
  for (const auto& e : events)
    all.take(e);
  return all;
}

/// The thickest layers, and which are too thick.
void judgeLayers(const StockEvents& events,
                 const std::vector<SweptMove>& moves,
                 const std::map<int, double>& limits,
                 Verification& result,
                 Findings& findings)
{
  for (std::size_t s = 0; s < events.layers.size(); ++s) {
    const auto& layer = events.layers[s];
    if (!(layer.thickness > 0))
      continue;
    const SweptMove& m = moves[layer.move];
    const int number = m.tool->number;
    result.sections[s].axial_depth = layer.thickness;
    result.sections[s].axial_line = m.line;
    double& thickest = result.axial_depth[number];
    thickest = std::max(thickest, layer.thickness);
    if (m.tool->flute_length > 0 && layer.thickness > m.tool->flute_length)
      findings.add("flute_length",
                   layer.thickness,
                   m.b,
                   m.line,
                   number,
                   1,
                   m.tool->flute_length);
    const auto limit = limits.find(number);
    if (limit != limits.end() && layer.thickness > limit->second)
      findings.add(
          "axial_depth", layer.thickness, m.b, m.line, number, 1, limit->second);
  }
}

void judgeVolumes(const StockEvents& events, Verification& result, Findings& findings)
{
  double all = 0;
  for (std::size_t s = 0; s < events.volumes.size(); ++s) {
    SectionFigures& section = result.sections[s];
    section.volume = events.volumes[s];
    all += section.volume;
    if (section.feed_moves > 0 && section.volume < kNoVolume)
      findings.add(
          "cuts_nothing", 0, Eigen::Vector3d::Zero(), section.line, section.tool);
  }
  if (all < kNoVolume)
    findings.add("empty");
}

} // namespace

void judgeStock(StockField field,
                const std::vector<SweptMove>& moves,
                const StockLimits& limits,
                unsigned threads,
                Verification& result,
                Findings& findings)
{
  const StockEvents events =
      cutAll(field, moves, limits, result.sections.size(), threads);
  for (const auto& [code, depths] : events.depths) {
    if (code == std::string("pressed_in") && events.depths.count("plunge"))
      continue; // the beginnings of what is said already
    for (const auto& [k, depth] : depths.byMove()) {
      const SweptMove& m = moves[k];
      findings.add(code.c_str(), depth, m.b, m.line, m.tool->number);
    }
  }
  const auto rapids = events.depths.find("rapid_in_stock");
  if (rapids != events.depths.end())
    for (const auto& [k, depth] : rapids->second.byMove()) {
      ++result.rapids_in_stock;
      if (depth > result.rapid_depth) {
        result.rapid_depth = depth;
        result.rapid_at = moves[k].b;
        result.rapid_line = moves[k].line;
      }
    }
  judgeLayers(events, moves, limits.axial, result, findings);
  judgeVolumes(events, result, findings);
  result.milled = field.toCloud();
}

} // namespace pointmill
