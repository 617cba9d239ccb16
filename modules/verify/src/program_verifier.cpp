// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "moves.h"

#include <pointmill/common/error.h>
#include <pointmill/common/parameters.h>
#include <pointmill/common/watch.h>
#include <pointmill/surface/raw_stock.h>

#include <cmath>
#include <set>

namespace pointmill {
namespace {
// What the points and the stock are of the work.
constexpr double kPointsShare = 0.7, kStockBegins = 0.75;
} // namespace

pcl::PointCloud<pcl::PointXYZI> Verification::deviationsInReach() const
{
  pcl::PointCloud<pcl::PointXYZI> reached;
  for (std::size_t i = 0; i < deviations.size(); ++i)
    if (in_reach[i])
      reached.push_back(deviations[i]);
  return reached;
}

double Verification::shareWithin(double tolerance) const
{
  std::size_t all = 0, within = 0;
  for (std::size_t i = 0; i < deviations.size(); ++i) {
    const double off = std::abs(double(deviations[i].intensity));
    if (!in_reach[i] || std::isnan(off))
      continue;
    ++all;
    within += off <= tolerance;
  }
  return all > 0 ? double(within) / double(all) : 0.0;
}

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

  machine_.validate();

  Verification result;
  Findings findings;
  const double safe = std::max(stock_.top(), keep_out_.highestTop());
  const auto moves = collectMoves(
      program, tools_, {stock_, machine_, safe, tolerance_}, result, findings);
  {
    const WorkStep step({0.0, kPointsShare});
    judgePoints(model_ ? *model_ : *part_,
                model_ ? part_.get() : nullptr,
                moves,
                {tolerance_, noise_allowance_, floor_},
                keep_out_,
                threads_,
                result,
                findings);
  }
  const PointIndex& part = model_ ? *model_ : *part_;
  {
    const WorkStep step({kPointsShare, kStockBegins});
    judgeBends(part, moves, tolerance_, threads_, findings);
    judgeBodies(part, moves, tolerance_, threads_, findings);
    if (protected_) {
      std::vector<float> height;
      const Gouges gouges =
          sweepPoints(*protected_, moves, tolerance_, threads_, height);
      if (gouges.count > 0)
        findings.add(
            "gap", gouges.depth, gouges.at, gouges.line, gouges.tool, gouges.count);
    }
    const double blend = program.blend < 0 ? std::numeric_limits<double>::infinity()
                                           : program.blend + program.merge;
    if (blend > blend_limit_)
      findings.add("blend", blend, Eigen::Vector3d::Zero(), 0, 0);
    judgeKeepOut(keep_out_, moves, tolerance_, threads_, result, findings);
  }
  const WorkStep stock_step({kStockBegins, 1.0});
  judgeStock(raw_
                 ? stockOf(stock_, cell_, StockField::Bound::Nominal, *raw_, raw_reach_)
                 : StockField(stock_, cell_, StockField::Bound::Nominal),
             moves,
             {tolerance_, std::tan(ramp_limit_ * M_PI / 180), axial_limits_},
             threads_,
             result,
             findings);
  if (result.residual.p50 > residual_limit_)
    findings.add("residual", result.residual.p50, Eigen::Vector3d::Zero(), 0, 0);
  if (result.residual.p90 > 2 * expected_residual_ + tolerance_)
    findings.add("leaves_more",
                 result.residual.p90 - expected_residual_,
                 Eigen::Vector3d::Zero(),
                 0,
                 0);
  result.findings = findings.list();
  return result;
}

} // namespace pointmill
