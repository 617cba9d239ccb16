// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "place.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pointmill::gcode {

/// @brief A line of Klartext as its words, between blanks.
class KlartextLine {
public:
  struct Word {
    std::string_view text;
    int column;
  };

  /// @brief Takes @p text apart; refers to it.
  void read(std::string_view text, std::size_t line);

  std::string_view comment() const { return comment_; }
  /// @brief Whether the block goes on in the next line: `~`.
  bool goesOn() const { return goes_on_; }
  std::size_t line() const { return line_; }

  bool atEnd() const { return next_ == words_.size(); }
  const Word& peek() const { return words_[next_]; }
  const Word& next() { return words_[next_++]; }
  /// @brief Takes the next word if it is @p text.
  bool takes(std::string_view text);
  /// @brief The next word; refused where there is none: "@p what is missing".
  const Word& need(const char* what);

  /// @brief The number of a word that begins with @p letters.
  double value(const Word& word, std::size_t letters) const;
  int whole(const Word& word, std::size_t letters, int most) const;

  [[noreturn]] void fail(const Word& word, const std::string& what) const
  {
    refuse({line_, word.column}, what);
  }
  [[noreturn]] void fail(const std::string& what) const { refuse({line_, 1}, what); }

private:
  std::size_t line_ = 0;
  std::size_t length_ = 0;
  std::vector<Word> words_;
  std::size_t next_ = 0;
  std::string_view comment_;
  bool goes_on_ = false;
};

} // namespace pointmill::gcode
