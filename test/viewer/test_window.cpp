// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// The viewer itself, in a window on a display in memory, driven by keys.
#include "picture.h"
#include "screen.h"

#include <gtest/gtest.h>

using namespace viewer_test;

namespace {

bool installed(const char* program)
{
  return std::system((std::string("command -v ") + program + " >/dev/null").c_str()) ==
         0;
}

std::string quoted(const std::string& text)
{
  return "'" + text + "'";
}

class Window : public testing::Test {
protected:
  static void SetUpTestSuite()
  {
    job_ = new TemporaryFolder;
    made_ = std::system((std::string(POINTMILL_PROGRAM) +
                         " mill " POINTMILL_DATA
                         "/dome.pcd -q --finish-diameter 6 --semi-scallop 0.1 "
                         "--scallop 0.05 -o " +
                         quoted(job_->file("job")))
                            .c_str());
    std::filesystem::create_directory(job_->file("screen"));
  }
  static void TearDownTestSuite()
  {
    delete job_;
    job_ = nullptr;
  }
  void SetUp() override
  {
    if (!installed("Xvfb") || !installed("xdotool"))
      GTEST_SKIP() << "needs Xvfb and xdotool";
    ASSERT_EQ(made_, 0);
    screen_ = std::make_unique<Screen>(job_->file("screen"));
    empty_ = screen_->pixels();
  }
  /// Starts the viewer and waits until the window is drawn.
  void open(std::vector<std::string> words)
  {
    words.insert(words.begin(), POINTMILL_VIEWER);
    viewer_ = std::make_unique<Process>(std::move(words), job_->file("out"));
    ASSERT_TRUE(
        waitFor([&] { return changedSince(empty_) > 200'000 || viewer_->ended(); }));
    ASSERT_FALSE(viewer_->ended()) << readBytes(job_->file("out"));
    settle();
  }
  std::size_t changedSince(const std::vector<char>& before) const
  {
    return Screen::changed(before, screen_->pixels());
  }
  /// Waits until nothing has moved for a while; a loaded machine draws seldom.
  void settle() const
  {
    using Clock = std::chrono::steady_clock;
    constexpr auto still = std::chrono::milliseconds(2500);
    auto last = screen_->pixels();
    auto since = Clock::now();
    waitFor(
        [&] {
          auto now = screen_->pixels();
          if (Screen::changed(last, now) > 0) {
            last = std::move(now);
            since = Clock::now();
          }
          return Clock::now() - since > still;
        },
        60);
  }
  /// How much a key changes.
  std::size_t press(const std::string& key) const
  {
    const auto before = screen_->pixels();
    Screen::key(key);
    waitFor([&] { return changedSince(before) > 0; }, 20);
    settle();
    return changedSince(before);
  }
  void closeBy(const std::string& key)
  {
    Screen::key(key);
    EXPECT_TRUE(waitFor([&] { return viewer_->ended(); }));
    EXPECT_EQ(viewer_->exitCode(), 0);
  }

  static TemporaryFolder* job_;
  static int made_;
  std::unique_ptr<Screen> screen_;
  std::unique_ptr<Process> viewer_;
  std::vector<char> empty_;
};

TemporaryFolder* Window::job_ = nullptr;
int Window::made_ = -1;

} // namespace

TEST_F(Window, ShowsAJobAndTakesKeys)
{
  open({job_->file("job")});
  EXPECT_GT(press("v"), 5000u);  // the part instead of the stock
  EXPECT_GT(press("v"), 1000u);  // its deviations
  EXPECT_GT(press("F2"), 5000u); // from above
  EXPECT_GT(press("t"), 100u);   // another choice of paths
  EXPECT_GT(press("m"), 5000u);  // the map
  EXPECT_GT(press("Next"), 20u); // a level down: at least its number
  EXPECT_GT(press("h"), 20'000u);
  EXPECT_GT(press("h"), 20'000u);
  EXPECT_GT(press("i"), 1000u); // no texts
  closeBy("q");
  EXPECT_NE(readBytes(job_->file("out")).find("switch to a point-based"),
            std::string::npos); // PCL's own help
}

TEST_F(Window, PlaysTheCutAndStops)
{
  open({job_->file("job"), "--at", "20%", "--speed", "20"});
  const auto before = screen_->pixels();
  Screen::key("space");
  for (int i = 0; i < 3; ++i) { // it goes on without further keys
    const auto now = screen_->pixels();
    EXPECT_TRUE(waitFor([&] { return changedSince(now) > 0; }));
  }
  Screen::key("space");
  settle();
  EXPECT_GT(changedSince(before), 500u);
  const auto stopped = screen_->pixels();
  std::this_thread::sleep_for(std::chrono::seconds(1));
  EXPECT_EQ(changedSince(stopped), 0u);
  EXPECT_GT(press("Home"), 5000u); // the whole block
  closeBy("q");
}

TEST_F(Window, ShowsCloudsAsPclsViewerDoes)
{
  open({POINTMILL_DATA "/saddle.pcd", "-ps", "4", "-bc", "20,20,40"});
  EXPECT_GT(press("2"), 1000u); // coloured by x instead of z
  EXPECT_GT(press("1"), 1000u); // and back
  EXPECT_GT(press("u"), 1000u); // its table of colours
  closeBy("e");
}

TEST_F(Window, SaysWhatIsWrongInsteadOfOpening)
{
  const auto fails = [&](std::vector<std::string> words, int code, const char* what) {
    words.insert(words.begin(), POINTMILL_VIEWER);
    Process process(words, job_->file("out"));
    EXPECT_TRUE(waitFor([&] { return process.ended(); }));
    EXPECT_EQ(process.exitCode(), code);
    EXPECT_NE(readBytes(job_->file("out")).find(what), std::string::npos)
        << readBytes(job_->file("out"));
  };
  fails({}, 1, "INPUT");
  fails({job_->file("job"), "--view", "below"}, 1, "iso|top");
  fails({job_->file("job"), "--at", "soon"}, 1, "--at takes");
  fails({job_->file("job"), "--at", "-5"}, 1, "--at takes");
  fails({job_->file("job"), "--at", "1:90:99"}, 1, "--at takes");
  fails({job_->file("job"), "--at", "line 99999999"}, 1, "has lines 1 ..");
  fails({job_->file("job"), "--screenshot", "a.jpg"}, 1, ".png");
  fails({job_->file("job"), "--finding", "99"}, 1, "there is no finding 99");
  fails({job_->file("job"), "--level", "999"}, 1, "there is no level 999");
  fails({job_->file("none.pcd")}, 2, "none.pcd");
  fails({POINTMILL_DATA}, 2, "report.json");
  fails({POINTMILL_DATA "/dome.pcd", "--program", "x.ngc"}, 1, "directory of a job");
  unsetenv("DISPLAY");
  fails({job_->file("job")}, 2, "no display");
}
