// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "place.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pointmill::gcode {

/// @brief One line of a program as its words, without meaning.
///
/// Words longer than a letter have places of their own behind Z; `CR=` is an R, and
/// `SUPA` a G53, which they mean.
class Block {
public:
  /// @brief A G or M word: its number in tenths, so that G91.1 is 911.
  struct Code {
    int tenths;
    int column;
  };
  static constexpr int most_codes = 32;

  enum : char {
    Tolerance = 'Z' + 1, ///< `CTOL=`
    Rounding,            ///< `ADIS=`
    HighSpeed            ///< `CYCLE832(..)`: its tolerance, 0 without one
  };

  /// @brief Whether the value of a word says by itself what it counts from.
  enum class Frame { Modal, Absolute, Incremental };

  void clear(std::size_t line)
  {
    line_ = line;
    present_ = absolute_ = incremental_ = used_ = 0;
    g_count_ = m_count_ = 0;
    percent_column_ = 0;
    comment_ = {};
  }
  void addCode(char letter, double number, int column);
  void addWord(char letter, double value, int column, Frame frame = Frame::Modal);
  void setComment(std::string_view text) { comment_ = text; }
  void setPercent(int column) { percent_column_ = column; }

  bool has(char letter) const { return present_ & bit(letter); }
  /// @brief Whether the word is there and nobody has taken it yet.
  bool open(char letter) const { return present_ & ~used_ & bit(letter); }
  /// @brief The value of a word that is there; a word can be taken once.
  double take(char letter) const
  {
    if (!open(letter))
      refuseSecondOwner(letter);
    used_ |= bit(letter);
    return values_[letter - 'A'];
  }
  int column(char letter) const { return columns_[letter - 'A']; }
  Place place(char letter) const { return {line_, column(letter)}; }
  Frame frame(char letter, Frame modal) const
  {
    return absolute_ & bit(letter)      ? Frame::Absolute
           : incremental_ & bit(letter) ? Frame::Incremental
                                        : modal;
  }
  /// @brief Whether there is nothing but coordinates, a feed and the block's number.
  bool onlyMoves() const
  {
    constexpr std::uint32_t moves = (0x7u << ('I' - 'A')) | (0x7u << ('X' - 'A')) |
                                    (1u << ('F' - 'A')) | (1u << ('N' - 'A')) |
                                    (1u << ('R' - 'A'));
    return g_count_ == 0 && m_count_ == 0 && (present_ & ~moves) == 0;
  }
  /// @brief The first of @p letters that is open, or 0.
  char firstOf(const char* letters) const
  {
    for (; *letters; ++letters)
      if (open(*letters))
        return *letters;
    return 0;
  }
  /// @brief A word that nobody has taken, or 0. N needs no taker.
  char leftOver() const;

  int gCount() const { return g_count_; }
  int mCount() const { return m_count_; }
  const Code& g(int i) const { return g_[i]; }
  const Code& m(int i) const { return m_[i]; }

  /// @brief The text of the last comment; lives as long as the line.
  std::string_view comment() const { return comment_; }
  bool isPercent() const { return percent_column_ != 0; }
  int percentColumn() const { return percent_column_; }
  bool isEmpty() const { return present_ == 0 && g_count_ == 0 && m_count_ == 0; }
  std::size_t line() const { return line_; }

  [[noreturn]] void fail(int column, const std::string& what) const
  {
    refuse({line_, column}, what);
  }

private:
  [[noreturn]] void refuseSecondOwner(char letter) const;

  static constexpr int places = HighSpeed - 'A' + 1;
  static std::uint32_t bit(char letter) { return 1u << (letter - 'A'); }

  std::size_t line_ = 0;
  std::uint32_t present_ = 0, absolute_ = 0, incremental_ = 0;
  mutable std::uint32_t used_ = 0;
  int g_count_ = 0, m_count_ = 0;
  int percent_column_ = 0;
  std::string_view comment_;
  double values_[places];
  int columns_[places];
  Code g_[most_codes], m_[most_codes];
};

/// @brief "X", "CTOL": as an error names a word.
std::string wordName(char letter);

} // namespace pointmill::gcode
