// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/rough/level_roughing.h>

namespace pointmill {

/// @brief On every level only along the part's walls, as near as the allowance lets the
/// tool: takes the skin that a larger tool left on steep walls down in steps, so that
/// no finishing pass meets it as high as the wall. Each wall is climb milled.
class WaterlineRoughing : public LevelRoughing {
public:
  WaterlineRoughing() : LevelRoughing("WaterlineRoughing") {}

  /// @brief The stock with nominal heights, which tells skins to a cell of its own;
  /// without it setStock()'s upper bound does, and all walls look as if they had one.
  void setNominalStock(std::shared_ptr<const StockField> stock)
  {
    nominal_ = std::move(stock);
  }
  /// @brief Skins that the tool would take less of than this are left [mm].
  void setMinSkin(double skin) { min_skin_ = skin; }
  double getMinSkin() const { return min_skin_; }

  template <typename V>
  void parameters(V&& v)
  {
    LevelRoughing::parameters(v);
    v("min_skin", min_skin_, "mm", Range{0, 20}, "thinner skins are left");
  }

protected:
  void checkParameters() const override;
  std::vector<LevelPath> clearLevel(const Level& level, Report& figures) const override;
  /// @brief Nothing: what is not at a wall is not this strategy's work.
  std::vector<LevelPath> clearRest(const Level& level,
                                   Material& material) const override;

private:
  std::shared_ptr<const StockField> nominal_;
  double min_skin_ = 0.0;
};

} // namespace pointmill
