// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/error.h>
#include <pointmill/common/watch.h>
#include <pointmill/io/write_file.h>

#include <pcl/common/io.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_cloud.h>

#include <ostream>
#include <string>
#include <vector>

namespace pointmill {

/// @brief Writes a cloud of any registered point type as a binary PCD file, see
/// writeFileAtomically().
/// @throws DataError where the cloud is empty or its width and height contradict its
/// size, or where it cannot be written
template <typename PointT>
void writeCloud(const std::string& path, const pcl::PointCloud<PointT>& cloud)
{
  if (cloud.empty())
    throw DataError(path + ": the cloud to write is empty; check the stage before");
  if (std::size_t(cloud.width) * cloud.height != cloud.size())
    throw DataError(path + ": the cloud's width x height is not its number of points; "
                           "set width to the number and height to 1");
  struct Piece {
    std::size_t offset, size;
  };
  std::vector<Piece> pieces;
  std::size_t row_size = 0;
  for (const auto& field : pcl::getFields<PointT>()) {
    if (field.name == "_")
      continue;
    const std::size_t count = field.count == 0 ? 1 : field.count;
    pieces.push_back({field.offset, count * pcl::getFieldSize(field.datatype)});
    row_size += pieces.back().size;
  }
  writeFileAtomically(path, [&](std::ostream& out) {
    out << pcl::PCDWriter::generateHeader<PointT>(cloud) << "DATA binary\n";
    std::vector<char> row(row_size);
    std::size_t written = 0;
    for (const PointT& point : cloud) {
      if (written++ % 4096 == 0)
        checkInterrupted();
      char* to = row.data();
      for (const Piece& piece : pieces) {
        const char* from = reinterpret_cast<const char*>(&point) + piece.offset;
        to = std::copy(from, from + piece.size, to);
      }
      out.write(row.data(), static_cast<std::streamsize>(row_size));
    }
  });
}

} // namespace pointmill
