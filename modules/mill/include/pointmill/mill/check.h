// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/gcode/gcode_reader.h>
#include <pointmill/mill/criteria.h>
#include <pointmill/verify/program_time.h>
#include <pointmill/verify/program_verifier.h>

#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace pointmill {

/// @brief A program as a control reads it, and what is to be said of it.
struct Judgement {
  Program program;
  Verification verification;
  ProgramTime time;
};

/// @brief One of the files of a program.
struct ProgramStream {
  std::string name;
  std::unique_ptr<std::istream> text;
};

/// @brief Opens files, in the order of machining. @throws DataError
std::vector<ProgramStream> openPrograms(const std::vector<std::string>& paths);

/// @brief How a file is spelled, where its first lines tell, else @p otherwise.
ProgramForm formOf(const ProgramStream& file, ProgramForm otherwise);

/// @brief Reads a program of one file or several, as the criteria say it is spelled.
/// @param mounted tool that is in the spindle at the start; 0: not known
/// @throws DataError where it cannot be read
Program readPrograms(std::vector<ProgramStream> files,
                     const Criteria& criteria,
                     int mounted = 0);

/// @brief How long it runs on the machine of the criteria.
ProgramTime timeOf(const Program& program, const Criteria& criteria);

/// @brief readPrograms(), and judges what it reads.
/// @param mounted tool that is in the spindle at the start; 0: not known
/// @throws DataError where it cannot be read
Judgement
judge(std::vector<ProgramStream> files, const Criteria& criteria, int mounted = 0);

/// @brief What was found, a line each: severity, code, what it is, and where.
std::vector<std::string> findingLines(const Verification& verification,
                                      const Program& program);

/// @brief What a person should know of a judged program.
std::string summaryOf(const Judgement& judgement, const Criteria& criteria);

/// @brief Writes the picture that shows what was found and where, see writeFindings().
void writeFindings(const std::string& path,
                   const std::string& title,
                   const Judgement& judgement,
                   const Criteria& criteria);

/// @brief Writes the same as a page that people look at, with figures and a 3D view;
/// see doc/report_page.md.
void writeCheckPage(const std::string& path,
                    const std::string& title,
                    const Judgement& judgement,
                    const Criteria& criteria);

} // namespace pointmill
