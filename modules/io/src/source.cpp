// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "source.h"

#include <pointmill/common/error.h>
#include <pointmill/common/watch.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace pointmill::detail {

namespace {

constexpr std::size_t kPiece = 1 << 22; // bytes that are read at once

// Names and quoted content may hold anything; the message stays one line.
std::string oneLine(std::string text)
{
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || c == 127)
      c = '?';
  return text;
}

} // namespace

Source::Source(const std::string& path) : path_(path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
    fail("there is no such file; check the name");
  if (!fs::is_regular_file(status))
    fail("is not a file; name the scan file itself");
  const auto size = fs::file_size(path, error);
  std::ifstream in(path, std::ios::binary);
  if (error || !in)
    fail(std::string("cannot be opened (") + std::strerror(errno) +
         "); check its permissions");
  if (size == 0)
    fail("is empty; export the scan again");
  size_ = static_cast<std::size_t>(size);
  data_.reset(new char[size_]);
  const WorkStep step({0.0, 1.0});
  for (std::size_t at = 0; at < size_; at += kPiece) {
    step.reach(double(at) / double(size_));
    const std::size_t piece = std::min(kPiece, size_ - at);
    if (!in.read(data_.get() + at, static_cast<std::streamsize>(piece)))
      fail("cannot be read to its end; check the disk");
  }
}

void Source::fail(const std::string& what) const
{
  throw DataError(oneLine(path_ + ": " + what));
}

void Source::failAt(const char* at, const std::string& what) const
{
  const auto line = 1 + std::count(begin(), at, '\n');
  throw DataError(oneLine(path_ + ", line " + std::to_string(line) + ": " + what));
}

void Source::failShort(unsigned long long announced, const char* things) const
{
  fail("is cut short: it announces " + std::to_string(announced) + " " + things +
       " and ends before the last; copy or export it again");
}

} // namespace pointmill::detail
