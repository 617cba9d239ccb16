// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// How Klartext moves: L, CC, C, CR, CP.
#include "klartext_form.h"

#include <cmath>
#include <cstring>

namespace pointmill::gcode {

namespace {

const double pi = std::acos(-1.0);
constexpr double farthest = 1e5; // mm
constexpr double most_turns = 1000.0;

} // namespace

/// The words of a block, of which the first letters must be @p allowed; R is that of
/// the compensation, and where @p by_radius also that of an arc.
KlartextForm::Path KlartextForm::readPath(const char* allowed, bool by_radius)
{
  Path path;
  while (!line_.atEnd()) {
    const Word word = line_.next();
    const std::string_view text = word.text;
    const char letter = text.front() == 'I' && text.size() > 1 ? text[1] : text.front();
    if (!std::strchr(allowed, letter))
      line_.fail(word, "'" + std::string(text) + "' is not supported here");
    if (readCoordinate(word, path))
      continue;
    if (text == "DR+" || text == "DR-")
      path.direction = text.back() == '+' ? 1 : -1;
    else if (letter == 'F')
      readFeed(word, path);
    else if (letter == 'M')
      readMachineWord(word, path);
    else if (text == "R0")
      ; // no compensation of the radius
    else if (letter == 'R' && by_radius && !path.radius && text != "RL" && text != "RR")
      path.radius = lengthOf(word, 1);
    else
      line_.fail(word, "'" + std::string(text) + "' is not supported");
  }
  return path;
}

bool KlartextForm::readCoordinate(const Word& word, Path& path)
{
  const std::string_view text = word.text;
  const bool incremental = text.front() == 'I';
  const std::size_t letters = incremental ? 2 : 1;
  const char letter = text.size() > letters ? text[letters - 1] : '\0';
  Coordinate* coordinate = nullptr;
  std::size_t skip = letters;
  if (letter >= 'X' && letter <= 'Z')
    coordinate = &path.axes[letter - 'X'];
  else if (letter == 'P' && text[letters] == 'A') {
    coordinate = &path.angle;
    ++skip;
  }
  if (!coordinate)
    return false;
  if (coordinate->column != 0)
    line_.fail(word, "a second '" + std::string(text.substr(0, skip)) + "'");
  const double value =
      coordinate == &path.angle ? line_.value(word, skip) : lengthOf(word, skip);
  *coordinate = {value, incremental, word.column};
  return true;
}

double KlartextForm::lengthOf(const Word& word, std::size_t letters) const
{
  const double value = line_.value(word, letters) * unit_;
  if (std::abs(value) > farthest)
    line_.fail(word, "'" + std::string(word.text) + "' is beyond 100 m");
  return value;
}

void KlartextForm::readFeed(const Word& word, Path& path)
{
  if (word.text == "FMAX") {
    path.rapid = true;
    return;
  }
  feed_ = line_.value(word, 1) * feed_unit_;
  if (!(feed_ > 0))
    line_.fail(word, "F must be above 0");
}

void KlartextForm::readMachineWord(const Word& word, Path& path)
{
  if (word.text.front() != 'M')
    line_.fail(word, "'" + std::string(word.text) + "' is not supported here");
  switch (line_.whole(word, 1, 9999)) {
  case 0:
  case 1:
  case 8:
  case 9:
    break;
  case 2:
  case 30:
    path.ends = true;
    break;
  case 3:
  case 13:
    machine_.turnSpindle(1);
    break;
  case 4:
  case 14:
    machine_.turnSpindle(-1);
    break;
  case 5:
    path.stops_spindle = true;
    break;
  case 91:
  case 92:
    path.machine_frame = line_.whole(word, 1, 92);
    break;
  default:
    line_.fail(word, std::string(word.text) + " is not supported");
  }
}

/// What happens at the end of a block.
void KlartextForm::finishPath(const Path& path)
{
  if (path.stops_spindle)
    machine_.turnSpindle(0);
  if (path.ends) {
    machine_.end();
    ended_ = true;
  }
}

double KlartextForm::position(const Coordinate& coordinate, int axis) const
{
  if (!coordinate.incremental) {
    machine_.enterFrame({line_.line(), coordinate.column});
    return coordinate.value;
  }
  if (!std::isfinite(machine_.at()[axis]))
    refuse({line_.line(), coordinate.column},
           std::string("I") + static_cast<char>('X' + axis) +
               " from an unknown position");
  return machine_.at()[axis] + coordinate.value;
}

Eigen::Vector3d KlartextForm::target(const Path& path) const
{
  Eigen::Vector3d to = machine_.at();
  for (int axis = 0; axis < 3; ++axis)
    if (path.axes[axis].column)
      to[axis] = position(path.axes[axis], axis);
  return to;
}

void KlartextForm::moveStraight(const Word& word, const Path& path)
{
  if (path.machine_frame)
    moveInMachine(word, path);
  else if (path.axes[0].column || path.axes[1].column || path.axes[2].column) {
    const Eigen::Vector3d to = target(path);
    if (path.rapid)
      machine_.rapid(to);
    else {
      machine_.checkFeedMove(feed_, "L", {line_.line(), word.column});
      machine_.straight(to, feed_);
    }
  }
  finishPath(path);
}

/// M91 counts from the machine's zero, M92 from a place that its builder chose.
void KlartextForm::moveInMachine(const Word& word, const Path& path)
{
  if (!path.rapid)
    line_.fail(word, "machine coordinates are supported with FMAX only");
  if (!path.axes[0].column && !path.axes[1].column && !path.axes[2].column)
    line_.fail(word, "machine coordinates without X, Y or Z");
  for (const auto& axis : path.axes)
    if (axis.incremental)
      refuse({line_.line(), axis.column}, "incremental machine coordinates");
  const auto& z = path.axes[2];
  const bool top = path.machine_frame == 91 && std::abs(z.value) <= near_top;
  machine_.toMachinePlace(
      path.axes[0].column, path.axes[1].column, z.column, top ? unbounded : -unbounded);
}

/// The pole: two axes, or where the tool is.
void KlartextForm::setPole(const Word& word)
{
  const Path path = readPath("XYZ");
  const bool x = path.axes[0].column, y = path.axes[1].column, z = path.axes[2].column;
  if (x + y + z != 0 && x + y + z != 2)
    line_.fail(word, "CC needs two axes, or none");
  plane_ = z ? (x ? 180 : 190) : 170;
  const auto axes = ArcAxes::of(plane_);
  pole_.setConstant(unknown);
  for (const int axis : {axes.u, axes.v})
    pole_[axis] =
        path.axes[axis].column ? position(path.axes[axis], axis) : machine_.at()[axis];
}

Eigen::Vector2d KlartextForm::poleFor(const Word& word) const
{
  const auto axes = ArcAxes::of(plane_);
  const Eigen::Vector2d pole(pole_[axes.u], pole_[axes.v]);
  if (!pole.allFinite())
    line_.fail(word, std::string(word.text) + " without a pole, CC, before it");
  return pole;
}

void KlartextForm::checkArc(const Word& word, const Path& path) const
{
  const std::string name(word.text);
  if (path.rapid)
    line_.fail(word, name + " with FMAX");
  if (path.machine_frame)
    line_.fail(word, name + " in machine coordinates");
  if (path.direction == 0)
    line_.fail(word, name + " without DR+ or DR-");
  machine_.checkFeedMove(feed_, name.c_str(), {line_.line(), word.column});
}

void KlartextForm::moveOnArc(const Word& word, const Path& path)
{
  checkArc(word, path);
  const auto axes = ArcAxes::of(plane_);
  const auto pole = poleFor(word);
  if (path.axes[axes.w].column)
    refuse({line_.line(), path.axes[axes.w].column}, "C leaves the plane of its pole");
  const Arc arc(machine_.at(), target(path), pole, axes, path.direction < 0);
  machine_.arc(arc, feed_, {line_.line(), word.column});
  finishPath(path);
}

/// In the plane of the tool; a negative radius goes the longer way.
void KlartextForm::moveByRadius(const Word& word, const Path& path)
{
  checkArc(word, path);
  if (!path.radius)
    line_.fail(word, "CR without R");
  if (path.axes[2].column)
    refuse({line_.line(), path.axes[2].column}, "CR leaves its plane");
  const Eigen::Vector3d &at = machine_.at(), to = target(path);
  const bool clockwise = path.direction < 0;
  if ((to - at).head<2>().norm() < 2e-6)
    line_.fail(word, "CR must not end where it starts");
  const auto centre =
      centreByRadius(at.head<2>(), to.head<2>(), *path.radius, clockwise);
  if (!centre)
    line_.fail(word, "R is too small to reach the end of the arc");
  machine_.arc(Arc(at, to, *centre, ArcAxes::of(170), clockwise),
               feed_,
               {line_.line(), word.column});
  finishPath(path);
}

/// By an angle about the pole, with a way along the axis: a helix of any turns.
void KlartextForm::moveByAngle(const Word& word, const Path& path)
{
  checkArc(word, path);
  const auto axes = ArcAxes::of(plane_);
  const auto pole = poleFor(word);
  for (const int axis : {axes.u, axes.v})
    if (path.axes[axis].column)
      refuse({line_.line(), path.axes[axis].column}, "CP goes by its angle");
  if (!path.angle.column)
    line_.fail(word, "CP without PA or IPA");

  const Eigen::Vector3d& at = machine_.at();
  const double angle = path.angle.value * pi / 180.0;
  double sweep = angle;
  if (!path.angle.incremental) {
    sweep = std::remainder(
        angle - std::atan2(at[axes.v] - pole.y(), at[axes.u] - pole.x()), 2 * pi);
    if (path.direction * sweep < 1e-6)
      sweep += path.direction * 2 * pi;
  }
  if (!(path.direction * sweep > 0) || std::abs(sweep) > most_turns * 2 * pi)
    refuse({line_.line(), path.angle.column},
           "the angle must have the sign of DR and be within 1000 turns");
  const double rise = target(path)[axes.w] - at[axes.w];
  machine_.arc(
      Arc::turned(at, pole, axes, sweep, rise), feed_, {line_.line(), word.column});
  finishPath(path);
}

} // namespace pointmill::gcode
