// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/report.h>
#include <pointmill/link/link_passes.h>
#include <pointmill/mill/check.h>
#include <pointmill/mill/criteria.h>
#include <pointmill/mill/mill_options.h>
#include <pointmill/rough/narrow_place.h>
#include <pointmill/slice/spacing.h>
#include <pointmill/verify/program_verifier.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pointmill {

/// @brief One operation as planned, with what is worth telling.
struct PlannedOperation {
  /// @brief Nothing yet of what @p job is to do.
  PlannedOperation(const ToolJob& job, const std::string& name)
      : operation{name, job.tool, job.cutting, {}}, allowance(job.allowance)
  {
  }

  Operation operation;
  double allowance = 0;
  std::vector<ParameterValue> parameters;
  Report report;
  PathFigures figures;
  /// Thickest layer at once, as the verification measures it in the program [mm].
  double axial_depth = 0;
  double volume_left = 0;          ///< of stock above the part [mm3]
  std::vector<NarrowPlace> narrow; ///< where the roughing tool does not get in
  double seconds = 0;              ///< to compute
  int colour = 0;                  ///< in pictures: which of the palette's
};

/// @brief The scan as it was taken up.
struct ScanFigures {
  std::string format;
  std::size_t vertices = 0, faces = 0, sampled = 0, nan_points = 0, strays = 0;
  double scale = 1; ///< mm per file unit
  Spacing spacing;
};

/// @brief What was made of the scan's points.
struct SurfaceFigures {
  bool smooth = false;
  double noise = 0;        ///< standard deviation of the scan's, as measured [mm]
  double noise_left = 0;   ///< after smoothing [mm]
  bool noise_kept = false; ///< the points are too few to take it off without form
  double farthest = 0;     ///< no point was moved further [mm]
  Report smoothing;        ///< what PointSmoother did; empty where it was not needed
};

/// @brief What a stage is of a job's work.
struct StageWork {
  std::string stage;
  double seconds = 0; ///< on some machine
};

/// @brief One file of the program that a job makes.
struct ProgramText {
  std::string name; ///< "program.ngc"
  std::string text;
};

/// @brief The main job: from the file of a scan to a verified NC program with its
/// picture and report.
///
/// `plan()` does everything in memory and throws VerificationError when the program,
/// read back from its text, fails; `write()` puts the files into a directory. Nothing
/// is ever written of a program that did not pass, but with MillOptions::force, when
/// the program's own head says what is wrong; writeRefusal() tells why.
///
/// Both are one whole to a Watch, of which `write()`, or writeRefusal(), is the end.
class MillJob {
public:
  explicit MillJob(MillOptions options) : options_(std::move(options)) {}

  /// @throws ParameterError, DataError, VerificationError
  void plan(const std::string& scan);

  /// @brief Writes the program, what it is judged by (part.pcd and clouds beside it),
  /// cl.pcd, pictures and report.json. The directory is made if need be;
  /// each file is written beside and renamed, the program last.
  /// @throws DataError, VerificationError where no program has passed
  void write(const std::string& directory);

  /// @brief Writes refused.json and refused.png, which show why plan() refused its
  /// program. The program of an earlier job in the directory is renamed, with
  /// ".earlier" behind its name, lest it be taken for the one that was refused.
  /// @throws DataError, VerificationError where no program was refused
  void writeRefusal(const std::string& directory);

  /// @brief Whether writeRefusal() found a program of an earlier job.
  bool earlierProgram() const { return earlier_program_; }

  /// @brief Names of what write() or writeRefusal() wrote into its directory.
  const std::vector<std::string>& files() const { return files_; }

  /// @brief Refuses (DataError) a directory that would overwrite the scan or is a file.
  static void checkDirectory(const std::string& scan, const std::string& directory);

  const MillOptions& options() const { return options_; }
  const std::vector<PlannedOperation>& operations() const { return operations_; }
  /// @brief Those that found nothing to cut, without a path.
  const std::vector<PlannedOperation>& idleOperations() const { return idle_; }
  /// @brief What the program is judged by, with all that does not depend on it.
  const Criteria& criteria() const { return criteria_; }
  const Verification& verification() const { return judgement_.verification; }
  /// @brief The program as it was read back from its text, and judged.
  const Judgement& judgement() const { return judgement_; }
  const std::vector<ProgramText>& programs() const { return programs_; }
  const GCodeWriter::Statistics& programFigures() const { return program_figures_; }
  const pcl::PointCloud<pcl::PointXYZ>& part() const { return *part_; }
  /// @brief Extents of the part's points [mm].
  Eigen::Vector3d partSize() const { return points_->max() - points_->min(); }
  const CellCloud& map() const { return *map_; }
  const std::vector<GapRegion>& gaps() const { return gaps_; }
  const Stock& stock() const { return stock_; }
  const ScanFigures& scanFigures() const { return scan_; }
  const SurfaceFigures& surfaceFigures() const { return figures_; }
  const Eigen::Matrix4d& alignment() const { return alignment_; }
  const std::vector<std::pair<std::string, double>>& seconds() const
  {
    return seconds_;
  }
  /// @brief Above the stock and all zones that are kept out of.
  double clearancePlane() const
  {
    return std::max(stock_.top(), options_.keep_out.highestTop()) + options_.clearance;
  }
  /// @brief All that may be in the program.
  std::vector<Tool> tools() const;
  double floor() const { return floor_; }
  double minutes() const;
  /// @brief Area of all gaps but the holes through the part [mm2].
  double gapArea() const;
  /// @brief Area inside the outline that lies between points and was bridged [mm2].
  double bridgedArea() const { return bridged_area_; }
  /// @brief What the one who sets up must know, a line each.
  std::vector<std::string> setUp() const;

private:
  void readAndAlign(const std::string& scan);
  void makeSurface();
  void makeMap();
  void readRawStock();
  void makeStock();
  template <typename Strategy>
  void planLevels(Strategy& roughing, const ToolJob& job, const std::string& name);
  void planRoughing();
  void planRest(const ToolJob& job, const std::string& name);
  void planWalls(ToolJob job, const std::string& name);
  void planFinishing(const ToolJob& job,
                     const std::string& name,
                     double scallop,
                     bool across);
  CLCloud rasterPasses(const ToolJob& job,
                       double scallop,
                       bool across,
                       PlannedOperation& planned) const;
  void link(PlannedOperation& planned, const CLCloud& passes, double lead_radius);
  double volumeLeft() const;
  void writeProgram(const std::vector<std::string>& remarks);
  void setCriteria();
  void verify();
  void takeTimes();
  void takeDepths();
  void estimateWork();
  void timed(const std::string& stage, const std::function<void()>& work);

  MillOptions options_;
  std::vector<StageWork> ahead_; // what is to be done yet
  double done_ = 0;              // share of all the work
  std::string scan_path_, scan_name_;
  ScanFigures scan_;
  Eigen::Matrix4d alignment_ = Eigen::Matrix4d::Identity();
  SurfaceFigures figures_;
  pcl::PointCloud<pcl::PointXYZ>::Ptr part_;
  pcl::PointCloud<pcl::PointXYZ>::Ptr clean_; // the same without noise, or the same
  CellCloud::Ptr map_;
  std::vector<GapRegion> gaps_;
  std::shared_ptr<const PointIndex> points_;       // the part's own points
  std::shared_ptr<const PointIndex> clean_points_; // without noise, or the same
  std::shared_ptr<const PointIndex> bridges_;      // over its gaps
  std::shared_ptr<const PointIndex> surface_;      // clean points and bridges
  std::shared_ptr<const SurfaceModel> model_;
  /// Of a mesh, whatever its size.
  static constexpr std::size_t kMostSamples = 6'000'000;
  Stock stock_;
  std::shared_ptr<const PointIndex> raw_; // of the raw part, where it was scanned
  double raw_reach_ = 0;                  // of its points [mm]
  std::shared_ptr<StockField> standing_, nominal_;
  double floor_ = 0, bridged_area_ = 0;
  std::vector<PlannedOperation> operations_, idle_;
  std::vector<ProgramText> programs_;
  std::vector<std::string> files_;
  GCodeWriter::Statistics program_figures_;
  Criteria criteria_;
  Judgement judgement_;
  bool passed_ = false, earlier_program_ = false;
  std::vector<std::pair<std::string, double>> seconds_;
};

} // namespace pointmill
