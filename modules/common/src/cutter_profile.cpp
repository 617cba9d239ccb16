// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/cutter_profile.h>

namespace pointmill {
namespace {

/// The root in [lo, hi] of the increasing f, to |f| <= tolerance: false position with
/// the Illinois rule, which halves the end that stays.
template <typename F>
double rootOf(double lo, double hi, double tolerance, F&& f)
{
  double f_lo = f(lo), f_hi = f(hi);
  if (f_lo >= 0)
    return lo;
  if (f_hi <= 0)
    return hi;
  constexpr int enough = 100; // some ten are needed
  for (int i = 0, stays = 0; i < enough; ++i) {
    const double x = lo + (hi - lo) * (f_lo / (f_lo - f_hi)), y = f(x);
    if (std::abs(y) <= tolerance || x <= lo || x >= hi)
      return x;
    if (y < 0) {
      lo = x, f_lo = y;
      f_hi *= stays < 0 ? 0.5 : 1.0;
      stays = -1;
    }
    else {
      hi = x, f_hi = y;
      f_lo *= stays > 0 ? 0.5 : 1.0;
      stays = 1;
    }
  }
  return 0.5 * (lo + hi);
}

/// ahead() where the place is passed by a rounding of radius `round` whose centre runs
/// at radius `centre` round the axis and which reaches out to `last`.
double aheadOnRounding(double centre,
                       double round,
                       double last,
                       double off,
                       double fall,
                       double lo,
                       double hi)
{
  if (round <= 0) { // an edge
    const double edge = std::max(centre, off);
    return std::clamp(std::sqrt(edge * edge - off * off), lo, hi);
  }
  if (centre <= 0) { // a ball: the tilted great circle along the track
    const double on = std::max(0.0, round * round - off * off);
    return std::clamp(fall * std::sqrt(on / (1 + fall * fall)), lo, hi);
  }
  // A torus has no closed form. At the angle w of its rounding, sin w = s, the sum is
  // stationary where tan(w) ahead / r = fall. Short moves mostly rise or fall all
  // along.
  const auto rise = [&](double a) {
    const double r = std::sqrt(off * off + a * a), u = std::max(0.0, r - centre);
    return u * a - fall * r * std::sqrt(std::max(0.0, round * round - u * u));
  };
  if (rise(hi) <= 0)
    return hi;
  if (rise(lo) >= 0)
    return lo;
  // With t = tan(w / 2) all is rational.
  const auto halfTangent = [&](double a) {
    const double r = std::clamp(std::sqrt(off * off + a * a), centre, last);
    const double s = std::min(1.0, (r - centre) / round);
    return s / (1 + std::sqrt(1 - s * s));
  };
  const auto radiusAt = [&](double t) { return centre + round * 2 * t / (1 + t * t); };
  const auto aheadAt = [&](double r) {
    return std::sqrt(std::max(0.0, r * r - off * off));
  };
  const double t = rootOf(halfTangent(std::max(0.0, lo)),
                          halfTangent(hi),
                          1e-9 * (centre + round) * std::min(1.0, fall),
                          [&](double x) {
                            const double r = radiusAt(x);
                            return 2 * x * aheadAt(r) - fall * (1 - x * x) * r;
                          });
  return std::clamp(aheadAt(radiusAt(t)), lo, hi);
}

} // namespace

CutterProfile::CutterProfile(
    double radius, double flat, double corner, double taper, double shoulder)
    : radius_(radius), flat_(flat), corner_(corner), shoulder_(shoulder),
      sin_(std::sin(taper * M_PI / 180)), cos_(std::cos(taper * M_PI / 180)),
      cone_first_(flat + corner * cos_), cone_last_(radius - shoulder * (1 - cos_)),
      shoulder_height_(corner +
                       ((radius - shoulder - flat) * cos_ - corner + shoulder) / sin_)
{
}

double CutterProfile::steepness(double r) const
{
  const double u = r - flat_;
  if (u <= 0.0)
    return 0.0;
  if (r <= cone_first_ || sin_ == 0.0)
    return corner_ > 0 ? std::min(1.0, u / corner_) : 0.0;
  if (r <= cone_last_ || shoulder_ <= 0)
    return cos_;
  return std::min(1.0, (r - (radius_ - shoulder_)) / shoulder_);
}

double CutterProfile::depth(double r, double z) const
{
  const auto length = [](double x, double y) { return std::sqrt(x * x + y * y); };
  // Signed distance to the disc and its cone, from their common edge.
  const double u = r - flat_, w = z - corner_;
  const double across = u * cos_ - w * sin_, up = u * sin_ + w * cos_;
  const double core = u > 0 && up < 0 ? length(u, w) : std::max(across, -w);
  // Sunk by the shoulder's radius, the cone meets the shank in a sharp edge.
  const double side = r - (radius_ - shoulder_), over = z - shoulder_height_;
  if (side > 0 && over < 0 && side * sin_ + over * cos_ > 0)
    return shoulder_ - length(side, over);
  return std::min(corner_ - core, radius_ - r);
}

double CutterProfile::ahead(double off, double fall, double lo, double hi) const
{
  if (sin_ > 0) {
    // The cone climbs by cos / sin per mm of r, and r by ahead / r per mm of track.
    const double share = fall * sin_ / cos_;
    const double r = share < 1 ? off / std::sqrt(1 - share * share)
                               : std::numeric_limits<double>::infinity();
    if (r > cone_last_)
      return aheadOnRounding(
          radius_ - shoulder_, shoulder_, radius_, off, fall, lo, hi);
    if (r >= cone_first_)
      return std::clamp(share * r, lo, hi);
  }
  return aheadOnRounding(flat_, corner_, cone_first_, off, fall, lo, hi);
}

} // namespace pointmill
