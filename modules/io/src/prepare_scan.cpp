// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "sample_faces.h"

#include <pointmill/common/error.h>
#include <pointmill/common/parameters.h>
#include <pointmill/io/scan.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pointmill {

namespace {

constexpr const char* who = "scan";
constexpr const char* absurd = "scan: its extents are not those of a part; check the "
                               "scale and the scan's coordinates";
constexpr double max_extent = 1e8; // mm, and in distances between samples

void check(const RawScan& raw,
           const ScanScale& scale,
           double density,
           std::size_t max_points)
{
  checkRange(who, "scale", scale.mm_per_unit, "mm per file unit", {1e-9, 1e9});
  if (scale.fit_mm != 0.0)
    checkRange(who, "fit", scale.fit_mm, "mm", {1e-3, 1e6});
  checkRange(who, "density", density, "points/mm^2", {1e-6, 1e6});
  checkRange(who, "max points", static_cast<double>(max_points), "", {1, 1e10});
  if (raw.points.empty())
    throw DataError("scan: it holds no points; read one first");
  for (const auto& point : raw.points)
    if (!point.allFinite())
      throw DataError("scan: a point is not finite; remove such points first");
  for (const auto& face : raw.faces)
    for (const auto corner : face)
      if (corner >= raw.points.size())
        throw DataError("scan: a face uses a vertex that does not exist; correct the "
                        "mesh");
}

} // namespace

Scan prepareScan(const RawScan& raw,
                 const ScanScale& scale,
                 double density_per_mm2,
                 std::size_t max_points,
                 std::uint32_t seed)
{
  check(raw, scale, density_per_mm2, max_points);
  Eigen::AlignedBox3d box;
  for (const auto& point : raw.points)
    box.extend(point);
  const double extent = box.sizes().maxCoeff();
  Scan scan;
  scan.format = raw.format;
  scan.vertices = raw.points.size();
  scan.faces = raw.faces.size();
  scan.non_finite = raw.non_finite;
  scan.scale = scale.fit_mm > 0.0 ? scale.fit_mm / extent : scale.mm_per_unit;
  const Eigen::Vector3d centre = box.center();
  scan.shift = centre * scan.scale;
  // NaN fails too.
  if (!(extent * scan.scale <= max_extent) || !(extent > 0.0) ||
      !scan.shift.allFinite())
    throw DataError(absurd);

  // All in double and around the origin; rounded once, at the end.
  std::vector<Eigen::Vector3d> points(raw.points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = (raw.points[i] - centre) * scan.scale;
  if (!raw.faces.empty()) {
    const double area = detail::areaOf(points, raw.faces);
    if (!(area > 0.0))
      throw DataError("scan: its faces have no area; repair the mesh or keep only its "
                      "vertices");
    const auto most = static_cast<double>(max_points);
    scan.density = std::min(density_per_mm2, most / area);
    // The grid of samples would be larger than any loop should run.
    if (extent * scan.scale * std::sqrt(scan.density) > max_extent)
      throw DataError(absurd);
    std::vector<Eigen::Vector3d> samples;
    while (
        (samples = detail::sampleFaces(points, raw.faces, scan.density, seed)).size() >
        max_points)
      scan.density *= most / static_cast<double>(samples.size() + 1);
    scan.sampled = samples.size();
    points.insert(points.end(), samples.begin(), samples.end());
  }
  scan.cloud.reset(new pcl::PointCloud<pcl::PointXYZ>);
  scan.cloud->reserve(points.size());
  for (const auto& point : points) {
    const Eigen::Vector3f p = point.cast<float>();
    scan.cloud->push_back({p.x(), p.y(), p.z()});
  }
  return scan;
}

} // namespace pointmill
