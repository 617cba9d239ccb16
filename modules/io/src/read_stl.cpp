// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "readers.h"
#include "scalar.h"
#include "text.h"

#include <pointmill/common/watch.h>

#include <limits>

namespace pointmill::detail {

namespace {

constexpr std::size_t header_size = 84, triangle_size = 50;

/// Gives equal vertices one index.
class Welder {
public:
  Welder(std::vector<Eigen::Vector3d>& points) : points_(points) { grow(1024); }

  std::uint32_t add(Eigen::Vector3d point)
  {
    // -0 is 0; NaN stays equal to itself, as its bits are compared.
    point.array() += 0.0;
    if (2 * points_.size() > slots_.size())
      grow(2 * slots_.size());
    std::size_t slot = slotOf(point);
    if (slots_[slot] == none) {
      slots_[slot] = static_cast<std::uint32_t>(points_.size());
      points_.push_back(point);
    }
    return slots_[slot];
  }

private:
  static constexpr auto none = std::numeric_limits<std::uint32_t>::max();

  // The point's own slot, or the free one where it belongs.
  std::size_t slotOf(const Eigen::Vector3d& point) const
  {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
      std::uint64_t bits;
      std::memcpy(&bits, &point[axis], sizeof(bits));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash & mask;
    while (slots_[slot] != none && std::memcmp(points_[slots_[slot]].data(),
                                               point.data(),
                                               3 * sizeof(double)) != 0)
      slot = (slot + 1) & mask;
    return slot;
  }

  void grow(std::size_t size)
  {
    slots_.assign(size, none);
    for (std::size_t i = 0; i < points_.size(); ++i)
      slots_[slotOf(points_[i])] = static_cast<std::uint32_t>(i);
  }

  std::vector<Eigen::Vector3d>& points_;
  std::vector<std::uint32_t> slots_; // a power of two, at most half of them in use
};

void readBinary(const Source& source, RawScan& scan)
{
  const auto count = loadAs<std::uint32_t>(source.begin() + header_size - 4);
  if (count > (source.size() - header_size) / triangle_size)
    source.failShort(count, "triangles");
  Welder welder(scan.points);
  scan.faces.resize(count);
  const char* from = source.begin() + header_size;
  const WorkStep step({0.0, 1.0});
  for (auto& face : scan.faces) {
    step.reach(source.shareBefore(from));
    for (int corner = 0; corner < 3; ++corner) {
      const char* vertex = from + 12 * (corner + 1); // after the normal
      face[corner] = welder.add({loadAs<float>(vertex),
                                 loadAs<float>(vertex + 4),
                                 loadAs<float>(vertex + 8)});
    }
    from += triangle_size;
  }
}

void readAscii(const Source& source, RawScan& scan)
{
  Welder welder(scan.points);
  std::vector<std::uint32_t> corners;
  bool closed = false;
  Text rest{source.begin(), source.end()};
  Text line{};
  const WorkStep step({0.0, 1.0});
  while (takeLine(rest, line)) {
    step.reach(source.shareBefore(line.at));
    const Text whole = line;
    const std::string key = lower(takeWord(line));
    bool good = true;
    if (key == "vertex") {
      Eigen::Vector3d point;
      for (double& value : point)
        good = good && takeWholeNumber(line, value);
      if (good)
        corners.push_back(welder.add(point));
    }
    else if (key == "endloop") {
      good = corners.size() == 3;
      if (good)
        addFan(corners, scan);
      corners.clear();
    }
    else if (key == "solid" || key == "endsolid")
      closed = key == "endsolid";
    else
      good = key.empty() || key == "facet" || key == "outer" || key == "endfacet";
    if (!good)
      source.failAt(whole.at,
                    quoted(whole) + " does not belong into an STL file; export the "
                                    "mesh again");
  }
  if (!closed || !corners.empty())
    source.fail("is cut short: 'endsolid' is missing; copy or export it again");
}

} // namespace

RawScan readStl(const Source& source)
{
  RawScan scan;
  scan.format = "STL";
  Text start{source.begin(), source.end()};
  // Some binary files begin with "solid" too, but no text holds a zero byte.
  const bool text = lower(takeWord(start)).compare(0, 5, "solid") == 0 &&
                    !std::memchr(source.begin(), 0, source.size());
  if (text)
    readAscii(source, scan);
  else if (source.size() >= header_size)
    readBinary(source, scan);
  else
    source.fail("is not an STL file; save it as STL or name it as it is");
  return scan;
}

} // namespace pointmill::detail
