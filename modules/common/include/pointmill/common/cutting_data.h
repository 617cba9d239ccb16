// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/machine.h>
#include <pointmill/common/material.h>
#include <pointmill/common/operation.h>
#include <pointmill/common/tool.h>

#include <optional>
#include <vector>

namespace pointmill {

enum class CutKind { Roughing, Finishing };
enum class ToolMaterial { Carbide, Hss };

/// @brief A cut to find the feeds and speeds of. What is not given follows from
/// material, tool and kind of cut: roughing takes the lower end of the material's
/// surface speeds, its depth and 0.4 of the width that the tool cuts at that depth;
/// finishing the upper end, and 0.05 of the diameter of the tool's end for the width
/// and, of a rounded end, for the depth, 0.5 of it for that of a sharp one.
struct CutSetting {
  WorkMaterial material;
  Tool tool;
  CutKind kind = CutKind::Roughing;
  ToolMaterial tool_material = ToolMaterial::Carbide;
  std::optional<double> surface_speed; ///< vc [m/min]
  std::optional<double> chip_load;     ///< thickest chip that is wanted [mm]
  std::optional<double> depth;         ///< ap [mm]
  std::optional<double> width;         ///< ae [mm]
  /// The most that the feed per tooth may be above the chip load where chips are thin.
  double max_thinning = 3.0;
  double plunge_ratio = 0.3; ///< feed downwards by the feed along the path
};

/// @brief What held a cut back from what its material and tool would bear.
enum class CutLimit { MinSpindle, MaxSpindle, Thinning, StepOver, MaxFeed, Power };

/// @brief For people, as "max spindle".
const char* nameOf(CutLimit limit);

/// @brief Feeds and speeds of a cut, and what they ask of the machine.
struct CuttingData {
  double depth = 0.0;              ///< ap [mm]
  double width = 0.0;              ///< ae [mm]
  double effective_diameter = 0.0; ///< that cuts at this depth [mm]
  double surface_speed = 0.0;      ///< there [m/min]
  double spindle = 0.0;            ///< n [rev/min]
  double chip_load = 0.0;          ///< the thickest chip that was wanted [mm]
  double feed_per_tooth = 0.0;     ///< fz [mm]
  double max_chip = 0.0;           ///< thickest chip that comes of it [mm]
  double mean_chip = 0.0;          ///< hm, mean along the arc of engagement [mm]
  double feed = 0.0;               ///< vf [mm/min]
  double plunge_feed = 0.0;        ///< mm/min
  double removal_rate = 0.0;       ///< Q [cm3/min]
  double cutting_force = 0.0;      ///< kc, specific, at the mean chip [N/mm2]
  double power = 0.0;              ///< Pc, at the cutter [W]
  double torque = 0.0;             ///< Mc, at the spindle [N m]
  bool coolant = true;
  std::vector<CutLimit> limits; ///< in the order they were met; empty: none

  /// @brief Whether limits made the chips thinner than a quarter of what is wanted: by
  /// rule of thumb the edge then rubs, and less depth or width or a slower spindle is
  /// better than so low a feed.
  bool rubs() const { return max_chip < chip_load / 4; }
  /// @brief Time to mill @p length mm of path at the feed [s].
  double secondsForLength(double length) const { return 60.0 * length / feed; }
  /// @brief Time to remove @p volume mm3 [s].
  double secondsForVolume(double volume) const { return 0.06 * volume / removal_rate; }
  /// @brief What an operation takes of it: spindle and feeds in whole units, rounded
  /// down.
  Cutting cutting() const;
};

/// @brief Works out feeds and speeds.
///
/// With the diameter De that cuts at the depth ap (of a ball `2 sqrt(ap (D - ap))`),
/// its entering angle k there (`sin k = De / D` of a ball) and z flutes
///
///     n  = 1000 vc / (pi De)                        spindle speed
///     fz = hex / (sin k 2 sqrt(w (1 - w)))          w = min(ae / De, 1/2)
///     vf = n z fz                                   feed
///     hm = fz sin km 2 (ae / De) / acos(1 - 2 ae / De)
///     kc = kc1.1 hm^-mc                             Kienzle
///     Q  = ap ae vf / 1000,  Pc = Q kc / 60,  Mc = 60 Pc / (2 pi n)
///
/// where hex is the chip load, the thickest chip that is wanted, and `sin km` is the
/// depth by the length of the engaged edge. fz is at most CutSetting::max_thinning
/// times the chip load, and in finishing with a rounded end no more than the step-over
/// ae, so that its marks along the feed are no higher than those across. Spindle speed,
/// feed and power are kept within what the machine is known to do, the latter two by a
/// lower feed.
///
/// Sources: Sandvik Coromant, Milling formulas and definitions (vc, fz, hex, hm, kc,
/// Pc, Mc, De of round tools); O. Kienzle, Die Bestimmung von Kraeften und Leistungen
/// an spanenden Werkzeugen und Werkzeugmaschinen, VDI-Z 94 (1952); Machinery's
/// Handbook, Estimating speeds and machining power. The power is that at the cutter
/// with neither rake nor wear taken into account.
/// @throws ParameterError naming field, value, unit and range where the tool, the
/// material or the machine is refused, the chip load is above a tenth of the tool's
/// end, the depth above the flute length (not given: five diameters), or the width
/// above what the tool cuts at that depth
CuttingData cuttingData(const CutSetting& cut, const Machine& machine = {});

/// @brief The same as an Operation takes it.
inline Cutting cuttingFor(const CutSetting& cut, const Machine& machine = {})
{
  return cuttingData(cut, machine).cutting();
}

} // namespace pointmill
