// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <bitset>
#include <string>
#include <vector>

namespace pointmill::gcode {

/// @brief The printable ASCII characters that @p ranges lists, as "A-Z0-9 .,_-"; a
/// hyphen at either end is itself.
std::bitset<128> characterSet(const std::string& ranges);

/// @brief Turns texts into the insides of comments that a control reads over.
struct CommentText {
  std::bitset<128> allowed;
  bool upper_case = false;
  std::size_t widest = 78;

  /// @brief @p text as lines of allowed characters, and never a comment that LinuxCNC
  /// would obey, as "MSG,".
  std::vector<std::string> lines(const std::string& text) const;

private:
  char spell(char c) const;
  std::string spellAll(const std::string& text) const;
};

} // namespace pointmill::gcode
