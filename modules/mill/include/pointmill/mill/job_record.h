// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/mill/criteria.h>
#include <pointmill/verify/finding.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pointmill {

/// @brief One operation as a job's report has it.
struct RecordedOperation {
  std::string name;
  int tool = 0;
  int colour = 0;            ///< in pictures
  std::size_t cl_points = 0; ///< of cl.pcd
};

/// @brief What a job left in its directory, for those who show it.
struct JobRecord {
  std::string scan; ///< name of its file
  double mm_per_unit = 1.0;
  /// From the scan's coordinates [mm] to the part frame.
  Eigen::Matrix4d alignment = Eigen::Matrix4d::Identity();
  Criteria criteria;
  std::vector<std::string> programs; ///< paths, in the order of machining
  std::vector<RecordedOperation> operations;
  std::vector<Finding> findings; ///< `place` is NaN where there is none

  /// @throws DataError where there is no job, or not one of this version
  static JobRecord read(const std::string& directory);
};

} // namespace pointmill
