// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "freeform_scan.h"

#include <pointmill_test/random.h>

#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace {

constexpr double edge = 100; // mm
constexpr std::uint64_t seed = 7;

} // namespace

void writeFreeformScan(const std::string& path, std::uint64_t count, double noise)
{
  std::ofstream out(path, std::ios::binary);
  out << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\n"
         "SIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH "
      << count << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << count
      << "\nDATA binary\n";
  pointmill_test::Random random(seed);
  for (std::uint64_t i = 0; i < count && out; ++i) {
    const double x = random.uniform(0, edge), y = random.uniform(0, edge);
    double z =
        10 + 4 * std::sin(x / 9) * std::cos(y / 11) + 2 * std::sin(x / 4 + y / 6);
    if (noise > 0)
      z += noise * random.normal();
    const std::array<float, 3> point = {float(x), float(y), float(z)};
    out.write(reinterpret_cast<const char*>(point.data()), sizeof point);
  }
  out.close();
  if (!out)
    throw std::runtime_error(path + ": cannot be written");
}
