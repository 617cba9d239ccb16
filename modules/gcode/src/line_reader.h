// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <cstddef>
#include <istream>
#include <string_view>
#include <vector>

namespace pointmill::gcode {

/// @brief Hands out the lines of a stream without copying them one by one.
class LineReader {
public:
  /// @brief Longer lines are refused; LinuxCNC's own limit.
  static constexpr std::size_t longest = 255;

  explicit LineReader(std::istream& in);

  /// @brief The next line without its end; false at the end of the stream. Throws
  /// DataError for lines that are too long and for streams that fail.
  bool next(std::string_view& line);

  std::size_t lines() const { return lines_; }
  /// @brief Part of the stream that has been handed out, 0 .. 1; 0 where the size of
  /// the stream is unknown.
  double progress() const;

private:
  bool fill();

  std::istream& in_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  std::size_t lines_ = 0;
  double size_ = -1.0, done_ = 0.0;
};

} // namespace pointmill::gcode
