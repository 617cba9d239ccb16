// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "finding_scene.h"
#include "print.h"

#include <pointmill/common/error.h>
#include <pointmill/common/watch.h>
#include <pointmill/mill/check.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace pointmill {
namespace {

constexpr double kReadShare = 0.05; // of the work of judging

std::string withPlace(const std::string& file, const std::string& what)
{
  return file.empty() ? what : file + ": " + what;
}

std::string whereOf(const Finding& f, const Program& program)
{
  return f.line > 0 ? program.where(f.line) : "";
}

/// Of what is not measured in the stock that the picture shows.
std::string noteOf(const Finding& f)
{
  if (f.code == "axial_depth" || f.code == "flute_length")
    return print("the stock is as the program leaves it: the layer of %.3f mm taken "
                 "here is gone",
                 f.worst);
  for (const char* code : {"rapid_in_stock", "plunge", "pressed_in", "shank", "holder"})
    if (f.code == code)
      return "the stock is as the program leaves it, not as the tool found it";
  return "";
}

bool hasPlace(const Finding& f)
{
  return f.place.allFinite() && !f.place.isZero();
}

} // namespace

std::vector<ProgramStream> openPrograms(const std::vector<std::string>& paths)
{
  std::vector<ProgramStream> files;
  for (const auto& path : paths) {
    std::error_code ignored; // what cannot be asked cannot be opened either
    auto in = std::make_unique<std::ifstream>(path, std::ios::binary);
    if (!*in || std::filesystem::is_directory(path, ignored))
      throw DataError(path + ": cannot be read");
    files.push_back({std::filesystem::path(path).filename().string(), std::move(in)});
  }
  return files;
}

ProgramForm formOf(const ProgramStream& file, ProgramForm otherwise)
{
  std::string head(4096, ' ');
  file.text->read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.text->gcount()));
  file.text->clear();
  file.text->seekg(0);
  const ProgramForm form = formOf(head);
  // Plain words may be Grbl's or Siemens' as well.
  const bool plain =
      otherwise == ProgramForm::Grbl || otherwise == ProgramForm::Siemens;
  return form == ProgramForm::Rs274 && plain ? otherwise : form;
}

Program
readPrograms(std::vector<ProgramStream> files, const Criteria& criteria, int mounted)
{
  GCodeReader reader;
  reader.setForm(criteria.form);
  reader.setMountedTool(mounted);
  reader.setChordError(criteria.arc_error);
  Program all;
  for (std::size_t i = 0; i < files.size(); ++i) {
    auto& file = files[i];
    const WorkStep step(
        {double(i) / double(files.size()), double(i + 1) / double(files.size())});
    try {
      Program program = reader.read(*file.text);
      if (files.size() == 1)
        all = std::move(program);
      else
        all.append(std::move(program), file.name);
    }
    catch (const DataError& e) {
      throw DataError(withPlace(file.name, e.what()));
    }
  }
  return all;
}

ProgramTime timeOf(const Program& program, const Criteria& criteria)
{
  ProgramTimeOptions options;
  if (criteria.form == ProgramForm::Grbl)
    options.corners = CornerMode::Machine;
  return programTime(program, criteria.machine, options);
}

Judgement judge(std::vector<ProgramStream> files, const Criteria& criteria, int mounted)
{
  Judgement judgement;
  {
    const WorkStep step({0.0, kReadShare});
    judgement.program = readPrograms(std::move(files), criteria, mounted);
  }
  const WorkStep step({kReadShare, 1.0});
  judgement.verification = criteria.judge(judgement.program);
  judgement.time = timeOf(judgement.program, criteria);
  return judgement;
}

std::vector<std::string> findingLines(const Verification& verification,
                                      const Program& program)
{
  std::vector<std::string> lines;
  for (const auto& f : verification.findings) {
    std::string line = f.severity == Severity::Error ? "error " : "warning ";
    line += f.code + ": " + f.text;
    std::string place = whereOf(f, program);
    if (hasPlace(f))
      place += (place.empty() ? "" : ", ") +
               print("X%.3f Y%.3f Z%.3f", f.place.x(), f.place.y(), f.place.z());
    lines.push_back(place.empty() ? line : line + " (" + place + ")");
  }
  return lines;
}

std::string summaryOf(const Judgement& judgement, const Criteria& criteria)
{
  const Verification& v = judgement.verification;
  std::string text = print("%-24s %4s %11s %9s %8s %8s\n",
                           "section",
                           "tool",
                           "feed mm",
                           "cut cm3",
                           "axial",
                           "min");
  for (std::size_t i = 0; i < v.sections.size(); ++i) {
    const SectionFigures& s = v.sections[i];
    const bool timed = i < judgement.time.sections.size();
    text += print("%-24s %4d %11.0f %9.2f %8.2f %8.1f\n",
                  s.name.empty() ? print("line %zu", s.line).c_str() : s.name.c_str(),
                  s.tool,
                  s.feed_length,
                  s.volume / 1000,
                  s.axial_depth,
                  timed ? judgement.time.sections[i].total() / 60 : 0.0);
  }
  text += print("gouge      %.4f mm at most", v.gouge);
  if (criteria.model)
    text += print(" of the points without noise, %.4f mm as scanned", v.raw_gouge);
  text += print("; %.4f mm would pass\n", criteria.gougeLimit());
  text += print("left over  p50 %.4f p90 %.4f p99 %.4f max %.3f mm more than a perfect "
                "pass of the last tool leaves; %.1f %% of the points were never cut\n",
                v.residual.p50,
                v.residual.p90,
                v.residual.p99,
                v.residual.max,
                100 * v.untouchedShare());
  text += print("rapids     %zu in stock\n", v.rapids_in_stock);
  text += "time       " + hoursAndMinutes(judgement.time.total.total() / 60) + "\n";
  for (const auto& line : findingLines(v, judgement.program))
    text += line + "\n";
  return text + (v.good() ? "passed\n" : "refused\n");
}

FindingPicture::FindingPicture(const std::string& title,
                               const Judgement& judgement,
                               const Criteria& criteria)
    : part_(criteria.part->toCloud())
{
  const Verification& v = judgement.verification;
  scene_.title = title;
  scene_.part = &part_;
  scene_.milled = &v.milled;
  scene_.stock = criteria.stock;
  scene_.tools = criteria.tools;
  for (const auto& f : v.findings) {
    FindingMark mark;
    mark.code = f.code;
    mark.text = f.text;
    mark.note = noteOf(f);
    mark.warning = f.severity == Severity::Warning;
    mark.where = whereOf(f, judgement.program);
    mark.tool = f.tool;
    mark.worst = f.worst;
    if (hasPlace(f))
      mark.place = f.place;
    const auto& moves = judgement.program.moves;
    const auto first = std::lower_bound(
        moves.begin(), moves.end(), f.line, [](const ProgramMove& m, std::size_t line) {
          return m.line < line;
        });
    for (auto m = first; f.line > 0 && m != moves.end() && m->line == f.line; ++m) {
      if (mark.move.empty())
        mark.move.push_back(m->from);
      mark.move.push_back(m->to);
    }
    scene_.findings.push_back(std::move(mark));
  }
}

void writeFindings(const std::string& path,
                   const std::string& title,
                   const Judgement& judgement,
                   const Criteria& criteria)
{
  writeFindings(path, FindingPicture(title, judgement, criteria).scene());
}

} // namespace pointmill
