// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "line_reader.h"

#include <pointmill/common/error.h>

#include <cstring>
#include <string>

namespace pointmill::gcode {

LineReader::LineReader(std::istream& in) : in_(in), buffer_(1 << 18)
{
  if (!in_)
    throw DataError("GCodeReader: the input cannot be read");
  // Not through tellg(), which would leave its mark on a stream that cannot seek.
  auto* const source = in_.rdbuf();
  const auto here = source->pubseekoff(0, std::ios::cur, std::ios::in);
  if (here == std::streampos(-1))
    return;
  const auto last = source->pubseekoff(0, std::ios::end, std::ios::in);
  source->pubseekpos(here, std::ios::in);
  if (last != std::streampos(-1))
    size_ = static_cast<double>(last - here);
}

double LineReader::progress() const
{
  return size_ > 0 ? done_ / size_ : 0.0;
}

bool LineReader::next(std::string_view& line)
{
  const char* newline = nullptr;
  std::size_t searched = 0;
  for (;;) {
    const char* const start = buffer_.data() + begin_;
    const std::size_t have = end_ - begin_;
    newline =
        static_cast<const char*>(std::memchr(start + searched, '\n', have - searched));
    if (newline || have > longest + 2)
      break;
    searched = have;
    if (!fill())
      break;
  }
  const char* const start = buffer_.data() + begin_;
  if (!newline && begin_ == end_)
    return false;
  ++lines_;
  const std::size_t length =
      newline ? static_cast<std::size_t>(newline - start) : end_ - begin_;
  line = std::string_view(start, length);
  begin_ += length + (newline ? 1 : 0);
  done_ += static_cast<double>(length + (newline ? 1 : 0));
  if (!line.empty() && line.back() == '\r')
    line.remove_suffix(1);
  if (line.size() > longest)
    throw DataError("line " + std::to_string(lines_) + ", column " +
                    std::to_string(longest + 1) +
                    ": the line is longer than 255 characters");
  return true;
}

bool LineReader::fill()
{
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  if (!in_)
    return false;
  in_.read(buffer_.data() + end_, static_cast<std::streamsize>(buffer_.size() - end_));
  if (in_.bad())
    throw DataError("GCodeReader: reading failed after line " + std::to_string(lines_));
  const auto got = static_cast<std::size_t>(in_.gcount());
  end_ += got;
  return got > 0;
}

} // namespace pointmill::gcode
