// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "clouds.h"
#include "demo.h"

#include <pointmill/align/z_alignment.h>
#include <pointmill/io/scan.h>

using namespace pointmill;

int main(int argc, char** argv)
{
  Demo demo(
      "pm_align",
      "ZAlignment: turns the machined side of a scan to +Z, squares its long side "
      "to X and sets the datum",
      "scan.ply part.pcd --up -z --datum centre");
  std::string scan;
  demo.input("SCAN", scan, "PCD, PLY, OBJ, STL or text");
  demo.output("PART", "PCD");
  ZAlignment<pcl::PointXYZ> align;
  demo.parameters(align, "ZAlignment");
  double density = 10;
  ScanScale scale;
  demo.choice<double>(
      "--units",
      [&](double mm) { scale.mm_per_unit = mm; },
      {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"inch", 25.4}},
      "of the scan");
  numberOption(demo.options(), "--density", density, "1/MM2", "of points on faces");
  demo.choice<Up>(
      "--up",
      [&](Up up) { align.setUp(up); },
      {{"z", Up::Z},
       {"x", Up::X},
       {"-x", Up::MinusX},
       {"y", Up::Y},
       {"-y", Up::MinusY},
       {"-z", Up::MinusZ},
       {"plane", Up::Plane},
       {"pca", Up::Pca}},
      "direction of the scan that the tool comes from");
  demo.choice<DatumXY>(
      "--datum",
      [&](DatumXY datum) { align.setDatumXY(datum); },
      {{"corner", DatumXY::Corner}, {"centre", DatumXY::Centre}},
      "X0 Y0 of the part's box");
  demo.choice<DatumZ>(
      "--datum-z",
      [&](DatumZ datum) { align.setDatumZ(datum); },
      {{"top", DatumZ::Top}, {"bottom", DatumZ::Bottom}},
      "Z0 of the part's box");
  return demo.run(argc, argv, [&] {
    checkIsPart(scan);
    const Scan prepared = prepareScan(readScan(scan), scale, density, 20'000'000, 1);
    demo.finish(*demo.filter(align, prepared.cloud));
  });
}
