// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "row.h"

namespace pointmill {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Passes end this near to where the tool ceases to touch [mm].
constexpr double kRim = 0.01;

/// Rows and stations keep this share of the radius inside the farthest place at which
/// the tool could touch: there it would graze single points.
constexpr double kGraze = 0.05;

/// The tip stays so much higher over zones: what is done to a path later may lower it
/// by its tolerances [mm].
constexpr double kOverZone = 0.02;

Span farthest(const SurfaceModel& surface, const Vector2d& axis, double reach)
{
  const auto& points = surface.points();
  const Span part = RowFrame::extent(axis, points.min(), points.max());
  return {part.first - reach, part.last + reach};
}

Span both(const Span& a, const Span& b)
{
  return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

} // namespace

RowFrame::RowFrame(double degrees)
{
  // The axes themselves must come out exactly.
  const double quarters = degrees / 90, whole = std::round(quarters);
  const double radians = (quarters - whole) * M_PI / 2;
  const double c = std::cos(radians), s = std::sin(radians);
  switch (static_cast<int>(whole) & 3) {
  case 0:
    along = {c, s};
    break;
  case 1:
    along = {-s, c};
    break;
  case 2:
    along = {-c, -s};
    break;
  default:
    along = {s, -c};
  }
  across = {-along.y(), along.x()};
}

Span RowFrame::extent(const Vector2d& axis, const Vector3d& low, const Vector3d& high)
{
  const double x0 = low.x() * axis.x(), x1 = high.x() * axis.x();
  const double y0 = low.y() * axis.y(), y1 = high.y() * axis.y();
  return {std::min(x0, x1) + std::min(y0, y1), std::max(x0, x1) + std::max(y0, y1)};
}

RowMaker::RowMaker(const SurfaceModel& surface, const Raster& raster, double degrees)
    : surface_(surface), grown_(raster.tool.grown(raster.allowance)),
      allowance_(raster.allowance), floor_(raster.floor), boundary_(raster.boundary),
      keep_out_(raster.keep_out), cutter_(raster.tool.profile()), frame_(degrees),
      width_(farthest(surface, frame_.across, (1 - kGraze) * grown_.radius())),
      stations_(0, 0, raster.forward_step)
{
  Span length = farthest(surface, frame_.along, (1 - kGraze) * grown_.radius());
  if (!boundary_.everywhere()) {
    width_ = both(width_, boundary_.extent(frame_.across));
    length = both(length, boundary_.extent(frame_.along));
  }
  stations_ = Places(length.first, length.last, raster.forward_step);
}

Station RowMaker::stationOf(double u, double v, const Contact& contact) const
{
  if (!contact.touches())
    return {floor_, 0.f, 0.f, false};
  const Vector2d at = frame_.xy(u, v);
  const Vector3d n = contactNormal(grown_, at.x(), at.y(), contact);
  const double tip = std::max(contact.tip + allowance_, floor_);
  const bool clear =
      keep_out_.empty() || tip >= keep_out_.lowest(cutter_, at.x(), at.y()) + kOverZone;
  return {tip, static_cast<float>(n.x()), static_cast<float>(n.y()), clear, !clear};
}

Station RowMaker::dropAt(double u, double v) const
{
  const Vector2d at = frame_.xy(u, v);
  return stationOf(u, v, surface_.drop(grown_, at.x(), at.y()));
}

Row RowMaker::drop(double v, Stretch stretch) const
{
  std::vector<Contact> contacts(stretch.last - stretch.first + 1);
  surface_.dropRow(grown_,
                   frame_.xy(stations_[stretch.first], v),
                   stations_.step * frame_.along,
                   contacts.size(),
                   contacts.data());
  Row row{v, stretch.first, {}};
  row.stations.reserve(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i)
    row.stations.push_back(stationOf(stations_[stretch.first + i], v, contacts[i]));
  return row;
}

std::vector<Stretch> RowMaker::within(double v, Stretch stretch) const
{
  if (boundary_.everywhere())
    return {stretch};
  std::vector<Stretch> parts;
  for (const Span& inside : boundary_.inside(v * frame_.across, frame_.along)) {
    const auto first = static_cast<double>(stretch.first);
    const auto last = static_cast<double>(stretch.last);
    const double from = std::floor((inside.first - stations_.low) / stations_.step);
    const double to = std::ceil((inside.last - stations_.low) / stations_.step);
    if (to < first || from > last)
      continue;
    const Stretch s{static_cast<std::size_t>(std::max(first, from)),
                    static_cast<std::size_t>(std::min(last, to))};
    if (!parts.empty() && s.first <= parts.back().last)
      parts.back().last = s.last;
    else
      parts.push_back(s);
  }
  return parts;
}

// Whether the tool keeps out of all zones on the whole of the curve between two places,
// which has more CL points later. The curve is no lower than the arc of any one contact
// (see ChordRefiner), and that is lowest at an end; where this does not prove it, each
// half may.
bool RowMaker::clear(double u0, double u1, double v) const
{
  const Vector2d a = frame_.xy(u0, v), b = frame_.xy(u1, v);
  const double zone = keep_out_.lowestAlong(cutter_, a.x(), a.y(), b.x(), b.y());
  if (std::isinf(zone))
    return true;
  double curve = floor_;
  for (const Vector2d& at : {a, b}) {
    const Contact contact = surface_.drop(grown_, at.x(), at.y());
    if (!contact.touches())
      continue;
    const auto arc = [&](const Vector2d& xy) {
      return contact.at.z() - grown_.profile((contact.at.head<2>() - xy).norm()) +
             allowance_;
    };
    curve = std::max(curve, std::min(arc(a), arc(b)));
  }
  if (curve >= zone + kOverZone)
    return true;
  const double middle = 0.5 * (u0 + u1);
  return std::abs(u1 - u0) > kRim && clear(u0, middle, v) && clear(middle, u1, v);
}

// The chord between the two places and the curve.
bool RowMaker::clear(const Place& a, const Place& b, double v) const
{
  if (keep_out_.empty())
    return true;
  const auto tip = [&](const Place& place) {
    const Vector2d at = frame_.xy(place.u, v);
    return Vector3d(at.x(), at.y(), place.station.tip);
  };
  return keep_out_.depth(cutter_, tip(a), tip(b)) <= 0 && clear(a.u, b.u, v);
}

// The last place that touches on the way from one that does to one that does not.
RowMaker::Place RowMaker::rim(Place touching, double apart, double v) const
{
  while (std::abs(apart - touching.u) > kRim) {
    const double middle = 0.5 * (touching.u + apart);
    const Station there = dropAt(middle, v);
    if (there.touches)
      touching = {middle, there};
    else
      apart = middle;
  }
  return touching;
}

void RowMaker::add(const Place& place, double v, CLCloud& path) const
{
  const Vector2d at = frame_.xy(place.u, v);
  PointCL p(at.x(), at.y(), place.station.tip);
  const double nx = place.station.nx, ny = place.station.ny;
  p.normal_x = place.station.nx;
  p.normal_y = place.station.ny;
  p.normal_z = static_cast<float>(std::sqrt(std::max(0.0, 1 - nx * nx - ny * ny)));
  path.push_back(p);
}

double RowMaker::cut(const Row& row, Stretch stretch, std::vector<Pass>& passes) const
{
  double kept_out = 0;
  const Span whole{stations_[stretch.first], stations_[stretch.last]};
  std::vector<Span> spans{whole};
  if (!boundary_.everywhere())
    spans = boundary_.inside(row.v * frame_.across, frame_.along);
  for (const Span& inside : spans) {
    const Span span = both(inside, whole);
    if (span.first > span.last)
      continue;
    std::vector<Place> places;
    if (inside.first > whole.first)
      places.push_back({span.first, dropAt(span.first, row.v)});
    for (std::size_t i = stretch.first; i <= stretch.last; ++i) {
      const double u = stations_[i];
      if (u >= span.first && u <= span.last && (places.empty() || u > places.back().u))
        places.push_back({u, row[i]});
    }
    if (inside.last < whole.last && (places.empty() || span.last > places.back().u))
      places.push_back({span.last, dropAt(span.last, row.v)});

    const auto addRim = [&](const Place& here, double apart) {
      const Place end = rim(here, apart, row.v);
      if (end.u != here.u && clear(here, end, row.v))
        add(end, row.v, passes.back().path);
    };
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Place& here = places[i];
      if (here.station.kept_out && i > 0)
        kept_out += here.u - places[i - 1].u;
      if (!here.station.touches)
        continue;
      if (i == 0 || !places[i - 1].station.touches) {
        passes.push_back({row.v, {}});
        if (i > 0)
          addRim(here, places[i - 1].u);
      }
      else if (!clear(places[i - 1], here, row.v))
        passes.push_back({row.v, {}});
      add(here, row.v, passes.back().path);
      if (i + 1 < places.size() && !places[i + 1].station.touches)
        addRim(here, places[i + 1].u);
    }
  }
  return kept_out;
}

} // namespace pointmill
