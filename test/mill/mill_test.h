// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/error.h>
#include <pointmill/mill/mill_job.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace mill_test {

using namespace pointmill;
namespace fs = std::filesystem;

inline std::string data(const std::string& name)
{
  return std::string(POINTMILL_DATA) + "/" + name;
}

inline std::string contents(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// A directory of the test's own that is gone when this is.
class TempDir {
public:
  TempDir()
  {
    std::string name = (fs::temp_directory_path() / "pointmill-XXXXXX").string();
    if (!mkdtemp(name.data()))
      throw std::runtime_error("no temporary directory");
    path_ = name;
  }
  TempDir(const TempDir&) = delete;
  TempDir& operator=(const TempDir&) = delete;
  ~TempDir()
  {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  fs::path operator/(const std::string& name) const { return path_ / name; }
  /// All that is in it, hidden files too.
  std::vector<std::string> names() const
  {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path_))
      names.push_back(entry.path().filename().string());
    return names;
  }

private:
  fs::path path_;
};

} // namespace mill_test
