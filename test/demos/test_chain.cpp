// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// The programs one after the other, by their files, against the classes.
#include "clouds.h"
#include "demo_test.h"

#include <pointmill/align/z_alignment.h>
#include <pointmill/finish/buffer_points.h>
#include <pointmill/finish/cl_surface.h>
#include <pointmill/gcode/post.h>
#include <pointmill/io/scan.h>
#include <pointmill/io/write_cloud.h>
#include <pointmill/rough/offset_roughing.h>
#include <pointmill/slice/occupancy_map.h>
#include <pointmill/slice/z_slices.h>

#include <cstring>

using namespace demo_test;
using namespace pointmill;

namespace {

using DemoChain = Programs;

template <typename PointT>
void expectSame(const pcl::PointCloud<PointT>& is,
                const pcl::PointCloud<PointT>& should)
{
  ASSERT_EQ(is.size(), should.size());
  EXPECT_EQ(is.width, should.width);
  for (std::size_t i = 0; i < is.size(); ++i)
    for (const auto& field : pcl::getFields<PointT>()) {
      const auto at = [&](const PointT& p) {
        return reinterpret_cast<const char*>(&p) + field.offset;
      };
      const bool both_nan =
          field.name == "z" && std::isnan(is[i].z) && std::isnan(should[i].z);
      ASSERT_TRUE(both_nan || std::memcmp(at(is[i]), at(should[i]), 4) == 0)
          << "point " << i << ", " << field.name;
    }
}

pcl::PointCloud<pcl::PointXYZ>::Ptr alignedDome()
{
  const Scan scan = prepareScan(readScan(POINTMILL_DATA "/dome.pcd"), {}, 10, 1000, 1);
  ZAlignment<pcl::PointXYZ> align;
  return run(scan.cloud, align);
}

} // namespace

TEST_F(DemoChain, RoughingByFilesIsWhatTheClassesGive)
{
  good("pm_align " POINTMILL_DATA "/dome.pcd part.pcd --up z");
  good("pm_occupancy part.pcd map.pcd --cell-size 0.6");
  good("pm_rough map.pcd cl.pcd --step-down 2 --strategy offset");

  const auto part = alignedDome();
  expectSame(*readPart(path("part.pcd")), *part);
  OccupancyMap<pcl::PointXYZ> map;
  map.setCellSize(0.6);
  const auto cells = pointmill::run(part, map);
  expectSame(*readMap(path("map.pcd")), *cells);
  OffsetRoughing roughing;
  roughing.setStepDown(2);
  const auto passes = pointmill::run(cells, roughing);
  ASSERT_GT(passes->size(), 100u);
  expectSame(*readPoints<PointCL>(path("cl.pcd"), ""), *passes);

  const std::string gcode =
      "pm_gcode cl.pcd part.ngc --part part.pcd --tool-type flat --tool-diameter 10";
  const std::string in = std::to_string(passes->size()) + " points in, ";
  EXPECT_NE(run(gcode).text.find(in), std::string::npos);
  EXPECT_NE(read("part.ngc").find("verified against"), std::string::npos);
  EXPECT_NE(read("part.ngc").find("T1 M6"), std::string::npos);
}

TEST_F(DemoChain, APartIsRoughedWithItsPoints)
{
  good("pm_align " POINTMILL_DATA "/dome.pcd part.pcd");
  good("pm_rough part.pcd cl.pcd --step-down 2 --cell-size 0.6");
  const auto part = alignedDome();
  OccupancyMap<pcl::PointXYZ> map;
  map.setCellSize(0.6);
  OffsetRoughing roughing;
  roughing.setStepDown(2);
  roughing.setPart(indexOf(*part));
  expectSame(*readPoints<PointCL>(path("cl.pcd"), ""),
             *pointmill::run(pointmill::run(part, map), roughing));
}

TEST_F(DemoChain, FinishingByFilesIsWhatTheClassesGive)
{
  good("pm_align " POINTMILL_DATA "/dome.pcd part.pcd");
  good("pm_cl_surface part.pcd rows.pcd --step-over 1 --tool-diameter 4");
  good("pm_buffer_points rows.pcd part.pcd cl.pcd --tool-diameter 4 "
       "--inside-tolerance 0.005");

  const auto part = alignedDome();
  CLSurface<pcl::PointXYZ> rows;
  rows.setTool(Tool::ball(1, 4));
  rows.setStepOver(1);
  BufferPoints<pcl::PointXYZ> buffer;
  buffer.setTool(Tool::ball(1, 4));
  buffer.setTolerance({0.005, 0.01});
  buffer.setSurface(part);
  const auto coarse = pointmill::run(part, rows);
  expectSame(*readPoints<PointCL>(path("rows.pcd"), ""), *coarse);
  expectSame(*readPoints<PointCL>(path("cl.pcd"), ""), *pointmill::run(coarse, buffer));

  const std::string tool = " --tool-type ball --tool-diameter 4";
  good("pm_gcode cl.pcd p.ngc --part part.pcd" + tool);
  bad(3,
      "get too deep into a tool",
      "pm_gcode rows.pcd out --part part.pcd" + tool,
      "out");
  bad(3,
      "get too deep into a tool",
      "pm_gcode cl.pcd out --part part.pcd --tool-type ball --tool-diameter 6",
      "out");
}

TEST_F(DemoChain, SlicesHoldWhatStandsAboveThem)
{
  good("pm_align " POINTMILL_DATA "/dome.pcd part.pcd");
  good("pm_slices part.pcd one.pcd --level -3");
  good("pm_slices part.pcd all.pcd --pitch 2");
  const auto part = readPart(path("part.pcd"));
  const auto above = [&](double z) {
    return std::count_if(part->begin(), part->end(), [z](auto& p) { return p.z > z; });
  };
  const auto one = readPoints<pcl::PointXYZL>(path("one.pcd"), "");
  EXPECT_EQ(static_cast<long>(one->size()), above(-3));
  for (const auto& p : *one)
    ASSERT_EQ(p.z, -3.f);

  ZSlices slices;
  double low = 0, high = -1e9;
  for (const auto& p : *part) {
    low = std::min<double>(low, p.z);
    high = std::max<double>(high, p.z);
  }
  slices.setZLimits(low, high);
  slices.setPitch(2);
  long sum = 0;
  for (const double z : slices.levels())
    sum += above(z);
  const auto all = readPoints<pcl::PointXYZL>(path("all.pcd"), "");
  EXPECT_EQ(static_cast<long>(all->size()), sum);
  EXPECT_EQ(all->front().label, 1u);
  EXPECT_EQ(all->back().label, slices.levels().size());
  const Outcome printed = run("pm_slices part.pcd all.pcd --pitch 2");
  EXPECT_NE(printed.text.find(std::to_string(part->size()) + " points in, " +
                              std::to_string(sum) + " points out"),
            std::string::npos)
      << printed.text;
  EXPECT_NE(printed.text.find("level_1 Z-2."), std::string::npos) << printed.text;
}

TEST_F(DemoChain, PicturesOfMapsNeedNoDisplay)
{
  good("pm_align " POINTMILL_DATA "/dome.pcd part.pcd");
  good("pm_occupancy part.pcd --png heights.png");
  good("pm_occupancy part.pcd map.pcd --png level.png --level -3");
  EXPECT_EQ(read("heights.png").substr(1, 3), "PNG");
  EXPECT_EQ(read("level.png").substr(1, 3), "PNG");
  EXPECT_NE(read("level.png"), read("heights.png"));
}

TEST_F(DemoChain, EveryPostIsReadBack)
{
  good("pm_align " POINTMILL_DATA "/dome.pcd part.pcd");
  good("pm_occupancy part.pcd map.pcd --cell-size 0.6");
  good("pm_rough map.pcd cl.pcd --step-down 3");
  for (const auto& post : Post::names())
    good("pm_gcode cl.pcd p." + post + " --part part.pcd --post " + post +
         " --tool-type flat --tool-diameter 10");
}

TEST_F(DemoChain, WithoutAPartAProgramSaysSo)
{
  good("pm_align " POINTMILL_DATA "/dome.pcd part.pcd");
  good("pm_occupancy part.pcd map.pcd --cell-size 0.6");
  good("pm_rough map.pcd cl.pcd --step-down 3");
  const std::string tool = " --tool-type flat --tool-diameter 10";
  bad(1, "--unverified", "pm_gcode cl.pcd out" + tool, "out");
  bad(1, "--stock-top", "pm_gcode cl.pcd out --unverified" + tool, "out");
  good("pm_gcode cl.pcd p.ngc --unverified --stock-top 0" + tool);
  EXPECT_NE(read("p.ngc").find("NOT VERIFIED AGAINST A PART"), std::string::npos);
  bad(1, "--tool-type", "pm_gcode cl.pcd out --part part.pcd", "out");
}

TEST_F(DemoChain, TheBlockIsNotLowerThanThePart)
{
  good("pm_align " POINTMILL_DATA "/dome.pcd part.pcd");
  good("pm_rough part.pcd cl.pcd --step-down 3 --cell-size 0.6");
  const std::string with = " --part part.pcd --tool-type flat --tool-diameter 10";
  bad(1,
      "the part reaches up to Z0",
      "pm_gcode cl.pcd out --stock-top -3" + with,
      "out");
  good("pm_gcode cl.pcd p.ngc --stock-top 0" + with);
  good("pm_gcode cl.pcd p.ngc --stock-top 1" + with);
}

TEST_F(DemoChain, APassOfSixPointsIsAProgram)
{
  CLCloud pass;
  for (int i = 0; i < 6; ++i) {
    pass.push_back(PointCL(10 * i, 0, -1));
    pass.back().feed = 600;
  }
  writeCloud(path("cl.pcd"), pass);
  good("pm_gcode cl.pcd p.ngc --unverified --stock-top 0 --tool-type flat "
       "--tool-diameter 10");
  EXPECT_NE(read("p.ngc").find("X50."), std::string::npos);
}
