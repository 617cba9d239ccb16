// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pointmill::gcode {

/// @brief One line of RS-274 as its words, without meaning.
class Block {
public:
  /// @brief A G or M word: its number in tenths, so that G91.1 is 911.
  struct Code {
    int tenths;
    int column;
  };
  static constexpr int most_codes = 32;

  /// @brief Takes @p text apart; throws DataError with line and column.
  void parse(std::string_view text, std::size_t line);

  bool has(char letter) const { return (present_ >> (letter - 'A')) & 1u; }
  double value(char letter) const { return values_[letter - 'A']; }
  int column(char letter) const { return columns_[letter - 'A']; }
  /// @brief Whether any of @p letters is there; the first one goes to @p found.
  bool hasAny(const char* letters, char& found) const;

  int gCount() const { return g_count_; }
  int mCount() const { return m_count_; }
  const Code& g(int i) const { return g_[i]; }
  const Code& m(int i) const { return m_[i]; }

  bool isPercent() const { return percent_column_ != 0; }
  int percentColumn() const { return percent_column_; }
  bool isEmpty() const { return present_ == 0 && g_count_ == 0 && m_count_ == 0; }
  std::size_t line() const { return line_; }

  [[noreturn]] void fail(int column, const std::string& what) const;

private:
  void addWord(char letter, double value, int column);

  std::size_t line_ = 0;
  std::uint32_t present_ = 0;
  int g_count_ = 0, m_count_ = 0;
  int percent_column_ = 0;
  double values_[26];
  int columns_[26];
  Code g_[most_codes], m_[most_codes];
};

/// @brief "G91.1" for ('G', 911).
std::string codeName(char letter, int tenths);

} // namespace pointmill::gcode
