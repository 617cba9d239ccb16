// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "comment_text.h"

#include <algorithm>

namespace pointmill::gcode {

namespace {

bool isLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// LinuxCNC obeys comments that start with a word and a comma: MSG, LOGOPEN, PY ...
void disarm(std::string& line, char instead)
{
  const auto comma = line.find(',');
  if (comma != std::string::npos &&
      std::all_of(line.begin(),
                  line.begin() + static_cast<std::ptrdiff_t>(comma),
                  [](char c) { return isLetter(c) || c == ' '; }))
    line[comma] = instead;
}

} // namespace

std::bitset<128> characterSet(const std::string& ranges)
{
  std::bitset<128> set;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const bool range = i + 2 < ranges.size() && ranges[i + 1] == '-';
    const char last = range ? ranges[i + 2] : ranges[i];
    for (int c = std::max<int>(ranges[i], ' '); c <= std::min<int>(last, '~'); ++c)
      set.set(static_cast<std::size_t>(c));
    i += range ? 2 : 0;
  }
  return set;
}

char CommentText::spell(char c) const
{
  if (upper_case && c >= 'a' && c <= 'z')
    c = static_cast<char>(c - 'a' + 'A');
  const auto may = [this](char a) { return allowed[static_cast<unsigned char>(a)]; };
  if (static_cast<unsigned char>(c) >= 0x80) // the first of a UTF-8 sequence
    c = '_';
  else if (!may(c) && (c == '(' || c == ')'))
    c = c == '(' ? '[' : ']';
  return may(c) ? c : ' ';
}

std::string CommentText::spellAll(const std::string& text) const
{
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\n')
      out += c;
    else if (byte < 0x80 || byte >= 0xC0) // one for each UTF-8 sequence
      out += spell(c);
  }
  return out;
}

std::vector<std::string> CommentText::lines(const std::string& text) const
{
  std::vector<std::string> lines;
  const std::string spelled = spellAll(text);
  std::size_t at = 0;
  while (at < spelled.size()) {
    const std::size_t newline = std::min(spelled.find('\n', at), spelled.size());
    std::size_t end = std::min(newline, at + widest);
    if (end < newline) {
      const auto blank = spelled.rfind(' ', end);
      if (blank != std::string::npos && blank > at)
        end = blank;
    }
    std::string line = spelled.substr(at, end - at);
    line.erase(line.find_last_not_of(' ') + 1);
    line.erase(0, line.find_first_not_of(' '));
    if (!line.empty()) {
      disarm(line, spell(':'));
      lines.push_back(line);
    }
    at = end < newline && spelled[end] != ' ' ? end : end + 1;
  }
  return lines;
}

} // namespace pointmill::gcode
