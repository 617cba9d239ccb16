// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// LinuxCNC's interpreter takes what is written for the controls that speak as it does.
#include "linuxcnc.h"
#include "two_tools.h"

#include <gtest/gtest.h>

using pointmill::Post;
using pointmill::Retract;
using pointmill::Unit;

namespace {

/// What the interpreter says against @p program; empty: nothing.
std::string complaint(const std::string& program)
{
  const auto judgement = linuxcnc::judge(program);
  return judgement.status == 0 ? "" : "refused: " + judgement.errors;
}

} // namespace

TEST(PostsLinuxCnc, AcceptsAllThatIsSpelledAlike)
{
  NEED_LINUXCNC();
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
