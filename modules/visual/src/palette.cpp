// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/visual/colour.h>
#include <pointmill/visual/deviation_scale.h>
#include <pointmill/visual/palette.h>

#include <cstdio>

namespace pointmill {
namespace {

using namespace visual;

std::string textOf(const Rgb& colour)
{
  char text[8];
  std::snprintf(text,
                sizeof text,
                "#%02x%02x%02x",
                toByte(colour.r),
                toByte(colour.g),
                toByte(colour.b));
  return text;
}

} // namespace

std::string operationColour(int number)
{
  return textOf(kOperations[number % kOperationCount]);
}

std::string heightColour(double share)
{
  return textOf(visual::heightColour(static_cast<float>(share)));
}

std::string deviationColour(double deviation, double tolerance, double range)
{
  return textOf(DeviationScale{tolerance, range}.at(deviation));
}

std::string neverCutColour()
{
  return textOf(kNeverCut);
}

} // namespace pointmill
