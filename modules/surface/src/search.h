// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "cutter_underside.h"
#include "height_pyramid.h"

#include <pointmill/surface/contact.h>
#include <pointmill/surface/sorted_points.h>

#include <cstddef>
#include <vector>

namespace pointmill {

/// What a search looks through.
struct SearchSpace {
  const SortedPoints& points;
  const HeightPyramid& pyramid;
};

/// The questions to the points, each in one version per instruction set. All versions
/// give the same bits: floats only sort out what cannot matter, with room for their
/// rounding; what remains is computed in double, one operation at a time.
struct Search {
  const char* name;
  void (*drop_row)(const SearchSpace&,
                   const Tool&,
                   const Eigen::Vector2d& from,
                   const Eigen::Vector2d& step,
                   std::size_t count,
                   Contact* contacts);
  double (*drop_along)(const SearchSpace&,
                       const Tool&,
                       const Eigen::Vector2d& a,
                       const Eigen::Vector2d& b);
  double (*gouge)(const SearchSpace&,
                  const Tool&,
                  const Eigen::Vector3d& a,
                  const Eigen::Vector3d& b,
                  double tolerance);
};

/// The versions that this machine can run, the best last; never empty.
const std::vector<Search>& searches();

} // namespace pointmill
