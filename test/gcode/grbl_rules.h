// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// @brief Judges a program as Grbl 1.1 does, from its documentation: the supported
/// words, the modal groups of its interface page, and the meanings of its error codes.
/// It shares no code with the library.
class GrblRules {
public:
  /// @return "line 3: error 20: ..." of the first line that Grbl refuses; empty: it
  /// takes all
  static std::string fault(const std::string& program)
  {
    GrblRules rules;
    std::istringstream in(program);
    std::string line;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
      try {
        rules.take(line);
      }
      catch (const std::runtime_error& error) {
        return "line " + std::to_string(number) + ": " + error.what();
      }
    }
    if (!rules.ended_)
      return "the program does not end";
    return {};
  }

private:
  static constexpr std::size_t longest = 79; // its buffer holds 80, one is the end
  static constexpr double inch = 25.4;

  struct Words {
    std::vector<int> g, m; ///< times 10: G91.1 is 911
    std::map<char, double> values;
    bool has(char letter) const { return values.count(letter) != 0; }
  };

  [[noreturn]] static void refuse(int code, const std::string& why)
  {
    throw std::runtime_error("error " + std::to_string(code) + ": " + why);
  }

  void take(const std::string& line)
  {
    if (ended_)
      refuse(0, "something follows the end of the program");
    for (const char c : line) {
      if (c == '!' || c == '?' || c == '~')
        refuse(0, "a real-time command, which acts in comments too");
      if (static_cast<unsigned char>(c) >= 0x80 || c == 0x18)
        refuse(0, "a byte that acts as a real-time command");
    }
    const std::string block = stripped(line);
    if (block.size() > longest)
      refuse(11, "more than 79 characters");
    if (!block.empty())
      run(parse(block));
  }

  /// Upper case, without blanks and comments.
  static std::string stripped(const std::string& line)
  {
    std::string block;
    bool comment = false;
    for (const char c : line) {
      if (comment) {
        if (c == '(')
          refuse(1, "a comment in a comment");
        comment = c != ')';
      }
      else if (c == ';')
        break;
      else if (c == '(')
        comment = true;
      else if (c != ' ' && c != '\t' && c != '\r' && c != '/')
        block += static_cast<char>(std::toupper(c));
    }
    if (comment)
      refuse(1, "a comment is not closed");
    return block;
  }

  Words parse(const std::string& block)
  {
    Words words;
    std::size_t at = 0;
    while (at < block.size()) {
      const char letter = block[at++];
      if (letter < 'A' || letter > 'Z')
        refuse(1, std::string("'") + letter + "' is not a letter");
      const double value = number(block, at);
      if (letter == 'G')
        words.g.push_back(code(value, 10));
      else if (letter == 'M')
        words.m.push_back(code(value, 1) * 10);
      else
        addValue(words, letter, value);
    }
    return words;
  }

  static double number(const std::string& block, std::size_t& at)
  {
    const std::size_t begin = at;
    if (at < block.size() && (block[at] == '-' || block[at] == '+'))
      ++at;
    int digits = 0, points = 0;
    for (; at < block.size(); ++at) {
      if (block[at] == '.' && ++points == 1)
        continue;
      if (block[at] < '0' || block[at] > '9')
        break;
      ++digits;
    }
    if (digits == 0 || points > 1)
      refuse(2, "not a number");
    return std::stod(block.substr(begin, at - begin));
  }

  static int code(double value, int scale)
  {
    const double scaled = value * scale;
    if (std::abs(scaled - std::round(scaled)) > 1e-6)
      refuse(23, "a code with more decimals");
    return static_cast<int>(std::round(scaled));
  }

  static void addValue(Words& words, char letter, double value)
  {
    if (std::string("FIJKLNPRSTXYZ").find(letter) == std::string::npos)
      refuse(20, std::string("the word ") + letter);
    if (!words.values.emplace(letter, value).second)
      refuse(25, std::string("the word ") + letter + " is repeated");
    if (std::string("FNPST").find(letter) != std::string::npos && value < 0)
      refuse(4, std::string("a negative ") + letter);
    if (letter == 'N' && value > 1e7)
      refuse(27, "a line number above 10000000");
    if (letter == 'T' && (value > 255 || value != std::floor(value)))
      refuse(38, "a tool number above 255, or with decimals");
  }

  /// The modal group of a G code; 0: not modal; none: not supported.
  static std::optional<int> groupOfG(int g)
  {
    static const std::map<int, int> groups{
        {0, 1},    {10, 1},   {20, 1},   {30, 1},   {382, 1},  {383, 1},  {384, 1},
        {385, 1},  {800, 1},  {170, 2},  {180, 2},  {190, 2},  {900, 3},  {910, 3},
        {911, 4},  {930, 5},  {940, 5},  {200, 6},  {210, 6},  {400, 7},  {431, 8},
        {490, 8},  {540, 12}, {550, 12}, {560, 12}, {570, 12}, {580, 12}, {590, 12},
        {610, 13}, {40, 0},   {100, 0},  {280, 0},  {281, 0},  {300, 0},  {301, 0},
        {530, 0},  {920, 0},  {921, 0}};
    const auto found = groups.find(g);
    return found == groups.end() ? std::nullopt : std::optional<int>(found->second);
  }
  static std::optional<int> groupOfM(int m)
  {
    static const std::map<int, int> groups{{0, 4},
                                           {10, 4},
                                           {20, 4},
                                           {300, 4},
                                           {30, 7},
                                           {40, 7},
                                           {50, 7},
                                           {80, 8},
                                           {90, 8}}; // M7 is a compile-time option
    const auto found = groups.find(m);
    return found == groups.end() ? std::nullopt : std::optional<int>(found->second);
  }

  static void checkGroups(const Words& words)
  {
    std::set<int> g_groups, m_groups;
    for (const int g : words.g) {
      const auto group = groupOfG(g);
      if (!group)
        refuse(20, "G" + std::to_string(g / 10) + "." + std::to_string(g % 10));
      if (!g_groups.insert(*group).second)
        refuse(21, "two G codes of one group");
    }
    for (const int m : words.m) {
      const auto group = groupOfM(m);
      if (!group)
        refuse(20, "M" + std::to_string(m / 10));
      if (!m_groups.insert(*group).second)
        refuse(21, "two M codes of one group");
    }
  }

  void run(const Words& words)
  {
    checkGroups(words);
    const bool axes = words.has('X') || words.has('Y') || words.has('Z');
    bool machine = false, homes = false, dwells = false, moves = false;
    for (const int g : words.g) {
      if (groupOfG(g) == 1) {
        motion_ = g;
        moves = true;
      }
      else if (groupOfG(g) == 2)
        plane_ = g;
      else if (groupOfG(g) == 6)
        unit_ = g == 200 ? inch : 1.0;
      else if (groupOfG(g) == 3)
        absolute_ = g == 900;
      machine |= g == 530;
      homes |= g == 280 || g == 300;
      dwells |= g == 40;
    }
    if (words.has('F'))
      feed_ = words.values.at('F');
    if (dwells && !words.has('P'))
      refuse(28, "G4 without P");
    if (machine && motion_ != 0 && motion_ != 10)
      refuse(30, "G53 without G0 or G1");
    if (homes && moves && axes)
      refuse(24, "two commands want the axis words");
    if (!homes)
      move(words, axes, moves, machine);
    else if (axes)
      forget(words);
    checkUnused(words, dwells, axes && !homes);
    for (const int m : words.m)
      ended_ |= m == 20 || m == 300;
  }

  void move(const Words& words, bool axes, bool said, bool machine)
  {
    const bool arc = motion_ == 20 || motion_ == 30;
    if (arc && said && !axes)
      refuse(26, "an arc without axis words");
    if (!axes)
      return;
    if (motion_ == 800)
      refuse(31, "axis words after G80");
    if (motion_ != 0 && feed_ <= 0)
      refuse(22, "no feed");
    if (machine) {
      forget(words);
      return;
    }
    const auto from = at_;
    for (int i = 0; i < 3; ++i) {
      const char letter = "XYZ"[i];
      if (!words.has(letter))
        continue;
      const double value = words.values.at(letter) * unit_;
      at_[i] = absolute_ ? value : at_[i] + value;
    }
    if (arc)
      checkArc(words, from);
  }

  void checkArc(const Words& words, const std::array<double, 3>& from) const
  {
    const int u = plane_ == 170 ? 0 : plane_ == 180 ? 2 : 1;
    const int v = plane_ == 170 ? 1 : plane_ == 180 ? 0 : 2;
    if (!words.has("XYZ"[u]) && !words.has("XYZ"[v]))
      refuse(32, "an arc without axis words of its plane");
    if (words.has('R')) {
      const double chord = std::hypot(at_[u] - from[u], at_[v] - from[v]);
      if (chord == 0)
        refuse(33, "a full circle by its radius");
      if (std::abs(words.values.at('R')) * unit_ * 2 < chord)
        refuse(34, "the radius does not reach");
      return;
    }
    if (!words.has("IJK"[u]) && !words.has("IJK"[v]))
      refuse(35, "an arc without a centre");
    const auto offset = [&](int axis) {
      const char letter = "IJK"[axis];
      return words.has(letter) ? words.values.at(letter) * unit_ : 0.0;
    };
    const double r = std::hypot(offset(u), offset(v));
    const double end =
        std::hypot(at_[u] - from[u] - offset(u), at_[v] - from[v] - offset(v));
    const double off = std::abs(end - r);
    if (off > 0.5 || (off > 0.005 && off > 0.001 * r))
      refuse(33, "the ends of an arc are not equally far from its centre");
  }

  void checkUnused(const Words& words, bool dwells, bool moved) const
  {
    const bool arc = moved && (motion_ == 20 || motion_ == 30);
    for (const char letter : {'I', 'J', 'K', 'R', 'P', 'L'})
      if (words.has(letter) && !(arc && letter != 'P' && letter != 'L') &&
          !(dwells && letter == 'P'))
        refuse(36, std::string("the word ") + letter + " has no use");
  }

  /// Where it is then depends on the machine.
  void forget(const Words&) { at_ = {}; }

  int motion_ = 0, plane_ = 170;
  double unit_ = 1.0, feed_ = 0.0;
  bool absolute_ = true, ended_ = false;
  std::array<double, 3> at_{};
};
