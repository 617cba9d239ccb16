// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/print.h>
#include <pointmill/page/html.h>

#include <string>

namespace pointmill::svg {

using pointmill::print;

/// @brief A text at (x, y). @param attributes as they are to be written
inline std::string
text(double x, double y, const std::string& what, const std::string& attributes = "")
{
  return print("<text x=\"%.1f\" y=\"%.1f\" ", x, y) + attributes + ">" +
         escaped(what) + "</text>\n";
}

/// @brief A line of a class of the page's style.
inline std::string line(const char* kind, double x0, double y0, double x1, double y1)
{
  return print("<line class=\"%s\" x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>\n",
               kind,
               x0,
               y0,
               x1,
               y1);
}

} // namespace pointmill::svg
