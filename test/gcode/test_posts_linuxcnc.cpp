// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// LinuxCNC's interpreter takes what is written for the controls that speak as it does.
#include "two_tools.h"

#include <pointmill/common/error.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

using pointmill::Post;
using pointmill::Retract;
using pointmill::Unit;

namespace {

namespace fs = std::filesystem;

bool installed()
{
  return std::system("command -v rs274 >/dev/null 2>&1") == 0;
}

/// What the interpreter says against @p program; empty: nothing.
std::string complaint(const std::string& program)
{
  std::string name = (fs::temp_directory_path() / "pointmill-XXXXXX").string();
  if (!mkdtemp(name.data()))
    throw std::runtime_error("no temporary directory");
  const fs::path folder = name;
  std::ofstream(folder / "program.ngc") << program;
  std::ofstream(folder / "parameters") << "5161\t0.000000\n";
  std::ofstream(folder / "tool.tbl") << "T1 P1 Z0 D10\nT2 P2 Z0 D4.5\n";
  const std::string command = "cd '" + folder.string() +
                              "' && HOME=$PWD timeout 60 rs274 -g -n 2 -t tool.tbl "
                              "-v parameters program.ngc out </dev/null >log 2>&1";
  std::string said;
  if (std::system(command.c_str()) != 0) {
    std::ostringstream log;
    log << std::ifstream(folder / "log").rdbuf();
    said = "refused: " + log.str();
  }
  fs::remove_all(folder);
  return said;
}

} // namespace

TEST(PostsLinuxCnc, AcceptsAllThatIsSpelledAlike)
{
  if (!installed())
    GTEST_SKIP() << "rs274 (linuxcnc-uspace) is not installed";
  for (const char* post : {"linuxcnc", "mach", "fanuc"})
    for (const auto unit : {Unit::Millimetre, Unit::Inch})
      for (const auto retract : {Retract::Machine, Retract::Home, Retract::Clearance}) {
        auto writer = sample::writerFor(Post::named(post), unit);
        writer.setRetract(retract);
        writer.setLineNumbers(unit == Unit::Inch);
        const auto text = sample::files(writer, sample::twoTools())[""].str();
        EXPECT_EQ(complaint(text), "") << post << "\n" << text;
      }
  EXPECT_NE(complaint("G17 G21\nG187 P3\nM30\n"), "") << "it judges";
}
