// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "printer.h"

#include "klartext_printer.h"
#include "word_printer.h"

#include <pointmill/common/version.h>

#include <algorithm>
#include <charconv>

namespace pointmill::gcode {

namespace {

constexpr double inch = 25.4; // mm

std::string upperCase(std::string text)
{
  for (auto& c : text)
    if (c >= 'a' && c <= 'z')
      c = static_cast<char>(c - 'a' + 'A');
  return text;
}

CommentText commentText(const Post& post)
{
  CommentText text;
  text.allowed = characterSet(post.comment_characters);
  if (!post.comment_close.empty()) // neither sign may stand inside
    for (const char c : post.comment_open + post.comment_close)
      text.allowed.reset(static_cast<unsigned char>(c) & 0x7F);
  text.allowed.set(' ');
  text.upper_case = post.upper_case;
  text.widest =
      static_cast<std::size_t>(std::min(post.comment_width, post.line_limit)) -
      post.comment_open.size() - post.comment_close.size();
  return text;
}

/// Klartext counts its blocks from 0, without a letter.
bool countsBlocks(const Post& post)
{
  return post.form == ProgramForm::Klartext;
}

} // namespace

std::unique_ptr<Printer>
Printer::make(std::ostream& out, const Post& post, const PrinterSettings& settings)
{
  if (post.form == ProgramForm::Klartext)
    return std::make_unique<KlartextPrinter>(out, post, settings);
  return std::make_unique<WordPrinter>(out, post, settings);
}

Printer::Printer(std::ostream& out, const Post& post, const PrinterSettings& settings)
    : post_(post), grid_(settings.grid), style_{post.plus_sign,
                                                post.decimal_point,
                                                post.leading_zero},
      settings_(settings), lines_(out, static_cast<std::size_t>(post.line_limit)),
      comments_(commentText(post)), feed_grid_(post.feed_decimals),
      feed_factor_(double(feed_grid_.nearest(1.0)) / 1000.0),
      next_number_(countsBlocks(post) ? 0 : post.number_start)
{
  if (settings.unit == Unit::Inch)
    feed_factor_ *= post.inch_feed_factor / inch;
}

void Printer::begin(const ProgramHead& head)
{
  places_ = {{"program", post_.upper_case ? upperCase(head.name) : head.name},
             {"number", std::to_string(settings_.number)},
             {"unit", settings_.unit == Unit::Inch ? post_.unit_inch : post_.unit_mm},
             {"control", post_.control}};
  print(post_.start);
  comment(std::string("PointMill ") + version + " for " + post_.control);
  for (const auto& text : head.comments)
    comment(text);
  for (const auto& tool : head.tools) {
    tool_texts_[tool.number] = tool.describe();
    comment(tool.describe());
  }
  if (settings_.corners == Corners::Control)
    comment("How far corners are rounded is left to the control");
  if (const auto& stock = head.stock) {
    const auto text = [this](double value) {
      return coordinateText(grid_.nearest(value));
    };
    print(post_.stock,
          {{"xmin", text(stock->min.x())},
           {"ymin", text(stock->min.y())},
           {"zmin", text(stock->min.z())},
           {"xmax", text(stock->max.x())},
           {"ymax", text(stock->max.y())},
           {"zmax", text(stock->max.z())}});
  }
  print(post_.setup);
  if (settings_.corners == Corners::Tolerance)
    printPathMode(head.path_tolerance);
}

void Printer::printPathMode(double tolerance)
{
  // Rounded, but never to more than was asked for.
  auto ticks = grid_.nearest(tolerance);
  if (grid_.value(ticks) > tolerance + 1e-9)
    --ticks;
  if (ticks > 0 && !post_.blend.empty())
    print(post_.blend, {{"tolerance", grid_.text(ticks, {false, style_.point, true})}});
  else
    print(post_.exact_path);
}

void Printer::comment(const std::string& text)
{
  for (const auto& line : comments_.lines(text))
    printLine(post_.comment_open + line + post_.comment_close);
}

void Printer::operation(std::size_t number, const std::string& name)
{
  comment("Operation " + std::to_string(number) + ": " + name);
}

void Printer::stop()
{
  print(post_.stop);
}

void Printer::retract()
{
  const auto& lines = post_.retractLines(settings_.retract);
  if (lines.empty())
    return;
  print(lines);
  forget();
}

void Printer::changeTool(int number)
{
  tool_ = number;
  tool_pending_ = true;
}

void Printer::spindle(long rpm)
{
  if (!tool_pending_) {
    print(post_.spindle, toolPlaces(rpm));
    return;
  }
  // The first tool is in the spindle when the program starts.
  const bool pause = settings_.pause_for_tools && tool_known_;
  print(pause ? post_.tool_pause : post_.tool_change, toolPlaces(rpm));
  tool_pending_ = false;
  tool_known_ = true;
  feed_ = 0; // a person may want to start here
  forget();
}

Places Printer::toolPlaces(long rpm) const
{
  const auto text = tool_texts_.find(tool_);
  const auto lines = comments_.lines(text == tool_texts_.end() ? "" : text->second);
  return {{"tool", std::to_string(tool_)},
          {"tool_text", lines.empty() ? "" : lines.front()},
          {"rpm", std::to_string(rpm)}};
}

void Printer::coolant(bool on)
{
  print(on ? post_.coolant_on : post_.coolant_off);
}

void Printer::approach(const MachinePosition& to)
{
  print(post_.approach,
        {{"tool", std::to_string(tool_)},
         {"x", coordinateText(to.x)},
         {"y", coordinateText(to.y)},
         {"z", coordinateText(to.z)}});
  approached(to);
}

void Printer::dwell(double seconds)
{
  const DecimalGrid grid(3);
  print(post_.dwell, {{"seconds", grid.text(grid.nearest(seconds))}});
}

void Printer::end()
{
  print(post_.end);
  lines_.flush();
}

void Printer::print(const Post::Lines& lines, const Places& more)
{
  if (lines.empty())
    return;
  Places places = places_;
  places.insert(places.end(), more.begin(), more.end());
  for (const auto& line : lines) {
    const auto filled = fill(line, places);
    if (isComment(filled)) // which may have to be wrapped
      comment(filled.substr(post_.comment_open.size(),
                            filled.size() - post_.comment_open.size() -
                                post_.comment_close.size()));
    else
      printLine(filled);
  }
}

void Printer::printLine(const std::string& line)
{
  char digits[16];
  char* const end = isNumbered(line) ? number(digits) : digits;
  lines_.line(std::string(static_cast<char*>(digits), end) + line);
}

/// A whole line of comment.
bool Printer::isComment(const std::string& line) const
{
  const auto &open = post_.comment_open, &close = post_.comment_close;
  return line.size() >= open.size() + close.size() &&
         line.compare(0, open.size(), open) == 0 &&
         line.compare(line.size() - close.size(), close.size(), close) == 0;
}

bool Printer::isNumbered(const std::string& line) const
{
  if (countsBlocks(post_))
    return true;
  return settings_.numbers && line[0] != '%' && line[0] != 'O' &&
         (!isComment(line) || post_.form == ProgramForm::HeidenhainIso);
}

char* Printer::number(char* to)
{
  const bool counted = countsBlocks(post_);
  if (!counted)
    *to++ = 'N';
  to = std::to_chars(to, to + 12, next_number_).ptr;
  *to++ = ' ';
  next_number_ += counted ? 1 : post_.number_step;
  if (!counted && next_number_ > post_.number_max)
    next_number_ = post_.number_start;
  return to;
}

char* Printer::block()
{
  char* p = lines_.line();
  if (settings_.numbers || countsBlocks(post_))
    p = number(p);
  first_ = p;
  return p;
}

char* Printer::word(char* to, char letter) const
{
  if (to != first_)
    *to++ = ' ';
  *to++ = letter;
  return to;
}

char* Printer::word(char* to, const std::string& text) const
{
  if (to != first_)
    *to++ = ' ';
  return std::copy(text.begin(), text.end(), to);
}

char* Printer::coordinate(char* to, char letter, std::int64_t ticks) const
{
  return grid_.write(word(to, letter), ticks, style_);
}

std::string Printer::coordinateText(std::int64_t ticks) const
{
  return grid_.text(ticks, style_);
}

std::int64_t Printer::feedTicks(std::int64_t feed) const
{
  // Downwards, so that no limit is exceeded, but for the noise of the conversion.
  const auto ticks = static_cast<std::int64_t>(double(feed) * feed_factor_ + 1e-6);
  return std::max<std::int64_t>(ticks, 1);
}

char* Printer::feed(char* to, std::int64_t feed)
{
  if (feed == feed_)
    return to;
  feed_ = feed;
  return feed_grid_.write(
      word(to, 'F'), feedTicks(feed), {false, style_.point, style_.leading_zero});
}

} // namespace pointmill::gcode
