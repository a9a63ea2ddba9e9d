#include "render/tracer/shared_occlusion.h"

#include <algorithm>

#include "render/math/for_avx2.h"

namespace mien::render {
namespace {

/// In an order that is the same on every machine.
float sum_of(const LaneFloats& values) {
  const float* v = values.lane;
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

}  // namespace

void SharedOcclusion::add(const Found& found) {
  std::vector<Entry>& entries = rows_[static_cast<std::size_t>(found.y)].entries;
  auto entry = entries.end();
  while (entry != entries.begin() && std::prev(entry)->x == found.x &&
         std::prev(entry)->part != found.part)
    --entry;
  if (entry == entries.begin() || std::prev(entry)->x != found.x) {
    if (entries.empty()) entries.reserve(64);
    entries.push_back({found.x, found.part});
    entry = entries.end();
  }
  --entry;
  entry->normal += found.normal;
  entry->occluded += found.occluded;
  entry->samples += 1.0f;
}

void SharedOcclusion::finish_row(int y) {
  Row& row = rows_[static_cast<std::size_t>(y)];
  if (row.entries.empty()) return;
  const std::size_t size = row.entries.size() + lanes;
  row.values.resize(Row::lists * size);
  row.parts.resize(size);
  for (std::size_t i = 0; i < row.entries.size(); ++i) {
    const Entry& entry = row.entries[i];
    const Vec3 normal = entry.normal.normalized();
    const float values[Row::lists] = {normal.x(),        normal.y(),        normal.z(),
                                      entry.occluded[0], entry.occluded[1], entry.occluded[2],
                                      entry.samples};
    for (std::size_t list = 0; list < Row::lists; ++list)
      row.values[list * size + i] = values[list];
    row.parts[i] = entry.part;
  }
  const int begin = row.entries.front().x;
  row.first.resize(static_cast<std::size_t>(row.entries.back().x - begin + 2));
  for (std::size_t column = 0, i = 0; column < row.first.size(); ++column) {
    while (i < row.entries.size() && row.entries[i].x - begin < static_cast<int>(column)) ++i;
    row.first[column] = static_cast<int>(i);
  }
}

// Weights are 1 for equal normals, and 0 from 60° on. Sums have eight parts, so that they are the
// same on every machine.
MIEN_FOR_AVX2_TOO void SharedOcclusion::add(const Neighbours& near, Sums& sums) {
  const float x = near.normal.x(), y = near.normal.y(), z = near.normal.z();
  const int part = near.part;
  for (int begin = near.begin; begin < near.end; begin += static_cast<int>(lanes)) {
    const Row& row = near.row;
    const float *nx = row.at(Row::normal_x, begin), *ny = row.at(Row::normal_y, begin),
                *nz = row.at(Row::normal_z, begin), *red = row.at(Row::red, begin),
                *green = row.at(Row::green, begin), *blue = row.at(Row::blue, begin),
                *samples = row.at(Row::samples, begin);
    const int* parts = &row.parts[static_cast<std::size_t>(begin)];
    const int count = near.end - begin;
#pragma omp simd
    for (int i = 0; i < static_cast<int>(lanes); ++i) {
      const float above = 2.0f * (x * nx[i] + y * ny[i] + z * nz[i]) - 1.0f;
      const bool counts = (i < count) & (parts[i] == part) & (above > 0.0f);
      const float weight = counts ? above * above : 0.0f;
      sums.red.lane[i] += weight * red[i];
      sums.green.lane[i] += weight * green[i];
      sums.blue.lane[i] += weight * blue[i];
      sums.samples.lane[i] += weight * samples[i];
    }
  }
}

Color SharedOcclusion::at(int x, int y, int part, const Vec3& normal) const {
  const int reach = part == floor_part ? floor_reach_ : figure_reach_;
  const int last_row = std::min(y + reach, static_cast<int>(rows_.size()) - 1);
  const Vec3 unit = normal.normalized();
  Sums sums;
  for (int number = std::max(y - reach, 0); number <= last_row; ++number) {
    const Row& row = rows_[static_cast<std::size_t>(number)];
    if (row.entries.empty()) continue;
    const int last = static_cast<int>(row.first.size()) - 1;
    const int column = x - row.entries.front().x;
    const auto from = static_cast<std::size_t>(std::clamp(column - reach, 0, last));
    const auto to = static_cast<std::size_t>(std::clamp(column + reach + 1, 0, last));
    if (row.first[from] < row.first[to])
      add({row, row.first[from], row.first[to], part, unit}, sums);
  }
  const float samples = sum_of(sums.samples);
  if (!(samples > 0.0f)) return Color::Zero();
  return Color{sum_of(sums.red), sum_of(sums.green), sum_of(sums.blue)} / samples;
}

}  // namespace mien::render
