// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/align/up_direction.h>
#include <pointmill/common/error.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_plane.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <random>

namespace pointmill {
namespace align {
namespace {

constexpr std::size_t ransac_points = 20000;
constexpr double decisive = 0.1;

struct Plane {
  Eigen::Vector3d normal;
  double offset;
  double distance(const Eigen::Vector3d& p) const { return normal.dot(p) + offset; }
};

struct Moments {
  Eigen::Vector3d mean;
  Eigen::Vector3d variances; // ascending
  Eigen::Matrix3d axes;
};

// Of all points, each with its weight(point).
template <typename Weight>
Moments moments(const Points& points, const Weight& weight)
{
  // About the first point, which lies among the others: one pass loses no digits.
  const Eigen::Vector3d& origin = points.front();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  double total = 0.0;
  for (const auto& point : points) {
    const double w = weight(point);
    if (w <= 0.0)
      continue;
    const Eigen::Vector3d d = point - origin;
    total += w;
    sum += w * d;
    squares += w * d * d.transpose();
  }
  const Eigen::Vector3d mean = sum / total;
  const Eigen::Matrix3d covariance = squares / total - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  return {origin + mean, solver.eigenvalues(), solver.eigenvectors()};
}

// The moments of all points, which must span a plane at least.
Moments spread(const Points& points, const std::string& name)
{
  Moments all = moments(points, [](const Eigen::Vector3d&) { return 1.0; });
  if (!(all.variances[1] > 1e-10 * all.variances[2]))
    throw DataError(name + ": the points lie on one line; no side can be turned up");
  return all;
}

// Some of the points, spread over all of them without the regularity of every k-th,
// which would favour single rows of an organised scan.
pcl::PointCloud<pcl::PointXYZ>::Ptr thinned(const Points& points)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  const std::size_t count = std::min(points.size(), ransac_points);
  std::mt19937 random(1);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t first = i * points.size() / count;
    const std::size_t next = (i + 1) * points.size() / count;
    const Eigen::Vector3f p = points[first + random() % (next - first)].cast<float>();
    cloud->push_back(pcl::PointXYZ(p.x(), p.y(), p.z()));
  }
  return cloud;
}

// PCL seeds model and sampler with constants unless told otherwise: the same points
// yield the same plane.
bool samplePlane(const Points& points, const PlaneSearch& search, Plane& plane)
{
  const pcl::SampleConsensusModelPlane<pcl::PointXYZ>::Ptr model(
      new pcl::SampleConsensusModelPlane<pcl::PointXYZ>(thinned(points), false));
  pcl::RandomSampleConsensus<pcl::PointXYZ> ransac(model, search.distance);
  ransac.setMaxIterations(search.iterations);
  ransac.setProbability(0.9999);
  if (!ransac.computeModel())
    return false;
  Eigen::VectorXf c;
  ransac.getModelCoefficients(c);
  const Eigen::Vector4d abcd = c.cast<double>();
  const double length = abcd.head<3>().norm();
  plane = {abcd.head<3>() / length, abcd[3] / length};
  return true;
}

// Least squares over all inliers until it stands still. The weights fall smoothly to
// zero, so that no single point at the border moves the plane.
Plane refined(const Points& points, Plane plane, double distance)
{
  const double reach = 2.0 * distance;
  for (int i = 0; i < 50; ++i) {
    const Plane last = plane;
    const Moments inliers = moments(points, [&](const Eigen::Vector3d& p) {
      const double r = last.distance(p) / reach;
      const double w = 1.0 - r * r;
      return w > 0.0 ? w * w : 0.0;
    });
    plane.normal = inliers.axes.col(0);
    if (plane.normal.dot(last.normal) < 0)
      plane.normal = -plane.normal;
    plane.offset = -plane.normal.dot(inliers.mean);
    if ((plane.normal - last.normal).norm() < 1e-12)
      break;
  }
  return plane;
}

// Turns the axis to the side that the evidence, the hint or the convention names.
UpDirection
decided(const Eigen::Vector3d& axis, double evidence, const Eigen::Vector3d& hint)
{
  int dominant;
  axis.cwiseAbs().maxCoeff(&dominant);
  double side = axis[dominant];
  if (std::abs(evidence) > decisive)
    side = evidence;
  else if (std::abs(axis.dot(hint)) > decisive * hint.norm())
    side = axis.dot(hint);
  const double sign = side < 0 ? -1.0 : 1.0;
  return {sign * axis, sign * evidence, 0.0};
}

} // namespace

UpDirection baseNormal(const Points& points,
                       const PlaneSearch& search,
                       const Eigen::Vector3d& hint,
                       const std::string& name)
{
  spread(points, name);
  Plane plane;
  if (!samplePlane(points, search, plane))
    throw DataError(name + ": no base plane was found");
  plane = refined(points, plane, search.distance);
  double in = 0, above = 0, below = 0;
  for (const auto& p : points) {
    const double d = plane.distance(p);
    in += std::abs(d) <= search.distance;
    above += d > 2 * search.distance;
    below += d < -2 * search.distance;
  }
  const double all = static_cast<double>(points.size());
  if (in < search.share * all)
    throw DataError(name + ": the largest plane holds " +
                    std::to_string(100.0 * in / all) +
                    " % of the points, too few for a base; name the axis that is up");
  const double off = above + below;
  UpDirection up =
      decided(plane.normal, off >= 0.005 * all ? (above - below) / off : 0.0, hint);
  up.base_share = in / all;
  return up;
}

UpDirection thinnestDirection(const Points& points,
                              const Eigen::Vector3d& hint,
                              const std::string& name)
{
  const Moments all = spread(points, name);
  if (all.variances[0] > 0.98 * all.variances[1])
    throw DataError(name + ": the points have no thinnest direction, two are within "
                           "1 %; name the axis that is up");
  const Eigen::Vector3d axis = all.axes.col(0);
  std::vector<double> heights;
  heights.reserve(points.size());
  for (const auto& p : points)
    heights.push_back(axis.dot(p - all.mean));
  const auto quantile = [&heights](double q) {
    const auto at = heights.begin() + static_cast<std::ptrdiff_t>(
                                          q * static_cast<double>(heights.size() - 1));
    std::nth_element(heights.begin(), at, heights.end());
    return *at;
  };
  const double low = quantile(0.02), middle = quantile(0.5), high = quantile(0.98);
  // A flat cloud has nothing but rounding errors there.
  const bool flat = high - low <= 1e-6 * std::sqrt(all.variances[2]);
  return decided(axis, flat ? 0.0 : (high + low - 2 * middle) / (high - low), hint);
}

} // namespace align
} // namespace pointmill
