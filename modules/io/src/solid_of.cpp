// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/error.h>
#include <pointmill/io/write_mesh.h>

#include <pcl/conversions.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pointmill {

namespace {

/// The geometry of an organised cloud of cells, lowest X and Y first.
struct Lattice {
  explicit Lattice(const CellCloud& field)
      : cells(field), columns(static_cast<int>(field.width)),
        rows(static_cast<int>(field.height))
  {
    if (columns < 2 || rows < 2 ||
        field.size() != static_cast<std::size_t>(field.width) * field.height)
      throw DataError("the height field is not organised in columns and rows, two at "
                      "least");
    const PointCell &first = field.front(), &last = field.back();
    step_x = (static_cast<double>(last.x) - first.x) / (columns - 1);
    step_y = (static_cast<double>(last.y) - first.y) / (rows - 1);
    if (!std::isfinite(step_x * step_y) || step_x * step_y == 0.0)
      throw DataError("the height field has cells without a place");
    x0 = std::min(first.x, last.x) - 0.5 * std::abs(step_x);
    y0 = std::min(first.y, last.y) - 0.5 * std::abs(step_y);
  }
  float z(int column, int row) const
  {
    const int c = step_x > 0 ? column : columns - 1 - column;
    const int r = step_y > 0 ? row : rows - 1 - row;
    return cells[static_cast<std::size_t>(r) * columns + c].z;
  }

  const CellCloud& cells;
  int columns, rows;
  double step_x, step_y; ///< mm; may be negative
  double x0, y0;         ///< outer corner [mm]
};

/// Blocks of n x n cells, each as high as its highest cell.
class Blocks {
public:
  Blocks(const Lattice& lattice, float bottom, std::size_t most) : lattice_(lattice)
  {
    while (static_cast<std::size_t>(count(lattice.columns)) * count(lattice.rows) >
           most)
      ++n_;
    columns_ = count(lattice.columns);
    rows_ = count(lattice.rows);
    z_.assign(static_cast<std::size_t>(columns_) * rows_, bottom);
    for (int r = 0; r < lattice.rows; ++r)
      for (int c = 0; c < lattice.columns; ++c) {
        const float z = lattice.z(c, r);
        if (std::isinf(z))
          throw DataError("the height field has a cell of infinite height");
        float& block = z_[index(c / n_, r / n_)];
        block = z > block ? z : block; // not where z is NaN
      }
    bottom_ = bottom;
  }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  bool solid(int c, int r) const
  {
    return c >= 0 && r >= 0 && c < columns_ && r < rows_ && z(c, r) > bottom_;
  }
  float z(int c, int r) const { return z_[index(c, r)]; }
  /// Left side of a column, lower side of a row [mm]; the last block may be smaller.
  double x(int c) const
  {
    return lattice_.x0 + std::min(c * n_, lattice_.columns) * std::abs(lattice_.step_x);
  }
  double y(int r) const
  {
    return lattice_.y0 + std::min(r * n_, lattice_.rows) * std::abs(lattice_.step_y);
  }

private:
  int count(int cells) const { return (cells + n_ - 1) / n_; }
  std::size_t index(int c, int r) const
  {
    return static_cast<std::size_t>(r) * columns_ + c;
  }

  const Lattice& lattice_;
  int n_ = 1, columns_ = 0, rows_ = 0;
  float bottom_ = 0;
  std::vector<float> z_;
};

/// The surface of the columns that stand on the solid blocks.
class Builder {
public:
  Builder(const Blocks& blocks, float bottom) : blocks_(blocks), bottom_(bottom)
  {
    addCorners();
    for (int r = 0; r < blocks.rows(); ++r)
      for (int c = 0; c < blocks.columns(); ++c)
        if (blocks.solid(c, r))
          addColumn(c, r);
  }
  const pcl::PointCloud<pcl::PointXYZ>& points() const { return points_; }
  std::vector<pcl::Vertices>& faces() { return faces_; }

private:
  using Index = pcl::index_t;

  Index add(double x, double y, double z)
  {
    points_.push_back(pcl::PointXYZ(
        static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)));
    return static_cast<Index>(points_.size() - 1);
  }

  /// The mean height of those cells around a corner, from row @p low to row @p high,
  /// that are solid; a point there, and one under it.
  void addCorner(int c, int r, int low, int high)
  {
    double sum = 0;
    int count = 0;
    for (int j = low; j <= high; ++j)
      for (int i = c - 1; i <= c; ++i)
        if (blocks_.solid(i, j)) {
          sum += blocks_.z(i, j);
          ++count;
        }
    if (count == 0)
      return;
    add(blocks_.x(c), blocks_.y(r), sum / count);
    add(blocks_.x(c), blocks_.y(r), bottom_);
  }

  void addCorners()
  {
    for (int r = 0; r <= blocks_.rows(); ++r)
      for (int c = 0; c <= blocks_.columns(); ++c) {
        first_.push_back(static_cast<Index>(points_.size()));
        if (isPinch(c, r)) {
          addCorner(c, r, r - 1, r - 1);
          addCorner(c, r, r, r);
        }
        else
          addCorner(c, r, r - 1, r);
      }
  }

  /// Whether just two cells meet in a corner, and nowhere else: it is two points.
  bool isPinch(int c, int r) const
  {
    const bool a = blocks_.solid(c - 1, r - 1), b = blocks_.solid(c, r);
    const bool d = blocks_.solid(c, r - 1), e = blocks_.solid(c - 1, r);
    return a == b && d == e && a != d;
  }

  /// The upper point of a corner of cell (c, r); the lower one follows it.
  Index corner(int c, int r, int right, int up) const
  {
    const int i = c + right, j = r + up;
    const Index first =
        first_[static_cast<std::size_t>(j) * (blocks_.columns() + 1) + i];
    return isPinch(i, j) && !up ? first + 2 : first;
  }

  void addFace(Index a, Index b, Index c)
  {
    faces_.emplace_back();
    faces_.back().vertices = {a, b, c};
  }

  void addColumn(int c, int r)
  {
    const Index corners[] = {
        corner(c, r, 0, 0), corner(c, r, 1, 0), corner(c, r, 1, 1), corner(c, r, 0, 1)};
    const bool open[] = {!blocks_.solid(c, r - 1),
                         !blocks_.solid(c + 1, r),
                         !blocks_.solid(c, r + 1),
                         !blocks_.solid(c - 1, r)};
    const Index middle = add(0.5 * (blocks_.x(c) + blocks_.x(c + 1)),
                             0.5 * (blocks_.y(r) + blocks_.y(r + 1)),
                             blocks_.z(c, r));
    for (int side = 0; side < 4; ++side) {
      const Index a = corners[side], b = corners[(side + 1) % 4];
      addFace(middle, a, b);
      if (open[side]) {
        addFace(a + 1, b + 1, b);
        addFace(a + 1, b, a);
      }
    }
    addFace(corners[0] + 1, corners[2] + 1, corners[1] + 1);
    addFace(corners[0] + 1, corners[3] + 1, corners[2] + 1);
  }

  const Blocks& blocks_;
  float bottom_;
  std::vector<Index> first_; // of the points of each corner
  pcl::PointCloud<pcl::PointXYZ> points_;
  std::vector<pcl::Vertices> faces_;
};

} // namespace

pcl::PolygonMesh solidOf(const CellCloud& field, double bottom, std::size_t max_cells)
{
  if (!std::isfinite(bottom))
    throw ParameterError("solid: bottom is not a finite height [mm]");
  if (max_cells == 0)
    throw ParameterError("solid: max_cells is 0; it must be 1 at least");
  const Lattice lattice(field);
  const Blocks blocks(lattice, static_cast<float>(bottom), max_cells);
  Builder builder(blocks, static_cast<float>(bottom));
  if (builder.faces().empty())
    throw DataError("the height field is nowhere above the solid's bottom; lower it");
  pcl::PolygonMesh mesh;
  pcl::toPCLPointCloud2(builder.points(), mesh.cloud);
  mesh.polygons = std::move(builder.faces());
  return mesh;
}

} // namespace pointmill
