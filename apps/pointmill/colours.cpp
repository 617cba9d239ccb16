// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "colours.h"

#include <algorithm>
#include <string_view>

namespace {

constexpr const char* kBold = "\033[1m";
constexpr const char* kRed = "\033[1;31m";
constexpr const char* kGreen = "\033[1;32m";
constexpr const char* kYellow = "\033[1;33m";
constexpr const char* kPlain = "\033[0m";

/// What a line begins with, and how that is to look.
struct Beginning {
  std::string_view word;
  const char* look;
  bool whole_line = false;
};
constexpr Beginning kBeginnings[] = {{"error", kRed},
                                     {"pointmill:", kRed},
                                     {"refused", kRed},
                                     {"warning", kYellow},
                                     {"mind", kYellow},
                                     {"passed", kGreen},
                                     {"verified", kGreen},
                                     {"operation ", kBold, true},
                                     {"section ", kBold, true}};

std::string colouredLine(std::string_view line)
{
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  const std::string_view words = line.substr(indent);
  for (const Beginning& b : kBeginnings) {
    if (words.substr(0, b.word.size()) != b.word)
      continue;
    const std::size_t end = b.whole_line ? words.size() : b.word.size();
    if (!b.whole_line && end < words.size() && words[end] != ' ')
      continue; // the beginning of another word
    return std::string(line.substr(0, indent)) + b.look +
           std::string(words.substr(0, end)) + kPlain + std::string(words.substr(end));
  }
  return std::string(line);
}

} // namespace

std::string coloured(const std::string& text)
{
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    result += colouredLine(std::string_view(text).substr(begin, end - begin));
    if (end < text.size())
      result += '\n';
    begin = end + 1;
  }
  return result;
}
