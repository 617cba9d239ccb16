// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pointmill {

/// @brief A scan as its file holds it: double precision, file units, nothing rounded.
struct RawScan {
  /// @brief The finite points in file order; a mesh's vertices where there are faces.
  std::vector<Eigen::Vector3d> points;
  /// @brief Triangles of indices into `points` (polygons fanned, strips unrolled);
  /// empty for a cloud.
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::size_t non_finite = 0; ///< points dropped, with the faces that used them
  std::string format;         ///< "PCD", "PLY", "OBJ", "STL" or "text"
};

/// @brief Reads a `.pcd`, `.ply`, `.obj`, `.stl`, `.xyz`, `.asc`, `.txt`, `.csv` or
/// `.pts` file, in any variant of these; the extension, in any case, decides.
///
/// Text files hold `x y z [anything]` per line, separated by blanks, commas or
/// semicolons; `#` and `//` begin comments. One line of column names may come first and
/// then tells which columns are x, y and z; so may a line with the number of points.
///
/// @throws DataError in one line that names the file, what is wrong and what to do: it
/// is missing, empty, cut short, malformed, or holds fewer than 10 finite points (3
/// vertices for a mesh), or only points on a line along an axis
RawScan readScan(const std::string& path);

} // namespace pointmill
