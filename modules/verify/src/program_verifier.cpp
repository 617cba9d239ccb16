// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "moves.h"

#include <pointmill/common/error.h>
#include <pointmill/common/parameters.h>
#include <pointmill/surface/raw_stock.h>

#include <cstdio>
#include <set>

namespace pointmill {
namespace {

std::string millimetres(double length)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3f mm", length);
  return text;
}

} // namespace

Verification ProgramVerifier::verify(const Program& program) const
{
  validateParameters(*this, "ProgramVerifier");
  if (!part_)
    throw DataError("ProgramVerifier: the part's points were not given (setPart)");
  std::set<int> numbers;
  for (const auto& tool : tools_) {
    tool.validate();
    if (!numbers.insert(tool.number).second)
      throw ParameterError("ProgramVerifier: two tools have the number " +
                           std::to_string(tool.number));
  }

  Verification result;
  const double safe = std::max(stock_.top(), keep_out_.highestTop());
  const auto moves = collectMoves(program, tools_, stock_, safe, result);
  judgePoints(model_ ? *model_ : *part_,
              model_ ? part_.get() : nullptr,
              moves,
              {tolerance_, noise_allowance_, floor_},
              keep_out_,
              threads_,
              result);
  if (protected_) {
    std::vector<float> height;
    const Gouges gouges = sweepPoints(*protected_, moves, tolerance_, threads_, height);
    if (gouges.count > 0)
      result.findings.push_back({"gap",
                                 "the bridge over a gap of the scan is cut into, " +
                                     millimetres(gouges.depth) + " deep",
                                 gouges.depth,
                                 gouges.at,
                                 gouges.line});
  }
  const double blend = program.blend < 0 ? std::numeric_limits<double>::infinity()
                                         : program.blend + program.merge;
  if (blend > blend_limit_)
    result.findings.push_back({"blend",
                               "the control may round corners by more than " +
                                   millimetres(blend_limit_) + " (G64)",
                               blend,
                               {0, 0, 0},
                               0});
  judgeKeepOut(keep_out_, moves, tolerance_, threads_, result);
  judgeStock(raw_
                 ? stockOf(stock_, cell_, StockField::Bound::Nominal, *raw_, raw_reach_)
                 : StockField(stock_, cell_, StockField::Bound::Nominal),
             moves,
             tolerance_,
             threads_,
             result);

  if (result.gouged_points > 0)
    result.findings.push_back(
        {"gouge",
         std::to_string(result.gouged_points) +
             (model_ ? " points of the smoothed surface" : " points") +
             " are gouged, the deepest by " + millimetres(result.gouge),
         result.gouge,
         result.gouge_at,
         result.gouge_line});
  if (result.raw_gouged_points > 0)
    result.findings.push_back({"gouge",
                               std::to_string(result.raw_gouged_points) +
                                   " measured points are gouged beyond their noise, "
                                   "the deepest by " +
                                   millimetres(result.raw_gouge),
                               result.raw_gouge,
                               result.raw_gouge_at,
                               result.raw_gouge_line});
  if (result.keep_out_moves > 0)
    result.findings.push_back(
        {"keep_out",
         std::to_string(result.keep_out_moves) +
             " moves get into keep-out zones or their margin of " +
             millimetres(keep_out_.margin()) + ", the deepest by " +
             millimetres(result.keep_out_depth),
         result.keep_out_depth,
         result.keep_out_at,
         result.keep_out_line});
  if (result.rapids_in_stock > 0)
    result.findings.push_back({"rapid_in_stock",
                               std::to_string(result.rapids_in_stock) +
                                   " rapids run into stock, the deepest by " +
                                   millimetres(result.rapid_depth),
                               result.rapid_depth,
                               {0, 0, 0},
                               result.rapid_line});
  if (result.residual.p50 > residual_limit_)
    result.findings.push_back({"residual",
                               "half of the points keep more than " +
                                   millimetres(result.residual.p50) +
                                   " of material over what the last tool could leave",
                               result.residual.p50,
                               {0, 0, 0},
                               0});
  return result;
}

} // namespace pointmill
