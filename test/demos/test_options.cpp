// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "demo_test.h"

#include <pointmill/align/z_alignment.h>
#include <pointmill/finish/buffer_points.h>
#include <pointmill/finish/cl_surface.h>
#include <pointmill/gcode/gcode_writer.h>
#include <pointmill/link/link_passes.h>
#include <pointmill/rough/high_speed_roughing.h>
#include <pointmill/rough/offset_roughing.h>
#include <pointmill/rough/waterline_roughing.h>
#include <pointmill/slice/occupancy_map.h>
#include <pointmill/slice/point_recovery.h>
#include <pointmill/slice/z_slices.h>
#include <pointmill/verify/program_verifier.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

using namespace demo_test;
using namespace pointmill;

namespace {

using P = pcl::PointXYZ;

class DemoOptions : public Programs {
protected:
  template <typename StageT>
  void expectOptions(const std::string& program, const StageT& stage) const
  {
    const Outcome help = run(program + " --help");
    EXPECT_EQ(help.code, 0);
    for (const auto& p : listParameters(stage)) {
      std::string option = "--" + p.name + " ";
      std::replace(option.begin(), option.end(), '_', '-');
      EXPECT_NE(help.text.find(option), std::string::npos)
          << program << " lacks " << option;
    }
  }
};

} // namespace

TEST_F(DemoOptions, EveryParameterOfAStageIsOne)
{
  expectOptions("pm_align", ZAlignment<P>());
  expectOptions("pm_slices", PointRecovery<P>());
  expectOptions("pm_slices", ZSlices());
  expectOptions("pm_occupancy", OccupancyMap<P>());
  expectOptions("pm_rough", OffsetRoughing());
  expectOptions("pm_rough", HighSpeedRoughing());
  expectOptions("pm_rough", WaterlineRoughing());
  expectOptions("pm_rough", OccupancyMap<P>());
  expectOptions("pm_cl_surface", CLSurface<P>());
  expectOptions("pm_buffer_points", BufferPoints<P>());
  expectOptions("pm_gcode", GCodeWriter());
  expectOptions("pm_gcode", LinkPasses());
  expectOptions("pm_gcode", ProgramVerifier());
}

TEST_F(DemoOptions, HelpSaysWhatTheStageIsWithAnExample)
{
  for (const char* program : {"pm_align",
                              "pm_slices",
                              "pm_occupancy",
                              "pm_rough",
                              "pm_cl_surface",
                              "pm_buffer_points",
                              "pm_gcode"}) {
    const Outcome help = run(std::string(program) + " -h");
    EXPECT_EQ(help.code, 0);
    EXPECT_NE(help.text.find("Example:\n  " + std::string(program)), std::string::npos);
    EXPECT_NE(help.text.find("-ps"), std::string::npos);
  }
}

TEST_F(DemoOptions, WhatIsWrongIsNamed)
{
  const std::string dome = " " POINTMILL_DATA "/dome.pcd ";
  bad(1, "did you mean --cell-size?", "pm_occupancy" + dome + "out.pcd --cell-sise 1");
  bad(1, "did you mean --up?", "pm_align" + dome + "out.pcd --upp=z");
  bad(1, "0.01 .. 50 mm", "pm_occupancy" + dome + "out.pcd --cell-size 60");
  bad(1, "whole number", "pm_align" + dome + "out.pcd --plane-iterations 10.5");
  bad(1, "--cell-size", "pm_occupancy" + dome + "out.pcd --cell-size wide");
  bad(1, "bridge|keep|mill", "pm_occupancy" + dome + "out.pcd --gaps fill");
  bad(1, "offset", "pm_rough" + dome + "out.pcd --strategy round");
  bad(1,
      "--ramp-angle does not befit zigzag",
      "pm_rough" + dome + "out.pcd --strategy zigzag --ramp-angle 2");
  bad(1, "--png", "pm_occupancy" + dome);
  bad(2, "no/such.pcd", "pm_occupancy no/such.pcd out.pcd");
  bad(2,
      "no field 'normal_x'",
      "pm_gcode" + dome +
          "out.pcd --unverified --stock-top 0 --tool-type flat "
          "--tool-diameter 10");
}

TEST_F(DemoOptions, LongOnesMayHaveOneDash)
{
  good("pm_occupancy " POINTMILL_DATA "/dome.pcd a.pcd -cell-size 2");
  good("pm_occupancy " POINTMILL_DATA "/dome.pcd b.pcd --cell-size=2");
  EXPECT_EQ(read("a.pcd"), read("b.pcd"));
}

TEST_F(DemoOptions, AnAxisMayBeNegative)
{
  good("pm_align " POINTMILL_DATA "/dome.pcd a.pcd --up -z");
  good("pm_align " POINTMILL_DATA "/dome.pcd b.pcd --up=-z");
  EXPECT_EQ(read("a.pcd"), read("b.pcd"));
}

TEST_F(DemoOptions, AViewIsSavedWithoutADisplayAWindowIsRefused)
{
  unsetenv("DISPLAY");
  good("pm_align " POINTMILL_DATA "/dome.pcd --png view.png");
  EXPECT_EQ(read("view.png").substr(1, 3), "PNG");
  bad(2, "no display", "pm_align " POINTMILL_DATA "/dome.pcd out.pcd --show", "other");
  setenv("DISPLAY", ":987", 1); // nobody answers there
  bad(2, "no display", "pm_align " POINTMILL_DATA "/dome.pcd out.pcd --show", "other");
}

TEST_F(DemoOptions, AnErrorThatNobodyReadsIsNoCrash)
{
  for (const std::string program : {"pm_align", "pm_occupancy", "pm_rough"}) {
    // A pipe that is closed before the program begins.
    const std::string call = "cd '" + path("") +
                             "' && { sleep 0.2; '" POINTMILL_BIN "/" + program +
                             "' no.pcd out.pcd 2>&1; echo $? >code; } | true";
    ASSERT_EQ(std::system(call.c_str()), 0);
    const int code = std::atoi(read("code").c_str());
    EXPECT_TRUE(code == 128 + SIGPIPE || code == 2) << program << " " << code;
  }
}

TEST_F(DemoOptions, WhatIsNoPartIsNotMilled)
{
  const std::string dome = " " POINTMILL_DATA "/dome.pcd ";
  good("pm_occupancy" + dome + "map.pcd --cell-size 1");
  good("pm_rough map.pcd cl.pcd --step-down 4");
  for (const std::string program : {"pm_align", "pm_slices", "pm_cl_surface"})
    bad(2, "is an occupancy map, not a part; pm_rough", program + " map.pcd out.pcd");
  for (const std::string program :
       {"pm_align", "pm_slices", "pm_occupancy", "pm_rough", "pm_cl_surface"})
    bad(2, "holds CL points, not a part", program + " cl.pcd out.pcd");
  bad(2,
      "is an occupancy map",
      "pm_gcode cl.pcd out --part map.pcd --tool-type flat --tool-diameter 10",
      "out");
}

TEST_F(DemoOptions, FilesAreNamedAsWhatTheyAre)
{
  const std::string dome = " " POINTMILL_DATA "/dome.pcd ";
  bad(1, "it is written as .pcd", "pm_occupancy" + dome + "out.ply", "out.ply");
  bad(1, "it is written as .pcd", "pm_align" + dome + "out", "out");
  bad(1, "it is written as .png", "pm_occupancy" + dome + "--png out.jpg", "out.jpg");
}

TEST_F(DemoOptions, PitchesThatAreNoneAreRefused)
{
  const std::string slices = "pm_slices " POINTMILL_DATA "/dome.pcd out.pcd ";
  bad(1, "0.001 .. 1000 mm", slices + "--pitch -1");
  bad(1, "--diameter", slices + "--diameter -1");
  bad(1, "--level", slices + "--pitch 1 --level -3");
  bad(1, "--level", slices + "--diameter 8 --level -3");
  bad(1, "--pitch", slices + "--diameter 8 --pitch 1");
  bad(1, "points above them", slices + "--pitch 0.001");
}

TEST_F(DemoOptions, PclsOptionsAreSpeltAsInItsViewer)
{
  const std::string align = "pm_align " POINTMILL_DATA "/dome.pcd ";
  good(align + "--png a.png -ps 5 -bc 0,0,64 -ax 10");
  good(align + "--png b.png -ps=5 --bc=0,0,64 -ax=10");
  EXPECT_EQ(read("a.png"), read("b.png"));
  for (const char* colour : {"0,0,0,0", "0,0", "0,0,256", "0;0;0", "0,0,0x"})
    bad(1, "-bc", align + "out.pcd -bc '" + std::string(colour) + "'");
  bad(1, "--ps", align + "out.pcd -ps 0");
}
