// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "ramp.h"

#include <pointmill/link/link_passes.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pointmill {
namespace {

using Eigen::Vector3d;

/// Thinner stock than this over an entry or a link is swarf, not material [mm].
constexpr double kNothing = 0.05;
/// Full feed is for cuts of at most this share of the end's diameter squared, slots of
/// the papers' pitch included; beyond it the feed falls in proportion, to a tenth at
/// least.
constexpr double kMostSection = 0.1, kSlowest = 0.1;
/// A stay-down link may cut this deep into stock that no pass has taken [mm].
constexpr double kLinkDepth = 0.5;

Vector3d position(const PointCL& p)
{
  return {p.x, p.y, p.z};
}

/// Builds the path point by point: sets feeds and cuts the stock.
class Builder {
public:
  Builder(const Tool& tool,
          const Cutting& cutting,
          StockField* stock,
          StockField* nominal,
          CLCloud& path)
      : tool_(tool), cutting_(cutting), stock_(stock), nominal_(nominal), path_(path)
  {
  }

  void add(const Vector3d& to, Motion motion, const PointCL& like)
  {
    PointCL p = like;
    p.x = static_cast<float>(to.x());
    p.y = static_cast<float>(to.y());
    p.z = static_cast<float>(to.z());
    p.setMotion(motion);
    const bool feeds = motion != Motion::Rapid && motion != Motion::Retract;
    const Vector3d at = position(p);
    if (path_.empty()) {
      p.feed = 0;
      path_.push_back(p);
      return;
    }
    const Vector3d from = position(path_.back());
    if (from == at)
      return;
    if (feeds) {
      double feed = feedFor(from, at, motion);
      if (stock_)
        stock_->cut(tool_, from, at);
      if (nominal_) { // slower where the tool takes more than it should
        const double section = thickestSection(from, at);
        const double most = kMostSection * tool_.endDiameter() * tool_.endDiameter();
        const bool sideways = (at - from).head<2>().norm() > (at - from).norm() / 2;
        if (sideways && section > most)
          feed *= std::max(kSlowest, most / section);
      }
      p.feed = static_cast<float>(feed);
    }
    else
      p.feed = 0.f;
    path_.push_back(p);
  }

  const PointCL& last() const { return path_.back(); }
  bool empty() const { return path_.empty(); }

private:
  /// Cuts the nominal stock; the largest cross-section on the way [mm2], looked at
  /// piece by piece, so that a lump counts on a long move too.
  double thickestSection(const Vector3d& from, const Vector3d& to)
  {
    const double length = (to - from).norm();
    const int pieces =
        std::max(1, static_cast<int>(std::ceil(length / tool_.diameter)));
    double thickest = 0;
    Vector3d at = from;
    for (int i = 1; i <= pieces; ++i) {
      const Vector3d next = from + (to - from) * (double(i) / pieces);
      const double volume = nominal_->cut(tool_, at, next).volume;
      thickest = std::max(thickest, volume / std::max((next - at).norm(), 1e-6));
      at = next;
    }
    return thickest;
  }

  double feedFor(const Vector3d& from, const Vector3d& to, Motion motion) const
  {
    double feed = cutting_.feed;
    if (motion == Motion::LeadIn)
      return feed; // through air
    if (motion == Motion::Plunge)
      feed = cutting_.plunge_feed;
    else if (motion == Motion::Ramp)
      feed = std::min(cutting_.feed, std::max(cutting_.plunge_feed, cutting_.feed / 2));
    const double down = from.z() - to.z();
    if (down > 0) // never down faster than the plunge feed
      feed = std::min(feed, cutting_.plunge_feed * (to - from).norm() / down);
    return feed;
  }

  const Tool& tool_;
  const Cutting& cutting_;
  StockField* stock_;
  StockField* nominal_;
  CLCloud& path_;
};

} // namespace

void LinkPasses::checkParameters() const
{
  validateParameters(*this, getName());
  tool_.validate();
  checkRange(getName(), "feed", cutting_.feed, "mm/min", {1, 1e5});
  checkRange(getName(), "plunge_feed", cutting_.plunge_feed, "mm/min", {1, 1e5});
  if (stock_ && !(clearance_ > stock_->stock().top()))
    throw ParameterError("LinkPasses: the clearance plane is not above the stock");
}

void LinkPasses::apply(CLCloud& output)
{
  Builder path(tool_, cutting_, stock_.get(), nominal_.get(), output);
  std::size_t ramps = 0, plunges = 0, links = 0, retracts = 0, passes = 0, skipped = 0;

  const auto& ids = *indices_;
  for (const auto i : ids) { // before the stock is cut
    const Vector3d p = position((*input_)[i]);
    if (!p.allFinite())
      throw DataError("LinkPasses: CL point " + std::to_string(i) + " is not finite");
    if (p.z() > clearance_)
      throw DataError("LinkPasses: CL point " + std::to_string(i) +
                      " lies above the clearance plane");
  }
  std::vector<Vector3d> pass;
  for (std::size_t begin = 0; begin < ids.size();) {
    std::size_t end = begin;
    const PointCL& first = (*input_)[ids[begin]];
    pass.clear();
    for (; end < ids.size() && (*input_)[ids[end]].label == first.label; ++end) {
      pass.push_back(position((*input_)[ids[end]]));
    }
    const Vector3d start = pass.front();

    // How high the stock stands that the tool has to cut on its way down to the start.
    const double top = highest(start, start, certainRadius());
    const double lead = std::min(std::max(top, start.z()) + kNothing, clearance_);
    const bool sinks = top > start.z() + kNothing;
    if (sinks && tool_.flatRadius() > 0 &&
        rampAlong(pass, lead - start.z(), ramp_angle_, 2 * tool_.diameter).empty()) {
      ++skipped;
      begin = end;
      continue;
    }
    double stay = clearance_;
    if (!path.empty())
      stay = linkHeight(position(path.last()), start);
    if (stay < clearance_) {
      const Vector3d from = position(path.last());
      path.add({from.x(), from.y(), stay}, Motion::Link, first);
      path.add({start.x(), start.y(), stay}, Motion::Link, first);
      ++links;
    }
    else {
      if (!path.empty()) {
        const Vector3d from = position(path.last());
        path.add({from.x(), from.y(), clearance_}, Motion::Retract, first);
        ++retracts;
      }
      path.add({start.x(), start.y(), clearance_}, Motion::Rapid, first);
      // Rapids mind every splinter that may stand at the rim.
      const double down =
          std::max(highest(start, start, tool_.radius()), start.z()) + approach_;
      if (down < clearance_)
        path.add({start.x(), start.y(), down}, Motion::Rapid, first);
    }
    if (lead < path.last().z - kNothing) {
      const bool air =
          nominal_ && nominal_->highest(start.x(), start.y(), tool_.radius()) <= lead;
      path.add(
          {start.x(), start.y(), lead}, air ? Motion::LeadIn : Motion::Plunge, first);
    }
    if (top > start.z() + kNothing && path.last().z > start.z() + kNothing) {
      const double above = std::min<double>(path.last().z, lead) - start.z();
      const auto ramp = rampAlong(pass, above, ramp_angle_, 2 * tool_.diameter);
      ++(ramp.empty() ? plunges : ramps);
      for (const auto& p : ramp)
        path.add(p, Motion::Ramp, first);
    }
    path.add(start, Motion::Plunge, first);
    for (std::size_t i = 1; i < pass.size(); ++i)
      path.add(pass[i], Motion::Cut, (*input_)[ids[begin + i]]);
    ++passes;
    begin = end;
  }
  if (!path.empty()) {
    const Vector3d from = position(path.last());
    path.add({from.x(), from.y(), clearance_}, Motion::Retract, path.last());
    ++retracts;
  }
  report_.set("skipped", static_cast<double>(skipped));
  report_.set("passes", static_cast<double>(passes));
  report_.set("links", static_cast<double>(links));
  report_.set("retracts", static_cast<double>(retracts));
  report_.set("ramps", static_cast<double>(ramps));
  report_.set("plunges", static_cast<double>(plunges));
}

double LinkPasses::certainRadius() const
{
  return stock_ ? std::max(0.0, tool_.endDiameter() / 2 - 2 * stock_->cellSize()) : 0.0;
}

double LinkPasses::highest(const Vector3d& a, const Vector3d& b, double radius) const
{
  return stock_ ? stock_->highest(a.x(), a.y(), b.x(), b.y(), radius)
                : -std::numeric_limits<double>::infinity();
}

double LinkPasses::linkHeight(const Vector3d& from, const Vector3d& to) const
{
  if (!part_ || (to - from).head<2>().norm() > stay_down_)
    return clearance_;
  const double higher = std::max(from.z(), to.z());
  const double part =
      part_->dropAlong(tool_.grown(allowance_), from.x(), from.y(), to.x(), to.y());
  const double z = std::max({part + allowance_, floor_, higher});
  // Over a hill, or through stock that no pass has taken, the way round is better.
  // A thin wall at the rim is cut at the feed that befits it.
  if (z > higher + stay_down_ ||
      highest(from, to, tool_.endDiameter() / 6) > z + kLinkDepth)
    return clearance_;
  return std::min(z, clearance_);
}

PathFigures measurePath(const CLCloud& path, double rapid_rate)
{
  PathFigures figures;
  figures.cl_points = path.size();
  std::uint32_t label = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i == 0 || path[i].label != label) {
      label = path[i].label;
      ++figures.passes;
    }
    if (i == 0)
      continue;
    const double length = (position(path[i]) - position(path[i - 1])).norm();
    const Motion motion = path[i].getMotion();
    figures.retracts += motion == Motion::Retract;
    if (motion == Motion::Rapid || motion == Motion::Retract) {
      figures.rapid_length += length;
      figures.minutes += length / rapid_rate;
    }
    else {
      figures.cutting_length += length;
      figures.minutes += length / path[i].feed;
    }
  }
  return figures;
}

} // namespace pointmill
