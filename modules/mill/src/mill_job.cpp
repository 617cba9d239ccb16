// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "work_estimate.h"

#include <pointmill/common/watch.h>
#include <pointmill/gcode/arc_fitter.h>
#include <pointmill/gcode/gcode_writer.h>
#include <pointmill/mill/mill_job.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>

namespace pointmill {
namespace {

/// Programs of more files are a slip.
constexpr std::size_t kMostFiles = 1000;

std::string joined(const std::vector<std::string>& lines, const std::string& between)
{
  std::string text;
  for (const auto& line : lines)
    text += (text.empty() ? "" : between) + line;
  return text;
}

/// The scan's name as every control takes it for a program's; the suffix of one of
/// several files finds room behind it.
std::string programName(const std::string& scan)
{
  constexpr std::size_t longest = 24;
  std::string name = std::filesystem::path(scan).stem().string().substr(0, longest);
  for (char& c : name) {
    const bool good = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                      (c >= '0' && c <= '9') || c == '_' || c == '-';
    c = good ? c : '_';
  }
  return name;
}

} // namespace

/// What is ahead, as well as it is known by now.
void MillJob::estimateWork()
{
  JobSize size;
  if (part_) {
    size.points = double(part_->size());
    const auto all = part_->getMatrixXfMap();
    const Eigen::Vector3f extents =
        (all.rowwise().maxCoeff() - all.rowwise().minCoeff()).head<3>();
    size.area = double(extents.x()) * double(extents.y());
    size.depth = extents.z();
  }
  if (points_)
    size.smooth = figures_.smooth;
  auto work = workOf(size, options_);
  work.erase(work.begin(), work.begin() + std::ptrdiff_t(seconds_.size()));
  ahead_ = std::move(work);
}

void MillJob::timed(const std::string& stage, const std::function<void()>& work)
{
  const auto here =
      std::find_if(ahead_.begin(), ahead_.end(), [&](const StageWork& next) {
        return next.stage == stage;
      });
  ahead_.erase(ahead_.begin(), here); // what was left out
  double seconds = 0;
  for (const auto& next : ahead_)
    seconds += next.seconds;
  const double mine = ahead_.empty() ? 0 : ahead_.front().seconds / seconds;
  const double begin = std::exchange(done_, done_ + (1 - done_) * mine);
  const WorkStep step(stage, {begin, done_});
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  seconds_.emplace_back(stage, took.count());
  if (!ahead_.empty())
    ahead_.erase(ahead_.begin());
}

double MillJob::gapArea() const
{
  double area = 0;
  for (const auto& gap : gaps_)
    if (gap.kind == GapKind::NotScanned)
      area += gap.area;
  return area;
}

std::vector<Tool> MillJob::tools() const
{
  std::vector<Tool> tools{
      options_.rough.tool, options_.semi.tool, options_.finish.tool};
  if (options_.rest)
    tools.push_back(options_.rest->tool);
  return tools;
}

double MillJob::minutes() const
{
  return judgement_.time.total.total() / 60;
}

std::vector<std::string> MillJob::setUp() const
{
  const auto range = [&](const char* axis, int i) {
    char text[64];
    std::snprintf(
        text, sizeof text, " %s%.3f to %.3f", axis, stock_.min[i], stock_.max[i]);
    return std::string(text);
  };
  char text[100];
  std::snprintf(text,
                sizeof text,
                "lowest tip Z%.3f mm, stock bottom Z%.3f mm, clearance plane Z%.3f mm",
                floor_,
                stock_.min.z(),
                clearancePlane());
  return {"stock mm" + range("X", 0) + range("Y", 1) + range("Z", 2),
          std::string("X0 Y0 is the ") +
              (options_.datum_xy == DatumXY::Corner ? "corner" : "centre") +
              " of the part's box, Z0 its " +
              (options_.datum_z == DatumZ::Top ? "top" : "bottom"),
          text};
}

void MillJob::writeProgram(const std::vector<std::string>& remarks)
{
  const ErrorBudget budget = ErrorBudget::of(options_.tolerance);
  GCodeWriter writer = options_.writer;
  writer.setComments(remarks);
  writer.addComment("part " + scan_name_);
  for (const auto& line : setUp())
    writer.addComment(line);
  writer.setProgramName(programName(scan_name_));
  writer.setStock(stock_);
  writer.setClearancePlane(clearancePlane());
  writer.setLowRapids(true); // LinkPasses proves them
  writer.setPathTolerance(budget.blend);
  writer.setMaxFeed(options_.machine.max_feed);
  writer.addAdapter([&](MachineCalls& next) {
    auto fitter = std::make_unique<ArcFitter>(next, writer.getGrid());
    fitter->setTolerance(budget.arcs);
    fitter->setArcs(options_.arcs);
    const Post& post = writer.getPost();
    for (const auto plane : {ArcPlane::XY, ArcPlane::ZX, ArcPlane::YZ}) {
      fitter->setPlane(plane, post.takesArcs(plane));
      fitter->setHelixPlane(plane, post.takesHelices(plane));
    }
    fitter->setLargestSweep(std::min(fitter->getLargestSweep(), post.largest_sweep));
    fitter->setFloor(floor_);
    return fitter;
  });
  std::vector<Operation> operations;
  std::uint32_t passes = 0;
  for (auto& o : operations_) { // pass numbers run through the whole program
    std::uint32_t last = passes;
    for (auto& p : o.operation.path) {
      p.label += passes;
      last = std::max(last, p.label + 1);
    }
    passes = last;
    operations.push_back(o.operation);
  }
  std::vector<std::pair<std::string, std::ostringstream>> files;
  files.reserve(kMostFiles); // the writer holds on to the streams
  program_figures_ = writer.write(
      operations, [&](const std::string& suffix) -> auto& {
        if (files.size() == kMostFiles)
          throw DataError("the program would be of more than " +
                          std::to_string(kMostFiles) + " files: --max-lines");
        files.emplace_back("program" + suffix + "." + writer.getPost().extension,
                           std::ostringstream());
        files.back().second.imbue(std::locale::classic());
        return files.back().second;
      });
  programs_.clear();
  for (auto& [name, text] : files)
    programs_.push_back({name, text.str()});
}

void MillJob::setCriteria()
{
  const ErrorBudget budget = ErrorBudget::of(options_.tolerance);
  criteria_ = Criteria();
  criteria_.part = points_;
  if (clean_points_ != points_) {
    criteria_.model = clean_points_;
    criteria_.noise_allowance = figures_.farthest;
  }
  criteria_.bridges = bridges_;
  criteria_.raw = raw_;
  criteria_.raw_reach = raw_reach_;
  criteria_.stock = stock_;
  criteria_.keep_out = options_.keep_out;
  criteria_.tools = tools();
  criteria_.machine = options_.machine;
  criteria_.tolerance = options_.tolerance;
  criteria_.blend = budget.blend;
  criteria_.arc_error = budget.rounding / 2;
  criteria_.corners_by_control = options_.writer.getCorners() == Corners::Control;
  criteria_.form = options_.writer.getPost().form;
  if (options_.boundary.empty()) // beyond a polygon all is left over
    criteria_.residual_limit = options_.residual_limit;
  criteria_.floor = floor_;
  const Eigen::Vector3d size = stock_.max - stock_.min;
  // Cells no wider than the thinnest tool's radius: nothing slips between two centres.
  double thinnest = std::numeric_limits<double>::infinity();
  for (const auto& tool : criteria_.tools)
    thinnest = std::min(thinnest, tool.radius());
  criteria_.cell =
      std::min(std::max(0.25, std::sqrt(size.x() * size.y() / 4e6)), thinnest / 2);
  criteria_.threads = options_.threads;
}

void MillJob::verify()
{
  std::vector<ProgramStream> files;
  for (const auto& p : programs_)
    files.push_back({p.name, std::make_unique<std::istringstream>(p.text)});
  judgement_ = judge(std::move(files), criteria_);
  criteria_.left_p90 = verification().residual.p90;
  takeTimes();
  takeDepths();
}

void MillJob::takeTimes()
{
  // The writer made a section of each operation, or several, where files end in it. Its
  // name may be spelled otherwise, in capitals.
  const auto& sections = judgement_.program.sections;
  std::vector<double> seconds;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (i == 0 || sections[i].name != sections[i - 1].name ||
        sections[i].tool != sections[i - 1].tool)
      seconds.push_back(0);
    seconds.back() += judgement_.time.sections[i].total();
  }
  if (seconds.size() != operations_.size()) // a post without comments: as planned
    return;
  for (std::size_t i = 0; i < operations_.size(); ++i)
    operations_[i].figures.minutes = seconds[i] / 60;
}

void MillJob::takeDepths()
{
  const Verification& v = verification();
  const auto& sections = v.sections;
  std::vector<double> depths;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (i == 0 || sections[i].name != sections[i - 1].name ||
        sections[i].tool != sections[i - 1].tool)
      depths.push_back(0);
    depths.back() = std::max(depths.back(), sections[i].axial_depth);
  }
  for (std::size_t i = 0; i < operations_.size(); ++i) {
    const auto tool = v.axial_depth.find(operations_[i].operation.tool.number);
    operations_[i].axial_depth = depths.size() == operations_.size() ? depths[i]
                                 : tool != v.axial_depth.end()       ? tool->second
                                                                     : 0.0;
  }
}

void MillJob::plan(const std::string& scan)
{
  options_.validate();
  passed_ = false;
  scan_path_ = scan;
  scan_name_ = std::filesystem::path(scan).filename().string();
  operations_.clear();
  idle_.clear();
  seconds_.clear();
  part_.reset();
  points_.reset();
  done_ = 0;
  estimateWork();
  readAndAlign(scan);
  estimateWork();
  makeSurface();
  estimateWork();
  makeMap();
  timed("stock", [&] { makeStock(); });
  timed("roughing", [&] { planRoughing(); });
  // Where the big tool did not get in, full stock stands: a ball end mill must not go
  // there in one pass. Nor must it meet the skins that stay on walls as high as these.
  const double rough_left = 0.6 * options_.rough.allowance;
  if (options_.rest)
    timed("rest roughing, T" + std::to_string(options_.rest->tool.number),
          [&] { planRest(*options_.rest, "rest roughing"); });
  ToolJob rest = options_.semi;
  rest.allowance = std::max(rest.allowance, rough_left);
  timed("rest roughing", [&] { planRest(rest, "rest roughing"); });
  timed("walls", [&] { planWalls(options_.semi, "walls"); });
  timed("semi-finishing", [&] {
    planFinishing(options_.semi, "semi-finishing", options_.semi_scallop, false);
  });
  rest = options_.finish;
  rest.allowance = std::max(rest.allowance, options_.semi.allowance);
  timed("rest roughing, fine", [&] { planRest(rest, "rest roughing, fine"); });
  timed("walls, fine", [&] { planWalls(options_.finish, "walls, fine"); });
  timed("finishing",
        [&] { planFinishing(options_.finish, "finishing", options_.scallop, true); });
  for (std::size_t i = 0; i < operations_.size(); ++i)
    operations_[i].colour = static_cast<int>(i);
  timed("write", [&] { writeProgram({}); });
  setCriteria();
  timed("verify", [&] { verify(); });
  passed_ = verification().good();
  if (passed_)
    return;
  const auto findings = findingLines(verification(), judgement_.program);
  if (!options_.force) // errors come first
    throw VerificationError(
        "the program fails its verification and was not written:\n  " +
        joined({findings.begin(),
                findings.begin() + std::count_if(verification().findings.begin(),
                                                 verification().findings.end(),
                                                 [](const Finding& f) {
                                                   return f.severity == Severity::Error;
                                                 })},
               "\n  "));
  // Its head says what is wrong with it, but no lines: these are counted anew then.
  std::vector<std::string> remarks{"FORCED: this program fails its verification"};
  for (const auto& f : verification().findings)
    remarks.push_back(f.code + ": " + f.text);
  ahead_.insert(ahead_.begin(), {"verify, forced", ahead_.front().seconds});
  ahead_.insert(ahead_.begin(), {"write, forced", 0.0});
  timed("write, forced", [&] { writeProgram(remarks); });
  timed("verify, forced", [&] { verify(); });
  passed_ = true;
}

} // namespace pointmill
