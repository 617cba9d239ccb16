// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "operation_comment.h"

#include "number.h"

#include <cstddef>

namespace pointmill::gcode {

namespace {

void skipBlanks(std::string_view& text)
{
  while (!text.empty() && isBlank(text.front()))
    text.remove_prefix(1);
}

} // namespace

std::optional<std::string_view> operationName(std::string_view comment)
{
  constexpr std::string_view word = "OPERATION";
  skipBlanks(comment);
  if (comment.size() <= word.size())
    return std::nullopt;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (upper(comment[i]) != word[i])
      return std::nullopt;
  comment.remove_prefix(word.size());
  if (!isBlank(comment.front()))
    return std::nullopt;
  skipBlanks(comment);
  const std::size_t before = comment.size();
  while (!comment.empty() && isDigit(comment.front()))
    comment.remove_prefix(1);
  if (comment.size() == before)
    return std::nullopt;
  skipBlanks(comment);
  constexpr std::string_view separators = ":-.=,";
  if (comment.empty() || separators.find(comment.front()) == std::string_view::npos)
    return std::nullopt;
  comment.remove_prefix(1);
  skipBlanks(comment);
  while (!comment.empty() && isBlank(comment.back()))
    comment.remove_suffix(1);
  return comment;
}

} // namespace pointmill::gcode
