// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// pm_gcode: LinkPasses, GCodeWriter, GCodeReader and ProgramVerifier, from CL points to
// a program that was proven.
#include "../pointmill/post_option.h"
#include "../pointmill/tool_options.h"
#include "checked_program.h"
#include "clouds.h"
#include "demo.h"

using namespace pointmill;

int main(int argc, char** argv)
{
  Demo demo("pm_gcode",
            "GCodeWriter: links the passes of a CL cloud and writes the program for a "
            "control. It is read back and compared with the CL points, and milled in "
            "simulation against --part, out of a block; without a part it is written "
            "only with --unverified, and says so in its head",
            "cl.pcd part.ngc --part part.pcd --post linuxcnc --tool-type flat "
            "--tool-diameter 10");
  CheckedProgram program;
  std::string path, part, post = "linuxcnc";
  demo.input("CL", path, "PCD of PointCL, as pm_rough and pm_buffer_points write it");
  demo.output("PROGRAM", "text for the control", "");
  CLI::App& app = demo.options();
  auto* given = app.add_option("--part", part, "cloud that the CL points are of");
  app.add_flag("--unverified", program.unverified, "write it without a part")
      ->excludes(given);
  numberOption(app, "--stock-top", program.stock_top, "MM", "of the block")
      ->default_str("the top of the part");
  app.add_option("--post", post, postHelp())->capture_default_str();
  numberOption(app, "--spindle", program.cutting.spindle, "RPM", "speed");
  numberOption(app, "--feed", program.cutting.feed, "MM/MIN", "along the path");
  numberOption(
      app, "--plunge-feed", program.cutting.plunge_feed, "MM/MIN", "downwards");
  demo.parameters(program.writer, "GCodeWriter");
  demo.parameters(program.link, "LinkPasses");
  demo.parameters(program.verifier, "ProgramVerifier");
  ToolOptions tool("tool");
  tool.declare(app, "Tool", Tool::flat(1, 10));
  return demo.run(argc, argv, [&] {
    if (!tool.type || !tool.diameter)
      throw ParameterError("a CL cloud does not say its tool: give --tool-type and "
                           "--tool-diameter");
    program.tool = tool.toolFrom(Tool::flat(1, 10));
    program.writer.setPost(readPost(post));
    if (!part.empty())
      program.part = indexOf(*readPart(part));
    const auto passes = readPoints<PointCL>(path, "pm_rough");
    const auto start = Demo::Clock::now();
    const CLCloud linked = program.make(*passes);
    demo.printRun(passes->size(), linked.size(), start);
    for (const auto& [figure, value] : program.figures)
      demo.print(figure, value);
    demo.finish(program.text, linked);
  });
}
