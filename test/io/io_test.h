// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/error.h>
#include <pointmill/io/raw_scan.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace io_test {

/// @brief A path that no other test uses, nor another run of this one at the same time.
inline std::string ownPath(const std::string& name)
{
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  return ::testing::TempDir() + "pointmill_" + std::to_string(::getpid()) + "_" +
         test->test_suite_name() + "_" + test->name() + "_" + name;
}

inline std::string writeFile(const std::string& name, const std::string& content)
{
  const std::string path = ownPath(name);
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

/// @brief What readScan() makes of a file with this @p content.
inline pointmill::RawScan read(const std::string& name, const std::string& content)
{
  const std::string path = writeFile(name, content);
  struct Remove {
    const std::string& path;
    ~Remove() { std::remove(path.c_str()); }
  } remove{path};
  return pointmill::readScan(path);
}

/// @brief The file is refused in one line that names it and holds @p words.
inline void expectRefused(const std::string& name,
                          const std::string& content,
                          const std::string& words)
{
  try {
    read(name, content);
    FAIL() << name << " was read; expected: " << words;
  }
  catch (const pointmill::DataError& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find(name), std::string::npos) << what;
    EXPECT_NE(what.find(words), std::string::npos) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
}

/// @brief Twelve points that neither float nor a short decimal form holds.
inline std::vector<Eigen::Vector3d> utmPoints()
{
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 12; ++i)
    points.emplace_back(512701.123456789 + i / 7.0, 5403554.987654321 + i * i, i / 3.0);
  return points;
}

/// @brief Decimal text that reads back as the same bits.
inline std::string exact(double value)
{
  char text[40];
  std::snprintf(text, sizeof(text), "%.17g", value);
  return text;
}

/// @brief The bytes of a number, as this machine has them or the other way round.
template <typename T>
std::string bytes(T value, bool big_endian = false)
{
  std::string text(sizeof(T), '\0');
  std::memcpy(text.data(), &value, sizeof(T));
  if (big_endian)
    std::reverse(text.begin(), text.end());
  return text;
}

/// @brief The points in rows of text, `tail` after each.
inline std::string rows(const std::vector<Eigen::Vector3d>& points,
                        const std::string& separator = " ",
                        const std::string& tail = "\n")
{
  std::string text;
  for (const auto& p : points)
    text += exact(p.x()) + separator + exact(p.y()) + separator + exact(p.z()) + tail;
  return text;
}

} // namespace io_test
