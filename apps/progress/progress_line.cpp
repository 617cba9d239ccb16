// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "progress_line.h"

#include "terminal.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pointmill {
namespace {

constexpr double kPeriod = 0.1;         // s
constexpr std::size_t kStageWidth = 20; // so that the bar stands still
constexpr std::size_t kLeastBar = 10, kLongestBar = 40;

/// Minutes and seconds, "0:07"; hours where there are any, "1:02:07".
std::string clock(double seconds)
{
  const long whole = std::lround(seconds), hours = whole / 3600;
  char text[64];
  if (hours > 0)
    std::snprintf(
        text, sizeof text, "%ld:%02ld:%02ld", hours, whole / 60 % 60, whole % 60);
  else
    std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
  return text;
}

std::string bar(double share, std::size_t width)
{
  const auto full = static_cast<std::size_t>(share * static_cast<double>(width));
  return "[" + std::string(full, '#') + std::string(width - full, ' ') + "]";
}

} // namespace

std::string progressLine(const Progress& progress, int width)
{
  const auto room = static_cast<std::size_t>(std::max(width, 0));
  const double share = std::clamp(progress.share, 0.0, 1.0);
  std::string stage = progress.stage;
  stage.resize(std::max(stage.size(), kStageWidth), ' ');
  char percent[16]; // what is not done is not 100 %
  std::snprintf(percent, sizeof percent, "  %2d %%", static_cast<int>(100 * share));
  std::string times = "  " + clock(progress.seconds);
  if (progress.left)
    times += ", about " + clock(*progress.left) + " left";
  const std::size_t words = stage.size() + std::string(percent).size() + times.size();
  if (words + kLeastBar + 2 <= room)
    return stage + bar(share, std::min(room - words - 2, kLongestBar)) + percent +
           times;
  std::string line = progress.stage + percent;
  if (line.size() + times.size() <= room)
    line += times;
  return line.substr(0, room);
}

ProgressLine::ProgressLine(const Watch& watch)
{
  if (isTerminal(STDERR_FILENO))
    teller_ = std::make_unique<ProgressTeller>(
        watch, kPeriod, [this](const Progress& progress) {
          // The last column stays free: there some terminals begin a new line.
          show(progressLine(progress, terminalWidth(STDERR_FILENO) - 1));
        });
}

ProgressLine::~ProgressLine()
{
  teller_.reset();
  if (shown_ == 0)
    return;
  show("");
  show("");
}

// In blanks, not in codes that some terminals do not know.
void ProgressLine::show(const std::string& line)
{
  std::string text = "\r" + line;
  if (line.size() < shown_)
    text += std::string(shown_ - line.size(), ' ');
  shown_ = line.size();
  // Where it cannot be written there is nothing to be done about it.
  [[maybe_unused]] const auto written =
      ::write(STDERR_FILENO, text.data(), text.size());
}

} // namespace pointmill
