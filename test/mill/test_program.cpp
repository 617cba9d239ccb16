// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// The program for every control, in every form, is read back and passes; what fails is
// refused, or forced and marked.
#include "mill_test.h"

#include <nlohmann/json.hpp>

#include <algorithm>

using namespace mill_test;

namespace {

/// Coarse, so that all posts can be tried.
MillOptions coarse()
{
  MillOptions options;
  options.tolerance = 0.05;
  options.scallop = 0.1;
  options.semi_scallop = 0.2;
  options.stock_top = 0.5;
  return options;
}

/// Options with which the dome's program is refused.
MillOptions tooMuchLeft()
{
  MillOptions options = coarse();
  options.finish.allowance = 0.3;
  options.residual_limit = 0.05;
  return options;
}

class EveryPost : public testing::TestWithParam<std::string> {};

} // namespace

TEST_P(EveryPost, MillsAndIsReadBack)
{
  MillOptions options = coarse();
  options.writer.setPost(Post::named(GetParam()));
  MillJob job(options);
  ASSERT_NO_THROW(job.plan(data("dome.pcd")));
  const Verification& v = job.verification();
  EXPECT_TRUE(v.good());
  EXPECT_LE(v.gouge, job.criteria().gougeLimit());
  EXPECT_LT(v.residual.p50, 0.02);
  EXPECT_GT(v.feed_moves, 1000u);
  EXPECT_EQ(job.judgement().time.sections.size(), job.operations().size());
  double minutes = 0;
  for (const auto& o : job.operations()) {
    EXPECT_GT(o.figures.minutes, 0) << o.operation.name;
    minutes += o.figures.minutes;
  }
  EXPECT_NEAR(minutes, job.minutes(), 1e-9);
  for (const auto& program : job.programs())
    EXPECT_EQ(fs::path(program.name).extension(),
              "." + options.writer.getPost().extension);
}

TEST_P(EveryPost, TakesInchesToo)
{
  MillOptions options = coarse();
  options.writer.setPost(Post::named(GetParam()));
  MillJob metric(options);
  metric.plan(data("cone.pcd"));
  options.writer.setUnit(Unit::Inch);
  MillJob inches(options);
  ASSERT_NO_THROW(inches.plan(data("cone.pcd")));
  EXPECT_TRUE(inches.judgement().program.inches);
  const Verification &a = metric.verification(), &b = inches.verification();
  EXPECT_NEAR(a.feed_length, b.feed_length, 1e-3 * a.feed_length);
  EXPECT_NEAR(a.residual.p50, b.residual.p50, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(All,
                         EveryPost,
                         testing::ValuesIn(Post::names()),
                         [](const auto& post) {
                           std::string name = post.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(MillProgram, AnArcKeepsWithinWhatItMayErr)
{
  MillOptions options = coarse();
  MillJob with(options);
  with.plan(data("dome.pcd"));
  options.arcs = false;
  MillJob without(options);
  without.plan(data("dome.pcd"));
  EXPECT_LT(with.programFigures().lines, 0.8 * without.programFigures().lines);
  const double most = ErrorBudget::of(options.tolerance).arcs;
  EXPECT_LE(with.verification().gouge, without.verification().gouge + most + 1e-3);
  EXPECT_NE(with.programs().front().text.find("G18"), std::string::npos);
}

TEST(MillProgram, InManyFilesItIsTheSameCut)
{
  MillOptions options = coarse();
  MillJob one(options);
  one.plan(data("dome.pcd"));
  options.writer.setToolChange(ToolChange::Program);
  MillJob tools(options);
  tools.plan(data("dome.pcd"));
  EXPECT_EQ(tools.programs().size(), 3u);
  options.writer.setMaxLines(500);
  MillJob many(options);
  many.plan(data("dome.pcd"));
  EXPECT_GT(many.programs().size(), one.programFigures().lines / 500);
  for (const auto& program : many.programs())
    EXPECT_LE(std::count(program.text.begin(), program.text.end(), '\n'), 500)
        << program.name;
  for (const MillJob* job : {&tools, &many}) {
    EXPECT_TRUE(job->verification().good());
    EXPECT_NEAR(
        job->verification().residual.p99, one.verification().residual.p99, 1e-3);
    EXPECT_NEAR(job->verification().gouge, one.verification().gouge, 1e-3);
    EXPECT_EQ(job->judgement().program.files.size(), job->programs().size());
    // Each file changes its tool once more, but the first of each tool.
    const double changes = 0.25 * (double(job->programs().size()) - 3);
    EXPECT_NEAR(job->minutes(), one.minutes() + changes, 0.5);
    for (std::size_t i = 0; i < job->operations().size(); ++i)
      EXPECT_GE(job->operations()[i].figures.minutes,
                one.operations()[i].figures.minutes - 0.3);
  }
}

TEST(MillProgram, ANewJobLeavesNoFileOfAnOldProgram)
{
  const TempDir folder;
  MillOptions options = coarse();
  options.writer.setToolChange(ToolChange::Program);
  MillJob tools(options);
  tools.plan(data("dome.pcd"));
  tools.write((folder / "nc").string());
  const auto programs = [&] {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder / "nc"))
      count += entry.path().filename().string().rfind("program", 0) == 0;
    return count;
  };
  EXPECT_EQ(programs(), 3);
  options.writer.setToolChange(ToolChange::Changer);
  MillJob one(options);
  one.plan(data("dome.pcd"));
  one.write((folder / "nc").string());
  EXPECT_EQ(programs(), 1);
  EXPECT_TRUE(fs::exists(folder / "nc/program.ngc"));
}

TEST(MillProgram, IsWrittenWhateverTheScanIsCalled)
{
  const TempDir folder;
  const std::string name = "my part (1), \xC3\xA4 scan of last week's second try.pcd";
  fs::copy_file(data("dome.pcd"), folder / name);
  MillOptions options = coarse();
  options.writer.setToolChange(ToolChange::Program);
  MillJob job(options);
  ASSERT_NO_THROW(job.plan((folder / name).string()));
  EXPECT_EQ(job.programs().size(), 3u);
}

TEST(MillProgram, ARefusalSaysWhyAndWritesNoProgram)
{
  const TempDir folder;
  MillJob job(tooMuchLeft());
  EXPECT_THROW(job.plan(data("dome.pcd")), VerificationError);
  job.writeRefusal((folder / "nc").string());
  EXPECT_FALSE(fs::exists(folder / "nc/program.ngc"));
  EXPECT_GT(fs::file_size(folder / "nc/refused.png"), 10000u);
  const auto report = nlohmann::json::parse(contents(folder / "nc/refused.json"));
  EXPECT_FALSE(report["verification"]["passed"].get<bool>());
  const auto& finding = report["verification"]["findings"][0];
  EXPECT_EQ(finding["code"], "residual");
  EXPECT_EQ(finding["severity"], "error");
  EXPECT_GT(finding["worst"].get<double>(), 0.05);

  MillJob good(coarse());
  EXPECT_THROW(good.writeRefusal((folder / "nc").string()), Error);
  good.plan(data("dome.pcd"));
  EXPECT_THROW(good.writeRefusal((folder / "nc").string()), Error);
  good.write((folder / "nc").string());
  EXPECT_FALSE(fs::exists(folder / "nc/refused.png")) << "beside a good program";
}

TEST(MillProgram, AForcedProgramSaysWhatIsWrongWithIt)
{
  const TempDir folder;
  MillOptions options = tooMuchLeft();
  options.force = true;
  MillJob job(options);
  ASSERT_NO_THROW(job.plan(data("dome.pcd")));
  EXPECT_FALSE(job.verification().good());
  job.write((folder / "nc").string());
  const std::string text = contents(folder / "nc/program.ngc");
  const auto head = text.substr(0, text.find("G21"));
  EXPECT_NE(head.find("FORCED"), std::string::npos) << head;
  EXPECT_NE(head.find("residual"), std::string::npos) << head;
  const auto report = nlohmann::json::parse(contents(folder / "nc/report.json"));
  EXPECT_TRUE(report["program"]["forced"].get<bool>());
  EXPECT_TRUE(fs::exists(folder / "nc/findings.png"));
}

TEST(MillProgram, FeedsKeepToTheMachine)
{
  MillOptions options = coarse();
  options.machine.max_feed = 700;
  MillJob job(options);
  job.plan(data("dome.pcd"));
  for (const auto& m : job.judgement().program.moves)
    ASSERT_LE(m.feed, 700);
  EXPECT_GT(job.programFigures().slowed, 0u);
  options.machine.max_spindle = 10000;
  EXPECT_THROW(MillJob(options).plan(data("dome.pcd")), ParameterError);
}
