// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/page/html.h>

#include <cstdint>

namespace pointmill {
namespace {

/// A table of more columns stacks its cells where the page is narrow.
constexpr std::size_t kFew = 3;
/// A table of more rows may go over from one printed page to the next.
constexpr std::size_t kShort = 12;

} // namespace

std::string escaped(std::string_view text)
{
  std::string html;
  html.reserve(text.size());
  for (const char c : text) {
    switch (c) {
    case '&':
      html += "&amp;";
      break;
    case '<':
      html += "&lt;";
      break;
    case '>':
      html += "&gt;";
      break;
    case '"':
      html += "&quot;";
      break;
    case '\'':
      html += "&#39;";
      break;
    default: // HTML has no way to spell other control characters
      if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
        html += "\xEF\xBF\xBD";
      else
        html += c;
    }
  }
  return html;
}

std::string base64(std::string_view bytes)
{
  constexpr char digits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 |
              (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63];
  }
  return text;
}

Html element(const std::string& tag, const Html& content)
{
  return Html::markup("<" + tag + ">" + content.str() + "</" +
                      tag.substr(0, tag.find(' ')) + ">\n");
}

Html picture(std::string_view png, const std::string& alt, const Html& caption)
{
  return element("figure",
                 Html::markup("<img alt=\"" + escaped(alt) +
                              "\" src=\"data:image/png;base64," + base64(png) + "\">") +
                     element("figcaption", caption));
}

Html table(const std::string& caption,
           const std::vector<HtmlColumn>& columns,
           const std::vector<std::vector<Html>>& rows)
{
  const auto kind = [&](std::size_t column) {
    return column < columns.size() && columns[column].number ? " class=\"number\"" : "";
  };
  Html head, body;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    Html text = columns[i].head;
    if (!columns[i].unit.empty())
      text += Html::markup("<br>") + element("small", columns[i].unit);
    head += element("th scope=\"col\"" + std::string(kind(i)), text);
  }
  const auto named = [&](std::size_t column) {
    if (column >= columns.size())
      return std::string();
    const HtmlColumn& c = columns[column];
    return " data-head=\"" + escaped(c.head + (c.unit.empty() ? "" : ", " + c.unit)) +
           "\"";
  };
  for (const auto& row : rows) {
    Html cells;
    for (std::size_t i = 0; i < row.size(); ++i)
      cells += element(i == 0 ? "th scope=\"row\"" + std::string(kind(i))
                              : "td" + std::string(kind(i)) + named(i),
                       row[i]);
    body += element("tr", cells);
  }
  const std::string classes = std::string("wide") +
                              (columns.size() > kFew ? " many" : "") +
                              (rows.size() > kShort ? " long" : "");
  return element(
      "div class=\"" + classes + "\" tabindex=\"0\" role=\"region\" aria-label=\"" +
          escaped(caption) + "\"",
      element("table",
              element("caption", caption) + element("thead", element("tr", head)) +
                  element("tbody", body)));
}

Html section(const std::string& id, const std::string& heading, const Html& content)
{
  return element("section id=\"" + id + "\" aria-labelledby=\"" + id + "-head\"",
                 element("h2 id=\"" + id + "-head\"", heading) + content);
}

} // namespace pointmill
