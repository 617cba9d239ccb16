// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/parameters.h>

#include <string>
#include <vector>

namespace pointmill {

/// @brief What a workpiece is made of, as far as milling feels it: a value, every field
/// of which may be set otherwise.
///
/// The specific cutting force follows Kienzle, `kc = kc11 h^-mc` with the chip
/// thickness h in mm: `kc11` is the force [N/mm2] on a chip of 1 mm by 1 mm.
struct WorkMaterial {
  std::string name;         ///< as "stainless-steel"
  std::string also;         ///< other names, between blanks
  std::string description;  ///< typical grades and hardness
  Range carbide_speed{};    ///< surface speed of solid carbide, rough .. finish [m/min]
  Range hss_speed{};        ///< of high-speed steel; 0 .. 0: not to be milled with it
  double chip_ratio = 0.0;  ///< chip load by the diameter of the tool's end
  double chip_limit = 0.0;  ///< of the chip load, however large the tool [mm]
  double rough_depth = 0.0; ///< of a roughing cut, by the diameter of the tool's end
  double kc11 = 0.0;        ///< N/mm2
  double mc = 0.0;
  bool coolant = true; ///< flood coolant; otherwise dry, or air

  /// @brief Throws ParameterError, naming the material and the field.
  void validate() const;
};

/// @brief The materials that are known by name. doc/cutting.md says where the numbers
/// are from.
const std::vector<WorkMaterial>& workMaterials();

/// @brief The material called @p name, or one of its other names; capitals, blanks and
/// underscores do not matter.
/// @throws ParameterError with the nearest name where there is none
const WorkMaterial& workMaterial(const std::string& name);

} // namespace pointmill
