// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "comment_text.h"

#include <algorithm>

namespace pointmill::gcode {

namespace {

constexpr std::size_t widest = 78;

bool isLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string toAscii(const std::string& text)
{
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\n')
      out += '\n';
    else if (c == '(')
      out += '[';
    else if (c == ')')
      out += ']';
    else if (byte >= 0xC0)
      out += '_'; // one for each UTF-8 sequence
    else if (byte < 0x80)
      out += byte < 0x20 || byte == 0x7F ? ' ' : c;
  }
  return out;
}

/// LinuxCNC obeys comments that start with a word and a comma: MSG, LOGOPEN, PY ...
void disarm(std::string& line)
{
  const auto comma = line.find(',');
  if (comma != std::string::npos &&
      std::all_of(line.begin(),
                  line.begin() + static_cast<std::ptrdiff_t>(comma),
                  [](char c) { return isLetter(c) || c == ' '; }))
    line[comma] = ':';
}

} // namespace

std::vector<std::string> commentLines(const std::string& text)
{
  std::vector<std::string> lines;
  const std::string ascii = toAscii(text);
  std::size_t at = 0;
  while (at < ascii.size()) {
    const std::size_t newline = std::min(ascii.find('\n', at), ascii.size());
    std::size_t end = std::min(newline, at + widest);
    if (end < newline) {
      const auto blank = ascii.rfind(' ', end);
      if (blank != std::string::npos && blank > at)
        end = blank;
    }
    std::string line = ascii.substr(at, end - at);
    line.erase(line.find_last_not_of(' ') + 1);
    line.erase(0, line.find_first_not_of(' '));
    if (!line.empty()) {
      disarm(line);
      lines.push_back(line);
    }
    at = end < newline && ascii[end] != ' ' ? end : end + 1;
  }
  return lines;
}

} // namespace pointmill::gcode
