// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/slice/cell_regions.h>

#include <utility>

namespace pointmill {

void takeRegion(const CellGrid& grid,
                std::vector<unsigned char>& mask,
                Connected connected,
                std::vector<std::size_t>& region)
{
  for (const auto at : region)
    mask[at] = 0;
  for (std::size_t k = 0; k < region.size(); ++k)
    forNeighbours(grid,
                  static_cast<int>(region[k] % grid.columns),
                  static_cast<int>(region[k] / grid.columns),
                  [&](int c, int r, bool straight) {
                    const std::size_t at = grid.index(c, r);
                    if (mask[at] && (straight || connected == Connected::Corners)) {
                      mask[at] = 0;
                      region.push_back(at);
                    }
                  });
}

std::vector<std::vector<std::size_t>>
cellRegions(const CellGrid& grid, std::vector<unsigned char> mask, Connected connected)
{
  std::vector<std::vector<std::size_t>> regions;
  for (std::size_t first = 0; first < mask.size(); ++first) {
    if (!mask[first])
      continue;
    std::vector<std::size_t> region{first};
    takeRegion(grid, mask, connected, region);
    regions.push_back(std::move(region));
  }
  return regions;
}

} // namespace pointmill
