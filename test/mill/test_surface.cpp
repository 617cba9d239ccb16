// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What the milled surface is against the true one, which the scan shows badly.
#include "mill_test.h"

#include <pointmill_test/freeform.h>

#include <pcl/io/pcd_io.h>

using namespace mill_test;
using pointmill_test::Freeform;

namespace {

struct Errors {
  double rms = 0, mean = 0;
};

/// Plans the milling of a scan of the freeform, `edge` mm square.
struct FreeformJob {
  FreeformJob(double density, double side, double noise, MillOptions options)
      : edge(side), job((options.square = false, options))
  {
    const auto scan = Freeform::sample(
        static_cast<std::size_t>(density * side * side), side, noise, 17);
    pcl::PCDWriter().writeBinary((folder / "scan.pcd").string(), *scan);
  }
  void plan() { job.plan((folder / "scan.pcd").string()); }

  /// Milled less true height along the normal, well inside the border.
  Errors errors() const
  {
    const Eigen::Matrix4d to_scan = job.alignment().inverse();
    Errors e;
    int count = 0;
    for (const auto& cell : job.verification().milled) {
      const Eigen::Vector4d p = to_scan * Eigen::Vector4d(cell.x, cell.y, cell.z, 1);
      if (std::min(p.x(), p.y()) < 4 || std::max(p.x(), p.y()) > edge - 4)
        continue;
      const double across =
          1 / std::sqrt(1 + Freeform::gradient(p.x(), p.y()).squaredNorm());
      const double error = (p.z() - Freeform::height(p.x(), p.y())) * across;
      e.mean += error;
      e.rms += error * error;
      ++count;
    }
    e.mean /= count;
    e.rms = std::sqrt(e.rms / count);
    return e;
  }

  double edge;
  TempDir folder;
  MillJob job;
};

} // namespace

TEST(MilledSurface, IsTheTrueOneUnderTheNoiseOfThePoints)
{
  FreeformJob noisy(100, 24, 0.05, MillOptions());
  noisy.plan();
  EXPECT_TRUE(noisy.job.surfaceFigures().smooth);
  EXPECT_NEAR(noisy.job.surfaceFigures().noise, 0.05 * 0.89, 0.003); // along the normal
  const Errors e = noisy.errors();
  EXPECT_LT(e.rms, 0.02);
  EXPECT_LT(std::abs(e.mean), 0.01);
}

TEST(MilledSurface, FloatsOnTheNoiseOfBarePoints)
{
  MillOptions options;
  options.surface = SurfaceChoice::Points;
  options.accept_sparse = true;
  FreeformJob bare(100, 24, 0.05, options);
  bare.plan();
  EXPECT_FALSE(bare.job.surfaceFigures().smooth);
  EXPECT_GT(bare.errors().mean, 0.06);
}

TEST(MilledSurface, IsTheTrueOneBetweenFewPoints)
{
  // One point in each 0.5 mm square, where a ball of 3 mm sinks by 0.04 mm and more.
  FreeformJob sparse(4, 24, 0.0, MillOptions());
  sparse.plan();
  EXPECT_TRUE(sparse.job.surfaceFigures().smooth);
  const Errors e = sparse.errors();
  EXPECT_LT(e.rms, 0.012);
  EXPECT_LT(std::abs(e.mean), 0.008); // of which the scallops are a third of 0.01
}

TEST(MilledSurface, RefusesBarePointsThatAreTooFewUnlessToldToGoOn)
{
  MillOptions options;
  options.surface = SurfaceChoice::Points;
  FreeformJob sparse(4, 12, 0.0, options);
  try {
    sparse.plan();
    FAIL() << "not refused";
  }
  catch (const DataError& e) {
    const std::string why = e.what();
    for (const char* part : {"too sparse", "--surface smooth", "--accept-sparse", "T3"})
      EXPECT_NE(why.find(part), std::string::npos) << why;
  }
  options.accept_sparse = true;
  FreeformJob accepted(4, 12, 0.0, options);
  EXPECT_NO_THROW(accepted.plan());
}

TEST(MilledSurface, OfDenseCleanPointsIsThatOfTheBarePoints)
{
  FreeformJob dense(1000, 12, 0.0, MillOptions());
  dense.plan();
  EXPECT_FALSE(dense.job.surfaceFigures().smooth);
}
