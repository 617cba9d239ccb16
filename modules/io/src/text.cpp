// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "text.h"

#include <pointmill/common/watch.h>

#include <algorithm>
#include <charconv>
#include <cstring>

namespace pointmill::detail {

namespace {

template <typename Number>
bool take(Text& text, Number& value)
{
  const char* from = text.at;
  if (text.end - from > 1 && *from == '+' && from[1] != '-')
    ++from;
  const auto [next, error] = std::from_chars(from, text.end, value);
  if (error != std::errc())
    return false;
  text.at = next;
  return true;
}

} // namespace

bool takeLine(Text& rest, Text& line)
{
  checkInterrupted(); // files are long
  if (rest.done())
    return false;
  const auto length = static_cast<std::size_t>(rest.end - rest.at);
  const auto* stop = static_cast<const char*>(std::memchr(rest.at, '\n', length));
  line = {rest.at, stop ? stop : rest.end};
  rest.at = stop ? stop + 1 : rest.end;
  return true;
}

std::string takeWord(Text& text)
{
  skipBlanks(text);
  const char* from = text.at;
  skipWord(text);
  return {from, text.at};
}

bool takeNumber(Text& text, double& value)
{
  return take(text, value);
}
bool takeNumber(Text& text, long long& value)
{
  return take(text, value);
}
bool takeNumber(Text& text, unsigned long long& value)
{
  return take(text, value);
}

std::string quoted(const Text& line)
{
  constexpr std::ptrdiff_t longest = 40;
  const char* stop = line.end;
  while (stop != line.at && isBlank(stop[-1]))
    --stop;
  if (stop - line.at <= longest)
    return "'" + std::string(line.at, stop) + "'";
  return "'" + std::string(line.at, line.at + longest) + "...'";
}

std::string lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

} // namespace pointmill::detail
