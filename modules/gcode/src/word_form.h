// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "codes.h"
#include "front_end.h"
#include "word_lexer.h"

#include <Eigen/Core>

#include <string>
#include <string_view>

namespace pointmill::gcode {

/// @brief What all programs of G and M words have in common: the order in which the
/// words of a block are obeyed, modes, and moves. What a form does otherwise is in its
/// hooks.
class WordForm : public FrontEnd {
public:
  WordForm(ProgramForm form, MachineState& machine);

  bool obey(std::string_view text, std::size_t line) override;

protected:
  using Code = Block::Code;

  /// @name Hooks, in the order in which they are called
  /// @{
  virtual void dwell() = 0;
  /// @brief mm/min of F1.
  virtual double feedUnit(bool inches) const { return inches ? inch : 1.0; }
  /// @brief Selects and changes tools.
  virtual void setTool() = 0;
  virtual void setLength() {}
  virtual void setOffset();
  virtual void setPath() = 0;
  /// @brief Obeys the non-modal words, which may take the block's axes.
  virtual void obeyNonModal() = 0;
  /// @brief Takes centres that stay for later blocks.
  virtual void setPole() {}
  /// @brief The centre of an arc without R, along the plane's axes.
  virtual Eigen::Vector2d centre(ArcAxes axes, int column) const;
  /// @brief Before a feed move that starts at @p column of the block.
  virtual void checkTool(int /*column*/) const {}
  /// @brief M0 and M1.
  virtual void pause() {}
  /// @}

  /// @name The block
  /// @{
  const Block& block() const { return block_; }
  Place place(int column) const { return {block_.line(), column}; }
  [[noreturn]] void fail(int column, const std::string& what) const
  {
    block_.fail(column, what);
  }
  [[noreturn]] void fail(char letter, const std::string& what) const
  {
    block_.fail(block_.column(letter), what);
  }
  const Code* code(Group group) const { return codes_[group]; }
  bool is(Group group, int tenths) const
  {
    return codes_[group] && codes_[group]->tenths == tenths;
  }
  /// @brief Takes a word as a length [mm].
  double length(char letter) const;
  /// @brief Takes a word as a whole number, @p least .. @p most.
  int whole(char letter, int least, int most) const;
  /// @brief Where the block's X Y Z go; @p zero_stays: from an unknown position G91
  /// may still say 0.
  Eigen::Vector3d target(bool zero_stays = false) const;
  /// @brief A rapid to X Y Z of the machine, as far as they are there.
  void moveInMachine(double height_of_zero);
  /// @}

  bool inRapid() const { return mode_ == 0; }
  bool incremental() const { return incremental_; }
  void setUnit(bool inches);

  MachineState& machine_;

private:
  bool execute();
  void readProgramNumber();
  bool stop();
  void sortCodes();
  void sort(char letter, const Code& word, Group group);
  void setUnits();
  void setFeedAndSpeed();
  void runSpindle();
  void setModes();
  void move();
  void moveOnArc(const Eigen::Vector3d& to, int column);
  void checkLeftOver() const;

  const ProgramForm form_;
  const CodeTable table_;
  WordLexer lexer_;
  Block block_;
  const Code* codes_[group_count] = {};
  bool started_ = false, percent_ = false;

  double unit_ = 0.0;      // mm; 0: not said yet
  double feed_unit_ = 0.0; // mm/min
  double feed_ = 0.0;      // mm/min, or 1/min in inverse time
  bool inverse_time_ = false, absolute_centres_ = false, incremental_ = false;
  int plane_ = 170;
  int mode_ = 800;
};

} // namespace pointmill::gcode
