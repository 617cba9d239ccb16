// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "io_test.h"

#include <pointmill/common/point_types.h>
#include <pointmill/io/write_mesh.h>

#include <pcl/conversions.h>
#include <pcl/io/ply_io.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>

using pointmill::CellCloud;
using pointmill::DataError;
using pointmill::ParameterError;
using pointmill::PointCell;
using pointmill::solidOf;
using pointmill::writeMesh;

namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
constexpr double kStepX = 0.5, kStepY = 0.25; // mm

/// Cells from (10, -5) on; height(column, row).
template <typename Height>
CellCloud field(int columns, int rows, const Height& height)
{
  CellCloud cells;
  cells.width = columns;
  cells.height = rows;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      PointCell cell;
      cell.x = static_cast<float>(10 + kStepX * c);
      cell.y = static_cast<float>(-5 + kStepY * r);
      cell.z = static_cast<float>(height(c, r));
      cells.points.push_back(cell);
    }
  return cells;
}

/// Heights of 1 .. 9 mm, with a @p share of them missing.
CellCloud randomField(int columns, int rows, double share, unsigned seed)
{
  std::mt19937 random(seed);
  const auto any = [&] { return static_cast<double>(random()) / random.max(); };
  return field(columns, rows, [&](int, int) {
    const double z = 1 + 8 * any();
    return any() < share ? kNothing : z;
  });
}

double columnsOver(const CellCloud& cells, double bottom)
{
  double sum = 0;
  for (const auto& cell : cells)
    if (cell.z > bottom)
      sum += kStepX * kStepY * (cell.z - bottom);
  return sum;
}

struct Solid {
  explicit Solid(const pcl::PolygonMesh& mesh) : faces(mesh.polygons)
  {
    pcl::fromPCLPointCloud2(mesh.cloud, points);
  }
  Eigen::Vector3d at(const pcl::Vertices& face, int i) const
  {
    return points[face.vertices[i]].getVector3fMap().cast<double>();
  }
  /// By the divergence theorem: positive where the triangles look outwards.
  double volume() const
  {
    double sum = 0;
    for (const auto& f : faces)
      sum += at(f, 0).dot(at(f, 1).cross(at(f, 2))) / 6;
    return sum;
  }
  /// Each edge is run along once in each direction, by two triangles.
  void expectClosed() const
  {
    std::map<std::pair<int, int>, int> edges;
    for (const auto& f : faces)
      for (int i = 0; i < 3; ++i)
        ++edges[{f.vertices[i], f.vertices[(i + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
      ASSERT_EQ(count, 1);
      ASSERT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
  }
  /// The height of the upper surface over a place, by the triangles that look up.
  double top(double x, double y) const
  {
    double best = -std::numeric_limits<double>::infinity();
    for (const auto& f : faces) {
      const Eigen::Vector3d a = at(f, 0), u = at(f, 1) - a, v = at(f, 2) - a;
      const double area = u.x() * v.y() - u.y() * v.x();
      if (area <= 0)
        continue;
      const double px = x - a.x(), py = y - a.y();
      const double s = (px * v.y() - py * v.x()) / area;
      const double t = (u.x() * py - u.y() * px) / area;
      if (s >= -1e-9 && t >= -1e-9 && s + t <= 1 + 1e-9)
        best = std::max(best, a.z() + s * u.z() + t * v.z());
    }
    return best;
  }

  pcl::PointCloud<pcl::PointXYZ> points;
  const std::vector<pcl::Vertices> faces;
};

} // namespace

TEST(Mesh, OfABoxIsThatBox)
{
  const Solid solid(solidOf(field(4, 3, [](int, int) { return 2; }), -1.5));
  solid.expectClosed();
  EXPECT_EQ(solid.faces.size(), 6u * 12 + 2 * 14);
  EXPECT_NEAR(solid.volume(), 4 * kStepX * 3 * kStepY * 3.5, 1e-5);
  Eigen::AlignedBox3f box;
  for (const auto& p : solid.points)
    box.extend(p.getVector3fMap());
  EXPECT_EQ(box.min(), Eigen::Vector3f(9.75f, -5.125f, -1.5f));
  EXPECT_EQ(box.max(), Eigen::Vector3f(11.75f, -4.375f, 2.f));
}

TEST(Mesh, IsClosedAndHoldsTheColumnsWhateverIsMissing)
{
  for (const double missing : {0.0, 0.1, 0.5, 0.9})
    for (unsigned seed = 1; seed < 6; ++seed) {
      const CellCloud cells = randomField(23, 17, missing, seed);
      const Solid solid(solidOf(cells, -0.25));
      solid.expectClosed();
      EXPECT_NEAR(solid.volume() / columnsOver(cells, -0.25), 1, 1e-5);
    }
}

TEST(Mesh, IsExactAtTheCentres)
{
  const CellCloud cells = randomField(9, 7, 0.2, 3);
  const Solid solid(solidOf(cells, 0));
  for (const auto& cell : cells)
    if (std::isfinite(cell.z)) {
      EXPECT_FLOAT_EQ(static_cast<float>(solid.top(cell.x, cell.y)), cell.z);
    }
    else
      EXPECT_EQ(solid.top(cell.x, cell.y), -std::numeric_limits<double>::infinity());
}

TEST(Mesh, LeavesOutWhatIsNotAboveTheBottom)
{
  const CellCloud cells =
      field(6, 6, [](int c, int r) { return c == 2 && r > 1 && r < 5 ? r - 2 : 5; });
  const Solid solid(solidOf(cells, 1)); // rows 2 and 3 of column 2 are a hole, 4 is low
  solid.expectClosed();
  EXPECT_NEAR(solid.volume(), columnsOver(cells, 1), 1e-4);
  EXPECT_EQ(solid.top(11, -4.25), -std::numeric_limits<double>::infinity());
  EXPECT_NEAR(solid.top(11, -4.0), 2, 1e-6);
}

TEST(Mesh, CountsFromEitherEnd)
{
  CellCloud cells = randomField(8, 5, 0.2, 7), turned = cells;
  std::reverse(turned.begin(), turned.end());
  const Solid one(solidOf(cells, 0)), other(solidOf(turned, 0));
  ASSERT_EQ(one.points.size(), other.points.size());
  for (std::size_t i = 0; i < one.points.size(); ++i)
    EXPECT_TRUE(one.points[i].getVector3fMap().isApprox(
        other.points[i].getVector3fMap(), 1e-6f));
  EXPECT_NEAR(one.volume(), other.volume(), 1e-4);
}

TEST(Mesh, ThinnedCellsAreAsHighAsTheHighest)
{
  const CellCloud cells = randomField(41, 30, 0.05, 11);
  const Solid solid(solidOf(cells, 0, 41 * 30 / 8)); // blocks of 3 x 3: 14 x 10
  solid.expectClosed();
  std::size_t centres = 0;
  for (int r = 0; r < 10; ++r)
    for (int c = 0; c < 14; ++c) {
      float highest = 0;
      for (int j = 3 * r; j < 3 * r + 3; ++j)
        for (int i = 3 * c; i < std::min(3 * c + 3, 41); ++i)
          highest = std::max(
              highest, std::isnan(cells[j * 41 + i].z) ? 0.f : cells[j * 41 + i].z);
      const double x = 0.5 * (3 * c + std::min(3 * c + 3, 41)), y = 3 * r + 1.5;
      EXPECT_NEAR(solid.top(9.75 + kStepX * x, -5.125 + kStepY * y), highest, 1e-5);
      ++centres;
    }
  EXPECT_EQ(centres, 140u);
  Eigen::AlignedBox3f box; // the last column's blocks are narrower
  for (const auto& p : solid.points)
    box.extend(p.getVector3fMap());
  EXPECT_FLOAT_EQ(box.max().x(), 9.75f + 41 * 0.5f);
}

TEST(Mesh, FilesAreReadBackTriangleByTriangle)
{
  const pcl::PolygonMesh mesh = solidOf(randomField(12, 9, 0.2, 5), 0);
  const Solid solid(mesh);
  for (const char* name : {"a.PLY", "a.stl"}) {
    const std::string path = io_test::ownPath(name);
    writeMesh(path, mesh);
    const auto scan = pointmill::readScan(path);
    ASSERT_EQ(scan.faces.size(), solid.faces.size());
    for (std::size_t f = 0; f < scan.faces.size(); ++f)
      for (int i = 0; i < 3; ++i)
        ASSERT_EQ(scan.points[scan.faces[f][i]], solid.at(solid.faces[f], i));
    std::remove(path.c_str());
  }
}

TEST(Mesh, PclReadsThePly)
{
  const std::string path = io_test::ownPath("a.ply");
  const CellCloud cells = randomField(12, 9, 0.2, 5);
  writeMesh(path, cells, 0);
  pcl::PolygonMesh mesh;
  ASSERT_EQ(pcl::io::loadPLYFile(path, mesh), 0);
  const Solid solid(mesh);
  solid.expectClosed();
  EXPECT_NEAR(solid.volume() / columnsOver(cells, 0), 1, 1e-5);
  std::remove(path.c_str());
}

TEST(Mesh, StlKnowsWhichSideIsOut)
{
  const std::string path = io_test::ownPath("a.stl");
  writeMesh(path, randomField(5, 4, 0.1, 2), 0);
  std::ifstream in(path, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(in), {}};
  ASSERT_EQ((content.size() - 84) % 50, 0u);
  for (std::size_t at = 84; at < content.size(); at += 50) {
    float v[12];
    std::memcpy(v, &content[at], sizeof v);
    const Eigen::Vector3f n(v), a(v + 3), b(v + 6), c(v + 9);
    EXPECT_TRUE(n.isApprox((b - a).cross(c - a).normalized(), 1e-4f));
  }
  std::remove(path.c_str());
}

TEST(Mesh, RefusesWhatIsNone)
{
  const CellCloud cells = randomField(5, 4, 0, 2);
  EXPECT_THROW(solidOf(CellCloud(), 0), DataError);
  CellCloud row = cells;
  row.width = 20;
  row.height = 1;
  EXPECT_THROW(solidOf(row, 0), DataError);
  CellCloud endless = cells;
  endless[7].z = std::numeric_limits<float>::infinity();
  EXPECT_THROW(solidOf(endless, 0), DataError);
  EXPECT_THROW(solidOf(cells, 10), DataError);
  EXPECT_THROW(solidOf(cells, 0, 0), ParameterError);
  EXPECT_THROW(solidOf(cells, std::nan("")), ParameterError);
  const std::string path = io_test::ownPath("a.obj");
  EXPECT_THROW(writeMesh(path, cells, 0), DataError);
  pcl::PolygonMesh mesh = solidOf(cells, 0);
  mesh.polygons[3].vertices[1] = 100000;
  EXPECT_THROW(writeMesh(io_test::ownPath("a.ply"), mesh), DataError);
  mesh.polygons[3].vertices = {0, 1, 2, 3};
  EXPECT_THROW(writeMesh(io_test::ownPath("a.ply"), mesh), DataError);
  EXPECT_THROW(writeMesh(io_test::ownPath("a.ply"), pcl::PolygonMesh()), DataError);
  EXPECT_FALSE(std::ifstream(io_test::ownPath("a.ply")).good());
}
