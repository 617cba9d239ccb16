// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "layer.h"

#include "scallop.h"

#include <pointmill/common/parallel.h>

#include <iterator>

namespace pointmill {
namespace {

constexpr std::size_t kNoiseSamples = 32; // pairs of rows

/// Stretches of two rows as one list; those that touch become one.
std::vector<Stretch> unite(std::vector<Stretch> a, const std::vector<Stretch>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  std::sort(a.begin(), a.end(), [](const Stretch& s, const Stretch& t) {
    return s.first < t.first;
  });
  std::vector<Stretch> united;
  for (const auto& s : a)
    if (united.empty() || s.first > united.back().last + 1)
      united.push_back(s);
    else
      united.back().last = std::max(united.back().last, s.last);
  return united;
}

template <typename T>
void append(std::vector<T>& to, std::vector<T>& from)
{
  to.insert(to.end(),
            std::make_move_iterator(from.begin()),
            std::make_move_iterator(from.end()));
}

} // namespace

LayerMaker::LayerMaker(const SurfaceModel& surface,
                       const Raster& raster,
                       double degrees)
    : raster_(raster), rows_(surface, raster, degrees),
      places_(rows_.width().first, rows_.width().last, raster.step_over)
{
}

Layer LayerMaker::everywhere() const
{
  if (empty())
    return Layer();
  const Stretches whole{{0, rows_.stations().count - 1}};
  return make(std::vector<Stretches>(places_.count, whole), nullptr);
}

Layer LayerMaker::on(const Mask& mask, double noise) const
{
  std::vector<Stretches> stretches(places_.count);
  parallelFor(places_.count, raster_.threads, [&](std::size_t row) {
    stretches[row] = stretchesOn(mask, row);
  });
  return make(stretches, &noise);
}

LayerMaker::Stretches LayerMaker::stretchesOn(const Mask& mask, std::size_t row) const
{
  Stretches found;
  for (std::size_t i = 0; i < rows_.stations().count; ++i) {
    if (!mask.holds(rows_.frame().xy(rows_.stations()[i], places_[row])))
      continue;
    if (!found.empty() && found.back().last + 1 == i)
      found.back().last = i;
    else
      found.push_back({i, i});
  }
  return found;
}

// Each row as far as it or a neighbour is wanted.
std::vector<Row> LayerMaker::dropRows(const std::vector<Stretches>& stretches) const
{
  std::vector<Row> rows(places_.count);
  parallelFor(rows.size(), raster_.threads, {0.0, 0.3}, [&](std::size_t row) {
    Stretches near;
    for (std::size_t r = row > 0 ? row - 1 : 0; r <= row + 1 && r < rows.size(); ++r)
      near = unite(std::move(near), stretches[r]);
    if (!near.empty())
      rows[row] = rows_.drop(places_[row], {near.front().first, near.back().last});
  });
  return rows;
}

double LayerMaker::measureNoise(const std::vector<Row>& rows) const
{
  const std::size_t gaps = rows.size() - 1, samples = std::min(gaps, kNoiseSamples);
  std::vector<std::vector<Cusp>> found(samples);
  parallelFor(samples, raster_.threads, [&](std::size_t k) {
    const Row &low = rows[k * gaps / samples], &high = rows[k * gaps / samples + 1];
    const Row middle = rows_.drop(0.5 * (low.v + high.v), {0, low.stations.size() - 1});
    found[k] = cusps(low, middle, high, rows_.stations().step);
  });
  return roughness(found);
}

Layer LayerMaker::make(const std::vector<Stretches>& stretches,
                       const double* noise) const
{
  Layer layer;
  const auto rows = dropRows(stretches);
  std::vector<std::vector<Pass>> regular(rows.size());
  std::vector<double> kept_out(rows.size(), 0.0);
  parallelFor(rows.size(), raster_.threads, {0.3, 0.35}, [&](std::size_t row) {
    for (const Stretch& s : stretches[row])
      kept_out[row] += rows_.cut(rows[row], s, regular[row]);
  });
  for (const double length : kept_out)
    layer.kept_out += length;
  for (auto& passes : regular)
    append(layer.passes, passes);
  if (raster_.scallop <= 0 || rows.size() < 2)
    return layer;

  layer.noise = noise ? *noise : measureNoise(rows);
  layer.tally = ScallopTally(raster_.scallop);
  const RowInserter inserter(rows_, raster_, layer.noise);
  std::vector<Insertion> insertions(rows.size() - 1);
  parallelFor(insertions.size(), raster_.threads, {0.35, 1.0}, [&](std::size_t i) {
    insertions[i] =
        inserter.between(rows[i], rows[i + 1], unite(stretches[i], stretches[i + 1]));
  });
  for (auto& insertion : insertions) {
    layer.inserted += insertion.passes.size();
    layer.kept_out += insertion.kept_out;
    append(layer.passes, insertion.passes);
    append(layer.steep, insertion.steep);
    layer.tally.add(insertion.tally);
  }
  std::stable_sort(layer.passes.begin(),
                   layer.passes.end(),
                   [](const Pass& a, const Pass& b) { return a.v < b.v; });
  return layer;
}

} // namespace pointmill
