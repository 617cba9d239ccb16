// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "wrap.h"

#include <iterator>
#include <sstream>

namespace pointmill::visual {

std::vector<std::string>
wrapText(const std::string& text, int width, std::size_t most, const TextStyle& style)
{
  std::istringstream stream(text);
  const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
  std::vector<std::string> lines;
  const auto join = [&](std::size_t first, std::size_t last) {
    std::string line = words[first];
    for (std::size_t i = first + 1; i < last; ++i)
      line += " " + words[i];
    return line;
  };
  for (std::size_t first = 0, last; first < words.size(); first = last) {
    last = words.size();
    if (lines.size() + 1 != most) {
      std::size_t wide = last + 1; // ends of lines: `last` fits, or is one word
      for (last = first + 1; wide - last > 1;) {
        const std::size_t middle = (last + wide) / 2;
        (textWidth(join(first, middle), style) <= width ? last : wide) = middle;
      }
    }
    lines.push_back(fitText(join(first, last), width, style));
  }
  return lines;
}

} // namespace pointmill::visual
