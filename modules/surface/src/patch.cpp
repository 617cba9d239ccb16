// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/surface/patch.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace pointmill {
namespace {

using Eigen::Vector3d;

constexpr int kRounds = 6; // of looking for the right radius

/// Two unit vectors that make a right-handed frame with `normal`.
void tangents(const Vector3d& normal, Vector3d& s, Vector3d& t)
{
  const Vector3d aside =
      std::abs(normal.x()) < 0.7 ? Vector3d::UnitX() : Vector3d::UnitY();
  s = (aside - aside.dot(normal) * normal).normalized();
  t = normal.cross(s);
}

} // namespace

void Neighbourhood::gatherWithin(const PointIndex& points, double distance)
{
  radius = distance;
  std::size_t count = 0; // the columns only grow: filling them costs time
  const int c0 = points.columnOf(centre.x() - distance);
  const int c1 = points.columnOf(centre.x() + distance);
  const int r0 = points.rowOf(centre.y() - distance);
  const int r1 = points.rowOf(centre.y() + distance);
  const double most = distance * distance;
  for (int row = r0; row <= r1; ++row) {
    const auto [first, last] = points.cells(row, c0, c1);
    if (x.size() < count + (last - first)) {
      for (auto* column : {&x, &y, &z})
        column->resize(count + (last - first));
    }
    for (std::size_t i = first; i < last; ++i) { // without branches
      const Vector3d d = points.point(i) - centre;
      x[count] = d.x();
      y[count] = d.y();
      z[count] = d.z();
      count += d.squaredNorm() <= most;
    }
  }
  count_ = count;
}

void Neighbourhood::gather(const PointIndex& points,
                           const Vector3d& place,
                           std::size_t wanted)
{
  centre = place;
  // The cells about the place tell how dense the points are, seen from above.
  const int column = points.columnOf(place.x()), row = points.rowOf(place.y());
  const int widest = std::max(points.columns(), points.rows());
  std::size_t seen = 0;
  int ring = 0;
  for (;; ring = 2 * ring + 1) {
    seen = 0;
    const int c0 = std::max(0, column - ring);
    const int c1 = std::min(points.columns() - 1, column + ring);
    const int r0 = std::max(0, row - ring);
    const int r1 = std::min(points.rows() - 1, row + ring);
    for (int r = r0; r <= r1; ++r) {
      const auto [first, last] = points.cells(r, c0, c1);
      seen += last - first;
    }
    if (seen >= wanted || ring >= widest)
      break;
  }
  const double edge = (2 * ring + 1) * points.cellSize();
  const double aim = static_cast<double>(std::min(wanted, points.size()));
  double distance = edge * std::sqrt(aim / (M_PI * static_cast<double>(seen)));
  for (int round = 0; round < kRounds; ++round) {
    gatherWithin(points, distance);
    const double count = static_cast<double>(size());
    if ((count > 0.6 * aim && count < 3 * aim) || size() == points.size())
      return;
    distance *= std::clamp(std::sqrt(1.1 * aim / std::max(count, 1.0)), 0.3, 4.0);
  }
}

Vector3d Neighbourhood::planeNormal() const
{
  Vector3d sum = Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    sum += Vector3d(x[i], y[i], z[i]);
    xx += x[i] * x[i];
    xy += x[i] * y[i];
    xz += x[i] * z[i];
    yy += y[i] * y[i];
    yz += y[i] * z[i];
    zz += z[i] * z[i];
  }
  products << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  products -=
      sum * sum.transpose() / static_cast<double>(std::max<std::size_t>(1, size()));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(products);
  const Vector3d normal = axes.eigenvectors().col(0);
  return normal.z() < 0 ? Vector3d(-normal) : normal;
}

bool Patch::fit(const Neighbourhood& points,
                const Vector3d& normal,
                const std::vector<unsigned char>* keep)
{
  origin_ = points.centre;
  normal_ = normal;
  tangents(normal, s_, t_);
  radius_ = std::max(points.radius, 1e-9);
  const Vector3d su = s_ / radius_, tu = t_ / radius_;

  // Sums of s^i t^j, of w s^i t^j, and of w^2.
  double m[15] = {}, b[kTerms] = {}, ww = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keep && !(*keep)[i])
      continue;
    const double px = points.x[i], py = points.y[i], pz = points.z[i];
    const double s = px * su.x() + py * su.y() + pz * su.z();
    const double t = px * tu.x() + py * tu.y() + pz * tu.z();
    const double w = px * normal.x() + py * normal.y() + pz * normal.z();
    const double s2 = s * s, st = s * t, t2 = t * t;
    m[1] += s, m[2] += t;
    m[3] += s2, m[4] += st, m[5] += t2;
    m[6] += s2 * s, m[7] += s2 * t, m[8] += t2 * s, m[9] += t2 * t;
    m[10] += s2 * s2, m[11] += s2 * st, m[12] += s2 * t2, m[13] += st * t2;
    m[14] += t2 * t2;
    b[0] += w, b[1] += w * s, b[2] += w * t;
    b[3] += w * s2, b[4] += w * st, b[5] += w * t2;
    ww += w * w;
    ++count;
  }
  if (count < kTerms + 2)
    return false;
  m[0] = static_cast<double>(count);
  Eigen::Matrix<double, kTerms, kTerms> a;
  a << m[0], m[1], m[2], m[3], m[4], m[5],   //
      m[1], m[3], m[4], m[6], m[7], m[8],    //
      m[2], m[4], m[5], m[7], m[8], m[9],    //
      m[3], m[6], m[7], m[10], m[11], m[12], //
      m[4], m[7], m[8], m[11], m[12], m[13], //
      m[5], m[8], m[9], m[12], m[13], m[14];
  solver_.compute(a);
  const Terms pivots = solver_.vectorD();
  // Points in a line or in two clumps determine no quadric.
  if (!(pivots.minCoeff() > 1e-7 * m[0]))
    return false;
  const Terms right = Eigen::Map<const Terms>(b);
  c_ = solver_.solve(right);
  const double sum = std::max(0.0, ww - c_.dot(right));
  residual_ = std::sqrt(sum / static_cast<double>(count - kTerms));
  return true;
}

double Patch::height(double s, double t) const
{
  const double u = s / radius_, v = t / radius_;
  return c_[0] + u * (c_[1] + c_[3] * u + c_[4] * v) + v * (c_[2] + c_[5] * v);
}

Patch::Slopes Patch::slopes(double s, double t) const
{
  const double u = s / radius_, v = t / radius_, area = radius_ * radius_;
  return {(c_[1] + 2 * c_[3] * u + c_[4] * v) / radius_,
          (c_[2] + c_[4] * u + 2 * c_[5] * v) / radius_,
          2 * c_[3] / area,
          c_[4] / area,
          2 * c_[5] / area};
}

double Patch::bendDeviation() const
{
  const double ss = solver_.solve(Terms::Unit(3))[3];
  const double tt = solver_.solve(Terms::Unit(5))[5];
  return 2 * residual_ * std::sqrt(std::max(ss, tt)) / (radius_ * radius_);
}

Vector3d Patch::normalAt(double s, double t) const
{
  const Slopes w = slopes(s, t);
  return (normal_ - w.s * s_ - w.t * t_).normalized();
}

bool Patch::isBetween(const Neighbourhood& points, double s, double t) const
{
  unsigned seen = 0; // a bit for each eighth of the directions
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d p(points.x[i], points.y[i], points.z[i]);
    const double ds = p.dot(s_) - s, dt = p.dot(t_) - t;
    seen |= 1u << ((ds < 0) | (dt < 0) << 1 | (std::abs(ds) < std::abs(dt)) << 2);
  }
  // The eighths in turn, as bits; four empty ones in a row are an empty half.
  constexpr int turn[8] = {0, 4, 5, 1, 3, 7, 6, 2};
  int empty = 0;
  for (int i = 0; i < 11; ++i) {
    empty = seen >> turn[i % 8] & 1u ? 0 : empty + 1;
    if (empty == 4)
      return false;
  }
  return true;
}

} // namespace pointmill
