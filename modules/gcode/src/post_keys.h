// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/parameters.h>
#include <pointmill/gcode/post.h>

#include <functional>
#include <string>

namespace pointmill::gcode {

/// @brief A post's numbers: visit(key, member, unit, range).
template <typename P, typename V>
void visitNumbers(P& p, V&& visit)
{
  visit("decimals_mm", p.decimals_mm, "", Range{3, 6});
  visit("decimals_inch", p.decimals_inch, "", Range{4, 6});
  visit("feed_decimals", p.feed_decimals, "", Range{0, 3});
  visit("inch_feed_factor", p.inch_feed_factor, "", Range{0.1, 100});
  visit("comment_width", p.comment_width, "", Range{20, 255});
  visit("line_limit", p.line_limit, "", Range{40, 500});
  visit("number_start", p.number_start, "", Range{0, 1e6});
  visit("number_step", p.number_step, "", Range{1, 1000});
  visit("number_max", p.number_max, "", Range{99, 1e7});
  visit("largest_sweep", p.largest_sweep, "deg", Range{1, 180});
}

/// @brief A post's templates: visit(key, member, places), the places being those
/// besides {program} {number} {unit} {control}, which may stand everywhere.
template <typename P, typename V>
void visitTemplates(P& p, V&& visit)
{
  const char* const tool = "tool tool_text rpm";
  visit("start", p.start, "");
  visit("stock", p.stock, "xmin ymin zmin xmax ymax zmax");
  visit("setup", p.setup, "");
  visit("exact_path", p.exact_path, "");
  visit("blend", p.blend, "tolerance");
  visit("tool_change", p.tool_change, tool);
  visit("tool_pause", p.tool_pause, tool);
  visit("spindle", p.spindle, tool);
  visit("coolant_on", p.coolant_on, "");
  visit("coolant_off", p.coolant_off, "");
  visit("approach", p.approach, "tool x y z");
  visit("dwell", p.dwell, "seconds");
  visit("stop", p.stop, "");
  visit("retract_machine", p.retract_machine, "");
  visit("retract_home", p.retract_home, "");
  visit("end", p.end, "");
}

/// @brief All that describes a post: visit(key, member).
template <typename P, typename V>
void visitKeys(P& p, V&& visit)
{
  visit("name", p.name);
  visit("control", p.control);
  visit("extension", p.extension);
  visit("form", p.form);
  visit("plus_sign", p.plus_sign);
  visit("decimal_point", p.decimal_point);
  visit("leading_zero", p.leading_zero);
  visit("comment_open", p.comment_open);
  visit("comment_close", p.comment_close);
  visit("comment_characters", p.comment_characters);
  visit("upper_case", p.upper_case);
  visit("numbers", p.numbers);
  visit("rapid", p.rapid);
  visit("feed", p.feed);
  visit("arc_cw", p.arc_cw);
  visit("arc_ccw", p.arc_ccw);
  visit("arc_planes", p.arc_planes);
  visit("helix_planes", p.helix_planes);
  visit("absolute_pole", p.absolute_pole);
  visit("tools", p.tools);
  visit("retract", p.retract);
  visit("unit_mm", p.unit_mm);
  visit("unit_inch", p.unit_inch);
  visitNumbers(p, [&visit](const char* key, auto& member, const char*, Range) {
    visit(key, member);
  });
  visitTemplates(
      p, [&visit](const char* key, auto& lines, const char*) { visit(key, lines); });
}

/// @brief Is told of a key and what is wrong with it.
using RefuseKey = std::function<void(const std::string& key, const std::string& why)>;

/// @brief Calls @p refuse, which must throw, for the first key of @p post that is
/// wrong.
void checkPost(const Post& post, const RefuseKey& refuse);

} // namespace pointmill::gcode
