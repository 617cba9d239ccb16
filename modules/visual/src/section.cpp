// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "section.h"

#include "cloud_extent.h"
#include "ruler.h"

#include <algorithm>
#include <cmath>

namespace pointmill::visual {

namespace {

constexpr double kDepthShare = 0.1; ///< of the width that a depth should take
constexpr double kWidest = 2.8;     ///< in radii of the tool
constexpr double kNarrowest = 10;   ///< in spacings of the points
constexpr double kSnap = 0.0872;    ///< sine of 5 deg: nearly along X is along X
constexpr double kSeen = 1e-4;      ///< mm; less is no depth
constexpr double kBesideTip = 0.1;  ///< of half the widest, seen beyond the tip
/// A dimension this near to the finding's own length is that [mm, or share of it].
constexpr double kAgrees = 0.003, kAgreesShare = 0.03;

bool isPlace(const Eigen::Vector3d& p)
{
  return p.allFinite();
}

template <typename Body>
void eachPoint(const pcl::PointCloud<pcl::PointXYZ>* part, const Body& body)
{
  if (part)
    for (const auto& p : *part)
      if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))
        body(Eigen::Vector3d(p.x, p.y, p.z));
}

SectionPlane planeAlong(int axis, const Eigen::Vector2d& place)
{
  const int other = 1 - axis;
  SectionPlane plane;
  plane.origin = Eigen::Vector2d::Zero();
  plane.origin[other] = place[other];
  plane.along = Eigen::Vector2d::Unit(axis);
  plane.axis = axis == 0 ? "X" : "Y";
  plane.where = std::string("along ") + plane.axis + " at " +
                (axis == 0 ? "Y " : "X ") + number(place[other]);
  return plane;
}

SectionPlane planeThrough(const Eigen::Vector2d& place, Eigen::Vector2d along)
{
  if (along.x() < 0)
    along = -along; // seen from the front
  const double turn = std::atan2(along.y(), along.x()) * 180 / M_PI;
  return {place,
          along,
          "from the place",
          "at " + number(std::round(turn)) + " deg to X, through X " +
              number(place.x()) + " Y " + number(place.y())};
}

} // namespace

Section::Section(const FindingScene& scene,
                 const std::optional<Grid>& milled,
                 const FindingMark& mark)
    : scene_(scene), milled_(milled), mark_(mark)
{
  findTool();
  measurePart();
  plane_ = choosePlane();
  findDimension();
  chooseWidth();
}

void Section::findTool()
{
  for (const Tool& tool : scene_.tools)
    if (tool.number == mark_.tool && mark_.tool != 0)
      tool_ = tool;
  if (!tool_)
    return;
  outline_.emplace(*tool_);
  std::vector<Eigen::Vector3d> way;
  std::copy_if(mark_.move.begin(), mark_.move.end(), std::back_inserter(way), isPlace);
  if (mark_.tip && isPlace(*mark_.tip))
    tip_ = mark_.tip;
  else if (!way.empty())
    tip_ = deepestOn(way, *outline_, *mark_.place);
}

/// Half the size of the surroundings [mm].
double Section::around() const
{
  if (tool_)
    return 0.5 * kWidest * tool_->radius();
  const Eigen::Vector3d size = scene_.stock.max - scene_.stock.min;
  if (size.head<2>().minCoeff() > 0)
    return 0.1 * size.head<2>().norm();
  const Eigen::AlignedBox3d box =
      scene_.part ? boxOf(*scene_.part) : Eigen::AlignedBox3d();
  return box.isEmpty() ? 5.0 : std::max(0.1 * box.sizes().head<2>().norm(), 1.0);
}

void Section::measurePart()
{
  const double half = std::max(around(), 1e-3);
  std::size_t count = 0;
  eachPoint(scene_.part, [&](const Eigen::Vector3d& p) {
    count += ((p - *mark_.place).head<2>().array().abs() < half).all();
  });
  if (count > 0)
    spacing_ = 2 * half / std::sqrt(std::max(static_cast<double>(count), 4.0));
  reach_ = 0.75 * spacing_;
}

/// How much the heights differ along a plane, around the place [mm].
double Section::relief(const SectionPlane& plane) const
{
  const double half = around(), middle = plane.u(mark_.place->head<2>());
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto take = [&](double z) {
    low = std::min(low, z);
    high = std::max(high, z);
  };
  eachPoint(scene_.part, [&](const Eigen::Vector3d& p) {
    if (std::abs(plane.off(p.head<2>())) < reach_ &&
        std::abs(plane.u(p.head<2>()) - middle) < half)
      take(p.z());
  });
  return high > low ? high - low : 0.0;
}

SectionPlane Section::choosePlane() const
{
  const Eigen::Vector2d place = mark_.place->head<2>();
  const SectionPlane x = planeAlong(0, place), y = planeAlong(1, place);
  if (tip_) {
    // Through the tool's axis, so that its outline and the depth in it are true.
    const Eigen::Vector2d away = place - tip_->head<2>();
    const double r = away.norm();
    if (r > 0.02 * outline_->radius()) {
      if (std::abs(away.y()) < kSnap * r)
        return x;
      if (std::abs(away.x()) < kSnap * r)
        return y;
      return planeThrough(place, away / r);
    }
  }
  return relief(y) > relief(x) ? y : x;
}

void Section::findDimension()
{
  const Eigen::Vector2d here = place();
  std::vector<Dimension> found;
  if (tip_) {
    const Eigen::Vector3d away = *mark_.place - *tip_;
    const double r = away.head<2>().norm(), depth = outline_->depth(r, away.z());
    if (depth > kSeen) {
      const Eigen::Vector2d near = outline_->nearest(r, away.z());
      const double side = here.x() < plane_.u(tip_->head<2>()) ? -1 : 1;
      const Eigen::Vector2d to = {here.x() + side * (near.x() - r),
                                  tip_->z() + near.y()};
      found.push_back({here, to, depth});
      const double lower = tip_->z() + outline_->lower(r);
      if (std::isfinite(lower) && here.y() - lower > kSeen)
        found.push_back({here, {here.x(), lower}, here.y() - lower});
    }
  }
  const double milled = milledAt(here.x());
  if (std::abs(milled - here.y()) > kSeen)
    found.push_back({here, {here.x(), milled}, std::abs(milled - here.y())});
  // Measured as the finding does: straight down or along the normal.
  const auto unlike = [&](const Dimension& d) {
    return mark_.worst > 0 ? std::abs(d.length - mark_.worst) : 0.0;
  };
  const auto best = std::min_element(
      found.begin(), found.end(), [&](const Dimension& a, const Dimension& b) {
        return unlike(a) < unlike(b);
      });
  // Where it was no depth at the place, or in stock that is gone by now, any other
  // length would be taken for it.
  if (best != found.end() &&
      unlike(*best) <= std::max(kAgrees, kAgreesShare * mark_.worst))
    dimension_ = *best;
}

void Section::chooseWidth()
{
  const double widest = 2 * around();
  width_ = widest;
  if (dimension_) {
    const double depth = dimension_->length;
    const double narrowest = std::min(kNarrowest * spacing_, widest);
    width_ = std::max(std::clamp(depth / kDepthShare, narrowest, widest), 2.5 * depth);
  }
  // The end of the tool belongs to it, unless it is far below.
  const double drop = tip_ ? mark_.place->z() - tip_->z() : 0.0;
  const double beside =
      tip_ ? std::abs(plane_.u(tip_->head<2>()) - place().x()) + kBesideTip * around()
           : 0.0;
  const double needed = std::max(drop / kDropShare / kHeightShare, 2 * beside);
  if (drop > 0 && needed <= widest) {
    width_ = std::max(width_, needed);
    drop_ = drop;
  }
}

std::vector<Section::Point> Section::points(const Eigen::AlignedBox2d& box) const
{
  std::vector<Point> found;
  eachPoint(scene_.part, [&](const Eigen::Vector3d& p) {
    const Eigen::Vector2d xy = p.head<2>(), here = at(p);
    if (std::abs(plane_.off(xy)) > reach_ || !box.contains(here))
      return;
    bool inside = false;
    if (tip_) {
      const Eigen::Vector3d away = p - *tip_;
      inside = outline_->depth(away.head<2>().norm(), away.z()) > kSeen;
    }
    found.push_back({here, inside});
  });
  return found;
}

double Section::milledAt(double u) const
{
  if (!milled_)
    return std::numeric_limits<double>::quiet_NaN();
  const Grid& grid = *milled_;
  const Eigen::Vector2d p = plane_.xy(u);
  const double x = (p.x() - grid.x(0)) / grid.stepX();
  const double y = (p.y() - grid.y(0)) / grid.stepY();
  const int c = static_cast<int>(std::floor(x)), r = static_cast<int>(std::floor(y));
  const double a = x - c, b = y - r;
  const double z = (1 - b) * ((1 - a) * grid.z(c, r) + a * grid.z(c + 1, r)) +
                   b * ((1 - a) * grid.z(c, r + 1) + a * grid.z(c + 1, r + 1));
  // Beside a hole and at the rim the cell itself.
  return std::isfinite(z) ? z
                          : grid.z(static_cast<int>(std::floor(x + 0.5)),
                                   static_cast<int>(std::floor(y + 0.5)));
}

/// Distance of a place of the plane from the tool's axis.
double Section::radiusAt(double u) const
{
  return (plane_.xy(u) - tip_->head<2>()).norm();
}

double Section::toolDepth(double u, double z) const
{
  return tip_ ? outline_->depth(radiusAt(u), z - tip_->z())
              : -std::numeric_limits<double>::infinity();
}

ToolOutline::Body Section::toolAt(double u, double z) const
{
  return tip_ ? outline_->at(radiusAt(u), z - tip_->z()) : ToolOutline::Body::None;
}

std::optional<Eigen::AlignedBox2d> Section::stock() const
{
  const Stock& stock = scene_.stock;
  if (!((stock.max - stock.min).array() > 0).all())
    return std::nullopt;
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  for (int axis = 0; axis < 2; ++axis) {
    const double from = plane_.origin[axis], slope = plane_.along[axis];
    if (std::abs(slope) < 1e-9) {
      if (from < stock.min[axis] || from > stock.max[axis])
        return std::nullopt;
      continue;
    }
    const double a = (stock.min[axis] - from) / slope;
    const double b = (stock.max[axis] - from) / slope;
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  if (low >= high)
    return std::nullopt;
  return Eigen::AlignedBox2d(Eigen::Vector2d(low, stock.min.z()),
                             Eigen::Vector2d(high, stock.max.z()));
}

} // namespace pointmill::visual
