// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// What a job does to the disk, and what it refuses.
#include "mill_test.h"

#include <pointmill/common/watch.h>

#include <atomic>
#include <iterator>
#include <set>
#include <thread>

using namespace mill_test;

namespace {

/// Options with which the dome's program is refused.
MillOptions tooMuchLeft()
{
  MillOptions options;
  options.finish.allowance = 0.3;
  options.residual_limit = 0.05;
  return options;
}

} // namespace

TEST(MillJob, ARefusedProgramIsNotWritten)
{
  const TempDir folder;
  MillJob job(tooMuchLeft());
  EXPECT_THROW(job.plan(data("dome.pcd")), VerificationError);
  EXPECT_FALSE(job.verification().good());
  // Who does not heed the exception gets no program all the same.
  EXPECT_THROW(job.write((folder / "nc").string()), Error);
  EXPECT_FALSE(fs::exists(folder / "nc" / "program.ngc"));
  EXPECT_TRUE(folder.names().empty());
}

TEST(MillJob, ARefusedProgramLeavesNoEarlierOneInItsPlace)
{
  const TempDir folder;
  fs::create_directory(folder / "nc");
  std::ofstream(folder / "nc/program.ngc") << "(earlier)";
  MillJob job(tooMuchLeft());
  try {
    job.plan(data("dome.pcd"));
    FAIL() << "not refused";
  }
  catch (const VerificationError& e) {
    const std::string why = e.what();
    EXPECT_NE(why.find("half of the points keep"), std::string::npos) << why;
  }
  EXPECT_THROW(job.write((folder / "nc").string()), VerificationError);
  EXPECT_EQ(contents(folder / "nc/program.ngc"), "(earlier)");
  job.writeRefusal((folder / "nc").string());
  EXPECT_TRUE(job.earlierProgram());
  EXPECT_FALSE(fs::exists(folder / "nc/program.ngc"));
  EXPECT_EQ(contents(folder / "nc/program.ngc.earlier"), "(earlier)");
}

TEST(MillJob, WithoutAPlanNothingIsWritten)
{
  const TempDir folder;
  MillJob job{MillOptions()};
  EXPECT_THROW(job.write((folder / "nc").string()), Error);
  EXPECT_TRUE(folder.names().empty());
}

TEST(MillJob, AFailedPlanAfterAGoodOneIsNotWrittenEither)
{
  const TempDir folder;
  MillJob job{MillOptions()};
  job.plan(data("dome.pcd"));
  EXPECT_THROW(job.plan((folder / "missing.pcd").string()), DataError);
  EXPECT_THROW(job.write((folder / "nc").string()), Error);
  EXPECT_FALSE(fs::exists(folder / "nc" / "program.ngc"));
}

TEST(MillJob, WritesIntoADirectoryThatIsThereAndKeepsWhatIsInIt)
{
  const TempDir folder;
  fs::create_directories(folder / "a/nc");
  std::ofstream(folder / "a/nc/notes.txt") << "mine";
  std::ofstream(folder / "a/nc/program.ngc") << "(earlier)";
  MillJob job{MillOptions()};
  job.plan(data("dome.pcd"));
  for (const char* name : {"a/nc", "a/nc/", "b/c/d"}) {
    job.write((folder / name).string());
    EXPECT_TRUE(contents(folder / name / "program.ngc") == job.programs().front().text)
        << name;
  }
  EXPECT_EQ(contents(folder / "a/nc/notes.txt"), "mine");
  for (const auto& entry : fs::recursive_directory_iterator(folder / ""))
    EXPECT_EQ(entry.path().string().find("partial"), std::string::npos) << entry;
}

TEST(MillJob, WhereItCannotWriteItSaysSoAndLeavesNothing)
{
  const TempDir folder;
  std::ofstream(folder / "file") << "x";
  MillJob job{MillOptions()};
  job.plan(data("dome.pcd"));
  EXPECT_THROW(job.write((folder / "file").string()), DataError);
  EXPECT_THROW(job.write((folder / "file/nc").string()), DataError);
  EXPECT_THROW(job.write(""), DataError);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"file"});
  EXPECT_EQ(contents(folder / "file"), "x");
}

TEST(MillJob, ADirectoryThatWouldOverwriteTheScanIsRefused)
{
  const TempDir folder;
  fs::create_directory(folder / "scans");
  const auto check = [&](const fs::path& scan, const fs::path& directory) {
    MillJob::checkDirectory(scan.string(), directory.string());
  };
  for (const char* name : {"part.pcd", "cl.pcd"}) {
    std::ofstream(folder / "scans" / name) << "a scan";
    EXPECT_THROW(check(folder / "scans" / name, folder / "scans"), DataError);
    EXPECT_THROW(check(folder / "scans/../scans" / name, folder / "scans/."),
                 DataError);
    fs::create_symlink(folder / "scans" / name, folder / name);
    EXPECT_THROW(check(folder / name, folder / "scans"), DataError) << "by a link";
  }
  std::ofstream(folder / "scans/dome.pcd") << "a scan";
  EXPECT_NO_THROW(check(folder / "scans/dome.pcd", folder / "scans"));
  EXPECT_THROW(check(folder / "scans/dome.pcd", folder / "scans/dome.pcd"), DataError);
  EXPECT_NO_THROW(check(folder / "scans/dome.pcd", folder / "new"));
}

TEST(MillJob, ASecondPlanDoesNotRememberTheFirst)
{
  MillJob both{MillOptions()}, fresh{MillOptions()};
  both.plan(data("cone.pcd"));
  both.plan(data("dome.pcd"));
  fresh.plan(data("dome.pcd"));
  EXPECT_TRUE(both.programs().front().text == fresh.programs().front().text);
  EXPECT_EQ(both.operations().size(), fresh.operations().size());
}

TEST(MillJob, ProgressOnlyGrowsAndEndsAtOne)
{
  const Watch watch;
  std::atomic<bool> ended{false};
  std::set<std::string> stages;
  std::thread looks([&] {
    for (double last = 0; !ended; std::this_thread::yield()) {
      stages.insert(watch.stage());
      const double share = watch.share();
      EXPECT_GE(share, last);
      EXPECT_LE(share, 1);
      last = share;
    }
  });
  const TempDir folder;
  MillJob job{MillOptions()};
  job.plan(data("cone.pcd"));
  const double planned = watch.share();
  job.write((folder / "nc").string());
  ended = true;
  looks.join();
  EXPECT_GT(planned, 0.3);
  EXPECT_LT(planned, 1);
  EXPECT_DOUBLE_EQ(watch.share(), 1);
  EXPECT_GT(stages.size(), 5u);
  EXPECT_EQ(stages.count("finishing"), 1u);
}

TEST(MillJob, StopsAnywhereAndLeavesWhatWasThere)
{
  const TempDir folder;
  fs::create_directory(folder / "nc");
  std::ofstream(folder / "nc/program.ngc") << "(earlier)";
  for (const double share : {0.0, 0.05, 0.2, 0.4, 0.6, 0.75}) {
    Watch watch;
    std::atomic<bool> ended{false};
    std::thread stops([&] {
      while (!ended && watch.share() < share)
        std::this_thread::yield();
      watch.stop();
    });
    MillJob job{MillOptions()};
    const auto mill = [&] {
      job.plan(data("dome.pcd"));
      job.write((folder / "nc").string());
    };
    EXPECT_THROW(mill(), Interrupted) << share;
    ended = true;
    stops.join();
    EXPECT_EQ(folder.names(), std::vector<std::string>{"nc"}) << share;
    EXPECT_EQ(contents(folder / "nc/program.ngc"), "(earlier)") << share;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "nc"), {}), 1) << share;
  }
}

TEST(MillJob, EveryShapeIsMilledAndVerified)
{
  for (const char* name : {"plane", "dome", "cone", "stairs", "channel", "saddle"}) {
    for (const auto strategy : {RoughingStrategy::ZigZag, RoughingStrategy::Spiral}) {
      MillOptions options;
      options.roughing = strategy;
      options.tolerance = 0.03; // a point in 0.5 mm: the ball sinks between them
      options.stock_margin = 3;
      options.stock_top = 0.5;
      MillJob job(options);
      EXPECT_NO_THROW(job.plan(data(std::string(name) + ".pcd"))) << name;
      EXPECT_LT(job.verification().residual.p50, 0.1) << name;
    }
  }
}

TEST(MillJob, AWrongUnitIsRefusedWithAdvice)
{
  MillOptions options;
  options.mm_per_unit = 1000;
  try {
    MillJob(options).plan(data("dome.pcd"));
    FAIL() << "60 m were taken";
  }
  catch (const DataError& e) {
    EXPECT_NE(std::string(e.what()).find("--units"), std::string::npos) << e.what();
  }
  options.fit = 50;
  MillJob fitted(options);
  fitted.plan(data("dome.pcd"));
  EXPECT_NEAR(fitted.partSize().maxCoeff(), 50, 1e-3);
}
