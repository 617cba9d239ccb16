// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "block.h"
#include "number.h"

#include <pointmill/gcode/gcode_reader.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pointmill::gcode {

/// @brief Takes the lines of programs in words apart: a letter and a number, for
/// Siemens also names with `=` or parentheses. Refuses what a form does not know.
class WordLexer {
public:
  explicit WordLexer(ProgramForm form);

  /// @brief The words of @p text; @p block refers to it. Throws DataError with line and
  /// column.
  void read(std::string_view text, std::size_t line, Block& block);

private:
  [[noreturn]] void fail(const char* at, const std::string& what) const;
  int columnOf(const char* at) const { return static_cast<int>(at - begin_) + 1; }
  bool skipsTo(char c);
  void readComment();
  void readEndOfBlock();
  void readWord();
  bool isKnown(char letter) const;
  [[noreturn]] void refuseLetter(const char* word) const;
  void checkProgramNumber(const char* word) const;
  /// The number at @ref p_ of the word that begins at @p word.
  double number(const char* word);
  [[noreturn]] void refuseNumber(const char* word, const Number& n) const;

  // Siemens; in siemens_words.cpp.
  bool readName();
  void readAssignment(const std::string& name, const char* at);
  void readCall(const std::string& name, const char* at);

  const ProgramForm form_;
  std::uint32_t letters_ = 0; // that may begin a word, besides G and M
  const char *begin_ = nullptr, *end_ = nullptr, *p_ = nullptr;
  Block* block_ = nullptr;
};

} // namespace pointmill::gcode
