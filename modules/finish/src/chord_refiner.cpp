// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/finish/chord_refiner.h>

#include <algorithm>
#include <cmath>

namespace pointmill {

using Eigen::Vector3d;

namespace {

/// Stretches of this share of a chord are as good as nothing: a leap is in them.
constexpr double kShortest = 1.0 / 1024;

/// A coordinate as float32 will hold it: beside a wall the curve is too steep to be
/// asked elsewhere. Volatile, since GCC 12 drops the two conversions where it turns
/// them into vectors.
double stored(double coordinate)
{
  const volatile float single = static_cast<float>(coordinate);
  return single;
}

} // namespace

Contact ChordRefiner::rest(double x, double y) const
{
  Contact contact = surface_.drop(grown_, x, y);
  contact.tip += allowance_;
  if (!(contact.tip > floor_))
    contact = {floor_, -1, {x, y, floor_}};
  return contact;
}

// Every point near the chord is tried: a leap between two harmless ends does not hide.
bool ChordRefiner::cutsIn(const Vector3d& a, const Vector3d& b) const
{
  const Vector3d down(0, 0, allowance_);
  return surface_.points().gouge(grown_, a - down, b - down, band_.inside) > 0;
}

bool ChordRefiner::followsCurve(const Vector3d& a, const Vector3d& b) const
{
  const double length = (b - a).head<2>().norm();
  const double steepness = std::hypot(length, b.z() - a.z()) / length;
  // The band as the step error of paper 000, P_i.z - P_d.z: across the chord.
  const double high = band_.outside * steepness, low = band_.inside * steepness;
  // The arc of one contact, or the floor: either alone is concave, the higher of both
  // is not.
  const auto arc = [&](double t, const Contact& contact) {
    if (!contact.touches())
      return floor_;
    const double d = (contact.at - (a + t * (b - a))).head<2>().norm();
    return contact.at.z() - grown_.profile(d) + allowance_;
  };
  const auto near = [&](double t, const Contact& contact) {
    return a.z() + t * (b.z() - a.z()) - arc(t, contact) <= high;
  };
  double from = 0, to = 1; // the stretch in hand; to the right, 2^k wide ones wait
  while (from < 1) {
    const double middle = 0.5 * (from + to);
    const Vector3d p = a + middle * (b - a);
    const Contact contact = rest(p.x(), p.y());
    const double error = p.z() - contact.tip;
    if (error > high || error < -low)
      return false;
    const bool proven = near(from, contact) && near(to, contact);
    if (!proven && to - from > kShortest) {
      to = middle;
      continue;
    }
    // On to the next one: the widest that begins here and is aligned to its width.
    double width = to - from;
    from = to;
    while (width < 1 && std::fmod(from, 2 * width) == 0)
      width *= 2;
    to = std::min(1.0, from + width);
  }
  return true;
}

bool ChordRefiner::holds(const Vector3d& a, const Vector3d& b) const
{
  if ((b - a).head<2>().norm() <= 1e-9)
    return true; // straight up or down between two clear places
  return !cutsIn(a, b) && followsCurve(a, b);
}

Vector3d ChordRefiner::normalAt(double x, double y, const Contact& contact) const
{
  return contactNormal(grown_, x, y, contact);
}

void ChordRefiner::leap(const Vector3d& a,
                        const CurvePoint& b,
                        std::vector<CurvePoint>& path)
{
  const Vector3d& to = b.tip;
  const double clear =
      surface_.points().dropAlong(grown_, a.x(), a.y(), to.x(), to.y()) + allowance_;
  const double z = std::max({a.z(), to.z(), clear});
  if (z > a.z())
    path.push_back({{a.x(), a.y(), z}, normalAt(a.x(), a.y(), rest(a.x(), a.y()))});
  path.push_back({{to.x(), to.y(), z}, b.normal});
  if (z > to.z())
    path.push_back(b);
  ++leaps_;
}

void ChordRefiner::refine(const Vector3d& a,
                          const CurvePoint& b,
                          std::vector<CurvePoint>& path)
{
  const double length = (b.tip - a).head<2>().norm();
  if (length <= shortest_) {
    if (length > 1e-9 && cutsIn(a, b.tip))
      leap(a, b, path);
    else
      path.push_back(b);
    return;
  }
  if (holds(a, b.tip)) {
    path.push_back(b);
    return;
  }
  const double x = stored(0.5 * (a.x() + b.tip.x()));
  const double y = stored(0.5 * (a.y() + b.tip.y()));
  const Contact contact = rest(x, y);
  const CurvePoint between{{x, y, contact.tip}, normalAt(x, y, contact)};
  refine(a, between, path);
  refine(between.tip, b, path);
}

} // namespace pointmill
