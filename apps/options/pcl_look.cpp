// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "pcl_look.h"

#include <algorithm>
#include <locale>
#include <sstream>

using namespace pointmill;

namespace {

/// "255,255,255", and nothing behind it
visual::Rgb backgroundOf(const std::string& text)
{
  float rgb[3];
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  for (float& c : rgb) {
    char comma = ',';
    if (&c != rgb)
      in >> comma;
    if (!(in >> c) || comma != ',' || c < 0 || c > 255)
      throw CLI::ValidationError("-bc", "R,G,B of 0 .. 255 each, not " + text);
    c /= 255;
  }
  if (!(in >> std::ws).eof())
    throw CLI::ValidationError("-bc", "R,G,B of 0 .. 255 each, not " + text);
  return {rgb[0], rgb[1], rgb[2]};
}

} // namespace

void declarePclLook(CLI::App& app, ViewerLook& look, const std::string& group)
{
  app.add_option("--ps", look.point_size, "size of points, also -ps")
      ->type_name("PX")
      ->check(CLI::Range(1.0, 64.0))
      ->capture_default_str()
      ->group(group);
  app.add_option_function<std::string>(
         "--bc",
         [&look](const std::string& text) { look.background = backgroundOf(text); },
         "colour of the background, also -bc")
      ->type_name("R,G,B")
      ->default_str("255,255,255")
      ->group(group);
  app.add_option("--ax", look.axes, "length of the axes, also -ax")
      ->type_name("MM")
      ->check(CLI::Range(1e-3, 1e5))
      ->default_str("a share of the part")
      ->group(group);
}

void takePclLook(const ViewerLook& said, ViewerLook& look)
{
  look.point_size = said.point_size;
  look.background = said.background;
  look.axes = said.axes;
}

std::vector<std::string>
withTwoDashes(int argc, char** argv, const std::vector<std::string>& names)
{
  std::vector<std::string> words(argv + 1, argv + argc);
  for (std::string& word : words) {
    const std::string name = "-" + word.substr(0, word.find('='));
    if (std::find(names.begin(), names.end(), name) != names.end())
      word.insert(0, 1, '-');
  }
  std::reverse(words.begin(), words.end());
  return words;
}
