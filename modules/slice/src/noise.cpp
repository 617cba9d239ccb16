// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "point_buckets.h"

#include <pointmill/common/error.h>
#include <pointmill/common/parallel.h>
#include <pointmill/slice/noise.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace pointmill {
namespace {

constexpr std::size_t kSamples = 2000;
constexpr std::size_t kNeighbours = 24, kMostNeighbours = 24 << 5;
constexpr std::size_t kFewest = 8; // two more than a quadric has coefficients
constexpr double kRadiusPerDeviation = 6;
// Growth of the variance with twice the neighbours that is form, and how much faster it
// then goes on growing at least; shared noise slows down.
constexpr double kGrowth = 1.3, kGrowthOfGrowth = 1.5;

/// Median of chi-square over its degrees of freedom (Wilson and Hilferty 1931).
double medianChiSquare(double freedom)
{
  const double root = 1 - 2 / (9 * freedom);
  return root * root * root;
}

DataError tooFew()
{
  return DataError("the noise of a scan with fewer than 8 different points was asked "
                   "for");
}

double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Variance of points about their quadric, NaN where they leave it no freedom.
double varianceAboutQuadric(const Eigen::Matrix3Xd& points, double radius)
{
  const Eigen::Vector3d mean = points.rowwise().mean();
  const Eigen::Matrix3Xd d = (points.colwise() - mean) / radius;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(d * d.transpose());
  const Eigen::Matrix3Xd local = axes.eigenvectors().transpose() * d; // normal first
  const Eigen::ArrayXd u = local.row(2), v = local.row(1);
  Eigen::MatrixXd terms(points.cols(), 6);
  terms << Eigen::VectorXd::Ones(points.cols()), u.matrix(), v.matrix(),
      (u * u).matrix(), (u * v).matrix(), (v * v).matrix();
  const Eigen::VectorXd height = local.row(0);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> fit(terms);
  const auto freedom = static_cast<double>(points.cols() - fit.rank());
  if (freedom < 1)
    return std::numeric_limits<double>::quiet_NaN();
  const double squares = (height - terms * fit.solve(height)).squaredNorm();
  return squares * radius * radius / (freedom * medianChiSquare(freedom));
}

/// The `count` different points nearest to `place`; a point that is there twice tells
/// nothing new.
Eigen::Matrix3Xd differentNeighbours(const PointBuckets& buckets,
                                     const Eigen::Vector3f& place,
                                     std::size_t count)
{
  std::vector<PointBuckets::Neighbour> near;
  std::vector<Eigen::Vector3f> kept;
  for (std::size_t ask = count;; ask *= 2) {
    buckets.nearest(place, ask, near);
    kept.clear();
    for (std::size_t i = 0; i < near.size() && kept.size() < count; ++i) {
      const Eigen::Vector3f& p = buckets.points()[near[i].number];
      bool again = false; // equal points are equally far
      for (std::size_t k = i; k-- > 0 && near[k].squared == near[i].squared;)
        again |= buckets.points()[near[k].number] == p;
      if (!again)
        kept.push_back(p);
    }
    if (kept.size() == count || near.size() < ask || ask > 8 * count)
      break;
  }
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = (kept[i] - place).cast<double>();
  return points;
}

/// The scatter in neighbourhoods of one size.
Noise scatterOf(const PointBuckets& buckets,
                const std::vector<std::size_t>& samples,
                std::size_t neighbours)
{
  std::vector<double> variance(samples.size()), radius(samples.size());
  parallelFor(samples.size(), 0, [&](std::size_t i) {
    const auto points =
        differentNeighbours(buckets, buckets.points()[samples[i]], neighbours);
    radius[i] = std::sqrt(points.colwise().squaredNorm().maxCoeff());
    variance[i] = static_cast<std::size_t>(points.cols()) < kFewest
                      ? std::numeric_limits<double>::quiet_NaN()
                      : varianceAboutQuadric(points, radius[i]);
  });
  variance.erase(std::remove_if(variance.begin(),
                                variance.end(),
                                [](double v) { return std::isnan(v); }),
                 variance.end());
  if (variance.empty())
    throw tooFew();
  Noise noise;
  noise.scatter = std::sqrt(median(variance));
  noise.radius = median(radius);
  noise.neighbours = static_cast<int>(neighbours);
  noise.samples = variance.size();
  return noise;
}

/// The part of the scatter that does not grow with the neighbourhoods.
double withoutForm(const PointBuckets& buckets,
                   const std::vector<std::size_t>& samples,
                   const Noise& noise)
{
  const auto variance = [&](std::size_t times) {
    const std::size_t neighbours = times * static_cast<std::size_t>(noise.neighbours);
    if (neighbours > buckets.points().size())
      return 0.0; // too few points to tell
    const double scatter = scatterOf(buckets, samples, neighbours).scatter;
    return scatter * scatter;
  };
  const double once = noise.scatter * noise.scatter, twice = variance(2);
  if (twice <= kGrowth * once)
    return noise.scatter;
  const double faster = (variance(4) - twice) / (twice - once);
  if (faster <= kGrowthOfGrowth)
    return noise.scatter;
  return std::sqrt(std::max(0.0, once - (twice - once) / (faster - 1)));
}

} // namespace

Noise measureNoise(const pcl::PointCloud<pcl::PointXYZ>& cloud, std::uint32_t seed)
{
  PointBuckets::Points finite;
  finite.reserve(cloud.size());
  for (const auto& p : cloud)
    if (p.getVector3fMap().allFinite())
      finite.push_back(p.getVector3fMap());
  if (finite.size() < kFewest)
    throw tooFew();
  const std::size_t count = finite.size();
  const CellGrid grid = PointBuckets::naturalGrid(finite);
  const PointBuckets buckets(std::move(finite), grid);

  std::mt19937 random(seed);
  std::vector<std::size_t> samples(std::min(kSamples, count));
  for (auto& s : samples)
    s = random() % count;
  const std::size_t most = std::min(kMostNeighbours, count);
  std::size_t neighbours = std::min(kNeighbours, most);
  Noise noise = scatterOf(buckets, samples, neighbours);
  while (noise.radius < kRadiusPerDeviation * noise.scatter && neighbours < most) {
    neighbours = std::min(2 * neighbours, most);
    noise = scatterOf(buckets, samples, neighbours);
  }
  noise.deviation = withoutForm(buckets, samples, noise);
  return noise;
}

} // namespace pointmill
