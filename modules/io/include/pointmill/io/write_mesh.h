// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/point_types.h>

#include <pcl/PolygonMesh.h>

#include <cstddef>
#include <string>

namespace pointmill {

/// @brief A height field as a closed solid [mm], such as the milled part, of triangles
/// that are seen counter-clockwise from outside.
///
/// Every cell is a square of four triangles round its centre, which has the cell's
/// height; a corner has the mean height of the cells that meet there. So the surface is
/// exact at the centres, a step is as wide as a cell, and the volume is the sum of the
/// cells' columns. Cells without a height (NaN), or with one not above @p bottom, are
/// no material. Cells that meet at a corner only do not share it, so that each edge has
/// two triangles; in an STL file, which knows no shared points, theirs looks like one
/// of four.
///
/// A field of more than @p max_cells is thinned: blocks of n x n cells become one cell
/// as high as the highest of them, and no material only where none of them is. Centres
/// are then too high by no more than the field rises within a block, never too low; the
/// outline is out by less than n cells. A cell takes 6 triangles: about 115 bytes in a
/// PLY and 300 in an STL file.
/// @throws ParameterError where @p bottom is not finite or @p max_cells is 0; DataError
/// where the field is not organised, of at least 2 x 2 cells, has an infinite height,
/// or nothing above @p bottom
pcl::PolygonMesh
solidOf(const CellCloud& field, double bottom, std::size_t max_cells = 250000);

/// @brief Writes triangles as a binary `.ply` or `.stl` file, see
/// writeFileAtomically(); the extension, in any case, decides. PLY keeps the shared
/// vertices, STL repeats them and has the triangles' normals.
/// @throws DataError for another extension, a mesh that is empty or holds a polygon of
/// more than three corners or with none of its points, or where it cannot be written
void writeMesh(const std::string& path, const pcl::PolygonMesh& mesh);

/// @brief Writes solidOf() the field.
inline void writeMesh(const std::string& path,
                      const CellCloud& field,
                      double bottom,
                      std::size_t max_cells = 250000)
{
  writeMesh(path, solidOf(field, bottom, max_cells));
}

} // namespace pointmill
