// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// One program of two tools with arcs, as each control gets it, to the letter.
#include "two_tools.h"

#include <pointmill/common/version.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cstdio>
#include <random>
#include <string>

using pointmill::Post;

namespace {

/// @p annotated without its notes, " <- why", and with the version filled in.
std::string program(const std::string& annotated)
{
  std::istringstream in(annotated);
  std::string out, line;
  std::getline(in, line); // the rest of the line that the text begins on
  while (std::getline(in, line)) {
    line.erase(std::min(line.find(" <- "), line.size()));
    line.erase(line.find_last_not_of(' ') + 1);
    const auto version = line.find("VERSION");
    if (version != std::string::npos)
      line.replace(version, 7, pointmill::version);
    out += line + "\n";
  }
  return out;
}

void expectProgram(const std::string& post, const std::string& annotated)
{
  auto files = sample::files(sample::writerFor(Post::named(post)), sample::twoTools());
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[""].str(), program(annotated));
}

} // namespace

TEST(Posts, LinuxCnc)
{
  expectProgram("linuxcnc", R"(
(PointMill VERSION for LinuxCNC)
(T1 flat 10 mm)
(T2 ball 4.5 mm)
G17 G21 G40 G49 G54 G80 G90 G94   <- every mode that counts, whatever ran before
G91.1                             <- I J K from the start of the arc
G64 P0.02 Q0.                     <- blends within P; Q0: does not merge lines as well
(Operation 1: Rough [all])        <- no parenthesis inside
M5 M9
G53 G0 Z0.                        <- machine coordinates: no other height is known
T1 M6
G43 H1                            <- the length, before the first Z
S10000 M3                         <- M6 has stopped the spindle
M8
G0 Z10.                           <- first Z
G0 X0. Y0.                        <- then X and Y
Z1.
G1 Z-1.5 F300.                    <- F with the first feed
G2 X20. I10. F1000.               <- 180 degrees
G3 X30. Y10. Z-2. J10.            <- a helix
G18                               <- ZX
G3 X40. I5.
G1 Y20.25 F812.5
G0 Z10.
(Operation 2: Finish)
M5 M9
G53 G0 Z0.
T2 M6
G43 H2
S18000 M3
G0 Z12.
G0 X-3. Y2.
G1 Z0.25 F150.
X-0.5 F600.
G0 Z12.
M5 M9
G53 G0 Z0.
M30
)");
}

TEST(Posts, Mach)
{
  expectProgram("mach", R"(
(PointMill VERSION for Mach3/4)
(T1 flat 10 mm)
(T2 ball 4.5 mm)
G17 G21 G40 G49 G54 G80 G90 G94
G91.1                             <- Mach can be set to absolute centres
G61                               <- its G64 knows no tolerance
(Operation 1: Rough [all])
M5 M9
G28 G91 Z0.                       <- home in Z, straight from where it is
G90
T1 M6
G43 H1
S10000 M3
M8
G0 Z10.
G0 X0. Y0.
Z1.
G1 Z-1.5 F300.
G2 X20. I10. F1000.
G3 X30. Y10. Z-2. J10.
G18
G3 X40. I5.
G1 Y20.25 F812.5
G0 Z10.
(Operation 2: Finish)
M5 M9
G28 G91 Z0.
G90
T2 M6
G43 H2
S18000 M3
G0 Z12.
G0 X-3. Y2.
G1 Z0.25 F150.
X-0.5 F600.
G0 Z12.
M5 M9
G28 G91 Z0.
G90
M30
)");
}

TEST(Posts, GrblHasOneProgramForEachTool)
{
  auto files =
      sample::files(sample::writerFor(Post::named("grbl")), sample::twoTools());
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files["_1_T1"].str(), program(R"(
(PointMill VERSION for Grbl 1.1)  <- no %, which Grbl refuses
(program 1 of 2)
(T1 flat 10 mm)
G17 G21 G54 G90 G94
G91.1                             <- no G64: the path is always exact
(Operation 1: Rough [all])
M5 M9
T1                                <- no M6, no G43; the operator has set Z for the tool
S10000 M3
M8
G0 Z10.                           <- no machine coordinates: not all machines are homed
G0 X0. Y0.
Z1.
G1 Z-1.5 F300.
G2 X20. I10. F1000.
G3 X30. Y10. Z-2. J10.
G18
G3 X40. I5.
G1 Y20.25 F812.5
G0 Z10.                           <- ends on the clearance plane
M5 M9
M30
)"));
  EXPECT_EQ(files["_2_T2"].str(), program(R"(
(PointMill VERSION for Grbl 1.1)
(program 2 of 2)
(T2 ball 4.5 mm)
G17 G21 G54 G90 G94
G91.1
(Operation 2: Finish)
M5 M9
T2
S18000 M3
G0 Z12.
G0 X-3. Y2.
G1 Z0.25 F150.
X-0.5 F600.
G0 Z12.
M5 M9
M30
)"));
}

TEST(Posts, Fanuc)
{
  expectProgram("fanuc", R"(
%
O1001 (BRACKET)                   <- 4 digits
(POINTMILL VERSION FOR FANUC)     <- no small letters
(T1 FLAT 10 MM)
(T2 BALL 4.5 MM)
G17 G21 G40 G49 G54 G80 G90 G94   <- no G91.1
G61                               <- G64 knows no tolerance
(OPERATION 1: ROUGH  ALL)
M9
M5                                <- one M word in a block
G28 G91 Z0.
G90 G49
T1 M6
S10000 M3
M8
G0 G43 Z10. H1                    <- the length with the first Z; every number has a point
G0 X0. Y0.
Z1.
G1 Z-1.5 F300.
G2 X20. I10. F1000.
G3 X30. Y10. Z-2. J10.
G18
G3 X40. I5.
G1 Y20.25 F812.5
G0 Z10.
(OPERATION 2: FINISH)
M9
M5
G28 G91 Z0.
G90 G49
T2 M6
S18000 M3
G0 G43 Z12. H2
G0 X-3. Y2.
G1 Z0.25 F150.
X-0.5 F600.
G0 Z12.
M9
M5
G28 G91 Z0.
G90 G49
M30
%
)");
}

TEST(Posts, Haas)
{
  expectProgram("haas", R"(
%
O01001 (Bracket)                  <- 5 digits
(PointMill VERSION for Haas)
(T1 flat 10 mm)
(T2 ball 4.5 mm)
G17 G21 G40 G49 G54 G80 G90 G94
G187 P3 E0.02                     <- the largest rounding of a corner
(Operation 1: Rough [all])
M9
M5
G53 G0 Z0.                        <- without offsets, also that of the tool
T1 M6
S10000 M3
M8
G0 G43 Z10. H1
G0 X0. Y0.
Z1.
G1 Z-1.5 F300.
G2 X20. I10. F1000.
G3 X30. Y10. Z-2. J10.
G18
G3 X40. I5.
G1 Y20.25 F812.5
G0 Z10.
(Operation 2: Finish)
M9
M5
G53 G0 Z0.
T2 M6
S18000 M3
G0 G43 Z12. H2
G0 X-3. Y2.
G1 Z0.25 F150.
X-0.5 F600.
G0 Z12.
M9
M5
G53 G0 Z0.
M30
%
)");
}

TEST(Posts, Siemens)
{
  expectProgram("siemens", R"(
; PointMill VERSION for Sinumerik 840D <- no parentheses, no %
; T1 flat 10 mm
; T2 ball 4.5 mm
G17 G710 G40 G54 G90 G94          <- no G21; G710 is for feeds too
G642                              <- blends
CTOL=0.02                         <- within this
; Operation 1: Rough (all)
M9
M5
G0 SUPA Z0 D0                     <- without offsets and length
T1 D1                             <- D is the length: no G43
M6                                <- a block of its own
S10000 M3
M8
G0 Z10
G0 X0 Y0
Z1
G1 Z-1.5 F300
G2 X20 I10 F1000
G3 X30 Y10 Z-2 J10
G18
G3 X40 I5
G1 Y20.25 F812.5
G0 Z10
; Operation 2: Finish
M9
M5
G0 SUPA Z0 D0
T2 D1
M6
S18000 M3
G0 Z12
G0 X-3 Y2
G1 Z0.25 F150
X-0.5 F600
G0 Z12
M9
M5
G0 SUPA Z0 D0
M30
)");
}

TEST(Posts, HeidenhainConversational)
{
  expectProgram("heidenhain", R"(
0 BEGIN PGM BRACKET MM            <- blocks are counted, without a gap
1 ; POINTMILL VERSION FOR HEIDENHAIN KLARTEXT
2 ; T1 FLAT 10 MM
3 ; T2 BALL 4.5 MM
4 BLK FORM 0.1 Z X-5 Y-5 Z-10     <- the raw block, for the picture
5 BLK FORM 0.2 X+45 Y+25 Z+0.5
6 CYCL DEF 32.0 TOLERANCE
7 CYCL DEF 32.1 T0.02
8 ; OPERATION 1: ROUGH (ALL)
9 M9
10 M5
11 L Z+0 R0 FMAX M91              <- from the machine's datum
12 TOOL CALL 1 Z S10000           <- with the speed; the length is the tool table's
13 M3
14 M8
15 L Z+10 R0 FMAX                 <- a sign on every coordinate
16 L X+0 Y+0 R0 FMAX              <- FMAX is for one block
17 L Z+1 R0 FMAX
18 L Z-1.5 F300
19 CC X+10 Y+0                    <- the pole, absolute
20 CP IPA-180 DR- F1000           <- the angle has the sign of DR
21 CC X+20 Y+10
22 CP IPA+90 Z-2 DR+              <- a helix
23 CC X+35 Z-2
24 CP IPA+180 DR+
25 L X+40 Y+20.25 Z-2 F812        <- X and Z again: an angle has decimals; feeds none
26 L Z+10 R0 FMAX
27 ; OPERATION 2: FINISH
28 M9
29 M5
30 L Z+0 R0 FMAX M91
31 TOOL CALL 2 Z S18000
32 M3
33 L Z+12 R0 FMAX
34 L X-3 Y+2 R0 FMAX
35 L Z+0.25 F150
36 L X-0.5 F600
37 L Z+12 R0 FMAX
38 M9
39 M5
40 L Z+0 R0 FMAX M91
41 M30
42 END PGM BRACKET MM
)");
}

TEST(Posts, HeidenhainIso)
{
  // Of the arcs it takes the one that is flat and in XY; chords are tested elsewhere.
  auto operations = sample::twoTools();
  auto& path = operations[0].path;
  path.erase(path.begin() + 4, path.begin() + 6);
  for (std::size_t i = 4; i < path.size(); ++i)
    path[i].x = 20;
  path[4].y = path[5].y = 5.5;
  path[4].z = -1.5f;
  auto writer = sample::plainWriterFor(Post::named("heidenhain-iso"));
  sample::makeArcs(writer, {{2, sample::someArcs(writer.getGrid()).at(2)}});
  auto files = sample::files(writer, operations);
  EXPECT_EQ(files[""].str(), program(R"(
%BRACKET G71                      <- G71 is mm
N10 ; POINTMILL VERSION FOR HEIDENHAIN ISO
N20 ; T1 FLAT 10 MM
N30 ; T2 BALL 4.5 MM
N40 G30 G17 X-5. Y-5. Z-10.       <- the raw block's least corner
N50 G31 G90 X+45. Y+25. Z+0.5
N60 G17 G40 G90 G94
N70 G62 T0.02                     <- the tolerance cycle
N80 ; OPERATION 1: ROUGH (ALL)
N90 M09
N100 M05
N110 G00 Z+0 M91
N120 T1 G17 S10000                <- calls the tool: no M6
N130 M03
N140 M08
N150 G00 Z+10.
N160 G00 X+0. Y+0.
N170 Z+1.
N180 G01 Z-1.5 F300.
N190 I+10. J+0.                   <- the pole, absolute, in a block of its own
N200 G02 X+20. Y+0. F1000.
N210 G01 Y+5.5 F812.
N220 G00 Z+10.
N230 ; OPERATION 2: FINISH
N240 M09
N250 M05
N260 G00 Z+0 M91
N270 T2 G17 S18000
N280 M03
N290 G00 Z+12.
N300 G00 X-3. Y+2.
N310 G01 Z+0.25 F150.
N320 X-0.5 F600.
N330 G00 Z+12.
N340 M09
N350 M05
N360 G00 Z+0 M91
N370 M30
%BRACKET G71
)"));
}

TEST(Posts, ConversationalArcsEndWhereTheyShallAlongAChain)
{
  // A control that goes where the angles say, and where each arc should have ended.
  struct Chain : pointmill::CallAdapter {
    Chain(pointmill::MachineCalls& next, std::vector<Eigen::Vector2d>& ends)
        : CallAdapter(next), ends_(ends)
    {
    }
    void straight(const pointmill::MachinePosition& to, std::int64_t feed) override
    {
      CallAdapter::straight(to, feed);
      std::mt19937 random(5);
      std::uniform_int_distribution<std::int64_t> side(-400000, 400000), off(-15, 15);
      auto at = to;
      for (int i = 0; i < 300; ++i) {
        pointmill::MachineArc arc;
        arc.u = side(random);
        arc.v = side(random);
        arc.clockwise = i % 3 == 0;
        // A quarter, with ends that are not quite equally far from the centre.
        const auto sign = arc.clockwise ? -1 : 1;
        arc.to = {at.x + arc.u + sign * arc.v + off(random),
                  at.y + arc.v - sign * arc.u + off(random),
                  at.z};
        CallAdapter::arc(arc, feed);
        at = arc.to;
        ends_.emplace_back(double(at.x) * 1e-4, double(at.y) * 1e-4);
      }
      CallAdapter::straight(to, feed);
    }
    std::vector<Eigen::Vector2d>& ends_;
  };
  std::vector<Eigen::Vector2d> ends;
  auto operation = sample::small();
  operation.path.erase(operation.path.begin() + 3, operation.path.begin() + 5);
  operation.path[3].x = operation.path[3].y = 0;
  auto writer = sample::plainWriterFor(Post::named("heidenhain"));
  writer.addAdapter([&ends](pointmill::MachineCalls& next) {
    return std::make_unique<Chain>(next, ends);
  });
  std::istringstream in(sample::files(writer, {operation})[""].str());

  Eigen::Vector2d at(0, 0), pole;
  std::size_t arcs = 0;
  double worst = 0;
  for (std::string line; std::getline(in, line);) {
    double x = 0, y = 0, angle = 0;
    int number = 0;
    if (std::sscanf(line.c_str(), "%d CC X%lf Y%lf", &number, &x, &y) == 3)
      pole = {x, y};
    else if (std::sscanf(line.c_str(), "%d CP IPA%lf", &number, &angle) == 2) {
      EXPECT_EQ(line.find(angle < 0 ? "DR-" : "DR+") != std::string::npos, true);
      at = pole + Eigen::Rotation2Dd(angle * 3.14159265358979 / 180) * (at - pole);
      ASSERT_LT(arcs, ends.size());
      worst = std::max(worst, (at - ends[arcs++]).norm());
    }
  }
  EXPECT_EQ(arcs, ends.size());
  // Radii up to 57 mm turned by half a ten-thousandth of a degree, and the pole's
  // place.
  EXPECT_LT(worst, 2e-4);
}

TEST(Posts, AreAllNamed)
{
  EXPECT_EQ(Post::names().size(), 8u);
  for (const auto& name : Post::names()) {
    const Post post = Post::named(name);
    EXPECT_EQ(post.name, name);
    EXPECT_NO_THROW(post.validate());
  }
}
