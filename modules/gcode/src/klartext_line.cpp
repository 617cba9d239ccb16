// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "klartext_line.h"

#include "number.h"

#include <cmath>

namespace pointmill::gcode {

void KlartextLine::read(std::string_view text, std::size_t line)
{
  line_ = line;
  words_.clear();
  next_ = 0;
  comment_ = {};
  goes_on_ = false;
  std::size_t at = 0;
  for (;;) {
    while (at < text.size() && isBlank(text[at]))
      ++at;
    length_ = at;
    if (at == text.size())
      break;
    if (text[at] == ';') {
      comment_ = text.substr(at + 1);
      break;
    }
    const std::size_t begin = at;
    while (at < text.size() && !isBlank(text[at]) && text[at] != ';') {
      const char c = text[at];
      if (c < 0x21 || c > 0x7E)
        refuse({line, static_cast<int>(at) + 1}, shown(c) + " is not supported");
      ++at;
    }
    words_.push_back({text.substr(begin, at - begin), static_cast<int>(begin) + 1});
  }
  if (!words_.empty() && words_.back().text == "~") {
    goes_on_ = true;
    words_.pop_back();
  }
}

bool KlartextLine::takes(std::string_view text)
{
  if (atEnd() || peek().text != text)
    return false;
  ++next_;
  return true;
}

const KlartextLine::Word& KlartextLine::need(const char* what)
{
  if (atEnd())
    refuse({line_, static_cast<int>(length_) + 1}, std::string(what) + " is missing");
  return next();
}

double KlartextLine::value(const Word& word, std::size_t letters) const
{
  const std::string_view digits = word.text.substr(letters);
  const Number n = scanNumber(digits.data(), digits.data() + digits.size());
  if (n.state != Number::State::Good || n.end != digits.data() + digits.size())
    fail(word, "'" + std::string(word.text) + "' is not supported");
  return n.value;
}

int KlartextLine::whole(const Word& word, std::size_t letters, int most) const
{
  const double number = value(word, letters);
  if (number < 0 || number > most || number != std::floor(number))
    fail(word,
         "'" + std::string(word.text) + "' must be a whole number, 0 .. " +
             std::to_string(most));
  return static_cast<int>(number);
}

} // namespace pointmill::gcode
