// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "word_lexer.h"

namespace pointmill::gcode {

namespace {

/// The letters that may begin a word, besides G and M.
const char* lettersOf(ProgramForm form)
{
  switch (form) {
  case ProgramForm::Grbl:
    return "FIJKNPRSTXYZ";
  case ProgramForm::Siemens:
    return "DFIJKNSTXYZ";
  case ProgramForm::HeidenhainIso:
    return "FHIJKNRSTXYZ";
  default:
    return "EFHIJKNOPQRSTXYZ";
  }
}

/// Why a letter is not read.
const char* unsupported(char letter)
{
  switch (letter) {
  case 'A':
  case 'B':
  case 'C':
    return "rotary axis";
  case 'U':
  case 'V':
  case 'W':
    return "second linear axis";
  case 'D':
    return "cutter radius";
  case 'E':
    return "largest rounding";
  case 'H':
    return "tool length";
  case 'L':
    return "repetition";
  case 'O':
    return "subroutine or program number";
  case 'P':
  case 'Q':
  case 'R':
    return "parameter";
  default:
    return "no word of this control";
  }
}

const char* meaning(char c)
{
  if (c == '#')
    return " (parameters)";
  if (c == '[' || c == ']')
    return " (expressions)";
  if (c == '/')
    return " (block delete)";
  return "";
}

} // namespace

WordLexer::WordLexer(ProgramForm form) : form_(form)
{
  for (const char* letter = lettersOf(form); *letter; ++letter)
    letters_ |= 1u << (*letter - 'A');
}

bool WordLexer::isKnown(char letter) const
{
  return letter >= 'A' && letter <= 'Z' && ((letters_ >> (letter - 'A')) & 1u);
}

void WordLexer::fail(const char* at, const std::string& what) const
{
  block_->fail(columnOf(at), what);
}

void WordLexer::read(std::string_view text, std::size_t line, Block& block)
{
  block.clear(line);
  block_ = &block;
  begin_ = p_ = text.data();
  end_ = begin_ + text.size();
  while (p_ != end_) {
    const char c = *p_;
    if (isBlank(c))
      ++p_;
    else if (c == ';') {
      const char* const comment = p_ + 1;
      block.setComment({comment, static_cast<std::size_t>(end_ - comment)});
      return;
    }
    else if (c == '(' && form_ != ProgramForm::Siemens)
      readComment();
    else if (c == '%' || c == '*')
      readEndOfBlock();
    else if (form_ != ProgramForm::Siemens || !readName())
      readWord();
  }
}

void WordLexer::readComment()
{
  const char* const open = p_;
  do
    ++p_;
  while (p_ != end_ && *p_ != ')' && *p_ != '(');
  if (p_ == end_)
    fail(open, "the comment is not closed");
  if (*p_ == '(')
    fail(p_, "a comment inside a comment");
  block_->setComment({open + 1, static_cast<std::size_t>(p_ - open - 1)});
  ++p_;
}

/// `%` about a program, `*` behind a block of Heidenhain's.
void WordLexer::readEndOfBlock()
{
  const char* const at = p_++;
  const bool percent = *at == '%';
  if (form_ != (percent ? ProgramForm::Rs274 : ProgramForm::HeidenhainIso))
    fail(at, shown(*at) + " is not supported");
  if (percent) {
    if (block_->isPercent() || !block_->isEmpty())
      fail(at, "'%' must stand alone");
    block_->setPercent(columnOf(at));
    return;
  }
  while (p_ != end_ && isBlank(*p_))
    ++p_;
  if (p_ != end_ && *p_ != ';')
    fail(p_, shown(*p_) + " behind the end of the block");
}

void WordLexer::readWord()
{
  const char* const word = p_++;
  const char letter = upper(*word);
  const bool code = letter == 'G' || letter == 'M';
  if (!code && !isKnown(letter))
    refuseLetter(word);
  if (letter == 'O')
    checkProgramNumber(word);
  const double value = number(word);
  if (block_->isPercent())
    block_->fail(block_->percentColumn(), "'%' must stand alone");
  if (code)
    block_->addCode(letter, value, columnOf(word));
  else
    block_->addWord(letter, value, columnOf(word));
}

void WordLexer::refuseLetter(const char* word) const
{
  if (!isLetter(*word))
    fail(word, shown(*word) + meaning(*word) + " is not supported");
  const char letter = upper(*word);
  fail(word,
       std::string(1, letter) + " (" + unsupported(letter) + ") is not supported");
}

/// LinuxCNC's subroutines have a name, or a word behind the number.
void WordLexer::checkProgramNumber(const char* word) const
{
  const Number n = scanNumber(p_, end_);
  if (n.state != Number::State::Good || (n.end != end_ && isLetter(*n.end)))
    refuseLetter(word);
}

double WordLexer::number(const char* word)
{
  const Number n = scanNumber(p_, end_);
  p_ = n.end;
  if (n.state != Number::State::Good)
    refuseNumber(word, n);
  return n.value;
}

void WordLexer::refuseNumber(const char* word, const Number& n) const
{
  std::string name;
  for (const char* c = word; c != end_ && (isLetter(*c) || c == word); ++c)
    name += upper(*c);
  if (n.state == Number::State::TooLong)
    fail(word, name + " has more than 17 digits");
  const char* const why = n.end != end_ ? meaning(*n.end) : "";
  if (*why)
    fail(n.end, shown(*n.end) + why + " is not supported");
  fail(word, name + " has no number");
}

} // namespace pointmill::gcode
