// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// on_terminal [--pipe] [--stop-at TEXT | --stop-after SECONDS] [--signal N] PROGRAM ...
//   Runs a program on a terminal of 80 columns, or with --pipe into a pipe, and prints
//   all that it writes. Once TEXT is among that, or after SECONDS, it is stopped: by
//   Ctrl-C, as a person would, or by the signal N. Exits with the program's own exit
//   code; with 254 if it did not end soon after it was stopped, 255 if a signal killed
//   it.
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kPatience = 10; // s; loaded machines are slow
constexpr int kHangs = 254, kKilled = 255, kUsage = 253;

double secondsSince(Clock::time_point then)
{
  return std::chrono::duration<double>(Clock::now() - then).count();
}

struct Call {
  bool pipe = false;
  std::string stop_at;
  double stop_after = -1;
  int signal = 0; // Ctrl-C
  char** program = nullptr;
};

Call read(char** argv)
{
  Call call;
  for (++argv; *argv && (*argv)[0] == '-'; ++argv) {
    const std::string name = *argv;
    if (name == "--pipe") {
      call.pipe = true;
      continue;
    }
    if (!*++argv)
      std::exit(kUsage);
    if (name == "--stop-at")
      call.stop_at = *argv;
    else if (name == "--stop-after")
      call.stop_after = std::atof(*argv);
    else if (name == "--signal")
      call.signal = std::atoi(*argv);
    else
      std::exit(kUsage);
  }
  call.program = argv;
  if (!*argv)
    std::exit(kUsage);
  return call;
}

/// Starts the program. @return its number, and where its output comes out
std::pair<pid_t, int> start(const Call& call)
{
  int output = -1, ends[2];
  pid_t child = -1;
  if (call.pipe) {
    if (pipe(ends) != 0)
      std::exit(kUsage);
    output = ends[0];
    child = fork();
    if (child == 0) {
      dup2(ends[1], STDOUT_FILENO);
      dup2(ends[1], STDERR_FILENO);
      close(ends[0]);
    }
    close(ends[1]);
  }
  else {
    winsize size{25, 80, 0, 0};
    child = forkpty(&output, nullptr, nullptr, &size);
  }
  if (child == 0) {
    execvp(call.program[0], call.program);
    _exit(kUsage);
  }
  return {child, output};
}

} // namespace

int main(int, char** argv)
{
  const Call call = read(argv);
  const auto [child, output] = start(call);
  const auto begin = Clock::now();
  Clock::time_point stopped_at;
  bool stopped = false;
  std::string seen;
  for (;;) {
    char bytes[4096];
    pollfd ready{output, POLLIN, 0};
    if (poll(&ready, 1, 20) > 0) {
      const auto count = ::read(output, bytes, sizeof bytes);
      if (count <= 0) // the other end is closed: it has ended
        break;
      std::fwrite(bytes, 1, static_cast<std::size_t>(count), stdout);
      seen.append(bytes, static_cast<std::size_t>(count));
    }
    if (stopped && secondsSince(stopped_at) > kPatience) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
      return kHangs;
    }
    const bool due =
        call.stop_after >= 0
            ? secondsSince(begin) > call.stop_after
            : !call.stop_at.empty() && seen.find(call.stop_at) != std::string::npos;
    if (stopped || !due)
      continue;
    stopped = true;
    stopped_at = Clock::now();
    if (call.signal != 0 || call.pipe)
      kill(child, call.signal != 0 ? call.signal : SIGINT);
    else if (write(output, "\x03", 1) != 1)
      return kUsage;
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : kKilled;
}
