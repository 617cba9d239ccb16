// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/gcode/gcode_writer.h>

#include "arc_limiter.h"
#include "feed_limiter.h"
#include "machining_plan.h"
#include "program_files.h"
#include "program_splitter.h"

#include <pointmill/common/error.h>
#include <pointmill/common/watch.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <streambuf>
#include <utility>

namespace pointmill {

using namespace gcode;

namespace {

constexpr double inch = 25.4;             // mm
constexpr std::size_t last_number = 7999; // beyond are those of the machine's builder
constexpr double soft_landing = 1.0;      // mm: the last of the way down is fed
constexpr double kLayoutShare = 0.1;      // of the work of writing

/// Takes all and keeps nothing.
class NullBuffer : public std::streambuf {
  int_type overflow(int_type c) override { return traits_type::not_eof(c); }
  std::streamsize xsputn(const char*, std::streamsize n) override { return n; }
};

[[noreturn]] void refuse(const std::string& what)
{
  throw ParameterError("GCodeWriter: " + what);
}

void checkName(const std::string& name)
{
  const bool good = !name.empty() && name.size() <= 32 &&
                    std::all_of(name.begin(), name.end(), [](char c) {
                      return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                             (c >= '0' && c <= '9') || c == '_' || c == '-';
                    });
  if (!good)
    refuse("the program's name '" + name +
           "' must be 1 .. 32 letters, digits, '_' and '-'");
}

void checkStock(const std::optional<Stock>& stock)
{
  const auto inReach = [](const Eigen::Vector3d& corner) {
    return (corner.array().abs() <= 1e5).all(); // NaN is not
  };
  if (stock && !(inReach(stock->min) && inReach(stock->max)))
    refuse("the stock is not finite or beyond 100 m");
}

void checkPost(const GCodeWriter& writer)
{
  const Post& post = writer.getPost();
  post.validate();
  const auto retract = writer.getRetract();
  if (retract != Retract::Clearance && post.retractLines(retract).empty())
    refuse("the post " + post.name + " has no retract to " +
           (retract == Retract::Home ? "the home position" : "the top of the machine"));
  const auto change = writer.getToolChange();
  if (change == ToolChange::Pause && post.tool_pause.empty())
    refuse("the post " + post.name + " cannot wait for a tool");
  if (change == ToolChange::Changer && post.tools != ToolChange::Changer)
    refuse("the post " + post.name + " has no tool changer");
}

void check(const GCodeWriter& writer)
{
  validateParameters(writer, "GCodeWriter");
  if (writer.getDecimals() != 0)
    checkRange("GCodeWriter",
               "decimals",
               writer.getDecimals(),
               "",
               {writer.getUnit() == Unit::Inch ? 4.0 : 3.0, 6}); // arcs need them
  if (writer.getMaxFeed() != 0)
    checkRange("GCodeWriter", "max_feed", writer.getMaxFeed(), "mm/min", {0.001, 1e6});
  checkName(writer.getProgramName());
  checkStock(writer.getStock());
  checkPost(writer);
}

ProgramHead headOf(const GCodeWriter& writer)
{
  ProgramHead head;
  head.name = writer.getProgramName();
  head.comments = writer.getComments();
  head.path_tolerance = writer.getPathTolerance();
  head.stock = writer.getStock();
  return head;
}

/// Says all to @p last, through the adapters.
GCodeWriter::Statistics runThrough(const std::vector<GCodeWriter::Adapter>& adapters,
                                   const GCodeWriter& writer,
                                   MachiningPlan& plan,
                                   MachineCalls& last)
{
  std::vector<std::unique_ptr<MachineCalls>> chain;
  MachineCalls* next = &last;
  for (auto adapter = adapters.rbegin(); adapter != adapters.rend(); ++adapter) {
    chain.push_back((*adapter)(*next));
    next = chain.back().get();
  }
  if (writer.getMaxFeed() == 0)
    return plan.run(headOf(writer), *next);
  FeedLimiter limiter(*next, DecimalGrid(3).nearest(writer.getMaxFeed()));
  auto statistics = plan.run(headOf(writer), limiter);
  statistics.slowed = limiter.slowed();
  return statistics;
}

} // namespace

DecimalGrid GCodeWriter::getGrid() const
{
  const bool inches = unit_ == Unit::Inch;
  const int preferred = inches ? post_.decimals_inch : post_.decimals_mm;
  return DecimalGrid(decimals_ != 0 ? decimals_ : preferred, inches ? inch : 1.0);
}

GCodeWriter::Statistics GCodeWriter::write(const std::vector<Operation>& operations,
                                           MachineCalls& calls) const
{
  check(*this);
  MachiningPlan plan(operations, *this);
  // A dry run finds every refusal before the first call.
  MachineCalls nothing;
  plan.run(headOf(*this), nothing);
  return runThrough(adapters_, *this, plan, calls);
}

GCodeWriter::Statistics GCodeWriter::print(const std::vector<Operation>& operations,
                                           const Opener& open,
                                           Layout layout) const
{
  PrinterSettings settings;
  settings.unit = unit_;
  settings.grid = getGrid();
  settings.numbers = getLineNumbers();
  settings.pause_for_tools = getToolChange() == ToolChange::Pause;
  settings.retract = getRetract();
  settings.corners = corners_;
  settings.number = number_;
  const bool of_one_tool = getToolChange() == ToolChange::Program;
  ProgramFiles programs(open, post_, settings, {layout.files, of_one_tool});

  MachiningPlan plan(operations, *this);
  Statistics statistics;
  if (layout.split) {
    ProgramSplitter::Settings split;
    split.max_lines = static_cast<std::size_t>(max_lines_);
    split.clearance = settings.grid.atOrAbove(static_cast<float>(clearance_));
    split.soft_landing = settings.grid.nearest(soft_landing);
    ProgramSplitter splitter(programs, post_, split);
    ArcLimiter limiter(splitter, post_, settings.grid);
    statistics = runThrough(adapters_, *this, plan, limiter);
  }
  else {
    ArcLimiter limiter(programs, post_, settings.grid);
    statistics = runThrough(adapters_, *this, plan, limiter);
  }
  statistics.files = programs.files();
  statistics.lines = programs.lines();
  statistics.bytes = programs.bytes();
  statistics.longest_file = programs.longest();
  return statistics;
}

/// Finds every refusal before anything is written.
GCodeWriter::Layout GCodeWriter::layOut(const std::vector<Operation>& operations) const
{
  MachiningPlan plan(operations, *this);
  MachineCalls nothing;
  plan.run(headOf(*this), nothing);
  const Layout whole{plan.parts().size(), false};
  if (max_lines_ == 0)
    return whole;

  NullBuffer buffer;
  std::ostream null(&buffer);
  const Opener open = [&null](const std::string&) -> std::ostream& { return null; };
  if (print(operations, open, whole).longest_file <=
      static_cast<std::size_t>(max_lines_))
    return whole;
  // Any number but 1, so that the heads have the line that tells the number.
  return {print(operations, open, {2, true}).files, true};
}

GCodeWriter::Statistics GCodeWriter::write(const std::vector<Operation>& operations,
                                           const Opener& open) const
{
  check(*this);
  const Layout layout = [&] {
    const WorkStep step({0.0, kLayoutShare});
    return layOut(operations);
  }();
  const WorkStep step({kLayoutShare, 1.0});
  if (number_ + layout.files - 1 > last_number)
    refuse("the number of the last program is beyond " + std::to_string(last_number));
  return print(operations, open, layout);
}

GCodeWriter::Statistics GCodeWriter::write(const std::vector<Operation>& operations,
                                           std::ostream& out) const
{
  check(*this);
  const Layout layout = layOut(operations);
  if (layout.files > 1)
    refuse("the post " + post_.name + " needs " + std::to_string(layout.files) +
           " programs for this, not one");
  return print(
      operations, [&out](const std::string&) -> std::ostream& { return out; }, layout);
}

} // namespace pointmill
