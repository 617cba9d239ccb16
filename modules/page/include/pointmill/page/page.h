// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/page/html.h>

#include <iosfwd>
#include <string>

namespace pointmill {

/// @brief A page as one file that loads nothing from anywhere: style, pictures, and the
/// programs of its 3D view are in it. It says so itself (Content-Security-Policy), so
/// that a browser would refuse to load anything.
struct Page {
  std::string title;
  Html body;         ///< with viewPlace() where the 3D view is to be, if there is one
  std::string scene; ///< of the 3D view, see viewJson(); empty: none
};

/// @brief Where the 3D view is to be. It comes into sight when it can be drawn; what
/// follows must do without it.
Html viewPlace();

/// @brief Writes the page. The same page gives the same bytes.
void writePage(std::ostream& out, const Page& page);

} // namespace pointmill
