// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "text.h"

#include <pointmill/common/error.h>
#include <pointmill/common/watch.h>
#include <pointmill/io/write_file.h>
#include <pointmill/io/write_mesh.h>

#include <pcl/conversions.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <ostream>

namespace pointmill {

namespace {

using Points = pcl::PointCloud<pcl::PointXYZ>;

/// The bytes of one record of a binary file.
class Record {
public:
  template <typename T>
  Record& operator<<(const T& value)
  {
    std::memcpy(bytes_ + size_, &value, sizeof value);
    size_ += sizeof value;
    return *this;
  }
  Record& operator<<(const Eigen::Vector3f& v)
  {
    return *this << v.x() << v.y() << v.z();
  }
  void writeTo(std::ostream& out) const
  {
    out.write(bytes_, static_cast<std::streamsize>(size_));
  }

private:
  char bytes_[50]; // as many as a triangle of an STL file takes
  std::size_t size_ = 0;
};

void writePly(std::ostream& out, const Points& points, const pcl::PolygonMesh& mesh)
{
  out << "ply\nformat binary_little_endian 1.0\ncomment lengths in mm\n"
      << "element vertex " << points.size()
      << "\nproperty float x\nproperty float y\nproperty float z\n"
      << "element face " << mesh.polygons.size()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  checkInterrupted();
  for (const auto& p : points)
    (Record() << p.x << p.y << p.z).writeTo(out);
  for (const auto& face : mesh.polygons) {
    checkInterrupted();
    Record record;
    record << std::uint8_t(3);
    for (const auto i : face.vertices)
      record << static_cast<std::int32_t>(i);
    record.writeTo(out);
  }
}

void writeStl(std::ostream& out, const Points& points, const pcl::PolygonMesh& mesh)
{
  const char head[80] = "binary STL, lengths in mm"; // must not begin with "solid"
  out.write(head, sizeof head);
  (Record() << static_cast<std::uint32_t>(mesh.polygons.size())).writeTo(out);
  for (const auto& face : mesh.polygons) {
    checkInterrupted();
    const auto corner = [&](int i) {
      return points[face.vertices[i]].getVector3fMap();
    };
    const Eigen::Vector3d a = corner(0).cast<double>();
    const Eigen::Vector3f normal = (corner(1).cast<double>() - a)
                                       .cross(corner(2).cast<double>() - a)
                                       .normalized() // stays 0 where there is no area
                                       .cast<float>();
    Record record;
    record << normal;
    for (int i = 0; i < 3; ++i)
      record << Eigen::Vector3f(corner(i));
    record << std::uint16_t(0);
    record.writeTo(out);
  }
}

void check(const std::string& path, const Points& points, const pcl::PolygonMesh& mesh)
{
  for (const auto& face : mesh.polygons) {
    if (face.vertices.size() != 3)
      throw DataError(path + ": the mesh to write has a face that is no triangle");
    for (const auto i : face.vertices)
      if (i < 0 || static_cast<std::size_t>(i) >= points.size())
        throw DataError(path + ": the mesh to write has a triangle without its points");
  }
}

} // namespace

void writeMesh(const std::string& path, const pcl::PolygonMesh& mesh)
{
  const std::string extension =
      detail::lower(std::filesystem::path(path).extension().string());
  const auto write = extension == ".ply"   ? writePly
                     : extension == ".stl" ? writeStl
                                           : nullptr;
  if (!write)
    throw DataError(path + ": a mesh is written as .ply or .stl; name such a file");
  if (mesh.polygons.empty())
    throw DataError(path + ": the mesh to write has no triangles");
  Points points;
  pcl::fromPCLPointCloud2(mesh.cloud, points);
  check(path, points, mesh);
  writeFileAtomically(path, [&](std::ostream& out) { write(out, points, mesh); });
}

} // namespace pointmill
