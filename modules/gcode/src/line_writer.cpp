// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "line_writer.h"

#include <pointmill/common/error.h>

#include <algorithm>
#include <ostream>
#include <string>

namespace pointmill::gcode {

LineWriter::LineWriter(std::ostream& out, std::size_t limit)
    : out_(out), limit_(limit), buffer_(1 << 18)
{
}

char* LineWriter::line()
{
  if (buffer_.size() - used_ < line_room)
    flush();
  return buffer_.data() + used_;
}

void LineWriter::endLine(char* end)
{
  const auto length = static_cast<std::size_t>(end - buffer_.data()) - used_;
  if (length > limit_)
    refuse(length);
  *end = '\n';
  bytes_ += length + 1;
  used_ += length + 1;
  ++lines_;
}

void LineWriter::line(std::string_view text)
{
  if (text.size() > limit_)
    refuse(text.size());
  endLine(std::copy(text.begin(), text.end(), line()));
}

void LineWriter::refuse(std::size_t length) const
{
  throw Error("GCodeWriter: line " + std::to_string(lines_ + 1) + " has " +
              std::to_string(length) + " characters; the control takes " +
              std::to_string(limit_));
}

void LineWriter::flush()
{
  out_.write(buffer_.data(), static_cast<std::streamsize>(used_));
  out_.flush();
  if (!out_)
    throw Error("GCodeWriter: the output failed before byte " + std::to_string(bytes_) +
                "; the program is incomplete");
  used_ = 0;
}

} // namespace pointmill::gcode
