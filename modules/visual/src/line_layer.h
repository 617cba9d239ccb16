// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "frame.h"

namespace pointmill::visual {

/// @brief Lines over a frame: hidden by its surfaces and by nearer lines.
class LineLayer {
public:
  /// @param bias how far a line may lie behind a surface and still be seen [mm]
  LineLayer(const Frame& frame, float bias);

  /// @brief Draws from a to b (see Camera::project) in style @p style (1 ..), with
  /// brightness @p tone in 0 .. 1, @p width px of the frame wide.
  void line(const Eigen::Vector3f& a,
            const Eigen::Vector3f& b,
            std::uint8_t style,
            float tone,
            int width);
  /// @brief The same dashed; the dashes of moves over one another coincide.
  void dashed(
      Eigen::Vector3f a, Eigen::Vector3f b, std::uint8_t style, int width, float dash);

  struct Style {
    Rgb colour;
    float alpha = 1.f;
    bool lit = false; ///< takes on the shading of the surface it lies on
  };
  /// @brief Draws the lines over the frame's colours; `styles[0]` is style 1 and
  /// @p lighting what lit lines take their brightness from.
  void copyTo(Raster& raster,
              const Raster& lighting,
              const std::vector<Style>& styles) const;
  /// @brief Forgets all lines.
  void clear();
  /// @brief Share of the pixels that a style takes where it is found at all, 0 .. 1.
  float coverage(std::uint8_t style) const;

private:
  void dot(int x, int y, float d, std::uint8_t style, float tone);

  const Frame& frame_;
  float bias_;
  std::vector<float> depth_;
  std::vector<std::uint8_t> style_; // 0: no line
  std::vector<std::uint8_t> tone_;
};

} // namespace pointmill::visual
