// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "readers.h"
#include "text.h"

#include <pointmill/common/watch.h>

#include <cctype>

namespace pointmill::detail {

namespace {

/// How the lines of a file are divided, as its first point tells.
struct Layout {
  char separator = ' ';                       ///< ' ' for blanks, ',' or ';'
  std::array<std::size_t, 3> column{0, 1, 2}; ///< of x, y and z
};

// Steps from one value to the next; false where there is none. Just one kind of
// separator, so that decimal commas are an error and not other numbers.
bool takeSeparator(Text& line, char separator)
{
  const char* before = line.at;
  skipBlanks(line);
  if (separator == ' ')
    return line.at != before && !line.done();
  if (line.done() || *line.at != separator)
    return false;
  ++line.at;
  skipBlanks(line);
  return true;
}

void skipValue(Text& line, char separator)
{
  while (!line.done() && *line.at != separator &&
         !(separator == ' ' && isBlank(*line.at)))
    ++line.at;
}

std::vector<std::string> values(Text line, char separator)
{
  std::vector<std::string> list;
  skipBlanks(line);
  do {
    const char* from = line.at;
    skipValue(line, separator);
    list.emplace_back(from, line.at);
  } while (takeSeparator(line, separator) && !line.done());
  return list;
}

// "Y (mm)" and "\"y\"" name the column y.
std::string columnName(const std::string& text)
{
  std::string name;
  for (const char c : lower(text)) {
    if (std::isalnum(static_cast<unsigned char>(c)))
      name += c;
    else if (!name.empty())
      break;
  }
  return name;
}

Layout layoutOf(const Text& header, Text first)
{
  Layout layout;
  const Text row = first;
  double value;
  skipBlanks(first);
  if (takeNumber(first, value))
    skipBlanks(first);
  else // a first column of words, which the header may explain
    while (!first.done() && *first.at != ',' && *first.at != ';' && !isBlank(*first.at))
      ++first.at;
  if (!first.done() && (*first.at == ',' || *first.at == ';'))
    layout.separator = *first.at;
  const auto names = values(header, layout.separator);
  if (header.done() || names.size() != values(row, layout.separator).size())
    return layout;
  std::array<std::size_t, 3> found{};
  std::array<int, 3> times{};
  for (std::size_t i = 0; i < names.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      if (columnName(names[i]) == std::string(1, static_cast<char>('x' + axis))) {
        found[axis] = i;
        ++times[axis];
      }
  if (times == std::array<int, 3>{1, 1, 1})
    layout.column = found;
  return layout;
}

bool takePoint(Text line, const Layout& layout, Eigen::Vector3d& point)
{
  const auto [x, y, z] = layout.column;
  const std::size_t last = std::max({x, y, z});
  for (std::size_t i = 0; i <= last; ++i) {
    if (i > 0 && !takeSeparator(line, layout.separator))
      return false;
    if (i != x && i != y && i != z) {
      skipValue(line, layout.separator);
      continue;
    }
    if (!takeNumber(line, point[i == x ? 0 : i == y ? 1 : 2]))
      return false;
    if (!atBreak(line) && *line.at != layout.separator)
      return false;
  }
  return true;
}

bool isComment(const Text& line)
{
  return *line.at == '#' ||
         (line.end - line.at > 1 && line.at[0] == '/' && line.at[1] == '/');
}

// A line that holds one whole number and nothing else.
bool isCount(Text line, unsigned long long& count)
{
  if (!takeWholeNumber(line, count))
    return false;
  skipBlanks(line);
  return line.done();
}

bool beginsWithWord(const Text& line)
{
  double value;
  Text number = line;
  if (takeNumber(number, value) &&
      (atBreak(number) || *number.at == ',' || *number.at == ';'))
    return false; // nan, inf
  const auto c = static_cast<unsigned char>(*line.at);
  return std::isalpha(c) || c == '"' || c == '_' || c >= 128;
}

} // namespace

RawScan readText(const Source& source)
{
  RawScan scan;
  scan.format = "text";
  Text rest{source.begin(), source.end()};
  if (source.size() >= 3 && std::string(rest.at, 3) == "\xef\xbb\xbf")
    rest.at += 3; // the mark that some editors put before UTF-8
  Text line{}, header{nullptr, nullptr};
  unsigned long long announced = 0;
  bool counted = false;
  Layout layout;
  const WorkStep step({0.0, 1.0});
  while (takeLine(rest, line)) {
    step.reach(source.shareBefore(line.at));
    skipBlanks(line);
    if (line.done() || isComment(line))
      continue;
    if (scan.points.empty()) {
      if (!counted && isCount(line, announced)) {
        counted = true;
        continue;
      }
      if (header.done() && beginsWithWord(line)) {
        header = line;
        continue;
      }
      layout = layoutOf(header, line);
      // A fair guess, never more than the file can hold.
      scan.points.reserve(source.size() /
                          static_cast<std::size_t>(line.end - line.at + 8));
    }
    Eigen::Vector3d point;
    if (!takePoint(line, layout, point))
      source.failAt(line.at,
                    quoted(line) + " is not a point; write x y z in each line, "
                                   "with decimal points");
    scan.points.push_back(point);
  }
  if (counted && announced > scan.points.size())
    source.failShort(announced, "points");
  if (counted && announced < scan.points.size())
    source.fail("holds " + std::to_string(scan.points.size()) + " points where " +
                std::to_string(announced) + " are announced; correct the number");
  return scan;
}

} // namespace pointmill::detail
