// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/parameters.h>
#include <pointmill/gcode/post.h>

#include <functional>
#include <string>

namespace pointmill::gcode {

/// @brief A post's numbers: v(key, member, unit, range).
template <typename P, typename V>
void visitNumbers(P& p, V&& v)
{
  v("decimals_mm", p.decimals_mm, "", Range{3, 6});
  v("decimals_inch", p.decimals_inch, "", Range{4, 6});
  v("feed_decimals", p.feed_decimals, "", Range{0, 3});
  v("inch_feed_factor", p.inch_feed_factor, "", Range{0.1, 100});
  v("comment_width", p.comment_width, "", Range{20, 255});
  v("line_limit", p.line_limit, "", Range{40, 500});
  v("number_start", p.number_start, "", Range{0, 1e6});
  v("number_step", p.number_step, "", Range{1, 1000});
  v("number_max", p.number_max, "", Range{99, 1e7});
  v("largest_sweep", p.largest_sweep, "deg", Range{1, 180});
}

/// @brief A post's templates: v(key, member, places), the places being those besides
/// {program} {number} {unit} {control}, which may stand everywhere.
template <typename P, typename V>
void visitTemplates(P& p, V&& v)
{
  const char* const tool = "tool tool_text rpm";
  v("start", p.start, "");
  v("stock", p.stock, "xmin ymin zmin xmax ymax zmax");
  v("setup", p.setup, "");
  v("exact_path", p.exact_path, "");
  v("blend", p.blend, "tolerance");
  v("tool_change", p.tool_change, tool);
  v("tool_pause", p.tool_pause, tool);
  v("spindle", p.spindle, tool);
  v("coolant_on", p.coolant_on, "");
  v("coolant_off", p.coolant_off, "");
  v("approach", p.approach, "tool x y z");
  v("dwell", p.dwell, "seconds");
  v("stop", p.stop, "");
  v("retract_machine", p.retract_machine, "");
  v("retract_home", p.retract_home, "");
  v("end", p.end, "");
}

/// @brief All that describes a post: v(key, member).
template <typename P, typename V>
void visitKeys(P& p, V&& v)
{
  v("name", p.name);
  v("control", p.control);
  v("extension", p.extension);
  v("form", p.form);
  v("plus_sign", p.plus_sign);
  v("decimal_point", p.decimal_point);
  v("leading_zero", p.leading_zero);
  v("comment_open", p.comment_open);
  v("comment_close", p.comment_close);
  v("comment_characters", p.comment_characters);
  v("upper_case", p.upper_case);
  v("numbers", p.numbers);
  v("rapid", p.rapid);
  v("feed", p.feed);
  v("arc_cw", p.arc_cw);
  v("arc_ccw", p.arc_ccw);
  v("arc_planes", p.arc_planes);
  v("helix_planes", p.helix_planes);
  v("absolute_pole", p.absolute_pole);
  v("tools", p.tools);
  v("retract", p.retract);
  v("unit_mm", p.unit_mm);
  v("unit_inch", p.unit_inch);
  visitNumbers(
      p, [&v](const char* key, auto& member, const char*, Range) { v(key, member); });
  visitTemplates(p, [&v](const char* key, auto& lines, const char*) { v(key, lines); });
}

/// @brief Is told of a key and what is wrong with it.
using RefuseKey = std::function<void(const std::string& key, const std::string& why)>;

/// @brief Calls @p refuse, which must throw, for the first key of @p post that is
/// wrong.
void checkPost(const Post& post, const RefuseKey& refuse);

} // namespace pointmill::gcode
