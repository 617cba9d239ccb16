// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "line_writer.h"

#include <pointmill/common/error.h>

#include <algorithm>
#include <ostream>
#include <string>

namespace pointmill::gcode {

LineWriter::LineWriter(std::ostream& out) : out_(out), buffer_(1 << 18)
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
  *end++ = '\n';
  const auto now = static_cast<std::size_t>(end - buffer_.data());
  bytes_ += now - used_;
  used_ = now;
  ++lines_;
}

void LineWriter::line(std::string_view text)
{
  text = text.substr(0, line_room - 1);
  endLine(std::copy(text.begin(), text.end(), line()));
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
