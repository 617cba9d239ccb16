// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include <pointmill/common/parallel.h>
#include <pointmill/link/simplify_path.h>

#include <algorithm>
#include <vector>

namespace pointmill {
namespace {

using Eigen::Vector3d;

/// One pass, and the choice of its points.
class Pass {
public:
  Pass(const CLCloud& cloud,
       const pcl::Indices& ids,
       std::size_t begin,
       std::size_t end)
      : cloud_(cloud), ids_(ids), begin_(begin), size_(end - begin)
  {
  }

  std::size_t size() const { return size_; }
  const PointCL& point(std::size_t i) const { return cloud_[ids_[begin_ + i]]; }
  Vector3d place(std::size_t i) const
  {
    const PointCL& p = point(i);
    return {p.x, p.y, p.z};
  }
  /// How far a chord from point i may lead at most: as long as all are of one kind.
  std::size_t lastLike(std::size_t i) const
  {
    std::size_t last = i + 1;
    const auto alike = [&](const PointCL& a, const PointCL& b) {
      return a.motion == b.motion && a.level == b.level && a.feed == b.feed;
    };
    while (last + 1 < size_ && alike(point(last), point(last + 1)))
      ++last;
    return last;
  }
  /// Whether the points between i and j lie within the band of the chord. The polyline
  /// through them does then, as the band is convex.
  bool skips(std::size_t i, std::size_t j, const ToleranceBand& band) const
  {
    const Vector3d a = place(i), along = place(j) - a;
    const double squared = along.squaredNorm();
    for (std::size_t k = i + 1; k < j; ++k) {
      const Vector3d p = place(k) - a;
      const double t = squared > 0 ? std::clamp(p.dot(along) / squared, 0.0, 1.0) : 0.0;
      const Vector3d off = p - t * along;
      const double most = off.z() > 0 ? band.inside : band.outside;
      if (off.squaredNorm() > most * most)
        return false;
    }
    return true;
  }

private:
  const CLCloud& cloud_;
  const pcl::Indices& ids_;
  std::size_t begin_, size_;
};

/// The last of (first, last] up to which `good` holds, doubling and halving the step;
/// first + 1 is taken for good.
template <typename Good>
std::size_t furthest(std::size_t first, std::size_t last, Good&& good)
{
  std::size_t best = first + 1, bad = last + 1;
  for (std::size_t step = 2; first + step <= last; step *= 2) {
    if (!good(first + step)) {
      bad = first + step;
      break;
    }
    best = first + step;
  }
  while (bad - best > 1) {
    const std::size_t middle = best + (bad - best) / 2;
    (good(middle) ? best : bad) = middle;
  }
  return best;
}

} // namespace

void SimplifyPath::checkParameters() const
{
  validateParameters(*this, getName());
  tool_.validate();
  if (!part_)
    throw DataError("SimplifyPath: the part's points were not given (setPart)");
}

void SimplifyPath::apply(CLCloud& output)
{
  const auto& ids = *indices_;
  std::vector<Pass> passes;
  for (std::size_t begin = 0; begin < ids.size();) {
    std::size_t end = begin;
    for (; end < ids.size() && (*input_)[ids[end]].label == (*input_)[ids[begin]].label;
         ++end) {
      const PointCL& p = (*input_)[ids[end]];
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        throw DataError("SimplifyPath: CL point " + std::to_string(ids[end]) +
                        " is not finite");
    }
    passes.emplace_back(*input_, ids, begin, end);
    begin = end;
  }

  const Tool grown = tool_.grown(allowance_);
  const Vector3d down(0, 0, allowance_);
  std::vector<CLCloud> kept(passes.size());
  parallelFor(passes.size(), threads_, {0.0, 1.0}, [&](std::size_t k) {
    const Pass& pass = passes[k];
    CLCloud& mine = kept[k];
    mine.push_back(pass.point(0));
    for (std::size_t i = 0; i + 1 < pass.size();) {
      checkInterrupted(); // all may be one pass
      const Vector3d from = pass.place(i);
      std::size_t next = furthest(i, pass.lastLike(i), [&](std::size_t j) {
        return (pass.place(j) - from).norm() <= longest_ && pass.skips(i, j, band_);
      });
      const auto clear = [&](std::size_t j) {
        return part_->gouge(grown, from - down, pass.place(j) - down, band_.inside) <=
               0;
      };
      if (next > i + 1 && !clear(next))
        next = furthest(i, next, [&](std::size_t j) {
          return pass.skips(i, j, band_) && clear(j);
        });
      mine.push_back(pass.point(next));
      i = next;
    }
  });
  for (const auto& pass : kept)
    output += pass;
  report_.set("cl_points_in", static_cast<double>(ids.size()));
  report_.set("cl_points", static_cast<double>(output.size()));
}

} // namespace pointmill
