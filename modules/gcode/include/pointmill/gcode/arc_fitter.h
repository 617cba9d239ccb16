// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/parameters.h>
#include <pointmill/gcode/decimal_grid.h>
#include <pointmill/gcode/machine_calls.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pointmill {

/// @brief A yes or no for each plane.
struct ArcPlanes {
  bool xy = true, zx = true, yz = true;

  bool& of(ArcPlane plane)
  {
    return plane == ArcPlane::XY ? xy : plane == ArcPlane::ZX ? zx : yz;
  }
  bool of(ArcPlane plane) const { return ArcPlanes(*this).of(plane); }
};

/// @brief Stands between GCodeWriter and a printer and says the same path with fewer
/// calls: a run of straight feed moves of about one feed becomes longer straight moves,
/// arcs in the three planes, and helices. All other calls pass through in their order.
///
/// Each call ends in a point of the path, so that no end is moved. What it replaces and
/// what the machine then does stay together: both can be gone through from end to end,
/// never backwards, without ever being more than the tolerance apart (Frechet distance,
/// 3-D; the Hausdorff distance, either way, is no larger). That is proven for each
/// call, with the centre as it is printed and for any way a control may bridge the
/// difference of both radii, not for the vertices alone but along the chords.
///
/// Each call leads as far as it can, at most 512 chords, at a feed that is no higher
/// than any that it replaces. The same calls give the same calls.
class ArcFitter : public MachineCalls {
public:
  struct Statistics {
    std::size_t straights_in = 0;
    std::size_t straights_out = 0;
    std::size_t arcs_out = 0;       ///< helices among them
    std::size_t helices_out = 0;    ///< arcs that move along their axis
    double largest_deviation = 0.0; ///< proven bound of all calls [mm]
  };

  /// @brief Hands on to @p next, which must outlive this; @p grid is that of the calls.
  ArcFitter(MachineCalls& next, const DecimalGrid& grid) : next_(next), grid_(grid) {}

  /// @brief How far the path may get from what came in [mm]. It adds to the chords' own
  /// error, to both sides, and belongs into the error budget.
  void setTolerance(double tolerance) { tolerance_ = tolerance; }
  double getTolerance() const { return tolerance_; }

  /// @brief Without arcs only straight moves are merged.
  void setArcs(bool allowed) { arcs_ = allowed; }
  bool getArcs() const { return arcs_; }

  /// @brief In which planes the control takes arcs, and in which of these helices: in
  /// all by default.
  void setPlane(ArcPlane plane, bool allowed) { planes_.of(plane) = allowed; }
  bool getPlane(ArcPlane plane) const { return planes_.of(plane); }
  void setHelixPlane(ArcPlane plane, bool allowed) { helices_.of(plane) = allowed; }
  bool getHelixPlane(ArcPlane plane) const { return helices_.of(plane); }

  /// @brief Largest sweep of one arc [deg]. Below 180 every control knows where the
  /// centre is.
  void setLargestSweep(double degrees) { largest_sweep_ = degrees; }
  double getLargestSweep() const { return largest_sweep_; }

  /// @brief Radii of arcs [mm].
  void setRadii(double smallest, double largest)
  {
    smallest_radius_ = smallest;
    largest_radius_ = largest;
  }
  double getSmallestRadius() const { return smallest_radius_; }
  double getLargestRadius() const { return largest_radius_; }

  /// @brief Largest lead angle of a helix [deg], its climb against its plane. Controls
  /// that take F in the plane run faster by 1 / cos.
  void setSteepestHelix(double degrees) { steepest_helix_ = degrees; }
  double getSteepestHelix() const { return steepest_helix_; }

  /// @brief Z that no arc may dip below between its ends [mm], as the bottom of the
  /// stock or the table: within the tolerance others may.
  void setFloor(double z) { floor_ = z; }
  double getFloor() const { return floor_; }

  /// @brief Share by which the feed of a call may be below any that it replaces; 0:
  /// only moves of one feed are put together.
  void setFeedDrop(double share) { feed_drop_ = share; }
  double getFeedDrop() const { return feed_drop_; }

  template <typename V>
  void parameters(V&& v)
  {
    v("tolerance", tolerance_, "mm", Range{0, 1}, "between the calls and the path");
    v("arcs", arcs_, "", Range{0, 1}, "arcs, not only straight moves");
    v("xy_plane", planes_.xy, "", Range{0, 1}, "arcs in G17");
    v("zx_plane", planes_.zx, "", Range{0, 1}, "arcs in G18");
    v("yz_plane", planes_.yz, "", Range{0, 1}, "arcs in G19");
    v("xy_helices", helices_.xy, "", Range{0, 1}, "helices along Z");
    v("zx_helices", helices_.zx, "", Range{0, 1}, "helices along Y");
    v("yz_helices", helices_.yz, "", Range{0, 1}, "helices along X");
    v("largest_sweep", largest_sweep_, "deg", Range{1, 350}, "of one arc");
    v("smallest_radius", smallest_radius_, "mm", Range{0.01, 1e5}, "of an arc");
    v("largest_radius", largest_radius_, "mm", Range{0.01, 1e5}, "of an arc");
    v("steepest_helix", steepest_helix_, "deg", Range{0, 60}, "lead angle of a helix");
    v("floor", floor_, "mm", Range{-1e5, 1e5}, "Z that no arc dips below");
    v("feed_drop", feed_drop_, "", Range{0, 0.9}, "share of the feed that may be lost");
  }

  const Statistics& statistics() const { return statistics_; }

  /// @brief Throws ParameterError.
  void begin(const ProgramHead& head) override;
  void comment(const std::string& text) override;
  void operation(std::size_t number, const std::string& name) override;
  void stop() override;
  void retract() override;
  void changeTool(int number) override;
  void spindle(long rpm) override;
  void coolant(bool on) override;
  void approach(const MachinePosition& to) override;
  void traverse(const MachinePosition& to) override;
  void straight(const MachinePosition& to, std::int64_t feed) override;
  void arc(const MachineArc& arc, std::int64_t feed) override;
  void dwell(double seconds) override;
  void end() override;

private:
  void emitOne();
  void hand(std::size_t count, const std::optional<MachineArc>& arc);
  void flush();
  void startAt(const MachinePosition& at);

  MachineCalls& next_;
  DecimalGrid grid_;
  double tolerance_ = 0.003;
  bool arcs_ = true;
  ArcPlanes planes_, helices_;
  double largest_sweep_ = 175.0;
  double smallest_radius_ = 0.05, largest_radius_ = 1000.0;
  double steepest_helix_ = 30.0;
  double floor_ = -1e5;
  double feed_drop_ = 0.0;

  /// Where the run starts, the ends of its moves, and their feeds beside them. In
  /// ticks, exact. Empty where the position is not known.
  std::vector<Eigen::Vector3d> run_;
  std::vector<std::int64_t> feeds_;
  std::size_t first_ = 0; ///< of run_: where the next call starts
  std::int64_t feed_ = 0; ///< of the last call
  Statistics statistics_;
};

} // namespace pointmill
