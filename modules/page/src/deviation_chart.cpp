// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "svg.h"

#include <pointmill/page/deviation_chart.h>
#include <pointmill/visual/deviation_picture.h>
#include <pointmill/visual/palette.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pointmill {
namespace {

using svg::line;
using svg::print;
using svg::text;

constexpr int kBins = 64; ///< even: none lies to both sides of zero
constexpr double kLeft = 76, kTop = 28, kWide = 640, kHigh = 210;
constexpr double kLeast = 0.01; ///< per cent, at the bottom

} // namespace

DeviationShares::DeviationShares(const pcl::PointCloud<pcl::PointXYZI>& deviation,
                                 double tolerance)
    : points(deviation.size())
{
  for (const auto& p : deviation) {
    if (std::isnan(p.intensity))
      continue;
    ++cut;
    ++(p.intensity < -tolerance ? below : p.intensity > tolerance ? over : within);
  }
}

Html deviationChart(const pcl::PointCloud<pcl::PointXYZI>& deviation, double tolerance)
{
  const double range = deviationRange(deviation, tolerance);
  std::array<std::size_t, kBins> bins{};
  std::size_t all = 0;
  for (const auto& p : deviation)
    if (!std::isnan(p.intensity)) {
      const double share = std::clamp(0.5 + 0.5 * p.intensity / range, 0.0, 1.0);
      ++bins[std::min<std::size_t>(kBins - 1, static_cast<std::size_t>(share * kBins))];
      ++all;
    }
  const auto x = [&](double mm) { return kLeft + kWide * (0.5 + 0.5 * mm / range); };
  const auto y = [&](double percent) {
    return kTop + kHigh * (1 - std::log10(percent / kLeast) / 4);
  };
  std::string drawn;
  for (const double percent : {0.01, 0.1, 1.0, 10.0, 100.0})
    drawn +=
        line("grid", kLeft, y(percent), kLeft + kWide, y(percent)) +
        text(kLeft - 8, y(percent) + 4.5, print("%g %%", percent), "class=\"end\"");
  for (int i = 0; i < kBins; ++i) {
    const auto count = static_cast<double>(bins[static_cast<std::size_t>(i)]);
    const double percent =
        100 * count / static_cast<double>(std::max<std::size_t>(1, all));
    if (count == 0)
      continue;
    const double top = std::min(y(std::max(percent, kLeast)), y(kLeast) - 1.5);
    drawn += print(
        "<rect class=\"bar\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" "
        "height=\"%.1f\" fill=\"%s\"/>\n",
        kLeft + kWide * i / kBins,
        top,
        kWide / kBins,
        y(kLeast) - top,
        deviationColour(range * (2 * (i + 0.5) / kBins - 1), tolerance, range).c_str());
  }
  drawn += line("axis", kLeft, y(kLeast), kLeft + kWide, y(kLeast));
  for (const double side : {-1.0, 1.0})
    drawn +=
        line("limit", x(side * tolerance), kTop - 8, x(side * tolerance), y(kLeast)) +
        text(x(side * tolerance) + side * 5,
             kTop - 9,
             print("%+.3g", side * tolerance),
             side < 0 ? "class=\"end\"" : "");
  for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0})
    drawn +=
        line("axis", x(share * range), y(kLeast), x(share * range), y(kLeast) + 5) +
        text(x(share * range),
             y(kLeast) + 20,
             share == 0 ? "0" : print("%+.3g", share * range),
             "class=\"middle\"");
  drawn += text(kLeft, y(kLeast) + 40, "\u2190 cut too deep") +
           text(kLeft + kWide / 2, y(kLeast) + 40, "mm", "class=\"middle\"") +
           text(kLeft + kWide, y(kLeast) + 40, "material left \u2192", "class=\"end\"");
  return Html::markup(print(
             "<svg class=\"chart\" viewBox=\"0 0 %.0f %.0f\" role=\"img\" "
             "aria-label=\"Share of the points by their deviation in mm, with the "
             "tolerance marked; the numbers are in the table\">\n",
             kLeft + kWide + 30,
             kTop + kHigh + 52)) +
         Html::markup(drawn + "</svg>\n");
}

} // namespace pointmill
