// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "verify_test.h"

namespace verify_test {

/// A plate of 30 x 20 at -2 in a stock that reaches up to 0.
struct OnAPlate : ::testing::Test {
  const Rectangle area{0, 0, 30, 20};
  const Cloud::Ptr cloud = surface(area, 0.5, [](double, double) { return -2; });
  ProgramVerifier verifier;

  OnAPlate()
  {
    verifier.setPart(indexOf(*cloud));
    verifier.setStock({{0, 0, -3}, {30, 20, 0}});
    verifier.setTools({Tool::flat(1, 6), Tool::ball(2, 4)});
    verifier.setResidualLimit(0.1);
  }
  /// Rows over all of the plate with the tip on z.
  static Text rows(double z, double step = 4, Text text = Text())
  {
    bool back = false;
    text.over(-5, 0);
    text.feed(-5, 0, z);
    for (double y = 0; y <= 20; y += step, back = !back) {
      text.feed(back ? 35 : -5, y, z);
      text.feed(back ? -5 : 35, y, z);
    }
    return text;
  }
};

} // namespace verify_test
