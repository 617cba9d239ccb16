// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "playback.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pointmill::viewer {

namespace {

constexpr double kSpeeds[] = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000};
constexpr double kMinute = 60; // s

template <typename Choice>
void next(Choice& choice, Choice last, bool back)
{
  const int count = static_cast<int>(last) + 1;
  choice =
      static_cast<Choice>((static_cast<int>(choice) + (back ? count - 1 : 1)) % count);
}

double otherSpeed(double speed, bool faster)
{
  if (faster) {
    const auto* at = std::upper_bound(std::begin(kSpeeds), std::end(kSpeeds), speed);
    return at == std::end(kSpeeds) ? speed : *at;
  }
  const auto* at = std::lower_bound(std::begin(kSpeeds), std::end(kSpeeds), speed);
  return at == std::begin(kSpeeds) ? speed : *(at - 1);
}

/// To the end of the move before, or of the next one.
double otherMove(const CutPlayer& player, bool back)
{
  const std::size_t move = player.move();
  if (back)
    return player.beginOf(move);
  const std::size_t last = player.program().moves.size() - 1;
  std::size_t at = move;
  while (at < last && player.endOf(at) <= player.time())
    ++at;
  return player.endOf(at);
}

bool changeMoment(const std::string& key,
                  bool shift,
                  const CutPlayer& player,
                  ViewerLook& look)
{
  if (key == "Left" || key == "Right") {
    const bool back = key == "Left";
    look.time =
        shift ? player.time() + (back ? -kMinute : kMinute) : otherMove(player, back);
    look.time = std::clamp(look.time, 0.0, player.duration());
  }
  else if (key == "Home")
    look.time = 0;
  else if (key == "End")
    look.time = player.duration();
  else if (key == "Up" || key == "Down")
    look.speed = otherSpeed(look.speed, key == "Up");
  else
    return false;
  return true;
}

void otherLevel(const std::vector<double>& levels, bool up, ViewerLook& look)
{
  if (levels.empty())
    return;
  if (!look.level)
    look.level = 0;
  else if (up)
    look.level = *look.level > 0 ? *look.level - 1 : 0;
  else
    look.level = std::min(*look.level + 1, levels.size() - 1);
  if (!look.map && look.paths != ViewedPaths::Level)
    look.map = true;
}

void otherFinding(const ViewerScene& scene, bool back, ViewerLook& look)
{
  const std::size_t count = scene.findings.size();
  if (count == 0)
    return;
  look.finding = !look.finding ? (back ? count - 1 : 0)
                               : (*look.finding + (back ? count - 1 : 1)) % count;
  look.time = momentOf(scene, scene.findings[*look.finding], look.time);
}

} // namespace

double
momentOf(const ViewerScene& scene, const ViewedFinding& finding, double otherwise)
{
  if (!scene.player || finding.line == 0)
    return otherwise;
  const CutPlayer& player = *scene.player;
  return finding.place ? player.nearestInLine(finding.line, *finding.place)
                       : player.endOf(player.moveOfLine(finding.line));
}

bool changeLook(const std::string& key,
                bool shift,
                const ViewerScene& scene,
                const std::vector<double>& levels,
                ViewerLook& look)
{
  if (scene.player && scene.player->duration() > 0 &&
      changeMoment(key, shift, *scene.player, look))
    return true;
  const auto is = [&](const char* name) {
    return key.size() == 1 ? std::tolower(key[0]) == name[0] && !name[1] : key == name;
  };
  if (is("Prior") || is("Next"))
    otherLevel(levels, is("Prior"), look);
  else if (is("n") || is("b"))
    otherFinding(scene, is("b"), look);
  else if (is("v"))
    next(look.solid, ViewedSolid::None, shift);
  else if (is("t"))
    next(look.paths, ViewedPaths::None, shift);
  else if (is("k"))
    next(look.colouring, PathColouring::Height, shift);
  else if (is("d"))
    look.rapids = !look.rapids;
  else if (is("y"))
    look.tool = !look.tool;
  else if (is("m")) {
    look.map = !look.map;
    if (look.map && !look.level && !levels.empty())
      look.level = levels.size() / 2;
  }
  else if (is("a"))
    look.box = !look.box;
  else if (is("i"))
    look.texts = !look.texts;
  else if (is("F1"))
    look.from = ViewedFrom::Iso;
  else if (is("F2"))
    look.from = ViewedFrom::Top;
  else if (is("F3"))
    look.from = ViewedFrom::Front;
  else if (is("F4"))
    look.from = ViewedFrom::Right;
  else
    return false;
  if (movesCamera(key) && key[0] == 'F')
    look.finding.reset();
  return true;
}

bool movesCamera(const std::string& key)
{
  return key == "F1" || key == "F2" || key == "F3" || key == "F4" || key == "n" ||
         key == "N" || key == "b" || key == "B";
}

const std::string& keysHelp()
{
  static const std::string text =
      "space        play the cut, or stop\n"
      "Left Right   a move back or on; with Shift a minute\n"
      "Home End     beginning and end of the program\n"
      "Up Down      play faster or slower\n"
      "PgUp PgDn    the level above or below\n"
      "m            the bi-colour map at that level\n"
      "n b          the next or last finding\n"
      "v            stock, part, deviation, nothing\n"
      "t            paths: all, of the level, trail, none\n"
      "k            what their colours tell\n"
      "d y a i      rapids, tool, box of the stock, texts\n"
      "F1 .. F4     from the corner, top, front, right";
  return text;
}

double suitableSpeed(double duration)
{
  for (const double speed : kSpeeds)
    if (duration / speed <= kMinute)
      return speed;
  return *(std::end(kSpeeds) - 1);
}

} // namespace pointmill::viewer
