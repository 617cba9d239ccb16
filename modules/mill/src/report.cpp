// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "report.h"

#include "criteria_json.h"

#include <pointmill/mill/summary.h>
#include <pointmill/slice/sink.h>

#include <pointmill/common/version.h>

#include <cmath>

namespace pointmill {
namespace {

using json::Json;
using json::number;
using json::vector;

Json quantiles(const Quantiles& q)
{
  return {{"p50", number(q.p50)},
          {"p90", number(q.p90)},
          {"p95", number(q.p95)},
          {"p99", number(q.p99)},
          {"max", number(q.max)}};
}

Json deviation(const Quantiles& q)
{
  Json json = quantiles(q);
  json["p1"] = number(q.p1);
  json["p5"] = number(q.p5);
  return json;
}

Json scanJson(const MillJob& job, const std::string& name)
{
  const ScanFigures& scan = job.scanFigures();
  return {{"file", name},
          {"format", scan.format},
          {"vertices", scan.vertices},
          {"faces", scan.faces},
          {"sampled_points", scan.sampled},
          {"nan_points", scan.nan_points},
          {"stray_points_removed", scan.strays},
          {"points", job.part().size()},
          {"mm_per_unit", scan.scale},
          {"spacing_mm",
           {{"median", scan.spacing.median},
            {"p99", scan.spacing.p99},
            {"worst", scan.spacing.worst},
            {"worst_at", {scan.spacing.worst_at.x(), scan.spacing.worst_at.y()}}}},
          {"noise_mm", number(job.surfaceFigures().noise)}};
}

Json surfaceJson(const MillJob& job)
{
  const SurfaceFigures& surface = job.surfaceFigures();
  const double spacing = job.scanFigures().spacing.p99;
  Json json = {{"model", surface.smooth ? "smooth" : "points"},
               {"noise_kept", surface.noise_kept},
               {"noise_left_mm", surface.noise_left},
               {"points_moved_at_most_mm", surface.farthest}};
  for (const auto& [name, value] : surface.smoothing.figures())
    json["smoothing"][name] = number(value);
  for (const Tool& t : job.tools())
    json["sink_between_bare_points_mm"].push_back(
        {{"tool", t.number},
         {"level", number(sinkBetweenPoints(t, spacing))},
         {"at_45_deg", number(sinkBetweenPoints(t, spacing, 45))}});
  return json;
}

const char* nameOf(GapPolicy policy)
{
  return policy == GapPolicy::Bridge ? "bridge"
         : policy == GapPolicy::Keep ? "keep"
                                     : "mill";
}

Json gapsJson(const MillJob& job)
{
  Json list = Json::array();
  for (const auto& gap : job.gaps()) {
    if (list.size() < 100) // the largest come first
      list.push_back(
          {{"kind", gap.kind == GapKind::ThroughHole ? "through_hole" : "not_scanned"},
           {"treatment", nameOf(gap.treatment)},
           {"open", gap.open},
           {"rim_z", {number(gap.rim_low), number(gap.rim_high)}},
           {"area_mm2", gap.area},
           {"centre", {gap.centre.x(), gap.centre.y()}},
           {"min", {gap.min.x(), gap.min.y()}},
           {"max", {gap.max.x(), gap.max.y()}}});
  }
  return {{"policy", nameOf(job.options().gaps)},
          {"count", job.gaps().size()},
          {"area_mm2", job.gapArea()},
          {"bridged_between_points_mm2", job.bridgedArea()},
          {"largest", list}};
}

Json operationJson(const PlannedOperation& planned, const Verification& verification)
{
  const Operation& o = planned.operation;
  Json parameters = {{"tool", o.tool.number},
                     {"allowance_mm", planned.allowance},
                     {"spindle_rpm", o.cutting.spindle},
                     {"feed_mm_min", o.cutting.feed},
                     {"plunge_feed_mm_min", o.cutting.plunge_feed},
                     {"coolant", o.cutting.coolant}};
  for (const auto& p : planned.parameters)
    if (p.name != "allowance") {
      std::string unit = p.unit;
      for (auto& c : unit)
        c = c == '/' ? '_' : c;
      parameters[unit.empty() ? p.name : p.name + "_" + unit] = number(p.value);
    }
  Json stages = Json::object();
  for (const auto& [name, value] : planned.report.figures())
    stages[name] = number(value);
  const PathFigures& f = planned.figures;
  Json json = {{"name", o.name},
               {"colour", planned.colour},
               {"parameters", parameters},
               {"cl_points", f.cl_points},
               {"passes", f.passes},
               {"retracts", f.retracts},
               {"cutting_mm", f.cutting_length},
               {"air_share", f.cut.airShare()},
               {"rapid_mm", f.rapid_length},
               {"radial_engagement_mm",
                {{"mean", f.cut.mean_radial}, {"max", f.cut.max_radial}}},
               {"axial_engagement_mm", f.cut.max_axial},
               {"axial_depth_mm", planned.axial_depth},
               {"volume_removed_mm3", f.cut.volume},
               {"volume_left_mm3", planned.volume_left},
               {"minutes", f.minutes},
               {"seconds_to_compute", planned.seconds},
               {"figures", stages}};
  for (const auto& place : planned.narrow) {
    if (json["narrow_places"].size() < 100) // the largest come first
      json["narrow_places"].push_back({{"at", vector(place.at)},
                                       {"area_mm2", place.area},
                                       {"volume_mm3", place.volume}});
  }
  double lowest = 0;
  for (const auto& p : o.path)
    lowest = std::min<double>(lowest, p.z);
  json["lowest_tip_mm"] = lowest;
  const auto axial = verification.axial_depth.find(o.tool.number);
  if (axial != verification.axial_depth.end())
    json["tool_axial_depth_mm"] = axial->second;
  return json;
}

} // namespace

Json json::verification(const Judgement& judgement, double tolerance)
{
  const Verification& v = judgement.verification;
  Json findings = Json::array();
  for (const auto& f : v.findings) {
    Json finding = {{"code", f.code},
                    {"severity", f.severity == Severity::Error ? "error" : "warning"},
                    {"text", f.text},
                    {"worst", number(f.worst)},
                    {"count", f.count},
                    {"where", f.line > 0 ? judgement.program.where(f.line) : ""},
                    {"line", f.line}};
    if (f.place.allFinite())
      finding["at"] = vector(f.place);
    if (f.tool > 0)
      finding["tool"] = f.tool;
    if (f.limit > 0)
      finding["limit"] = f.limit;
    findings.push_back(finding);
  }
  const double points = static_cast<double>(std::max<std::size_t>(1, v.points));
  return {{"passed", v.good()},
          {"gouge_tolerance_mm", tolerance},
          {"gouge_max_mm", v.gouge},
          {"gouge_at", vector(v.gouge_at)},
          {"gouge_line", v.gouge_line},
          {"gouged_points", v.gouged_points},
          {"scan_gouge_max_mm", v.raw_gouge},
          {"scan_gouge_line", v.raw_gouge_line},
          {"scan_gouged_points", v.raw_gouged_points},
          {"scan_deviation_mm", deviation(v.raw_deviation)},
          {"residual_mm", quantiles(v.residual)},
          {"deviation_mm", deviation(v.deviation)},
          {"rapids_in_stock", v.rapids_in_stock},
          {"rapid_depth_mm", v.rapid_depth},
          {"unreachable_points", v.unreachable_points},
          {"keep_out_depth_mm", v.keep_out_depth},
          {"kept_out_points", v.kept_out_points},
          {"unreachable_share", static_cast<double>(v.unreachable_points) / points},
          {"untouched_points", v.untouched_points},
          {"untouched_share", v.untouchedShare()},
          {"feed_moves", v.feed_moves},
          {"rapid_moves", v.rapid_moves},
          {"feed_mm", v.feed_length},
          {"rapid_mm", v.rapid_length},
          {"findings", findings}};
}

namespace {

const char* nameOf(Unit unit)
{
  return unit == Unit::Millimetre ? "mm" : "inch";
}

Json programJson(const MillJob& job)
{
  const GCodeWriter& writer = job.options().writer;
  const GCodeWriter::Statistics& f = job.programFigures();
  Json json = {{"post", writer.getPost().name},
               {"control", writer.getPost().control},
               {"units", nameOf(writer.getUnit())},
               {"arcs", job.options().arcs && !writer.getPost().arc_planes.empty()},
               {"forced", !job.verification().good()},
               {"lines", f.lines},
               {"bytes", f.bytes},
               {"feed_moves_planned", f.feed_moves},
               {"slowed_to_max_feed", f.slowed}};
  for (const auto& p : job.programs())
    json["files"].push_back({{"name", p.name}, {"bytes", p.text.size()}});
  return json;
}

} // namespace

std::string reportJson(const MillJob& job, const std::string& scan_name)
{
  const MillOptions& o = job.options();
  const ErrorBudget budget = ErrorBudget::of(o.tolerance);
  Json alignment = Json::array();
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      alignment.push_back(job.alignment()(r, c));

  Json report;
  report["pointmill"] = version;
  report["scan"] = scanJson(job, scan_name);
  report["alignment"] = alignment;
  report["part"] = {{"size", vector(job.partSize())}, {"floor_z", job.floor()}};
  report["stock"] = json::of(job.stock());
  report["keep_out"] = json::of(o.keep_out);
  report["machine"] = json::of(o.machine);
  report["criteria"] = json::of(job.criteria());
  report["clearance_plane_z"] = job.clearancePlane();
  report["tools"] = Json::array();
  for (const auto& tool : job.tools())
    report["tools"].push_back(json::of(tool));
  report["tolerance"] = {{"total_mm", o.tolerance},
                         {"chord_mm", budget.chord},
                         {"arcs_mm", budget.arcs},
                         {"control_blend_mm", budget.blend},
                         {"rounding_mm", budget.rounding},
                         {"scallop_mm", o.scallop},
                         {"semi_scallop_mm", o.semi_scallop}};
  report["surface"] = surfaceJson(job);
  report["gaps"] = gapsJson(job);
  report["program"] = programJson(job);
  report["operations"] = Json::array();
  for (const auto& planned : job.operations())
    report["operations"].push_back(operationJson(planned, job.verification()));
  report["idle_operations"] = Json::array();
  for (const auto& planned : job.idleOperations())
    report["idle_operations"].push_back(
        {{"name", planned.operation.name}, {"tool", planned.operation.tool.number}});
  report["minutes"] = job.minutes();
  report["verification"] =
      json::verification(job.judgement(), job.criteria().gougeLimit());
  report["warnings"] = warningsOf(job);
  report["seconds"] = Json::object();
  for (const auto& [stage, seconds] : job.seconds())
    report["seconds"][stage] = seconds;
  return report.dump(2) + "\n";
}

std::vector<std::string> programsOf(std::istream& in)
{
  std::vector<std::string> names;
  const Json report = Json::parse(in, nullptr, false);
  if (report.is_object() && report.contains("program") &&
      report["program"].contains("files"))
    for (const auto& file : report["program"]["files"]) {
      const auto name = file.value("name", std::string());
      if (name.rfind("program", 0) == 0 && name.find('/') == std::string::npos)
        names.push_back(name);
    }
  return names;
}

} // namespace pointmill
