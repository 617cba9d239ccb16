// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pointmill {

/// @brief @p text with what HTML would take for markup spelled so that it is shown, in
/// elements and in quoted attributes.
std::string escaped(std::string_view text);

/// @brief The same bytes in base64.
std::string base64(std::string_view bytes);

/// @brief A piece of HTML. Texts become HTML by being escaped: whatever a file is
/// called, none of it is taken for markup unless markup() says that it is.
class Html {
public:
  Html() = default;
  // Not explicit: texts are to be as good as HTML.
  Html(std::string_view text) : html_(escaped(text)) {}
  Html(const std::string& text) : Html(std::string_view(text)) {}
  Html(const char* text) : Html(std::string_view(text)) {}
  static Html markup(std::string html)
  {
    Html piece;
    piece.html_ = std::move(html);
    return piece;
  }

  bool empty() const { return html_.empty(); }
  const std::string& str() const { return html_; }
  Html& operator+=(const Html& more)
  {
    html_ += more.html_;
    return *this;
  }
  friend Html operator+(Html first, const Html& second)
  {
    first += second;
    return first;
  }

private:
  std::string html_;
};

/// @brief An element round @p content. @param tag its name, and its attributes as they
/// are to be written: `td class="number"`
Html element(const std::string& tag, const Html& content);

/// @brief A picture in the page itself, with a caption. @param png its bytes
Html picture(std::string_view png, const std::string& alt, const Html& caption);

/// @brief A column of a table. Numbers stand flush right.
struct HtmlColumn {
  std::string head;
  bool number = false;
  std::string unit; ///< under the head
};

/// @brief A table whose first column names its rows. Where the page is narrow, the
/// cells of a row stand under each other, each with the head of its column.
Html table(const std::string& caption,
           const std::vector<HtmlColumn>& columns,
           const std::vector<std::vector<Html>>& rows);

/// @brief A section with its heading. @param id of the element; letters and -
Html section(const std::string& id, const std::string& heading, const Html& content);

} // namespace pointmill
