// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string_view>
#include <vector>

namespace pointmill::gcode {

/// @brief Collects lines in one buffer and hands them to a stream in large pieces.
class LineWriter {
public:
  /// @brief Room for one line.
  static constexpr std::size_t line_room = 512;

  /// @param limit longest line that the control takes, below line_room
  LineWriter(std::ostream& out, std::size_t limit);

  /// @brief Where the next line goes; line_room characters are free.
  char* line();
  /// @brief Ends the line whose text stops at @p end. Throws Error for a line that the
  /// control does not take.
  void endLine(char* end);
  void line(std::string_view text);
  /// @brief Throws Error when the stream does not take the bytes.
  void flush();

  std::size_t lines() const { return lines_; }
  std::size_t bytes() const { return bytes_; }

private:
  [[noreturn]] void refuse(std::size_t length) const;

  std::ostream& out_;
  std::size_t limit_;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
  std::size_t lines_ = 0;
  std::size_t bytes_ = 0;
};

} // namespace pointmill::gcode
