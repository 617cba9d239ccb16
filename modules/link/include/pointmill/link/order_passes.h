// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/stage.h>

namespace pointmill {

/// @brief Puts passes (`label`) that may be cut in any order and direction, as those of
/// a zig-zag raster, into an order with little air between them, see shortTour().
/// Passes are renumbered; the first one stays first.
///
/// Report: "air_before_mm" and "air_after_mm", the XY distances between consecutive
/// passes.
class OrderPasses : public Filter<PointCL> {
public:
  OrderPasses() : Filter<PointCL>("OrderPasses") {}

protected:
  void checkParameters() const override {}
  void apply(CLCloud& output) override;
};

} // namespace pointmill
