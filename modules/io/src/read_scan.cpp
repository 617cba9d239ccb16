// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "readers.h"
#include "text.h"

#include <pointmill/common/watch.h>

#include <Eigen/Geometry>

#include <filesystem>
#include <limits>

namespace pointmill {

namespace {

using detail::Source;

constexpr std::size_t min_points = 10;
constexpr double kFileShare = 0.3; // of the time, to get the file into memory

RawScan readByExtension(const Source& source, const std::string& path)
{
  const std::string extension =
      detail::lower(std::filesystem::path(path).extension().string());
  if (extension == ".pcd")
    return detail::readPcd(source);
  if (extension == ".ply")
    return detail::readPly(source);
  if (extension == ".obj")
    return detail::readObj(source);
  if (extension == ".stl")
    return detail::readStl(source);
  for (const char* text : {".xyz", ".asc", ".txt", ".csv", ".pts"})
    if (extension == text)
      return detail::readText(source);
  source.fail("its kind is not known by its name; save the scan as .pcd, .ply, .obj, "
              ".stl, .xyz, .asc, .txt, .csv or .pts");
}

void checkFaces(const RawScan& scan, const Source& source)
{
  for (const auto& face : scan.faces)
    for (const std::uint32_t corner : face)
      if (corner >= scan.points.size())
        source.fail("a face uses vertex " + std::to_string(corner + 1ull) + " of " +
                    std::to_string(scan.points.size()) + "; export the mesh again");
}

void dropNonFinite(RawScan& scan)
{
  constexpr auto gone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> new_index(scan.faces.empty() ? 0 : scan.points.size());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const bool finite = scan.points[i].allFinite();
    if (!new_index.empty())
      new_index[i] = finite ? static_cast<std::uint32_t>(kept) : gone;
    if (finite)
      scan.points[kept++] = scan.points[i];
  }
  scan.non_finite = scan.points.size() - kept;
  if (scan.non_finite == 0)
    return;
  scan.points.resize(kept);
  std::size_t faces = 0;
  for (auto face : scan.faces) {
    for (auto& corner : face)
      corner = new_index[corner];
    if (face[0] != gone && face[1] != gone && face[2] != gone)
      scan.faces[faces++] = face;
  }
  scan.faces.resize(faces);
}

void checkSubstance(const RawScan& scan, const Source& source)
{
  const std::size_t count = scan.points.size();
  if (count + scan.non_finite == 0)
    source.fail("holds no points; export the scan again");
  if (count == 0)
    source.fail("all of its " + std::to_string(scan.non_finite) +
                " points are NaN or infinite; export the scan again");
  const std::size_t needed = scan.faces.empty() ? min_points : 3;
  if (count < needed)
    source.fail("has too few points, " + std::to_string(count) +
                " finite ones; a scan needs at least " + std::to_string(needed));
  Eigen::AlignedBox3d box;
  for (const auto& point : scan.points)
    box.extend(point);
  if ((box.sizes().array() > 0.0).count() < 2)
    source.fail("all of its points lie on one spot or line; check how it was exported");
}

} // namespace

RawScan readScan(const std::string& path)
{
  const Source source = [&] {
    const WorkStep step({0.0, kFileShare});
    return Source(path);
  }();
  RawScan scan = [&] {
    const WorkStep step({kFileShare, 1.0});
    return readByExtension(source, path);
  }();
  if (!scan.faces.empty() &&
      scan.points.size() >= std::numeric_limits<std::uint32_t>::max())
    source.fail("has more vertices than 32-bit indices count; decimate the mesh");
  checkFaces(scan, source);
  dropNonFinite(scan);
  checkSubstance(scan, source);
  return scan;
}

} // namespace pointmill
