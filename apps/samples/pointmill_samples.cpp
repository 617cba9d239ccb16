// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// Writes the files of data/, see data/README.md, or the scan of the benchmarks. The
// same bytes at every run.
#include "freeform_scan.h"

#include <pointmill_test/sample_part.h>
#include <pointmill_test/shapes.h>

#include <pcl/io/pcd_io.h>

#include <cmath>
#include <cstdint>
#include <exception>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace {

using pointmill_test::Random;
using pointmill_test::SamplePart;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double pi = 3.14159265358979323846;
constexpr double pitch = 0.175; // mm between two measured points
constexpr double noise = 0.015; // mm
constexpr double dropouts = 0.005;
constexpr double on_walls = 0.15; // share of a steep wall's points that return
constexpr int nan_points = 25;
constexpr int strays = 8;

// The laser looks straight down, the camera from +X at 20 degrees to it: whether the
// camera sees a point at height z.
bool inSight(double x, double y, double z)
{
  const double rise = 1 / std::tan(20 * pi / 180);
  for (double s = 0.05; z + s * rise < 20; s += 0.05)
    if (SamplePart::height(x + s, y) > z + s * rise)
      return false;
  return true;
}

// The part as the scanner sees it, in the part's own frame.
Cloud scan(Random& random)
{
  Cloud cloud;
  const auto add = [&](double x, double y, double z) {
    cloud.push_back(pcl::PointXYZ(static_cast<float>(x + 0.3 * noise * random.normal()),
                                  static_cast<float>(y + 0.3 * noise * random.normal()),
                                  static_cast<float>(z + noise * random.normal())));
  };
  const int columns = static_cast<int>(std::lround(SamplePart::length / pitch));
  const int rows = static_cast<int>(std::lround(SamplePart::width / pitch));
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double x = (column + random.uniform()) * SamplePart::length / columns;
      const double y = (row + random.uniform()) * SamplePart::width / rows;
      const double z = SamplePart::height(x, y);
      if (std::isnan(z) || random.uniform() < dropouts || !inSight(x, y, z))
        continue;
      add(x, y, z);
      // A wall that faces the camera returns a few points between its foot and its top.
      const double behind = SamplePart::height(x - pitch, y);
      if (behind > z + 0.5 && random.uniform() < on_walls)
        add(x - pitch / 2, y, random.uniform(z, behind));
    }
  for (int i = 0; i < nan_points; ++i)
    cloud[static_cast<std::size_t>(random.uniform() * cloud.size())].z =
        std::numeric_limits<float>::quiet_NaN();
  // Dust in the air, one grain per field of a 4 x 2 grid, so that each is alone.
  for (int i = 0; i < strays; ++i) {
    const int column = i % 4, row = i / 4;
    add((column + random.uniform(0.2, 0.8)) * SamplePart::length / 4,
        (row + random.uniform(0.2, 0.8)) * SamplePart::width / 2,
        random.uniform(26, 45));
  }
  cloud.is_dense = false;
  return cloud;
}

// As the part lay on the scanner's table: turned by 7 degrees, away from the origin.
void place(Cloud& cloud)
{
  const double c = std::cos(7 * pi / 180), s = std::sin(7 * pi / 180);
  for (auto& p : cloud) {
    const double x = p.x, y = p.y;
    p.x = static_cast<float>(212.5 + c * x - s * y);
    p.y = static_cast<float>(-84.0 + s * x + c * y);
    p.z += 37.25f;
  }
}

// The sample clouds, into an existing folder.
void writeSamples(const std::string& folder)
{
  pcl::PCDWriter writer;
  std::uint64_t seed = 1;
  for (const auto& shape : pointmill_test::shapes()) {
    const Cloud::Ptr cloud = pointmill_test::sample(shape, 0.5, seed++);
    writer.writeBinary(folder + "/" + shape.name + ".pcd", *cloud);
    std::cout << shape.name << ".pcd: " << cloud->size() << " points\n";
  }
  Random random(2026);
  Cloud cloud = scan(random);
  place(cloud);
  writer.writeBinaryCompressed(folder + "/sample_scan.pcd", cloud);
  std::cout << "sample_scan.pcd: " << cloud.size() << " points\n";
}

int usage()
{
  std::cerr << "usage: pointmill_samples FOLDER\n"
               "       pointmill_samples --freeform POINTS [--noise MM] FILE\n"
               "Writes PointMill's sample clouds into an existing folder, or a binary "
               "PCD file\nwith random points of the freeform that the benchmarks "
               "mill.\n";
  return 2;
}

} // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (words.size() == 1 && words[0][0] != '-')
      writeSamples(words[0]);
    else if (words.size() == 3 && words[0] == "--freeform")
      writeFreeformScan(words[2], std::stoull(words[1]), 0.0);
    else if (words.size() == 5 && words[0] == "--freeform" && words[2] == "--noise")
      writeFreeformScan(words[4], std::stoull(words[1]), std::stod(words[3]));
    else
      return usage();
  }
  catch (const std::exception& e) {
    std::cerr << "pointmill_samples: " << e.what() << "\n";
    return 1;
  }
  return 0;
}
