// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "readers.h"
#include "text.h"

#include <pointmill/common/watch.h>

#include <limits>

namespace pointmill::detail {

namespace {

constexpr const char* again = "; export the mesh again";

// One corner of a face, `v`, `v/vt`, `v//vn` or `v/vt/vn`, as an index from 0.
std::uint32_t takeCorner(Text& line, std::size_t vertices, const Source& source)
{
  const Text word = line;
  long long index = 0;
  const bool number = takeNumber(line, index) && (atBreak(line) || *line.at == '/');
  // -1 is the vertex just before.
  if (index < 0)
    index += static_cast<long long>(vertices) + 1;
  if (!number || index < 1 || index > std::numeric_limits<std::uint32_t>::max())
    source.failAt(word.at, quoted(word) + " is not a vertex of a face" + again);
  skipWord(line);
  return static_cast<std::uint32_t>(index - 1);
}

// Steps over blanks, and over line ends that a backslash hides.
void skipToWord(Text& rest, Text& line)
{
  skipBlanks(line);
  while (!line.done() && *line.at == '\\') {
    Text after{line.at + 1, line.end};
    skipBlanks(after);
    if (!after.done() || !takeLine(rest, line))
      return;
    skipBlanks(line);
  }
}

} // namespace

RawScan readObj(const Source& source)
{
  RawScan scan;
  scan.format = "OBJ";
  Text rest{source.begin(), source.end()};
  Text line{};
  std::vector<std::uint32_t> corners;
  const WorkStep step({0.0, 1.0});
  while (takeLine(rest, line)) {
    step.reach(source.shareBefore(line.at));
    const Text whole = line;
    skipBlanks(line);
    if (line.end - line.at < 2 || !isBlank(line.at[1]))
      continue;
    const char key = *line.at++;
    if (key == 'v') {
      Eigen::Vector3d point;
      for (double& value : point) {
        skipToWord(rest, line);
        if (!takeWholeNumber(line, value))
          source.failAt(whole.at, quoted(whole) + " is not a vertex" + again);
      }
      scan.points.push_back(point);
    }
    else if (key == 'f') {
      corners.clear();
      for (skipToWord(rest, line); !line.done() && *line.at != '#';
           skipToWord(rest, line))
        corners.push_back(takeCorner(line, scan.points.size(), source));
      addFan(corners, scan);
    }
  }
  return scan;
}

} // namespace pointmill::detail
