// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/operation.h>
#include <pointmill/common/parameters.h>
#include <pointmill/gcode/decimal_grid.h>
#include <pointmill/gcode/machine_calls.h>
#include <pointmill/gcode/post.h>

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pointmill {

/// @brief Who decides how far corners may be rounded.
enum class Corners {
  Tolerance, ///< the program: the path tolerance, exact path where none can be stated
  Control    ///< the control, by its own settings; the program's head says so
};

/// @brief Writes operations as NC programs for the control that a Post describes.
///
/// Every rule is checked before the first byte is written: no program is better than a
/// wrong one.
/// - A path begins and ends on the clearance plane or above it. The writer retracts
///   before each tool change, goes to the first point's Z, then to its X and Y; between
///   two operations of one tool it travels at the higher of both ends.
/// - `Motion::Rapid` and `Motion::Retract` become rapids, all others feed moves with
/// the
///   point's feed. A rapid is either vertical, or level on the clearance plane or above
///   it, or below it where that is allowed.
/// - X and Y are rounded to the nearest decimal, Z upwards; points that coincide
///   after rounding are written once.
///
/// The same operations and settings give the same bytes, in any locale.
class GCodeWriter {
public:
  struct Statistics {
    std::size_t lines = 0;
    std::size_t bytes = 0;
    std::size_t feed_moves = 0; ///< before adapters make fewer or more of them
    std::size_t rapids = 0;     ///< with those of retracts and approaches
    std::size_t tool_changes = 0;
    std::size_t skipped = 0; ///< points that coincide with the one before
    std::size_t slowed = 0;  ///< moves whose feed was above the limit
    std::size_t files = 1;
    std::size_t longest_file = 0; ///< [lines]
  };

  /// @brief Gives the stream of each next file. The one before is complete then. @p
  /// suffix is for the file's name: empty for a single one, else "_1", "_2", or "_1_T3"
  /// where each file has one tool: in the order of machining.
  using Opener = std::function<std::ostream&(const std::string& suffix)>;
  /// @brief Makes what stands between the writer and the printer, as a CallAdapter: it
  /// hands on to @p next.
  using Adapter = std::function<std::unique_ptr<MachineCalls>(MachineCalls& next)>;

  /// @brief The control that is written for, LinuxCNC by default.
  void setPost(Post post) { post_ = std::move(post); }
  const Post& getPost() const { return post_; }

  /// @brief Of the lengths in the program; the operations stay in mm.
  void setUnit(Unit unit) { unit_ = unit; }
  Unit getUnit() const { return unit_; }

  /// @brief For controls that name or number their programs. Of several files each has
  /// its suffix, or the next number.
  void setProgramName(const std::string& name) { name_ = name; }
  const std::string& getProgramName() const { return name_; }
  void setProgramNumber(int number) { number_ = number; }
  int getProgramNumber() const { return number_; }

  /// @brief The block of raw material, for controls that show it.
  void setStock(const std::optional<Stock>& stock) { stock_ = stock; }
  const std::optional<Stock>& getStock() const { return stock_; }

  /// @brief N words, or none, whatever the post prefers.
  void setLineNumbers(bool numbers) { line_numbers_ = numbers; }
  bool getLineNumbers() const { return line_numbers_.value_or(post_.numbers); }

  /// @brief Who changes tools, whatever the post prefers. With ToolChange::Program each
  /// tool gets a program of its own.
  void setToolChange(ToolChange change) { tool_change_ = change; }
  ToolChange getToolChange() const { return tool_change_.value_or(post_.tools); }

  /// @brief Where the tool goes before tool changes and at the end, whatever the post
  /// prefers.
  void setRetract(Retract retract) { retract_ = retract; }
  Retract getRetract() const { return retract_.value_or(post_.retract); }

  /// @brief Faster feeds are written as this one [mm/min]; 0: none is.
  void setMaxFeed(double feed) { max_feed_ = feed; }
  double getMaxFeed() const { return max_feed_; }

  /// @brief Longest program [lines]; 0: any. A longer one is split into complete
  /// programs: at a rapid if one is near, else the tool is lifted from where it is, and
  /// comes down there again.
  void setMaxLines(int lines) { max_lines_ = lines; }
  int getMaxLines() const { return max_lines_; }

  void setCorners(Corners corners) { corners_ = corners; }
  Corners getCorners() const { return corners_; }

  /// @brief Adapters in the order in which calls go through them.
  void addAdapter(Adapter adapter) { adapters_.push_back(std::move(adapter)); }

  /// @brief What machine calls count in.
  DecimalGrid getGrid() const;

  /// @brief Text for the head of each program, turned to what the control allows in
  /// comments.
  void addComment(const std::string& text) { comments_.push_back(text); }
  void setComments(std::vector<std::string> lines) { comments_ = std::move(lines); }
  const std::vector<std::string>& getComments() const { return comments_; }

  /// @brief Z [mm], part frame, above which the tool may travel in rapid. Obligatory.
  void setClearancePlane(double z) { clearance_ = z; }
  double getClearancePlane() const { return clearance_; }

  /// @brief Whether level rapids may run below the clearance plane, as LinkPasses plans
  /// them where a machine may dog-leg.
  void setLowRapids(bool allowed) { low_rapids_ = allowed; }
  bool getLowRapids() const { return low_rapids_; }

  /// @brief How far the control may round corners [mm], as `G64 P.. Q0.`; 0, or where
  /// the control cannot be told: exact path. It belongs into the error budget.
  void setPathTolerance(double tolerance) { tolerance_ = tolerance; }
  double getPathTolerance() const { return tolerance_; }

  /// @brief Decimals of coordinates, 3 .. 6, in inches 4 .. 6; 0: as many as the post
  /// prefers.
  void setDecimals(int decimals) { decimals_ = decimals; }
  int getDecimals() const { return decimals_; }

  template <typename V>
  void parameters(V&& v)
  {
    v("clearance_plane", clearance_, "mm", Range{-1e5, 1e5}, "Z of rapid travel");
    v("path_tolerance", tolerance_, "mm", Range{0, 1}, "rounding of corners");
    v("decimals", decimals_, "", Range{0, 6}, "decimals of coordinates");
    v("max_feed", max_feed_, "mm/min", Range{0, 1e6}, "limit of feeds");
    v("max_lines", max_lines_, "", Range{0, 1e9}, "lines of one program");
    v("program_number", number_, "", Range{1, 7999}, "of the first program");
  }

  /// @brief Writes one program to @p out. Throws ParameterError for settings, tools,
  /// feeds and speeds, and where one program cannot hold it all, DataError for paths,
  /// both before anything is written; Error when @p out fails.
  Statistics write(const std::vector<Operation>& operations, std::ostream& out) const;

  /// @brief The same as one program or several; @p open is called for each.
  Statistics write(const std::vector<Operation>& operations, const Opener& open) const;

  /// @brief The same as machine calls, through the adapters that were added; no limit
  /// of lines or of arcs is kept, `lines` and `bytes` stay 0.
  Statistics write(const std::vector<Operation>& operations, MachineCalls& calls) const;

private:
  /// How many files there will be, and whether because of their length.
  struct Layout {
    std::size_t files;
    bool split;
  };
  Layout layOut(const std::vector<Operation>& operations) const;
  Statistics print(const std::vector<Operation>& operations,
                   const Opener& open,
                   Layout layout) const;

  std::vector<std::string> comments_;
  double clearance_ = std::numeric_limits<double>::quiet_NaN();
  double tolerance_ = 0.01;
  int decimals_ = 0;
  bool low_rapids_ = false;
  Post post_ = Post::named("linuxcnc");
  Unit unit_ = Unit::Millimetre;
  std::string name_ = "POINTMILL";
  int number_ = 1001;
  std::optional<Stock> stock_;
  std::optional<bool> line_numbers_;
  std::optional<ToolChange> tool_change_;
  std::optional<Retract> retract_;
  double max_feed_ = 0.0;
  int max_lines_ = 0;
  Corners corners_ = Corners::Tolerance;
  std::vector<Adapter> adapters_;
};

} // namespace pointmill
