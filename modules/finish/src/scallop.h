// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "row.h"

#include <vector>

namespace pointmill {

/// What two neighbouring rows leave between them is known from a row halfway, which is
/// not cut. In the section across the feed the two stand for circles of radius R whose
/// centres c1, c2 are a chord L apart, and the part is what the circle about the
/// halfway centre c would just touch. If c stands a sagitta s above the chord, the
/// circles meet
///
///     h = R - sqrt(R^2 - L^2 / 4) - s
///
/// above the part. To second order this is |c1 - c2| |q1 - q2| / (8 R) with the contact
/// points q: on a plane s = 0 and h = L^2 / (8 R); on a sphere of radius r, convex or
/// concave, the centres lie on one of r +- R, s = L^2 / (8 (r +- R)) of the sphere's
/// sign, and h = L^2 / (8 R) * r / (r +- R); on a sharp edge all centres lie on a
/// circle of radius R about it and nothing is left. Rows that climb lie nearer to each
/// other than their stations: sections are taken at right angles to the feed.
struct Cusp {
  double chord;   ///< L [mm]
  double sagitta; ///< s [mm]
  double lean;    ///< L's share between c and the farther of c1, c2; 0.5 .. 1
  bool certain;   ///< all three rows touch the part

  /// The ground between the rows is no slope that rows nearer to each other could
  /// share: it breaks off.
  bool isCliff(double r) const { return chord >= 2 * r && lean > 0.75; }
};

/// The cusps between @p low and @p high at the stations of @p middle, which lies
/// halfway; @p step is the distance of stations.
std::vector<Cusp>
cusps(const Row& low, const Row& middle, const Row& high, double step);

/// Standard deviation of the sagittas by which those of neighbouring stations differ
/// without order: the scan's noise as the rows feel it. Median of the second
/// differences along @p rows, so that edges do not count.
double roughness(const std::vector<std::vector<Cusp>>& rows);

/// Heights of the cusps for corners of radius @p r, 0 .. r. Noise would be taken for
/// curvature: sagittas are averaged over the stations within r and count as far as they
/// stand out of @p noise (twice for the mean, three times for one that differs from
/// it).
std::vector<double>
scallops(const std::vector<Cusp>& cusps, double r, double step, double noise);

} // namespace pointmill
