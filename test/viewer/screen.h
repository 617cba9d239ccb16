// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace viewer_test {

/// A program that runs beside the test, and is ended with it.
class Process {
public:
  /// @param out file that takes what it prints; -1: none
  explicit Process(std::vector<std::string> words, const std::string& out = "/dev/null")
  {
    id_ = fork();
    if (id_ != 0)
      return;
    std::vector<char*> argv;
    for (auto& word : words)
      argv.push_back(word.data());
    argv.push_back(nullptr);
    if (!std::freopen(out.c_str(), "w", stdout) || dup2(1, 2) < 0)
      _exit(126);
    execvp(argv[0], argv.data());
    _exit(127);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process()
  {
    if (!ended()) {
      kill(id_, SIGKILL);
      waitpid(id_, nullptr, 0);
    }
  }
  bool ended()
  {
    if (!over_ && waitpid(id_, &status_, WNOHANG) == id_)
      over_ = true;
    return over_;
  }
  /// Of a process that has ended by itself; -1 otherwise.
  int exitCode() const
  {
    return over_ && WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
  }

private:
  pid_t id_ = 0;
  int status_ = 0;
  bool over_ = false;
};

/// Waits, but not for ever. @return whether it came true
inline bool waitFor(const std::function<bool()>& condition, double seconds = 60)
{
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (!condition()) {
    if (Clock::now() > end)
      return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return true;
}

/// An X display in memory whose pixels can be looked at.
class Screen {
public:
  explicit Screen(const std::string& folder)
      : file_(folder + "/Xvfb_screen0"), number_file_(folder + "/display"),
        server_({"sh",
                 "-c",
                 "exec Xvfb -screen 0 1280x800x24 -nolisten tcp -fbdir " + folder +
                     " -displayfd 3 3>" + number_file_})
  {
    if (!waitFor([&] { return server_.ended() || !number().empty(); }) ||
        server_.ended())
      throw std::runtime_error("Xvfb does not start");
    setenv("DISPLAY", (":" + number()).c_str(), 1);
  }
  /// What is on it: 4 bytes a pixel, blue first.
  std::vector<char> pixels() const
  {
    std::ifstream in(file_, std::ios::binary);
    std::vector<char> all{std::istreambuf_iterator<char>(in), {}};
    const auto word = [&](std::size_t i) { // of the header of an XWD file
      std::uint32_t value = 0;
      for (std::size_t k = 0; k < 4; ++k)
        value = value << 8 | static_cast<unsigned char>(all.at(4 * i + k));
      return value;
    };
    return {all.begin() + word(0) + 12 * word(19), all.end()};
  }
  /// How many pixels differ between two looks.
  static std::size_t changed(const std::vector<char>& a, const std::vector<char>& b)
  {
    std::size_t count = 0;
    for (std::size_t i = 0; i + 3 < a.size() && i + 3 < b.size(); i += 4)
      count += a[i] != b[i] || a[i + 1] != b[i + 1] || a[i + 2] != b[i + 2];
    return count;
  }
  /// Presses a key, as a person would, where the pointer is.
  static void key(const std::string& name)
  {
    if (std::system(("xdotool mousemove 400 300 key " + name).c_str()) != 0)
      throw std::runtime_error("xdotool cannot press " + name);
  }

private:
  std::string number() const
  {
    std::ifstream in(number_file_);
    std::string text;
    return std::getline(in, text) ? text : "";
  }
  std::string file_, number_file_;
  Process server_;
};

} // namespace viewer_test
