// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// Any program is judged by what an earlier job left in its directory.
#include "mill_test.h"

#include <pointmill/mill/check.h>

#include <algorithm>
#include <charconv>

using namespace mill_test;

namespace {

using Lines = std::vector<std::string>;

Lines linesOf(const std::string& text)
{
  Lines lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

std::string textOf(const Lines& lines)
{
  std::string text;
  for (const auto& line : lines)
    text += line + "\n";
  return text;
}

/// All numbers after `letter` in blocks that move in the part frame, `by` greater.
std::string shifted(const std::string& program, char letter, double by)
{
  Lines lines = linesOf(program);
  for (auto& line : lines) {
    const auto at = line.find(letter);
    if (at == std::string::npos || line[0] == '(' || line.rfind("G53", 0) == 0)
      continue;
    double value = 0;
    const char* const begin = line.data() + at + 1;
    const auto read = std::from_chars(begin, line.data() + line.size(), value);
    char number[32];
    std::snprintf(number, sizeof number, "%.4f", value + by);
    line.replace(at + 1, static_cast<std::size_t>(read.ptr - begin), number);
  }
  return textOf(lines);
}

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  std::size_t at = 0, count = 0;
  while ((at = text.find(what, at)) != std::string::npos) {
    text.replace(at, what.size(), by);
    at += by.size();
    ++count;
  }
  EXPECT_GT(count, 0u) << what;
  return text;
}

/// A part that was milled, once for all tests.
class Check : public testing::Test {
protected:
  static void SetUpTestSuite()
  {
    folder_ = new TempDir;
    MillOptions options;
    options.stock_margin = 2;
    options.rest = options.rough;
    options.rest->tool = Tool::flat(4, 6.0);
    options.keep_out = KeepOut({KeepOutZone::cylinder(-30, -30, 5, 10),
                                KeepOutZone::box(200, 200, 220, 230, 5)});
    job_ = new MillJob(options);
    job_->plan(data("dome.pcd"));
    job_->write((*folder_ / "nc").string());
    program_ = job_->programs().front().text;
  }
  static void TearDownTestSuite()
  {
    delete job_;
    delete folder_;
  }

  static Judgement judged(const std::string& text)
  {
    std::vector<ProgramStream> files;
    files.push_back({"program.ngc", std::make_unique<std::istringstream>(text)});
    return judge(std::move(files), Criteria::read((*folder_ / "nc").string()));
  }

  /// Whether an error of that code is found.
  static testing::AssertionResult refuses(const std::string& text,
                                          const std::string& code)
  {
    const Judgement j = judged(text);
    std::string all;
    for (const auto& f : j.verification.findings) {
      if (f.code == code && f.severity == Severity::Error)
        return testing::AssertionSuccess();
      all += f.code + " ";
    }
    return testing::AssertionFailure() << "found only: " << all;
  }

  static TempDir* folder_;
  static MillJob* job_;
  static std::string program_;
};

TempDir* Check::folder_ = nullptr;
MillJob* Check::job_ = nullptr;
std::string Check::program_;

} // namespace

TEST_F(Check, TheJobsOwnProgramIsJudgedAsTheJobDid)
{
  const Judgement again = judged(program_);
  const Verification &a = job_->verification(), &b = again.verification;
  EXPECT_TRUE(b.good());
  EXPECT_EQ(a.gouge, b.gouge);
  EXPECT_EQ(a.gouge_line, b.gouge_line);
  EXPECT_EQ(a.residual.p50, b.residual.p50);
  EXPECT_EQ(a.residual.p99, b.residual.p99);
  EXPECT_EQ(a.deviation.max, b.deviation.max);
  EXPECT_EQ(a.findings.size(), b.findings.size());
  EXPECT_EQ(a.axial_depth, b.axial_depth);
  // And its summary tells the same depths.
  ASSERT_EQ(job_->operations().size(), b.sections.size());
  for (std::size_t i = 0; i < b.sections.size(); ++i)
    EXPECT_EQ(job_->operations()[i].axial_depth, b.sections[i].axial_depth)
        << b.sections[i].name;
  EXPECT_EQ(job_->judgement().time.total.total(), again.time.total.total());
}

TEST_F(Check, TheCriteriaComeBackAsTheyWere)
{
  const Criteria& a = job_->criteria();
  const Criteria b = Criteria::read((*folder_ / "nc").string());
  EXPECT_EQ(a.part->size(), b.part->size());
  EXPECT_EQ(a.model == nullptr, b.model == nullptr);
  EXPECT_EQ(a.bridges == nullptr, b.bridges == nullptr);
  EXPECT_EQ(a.stock.min, b.stock.min);
  EXPECT_EQ(a.stock.max, b.stock.max);
  EXPECT_EQ(a.gougeLimit(), b.gougeLimit());
  EXPECT_EQ(a.noise_allowance, b.noise_allowance);
  EXPECT_EQ(a.residual_limit, b.residual_limit);
  EXPECT_EQ(a.floor, b.floor);
  EXPECT_EQ(a.cell, b.cell);
  EXPECT_EQ(a.form, b.form);
  ASSERT_EQ(a.tools.size(), b.tools.size());
  for (std::size_t i = 0; i < a.tools.size(); ++i)
    EXPECT_EQ(a.tools[i].describe(), b.tools[i].describe());
  ASSERT_EQ(a.keep_out.zones().size(), b.keep_out.zones().size());
  EXPECT_EQ(a.keep_out.margin(), b.keep_out.margin());
  for (std::size_t i = 0; i < a.keep_out.zones().size(); ++i)
    EXPECT_EQ(a.keep_out.zones()[i].describe(), b.keep_out.zones()[i].describe());
}

TEST_F(Check, AProgramThatIsLowerByTwoTenthsIsRefused)
{
  EXPECT_TRUE(refuses(shifted(program_, 'Z', -0.2), "gouge"));
}

TEST_F(Check, AShiftedOriginIsRefused)
{
  EXPECT_TRUE(refuses(shifted(program_, 'X', 2.0), "gouge"));
}

TEST_F(Check, ARapidThroughThePartIsRefused)
{
  // Down into the dome's middle after the first tool change, and out again.
  const auto change = program_.find("T1 M6");
  const auto line = program_.find("\nG0 Z", change); // the approach's first block
  const auto next = program_.find('\n', program_.find('\n', line + 1) + 1);
  const auto place = program_.find('\n', line + 1) + 1; // the second one
  const std::string back = program_.substr(place, next + 1 - place);
  std::string bad = program_;
  bad.insert(next + 1, "G0 X30. Y30.\nZ-12.\nZ5.\n" + back);
  EXPECT_TRUE(refuses(bad, "rapid_in_stock"));
  EXPECT_TRUE(refuses(bad, "gouge"));
}

TEST_F(Check, AWrongToolIsRefused)
{
  const std::string swapped =
      replaced(replaced(program_, "T3 M6", "T1 M6"), "G43 H3", "G43 H1");
  EXPECT_TRUE(refuses(swapped, "gouge"));
  const std::string unknown =
      replaced(replaced(program_, "T3 M6", "T7 M6"), "G43 H3", "G43 H7");
  EXPECT_TRUE(refuses(unknown, "unknown_tool"));
}

TEST_F(Check, ADroppedRetractIsRefused)
{
  // The last lift of the roughing that a rapid to another place follows.
  const auto& moves = job_->judgement().program.moves;
  std::size_t line = 0;
  for (std::size_t i = 1; i + 1 < moves.size(); ++i) {
    const auto &up = moves[i], &next = moves[i + 1];
    if (up.tool == 1 && up.rapid && next.rapid && !moves[i - 1].rapid &&
        up.to.z() - up.from.z() > 3 && std::isfinite(up.to.z()) &&
        (next.to - next.from).head<2>().norm() > 5)
      line = up.line;
  }
  ASSERT_GT(line, 0u);
  Lines lines = linesOf(program_);
  std::string& block = lines[line - 1];
  const auto z = block.find('Z');
  ASSERT_NE(z, std::string::npos) << block;
  block.erase(z); // its G0 stays in force
  EXPECT_TRUE(refuses(textOf(lines), "rapid_in_stock"));
}

TEST_F(Check, AProgramThatIsCutShortIsRefused)
{
  EXPECT_TRUE(refuses(program_.substr(0, program_.rfind("M30")), "not_ended"));
}

TEST_F(Check, WhatCannotBeReadIsAnErrorWithFileAndPlace)
{
  try {
    judged("G21\nG81 X1 Y1 Z-3 R1 F100\n");
    FAIL();
  }
  catch (const DataError& e) {
    EXPECT_EQ(std::string(e.what()).find("program.ngc: line 2, column 1: G81"), 0u)
        << e.what();
  }
}

TEST_F(Check, ADirectoryWithoutAJobIsNamed)
{
  try {
    Criteria::read((*folder_ / "nowhere").string());
    FAIL();
  }
  catch (const DataError& e) {
    EXPECT_NE(std::string(e.what()).find("nowhere"), std::string::npos) << e.what();
  }
  fs::create_directory(*folder_ / "old");
  std::ofstream(*folder_ / "old/report.json") << "{\"pointmill\": \"0.0.1\"}";
  EXPECT_THROW(Criteria::read((*folder_ / "old").string()), DataError);
  fs::copy_file(*folder_ / "nc/report.json",
                *folder_ / "old/report.json",
                fs::copy_options::overwrite_existing);
  EXPECT_THROW(Criteria::read((*folder_ / "old").string()), DataError);
}
