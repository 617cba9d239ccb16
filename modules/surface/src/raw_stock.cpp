// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/parameters.h>
#include <pointmill/surface/raw_stock.h>

#include <cmath>

namespace pointmill {

StockField stockOf(const Stock& box,
                   double cell,
                   StockField::Bound bound,
                   const PointIndex& raw,
                   double reach)
{
  checkRange("stockOf", "reach", reach, "mm", {1e-3, 1000});
  StockField field(box, cell, bound);
  // A bound holds for all of its cell: the highest point that counts for any place of
  // it, and none is known where one place of it may have none.
  const double more = bound == StockField::Bound::Upper ? cell * std::sqrt(0.5) : 0.0;
  if (reach <= more)
    return field;
  // Discs rest on the highest point under them.
  const Tool near = Tool::flat(1, 2 * (reach - more)),
             all = Tool::flat(1, 2 * (reach + more));
  field.lowerTo([&](double x, double y) {
    return raw.drop(near, x, y).touches() ? raw.drop(all, x, y).tip : box.top();
  });
  return field;
}

} // namespace pointmill
