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
  static constexpr std::size_t line_room = 256;

  explicit LineWriter(std::ostream& out);

  /// @brief Where the next line goes; line_room characters are free.
  char* line();
  /// @brief Ends the line whose text stops at @p end.
  void endLine(char* end);
  /// @brief A whole line, cut at line_room - 1 characters.
  void line(std::string_view text);
  /// @brief Throws Error when the stream does not take the bytes.
  void flush();

  std::size_t lines() const { return lines_; }
  std::size_t bytes() const { return bytes_; }

private:
  std::ostream& out_;
  std::vector<char> buffer_;
  std::size_t used_ = 0;
  std::size_t lines_ = 0;
  std::size_t bytes_ = 0;
};

} // namespace pointmill::gcode
