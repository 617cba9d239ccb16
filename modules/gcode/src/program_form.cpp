// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Which form a text is in, by what only one of them has.
#include "number.h"

#include <pointmill/gcode/gcode_reader.h>

#include <string>

namespace pointmill {

using namespace gcode;

namespace {

std::string upperCase(std::string_view text)
{
  std::string out(text);
  for (char& c : out)
    c = upper(c);
  return out;
}

bool contains(const std::string& line, const char* what)
{
  return line.find(what) != std::string::npos;
}

/// Takes blanks and a word of @p letter (none: '\0') with its number off.
void skipNumber(std::string_view& line, char letter)
{
  const auto skip = [&line](auto is) {
    while (!line.empty() && is(line.front()))
      line.remove_prefix(1);
  };
  skip(isBlank);
  if (letter != '\0') {
    if (line.empty() || line.front() != letter)
      return;
    line.remove_prefix(1);
  }
  skip(isDigit);
  skip(isBlank);
}

/// "0 BEGIN PGM NAME MM"
bool beginsKlartext(std::string_view line)
{
  skipNumber(line, '\0');
  return line.substr(0, 9) == "BEGIN PGM";
}

/// "%NAME G71", behind which only the end of the block stands.
bool beginsHeidenhainIso(std::string_view line)
{
  skipNumber(line, 'N');
  if (line.empty() || line.front() != '%')
    return false;
  const auto blank = line.find_first_of(" \t");
  if (blank == std::string_view::npos || blank == 1)
    return false;
  const auto unit = line.find_first_not_of(" \t", blank);
  return unit != std::string_view::npos &&
         (line.substr(unit, 3) == "G71" || line.substr(unit, 3) == "G70");
}

/// The words of a line, without its comments.
std::string withoutComments(const std::string& line)
{
  std::string words;
  bool inside = false;
  for (const char c : line.substr(0, line.find(';'))) {
    // Behind a name it is a call of Siemens's.
    if (c == '(' &&
        (words.empty() || (!isLetter(words.back()) && !isDigit(words.back()))))
      inside = true;
    if (!inside)
      words += c;
    if (c == ')')
      inside = false;
  }
  return words;
}

bool isSiemens(const std::string& words)
{
  for (const char* const mark : {"SUPA",
                                 "MSG(",
                                 "WORKPIECE(",
                                 "CYCLE832",
                                 "CTOL=",
                                 "CR=",
                                 "=AC(",
                                 "=IC(",
                                 "G642",
                                 "G710",
                                 "G700"})
    if (contains(words, mark))
      return true;
  // T1 D1: the edge of a tool.
  const auto t = words.find('T'), d = words.find(" D");
  return t != std::string::npos && d != std::string::npos && t < d &&
         d + 2 < words.size() && isDigit(words[d + 2]);
}

} // namespace

ProgramForm formOf(std::string_view text)
{
  bool first = true;
  while (!text.empty()) {
    const auto newline = text.find('\n');
    const std::string line = upperCase(text.substr(0, newline));
    text.remove_prefix(newline == std::string_view::npos ? text.size() : newline + 1);
    const auto content = line.find_first_not_of(" \t\r");
    if (content == std::string::npos)
      continue;
    if (first && beginsKlartext(line))
      return ProgramForm::Klartext;
    if (first && beginsHeidenhainIso(line))
      return ProgramForm::HeidenhainIso;
    if (line[content] != ';' && line[content] != '(')
      first = false;
    const std::string words = withoutComments(line);
    if (isSiemens(words))
      return ProgramForm::Siemens;
    // Its words alone are also those of RS-274; only a comment tells.
    if (words.size() < line.size() && contains(line, "GRBL"))
      return ProgramForm::Grbl;
  }
  return ProgramForm::Rs274;
}

} // namespace pointmill
