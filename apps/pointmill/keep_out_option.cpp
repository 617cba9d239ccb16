// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "keep_out_option.h"

#include <pointmill/common/error.h>

#include <charconv>

using pointmill::KeepOut;
using pointmill::KeepOutZone;

const char* const kKeepOutSyntax = "box:X0,Y0,X1,Y1,TOP|cylinder:X,Y,R,TOP|"
                                   "polygon:X,Y,X,Y,X,Y,...,TOP";

namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& why)
{
  throw pointmill::ParameterError("mill: --keep-out " + text + ": " + why);
}

std::string trimmed(const std::string& text)
{
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos)
    return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The numbers after `begin`, between commas.
std::vector<double> numbersIn(const std::string& text, std::size_t begin)
{
  std::vector<double> numbers;
  for (;;) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = trimmed(text.substr(begin, end - begin));
    double number = 0;
    const char* const last = word.data() + word.size();
    const auto read = std::from_chars(word.data(), last, number);
    if (word.empty())
      refuse(text, "a number is missing");
    if (read.ec != std::errc() || read.ptr != last)
      refuse(text, word + " is not a number");
    numbers.push_back(number);
    if (end == text.size())
      return numbers;
    begin = end + 1;
  }
}

} // namespace

KeepOutZone readKeepOutZone(const std::string& text)
{
  const auto colon = text.find(':');
  const std::string kind = trimmed(text.substr(0, colon));
  const bool box = kind == "box", cylinder = kind == "cylinder";
  if (colon == std::string::npos || !(box || cylinder || kind == "polygon"))
    refuse(text, std::string("it must be written as ") + kKeepOutSyntax);
  const auto n = numbersIn(text, colon + 1);
  const auto needs = [&](bool right, const char* what) {
    if (!right)
      refuse(text,
             "a " + kind + " needs " + what + ", not " + std::to_string(n.size()) +
                 " numbers");
  };
  const auto zone = [&] {
    if (box) {
      needs(n.size() == 5, "five numbers (X0,Y0,X1,Y1,TOP)");
      return KeepOutZone::box(n[0], n[1], n[2], n[3], n[4]);
    }
    if (cylinder) {
      needs(n.size() == 4, "four numbers (X,Y,R,TOP)");
      return KeepOutZone::cylinder(n[0], n[1], n[2], n[3]);
    }
    needs(n.size() >= 7 && n.size() % 2 == 1,
          "three corners or more, X,Y each, and TOP");
    std::vector<Eigen::Vector2d> corners;
    for (std::size_t i = 0; i + 2 < n.size(); i += 2)
      corners.emplace_back(n[i], n[i + 1]);
    return KeepOutZone::polygon(std::move(corners), n.back());
  }();
  try {
    zone.validate();
  }
  catch (const pointmill::ParameterError& error) {
    refuse(text, error.what());
  }
  return zone;
}

KeepOut readKeepOut(const std::vector<std::string>& texts, double margin)
{
  std::vector<KeepOutZone> zones;
  for (const auto& text : texts)
    zones.push_back(readKeepOutZone(text));
  return KeepOut(std::move(zones), margin);
}
