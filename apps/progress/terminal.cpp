// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace pointmill {
namespace {

std::string_view environment(const char* name)
{
  const char* value = std::getenv(name);
  return value ? value : "";
}

} // namespace

bool isTerminal(int descriptor)
{
  return isatty(descriptor) != 0;
}

bool takesColours(int descriptor)
{
  const std::string_view term = environment("TERM");
  return isTerminal(descriptor) && environment("NO_COLOR").empty() && !term.empty() &&
         term != "dumb";
}

int terminalWidth(int descriptor)
{
  winsize size{};
  return ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col
                                                                      : 80;
}

} // namespace pointmill
