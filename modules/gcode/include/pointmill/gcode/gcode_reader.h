// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace pointmill {

/// @brief One straight move of the tool's tip, part frame [mm].
///
/// A coordinate that the program does not determine is NaN: every axis at the start, X
/// Y Z after a tool change, Z after a change of the tool length, an axis at a reference
/// point or at a position of the machine. After `G53 G0 Z0` or `G28 Z..` Z is
/// +infinity, "above everything": the top of the machine, wherever that is in the part
/// frame; after a machine height more than 10 mm off 0, or `G30`, -infinity, since it
/// may be below everything. A feed move always has finite ends; only rapids, which then
/// set or keep the undetermined axes, may not.
struct ProgramMove {
  Eigen::Vector3d from, to;
  double feed = 0.0;    ///< mm/min; 0 for a rapid
  double spindle = 0.0; ///< rev/min, 0: off, negative: M4
  std::size_t line = 0; ///< counts from 1
  int tool = 0;         ///< in the spindle; 0: none or not known
  bool rapid = false;
  bool from_known = false;    ///< all of @ref from is finite
  bool length_offset = false; ///< the tool's length is in force (G43)
};

/// @brief A stretch of a program by one tool: from a tool change, or from a comment
/// that names an operation, "Operation 2: finishing", to the next. Both, in either
/// order and without a feed move between, begin one section. Rapids before the first
/// belong to none.
struct ProgramSection {
  std::string name; ///< as in the comment, empty without one
  int tool = 0;
  std::size_t line = 0; ///< where it begins
  std::size_t move = 0; ///< the first of its moves
};

/// @brief One of the files that make up a program, and which of its lines, counted
/// through all files, is its first.
struct ProgramFile {
  std::string name;
  std::size_t first_line = 1;
};

/// @brief How a program is spelled.
enum class ProgramForm {
  Rs274,         ///< LinuxCNC, Mach, Fanuc, Haas and their like
  Grbl,          ///< the same without tool changer: a T word and a pause
  Siemens,       ///< 840D
  HeidenhainIso, ///< DIN/ISO on a TNC
  Klartext       ///< Heidenhain's conversational form
};

/// @brief The form of a program of which @p text is the beginning, or all: where only
/// one form begins so, or has a word that stands there. A comment that names Grbl is
/// one of its; everything else is Rs274.
ProgramForm formOf(std::string_view text);

/// @brief What a program does.
struct Program {
  std::vector<ProgramMove> moves;
  std::vector<ProgramSection> sections;
  std::vector<ProgramFile> files; ///< empty where it is one stream
  std::vector<int> tools;         ///< in the order of M6
  std::size_t lines = 0;          ///< read, up to the end of the program
  bool ended = false;             ///< M2 or M30 seen
  /// @brief How far corners may be blended while the program feeds [mm]: the largest
  /// tolerance that it states, as G64 P, G187 E, G642 with CTOL or cycle 32. Infinite
  /// for G64 without a tolerance, 0 where the path is exact (G61, G60, always for
  /// Grbl), -1 where it leaves the matter to the machine for any feed move.
  double blend = -1.0;
  /// @brief Largest G64 Q [mm], within which the control merges lines **in addition**;
  /// P where Q is not given, as LinuxCNC does.
  double merge = 0.0;
  bool inches = false; ///< G20 seen; moves are in mm all the same

  /// @brief Takes the moves of @p next, which is milled after this, as file @p name.
  /// Its line numbers go on from the last line of this.
  void append(Program next, const std::string& name);
  /// @brief "line 12", or "part_2.nc line 12" where the program is of several files.
  std::string where(std::size_t line) const;
};

/// @brief Reads programs as the controls understand them, without macros, parameters,
/// cycles and rotary axes: what posts for milling in three axes write, and ordinary
/// programs of others. doc/stages/gcode_reader.md lists the words of each form.
///
/// Arcs become chords. Only G17 G90 G94 are taken to be in force at the start; nothing
/// else is guessed: a word that is unknown, doubled, in conflict with another or
/// without effect, a length without a unit, a feed move from an unknown position or
/// without F, and a position in a second work offset are DataErrors that name line,
/// column and word, as "line 12, column 5: G81 (canned drilling) is not supported". The
/// part frame is that of the first position: work offset, and shift by G92. It shares
/// no code with GCodeWriter.
class GCodeReader {
public:
  using MoveHandler = std::function<void(const ProgramMove&)>;

  /// @brief How the programs are spelled, Rs274 by default; see formOf().
  void setForm(ProgramForm form) { form_ = form; }
  ProgramForm getForm() const { return form_; }

  /// @brief The tool that is in the spindle at the start, with its length in force; 0,
  /// the default: not known.
  void setMountedTool(int number) { mounted_ = number; }
  int getMountedTool() const { return mounted_; }

  /// @brief Distance between an arc and its chords [mm], 1e-6 .. 1.
  void setChordError(double error) { chord_error_ = error; }
  double getChordError() const { return chord_error_; }

  /// @brief Reads until M2, M30, the closing `%` or the end of @p in. 80 bytes a move.
  Program read(std::istream& in) const;

  /// @brief The same for programs of any size: @p handler gets each move, `moves` stays
  /// empty.
  Program read(std::istream& in, const MoveHandler& handler) const;

private:
  ProgramForm form_ = ProgramForm::Rs274;
  int mounted_ = 0;
  double chord_error_ = 1e-4;
};

/// @brief GCodeReader with its defaults.
inline Program readProgram(std::istream& in)
{
  return GCodeReader().read(in);
}

} // namespace pointmill
