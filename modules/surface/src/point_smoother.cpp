// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/surface/patch.h>
#include <pointmill/surface/point_smoother.h>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

/// A surface fits when its points deviate by no more than the noise, allowing for what
/// the estimate of a few dozen points may err.
constexpr double kFits = 1.25;
/// Each neighbourhood that is tried has this share of the points of the one before.
constexpr int kShrink = 3;
constexpr int kFewest = 16;
/// A few points further than this many deviations from a fit are not of the surface.
constexpr double kStray = 3.0, kMostStrays = 0.1;
/// Of places that are noisier than the scan at large by no more than this.
constexpr double kNoisier = 2.0;
constexpr int kSides = 8;
/// A one-sided fit that takes off less than half of the variance is not worth its risk.
constexpr double kMostVariance = 0.5;

/// Marks the points that are no strays; false where that leaves too few.
bool withoutStrays(const Neighbourhood& near,
                   const Patch& patch,
                   double noise,
                   std::vector<unsigned char>& keep)
{
  keep.assign(near.size(), 1);
  std::size_t strays = 0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const Eigen::Vector3d p(near.x[i], near.y[i], near.z[i]);
    const double s = p.dot(patch.tangentS()), t = p.dot(patch.tangentT());
    const double off = p.dot(patch.normal()) - patch.height(s, t);
    if (std::abs(off) > kStray * noise) {
      keep[i] = 0;
      ++strays;
    }
  }
  return strays > 0 && double(strays) <= kMostStrays * double(near.size());
}

Smoothed onto(const Patch& patch, Smoothed::How how, const MostMoved& most)
{
  const double along = patch.height(0, 0);
  const double allowed = std::clamp(along, -most.down, most.up);
  Smoothed s;
  s.held = allowed != along;
  s.place = patch.origin() + allowed * patch.normal();
  s.variance = patch.variance();
  s.how = how;
  return s;
}

/// A quadric for the neighbours on one side of the point, whichever side it fits best;
/// false where none fits.
bool fitOneSide(const Neighbourhood& near, double fits, Patch& best)
{
  static thread_local std::vector<unsigned char> keep;
  const Eigen::Vector3d normal = near.planeNormal();
  Patch patch;
  if (!patch.fit(near, normal))
    return false;
  const Eigen::Vector3d s = patch.tangentS(), t = patch.tangentT();
  double least = fits;
  for (int side = 0; side < kSides; ++side) {
    const double angle = 2 * M_PI * side / kSides;
    const Eigen::Vector3d aside = std::cos(angle) * s + std::sin(angle) * t;
    keep.assign(near.size(), 0);
    for (std::size_t i = 0; i < near.size(); ++i)
      keep[i] =
          near.x[i] * aside.x() + near.y[i] * aside.y() + near.z[i] * aside.z() >= 0;
    if (patch.fit(near, normal, &keep) && patch.residual() < least &&
        patch.variance() <= kMostVariance) {
      least = patch.residual();
      best = patch;
    }
  }
  return least < fits;
}

} // namespace

Smoothed smoothPoint(const PointIndex& points,
                     const Eigen::Vector3d& point,
                     double noise,
                     int neighbours,
                     const MostMoved& most)
{
  static thread_local Neighbourhood near;
  static thread_local std::vector<unsigned char> keep;
  static thread_local std::vector<Patch> patches; // from wide to narrow
  const double fits = kFits * noise;
  patches.clear();
  for (int wanted = neighbours; wanted >= kFewest; wanted /= kShrink) {
    near.gather(points, point, static_cast<std::size_t>(wanted));
    Patch patch;
    if (!patch.fit(near, near.planeNormal()))
      break;
    if (patch.residual() > fits && withoutStrays(near, patch, fits, keep) &&
        !patch.fit(near, patch.normal(), &keep))
      break;
    if (patch.residual() <= fits && patch.variance() < 1)
      return onto(patch, Smoothed::How::Surface, most);
    patches.push_back(patch);
  }
  near.gather(points, point, static_cast<std::size_t>(neighbours));
  Patch side;
  if (fitOneSide(near, fits, side))
    return onto(side, Smoothed::How::Edge, most);
  // No edge: the scan is noisier here, if wide fits are no worse than the narrowest.
  if (!patches.empty() && patches.back().residual() <= kNoisier * noise)
    for (const auto& patch : patches)
      if (patch.residual() <= kFits * patches.back().residual() && patch.variance() < 1)
        return onto(patch, Smoothed::How::Surface, most);
  return {point};
}

template class PointSmoother<pcl::PointXYZ>;
template class PointSmoother<pcl::PointXYZI>;
template class PointSmoother<pcl::PointXYZRGB>;
template class PointSmoother<pcl::PointXYZRGBA>;
template class PointSmoother<pcl::PointNormal>;

} // namespace pointmill
