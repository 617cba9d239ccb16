// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "resources.h"

#include <pointmill/page/page.h>

#include <functional>
#include <map>
#include <ostream>

namespace pointmill {
namespace {

using Values = std::map<std::string_view, std::function<void()>>;

/// Writes a template with what stands for its {{names}}. What is put in is not looked
/// through again.
void fill(std::ostream& out, std::string_view text, const Values& values)
{
  while (!text.empty()) {
    const auto begin = text.find("{{");
    out << text.substr(0, begin);
    if (begin == std::string_view::npos)
      return;
    const auto end = text.find("}}", begin);
    values.at(text.substr(begin + 2, end - begin - 2))();
    text.remove_prefix(end + 2);
  }
}

/// What is needed for the 3D view alone.
void writeView(std::ostream& out, const std::string& scene)
{
  out << "<script type=\"application/json\" id=\"scene\">" << scene << "</script>\n"
      << "<script>\n/*\n"
      << resources::three_licence << "*/\n"
      << resources::three << "\n</script>\n"
      << "<script>\n"
      << resources::orbit_controls << "\n</script>\n"
      << "<script>\n"
      << resources::view_script << "</script>\n";
}

} // namespace

Html viewPlace()
{
  return Html::markup(std::string(resources::view));
}

void writePage(std::ostream& out, const Page& page)
{
  fill(out,
       resources::page,
       {{"title", [&] { out << escaped(page.title); }},
        {"style", [&] { out << resources::style; }},
        {"body", [&] { out << page.body.str(); }},
        {"view", [&] {
           if (!page.scene.empty())
             writeView(out, page.scene);
         }}});
}

} // namespace pointmill
