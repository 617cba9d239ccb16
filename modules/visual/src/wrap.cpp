// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "wrap.h"

#include <sstream>

namespace pointmill::visual {

std::vector<std::string>
wrapText(const std::string& text, int width, std::size_t most, const TextStyle& style)
{
  std::vector<std::string> lines;
  std::istringstream words(text);
  std::string line, word;
  while (words >> word) {
    const std::string longer = line.empty() ? word : line + " " + word;
    if (line.empty() || lines.size() + 1 == most || textWidth(longer, style) <= width)
      line = longer;
    else {
      lines.push_back(fitText(line, width, style));
      line = word;
    }
  }
  if (!line.empty())
    lines.push_back(fitText(line, width, style));
  return lines;
}

} // namespace pointmill::visual
