// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <sys/wait.h>

namespace demo_test {

struct Outcome {
  int code = -1;
  std::string text; ///< of both streams
};

/// @brief Runs one of the programs from a folder of its own.
class Programs : public testing::Test {
protected:
  Programs()
  {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("pointmill_demos_" + std::string(test->name()) +
               std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "_" +
               std::to_string(std::hash<std::string>()(POINTMILL_BIN)));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~Programs() override { std::filesystem::remove_all(folder_); }

  Outcome run(const std::string& line) const
  {
    const std::string call =
        "cd '" + folder_.string() + "' && '" POINTMILL_BIN "'/" + line + " 2>&1";
    Outcome outcome;
    FILE* pipe = popen(call.c_str(), "r");
    char buffer[4096];
    for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;)
      outcome.text.append(buffer, n);
    const int status = pclose(pipe);
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
  }
  /// It does what it is told, or the test ends.
  void good(const std::string& line) const
  {
    const Outcome outcome = run(line);
    ASSERT_EQ(outcome.code, 0) << line << "\n" << outcome.text;
  }
  /// It exits with @p code, says @p words, and leaves @p file as it was.
  void bad(int code,
           const std::string& words,
           const std::string& line,
           const std::string& file = "out.pcd") const
  {
    std::ofstream(path(file)) << "earlier";
    const Outcome outcome = run(line);
    EXPECT_EQ(outcome.code, code) << line << "\n" << outcome.text;
    EXPECT_NE(outcome.text.find(words), std::string::npos) << line << "\n"
                                                           << outcome.text;
    EXPECT_EQ(read(file), "earlier") << line;
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string read(const std::string& name) const
  {
    std::ostringstream text;
    text << std::ifstream(path(name), std::ios::binary).rdbuf();
    return text.str();
  }

private:
  std::filesystem::path folder_;
};

} // namespace demo_test
