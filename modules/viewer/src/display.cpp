// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "display.h"

#include <X11/Xlib.h>

namespace pointmill::viewer {

bool hasDisplay()
{
  Display* display = XOpenDisplay(nullptr);
  if (!display)
    return false;
  XCloseDisplay(display);
  return true;
}

} // namespace pointmill::viewer
