#include "render/tracer/shared_sky.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include "render/math/for_avx2.h"

namespace mien::render {
namespace {

constexpr int near_rows = 3;
constexpr int near_columns = 1;

float sum_of(const LaneFloats& values) {
  return std::accumulate(std::begin(values.lane), std::end(values.lane), 0.0f);
}

}  // namespace

void SharedSky::begin_tile(const Tile& tile) {
  x_begin_ = tile.x_begin;
  y_begin_ = tile.y_begin;
  samples_.clear();
  for (auto* list : {&lists_.normal_x, &lists_.normal_y, &lists_.normal_z, &lists_.red,
                     &lists_.green, &lists_.blue, &lists_.weight})
    list->clear();
  lists_.part.clear();
  first_.fill(0);
}

void SharedSky::append(const Vec3& normal, float weight, int part) {
  lists_.normal_x.push_back(normal.x());
  lists_.normal_y.push_back(normal.y());
  lists_.normal_z.push_back(normal.z());
  lists_.red.push_back(0.0f);
  lists_.green.push_back(0.0f);
  lists_.blue.push_back(0.0f);
  lists_.weight.push_back(weight);
  lists_.part.push_back(part);
}

int SharedSky::add(const Sample& sample, const Surface& surface) {
  const int row = sample.pixel->y - y_begin_, column = (sample.pixel->x - x_begin_) / 2;
  const auto number = static_cast<int>(samples_.size());
  assert(samples_.empty() ||
         std::pair(samples_.back().row, samples_.back().column) <= std::pair(row, column));
  samples_.push_back({sample, surface.albedo, row, column});
  append(surface.normal, sample.weight + sample.partner_weight, surface.part);
  ++first_[static_cast<std::size_t>(row * columns + column) + 1];
  return number;
}

// Weights are 1 for equal normals, and 0 from 60° on. Sums have eight parts, so that they are the
// same on every machine.
MIEN_FOR_AVX2_TOO void SharedSky::add_near(const Lists& lists, int here, int begin, int end,
                                           Sums& sums) {
  const auto at = static_cast<std::size_t>(here);
  const float x = lists.normal_x[at], y = lists.normal_y[at], z = lists.normal_z[at];
  const int part = lists.part[at];
  for (int first = begin; first < end; first += static_cast<int>(lanes)) {
    const float *nx = &lists.normal_x[static_cast<std::size_t>(first)],
                *ny = &lists.normal_y[static_cast<std::size_t>(first)],
                *nz = &lists.normal_z[static_cast<std::size_t>(first)],
                *red = &lists.red[static_cast<std::size_t>(first)],
                *green = &lists.green[static_cast<std::size_t>(first)],
                *blue = &lists.blue[static_cast<std::size_t>(first)],
                *represented = &lists.weight[static_cast<std::size_t>(first)];
    const int* parts = &lists.part[static_cast<std::size_t>(first)];
    const int count = end - first;
#pragma omp simd
    for (int i = 0; i < static_cast<int>(lanes); ++i) {
      const float above = 2.0f * (x * nx[i] + y * ny[i] + z * nz[i]) - 1.0f;
      const bool counts = (i < count) & (parts[i] == part) & (above > 0.0f);
      const float weight = counts ? represented[i] * above * above : 0.0f;
      sums.red.lane[i] += weight * red[i];
      sums.green.lane[i] += weight * green[i];
      sums.blue.lane[i] += weight * blue[i];
      sums.weight.lane[i] += weight;
    }
  }
}

Color SharedSky::mean_near(int number) const {
  const auto i = static_cast<std::size_t>(number);
  const SkySample& here = samples_[i];
  Sums sums;
  const int first_column = std::max(here.column - near_columns, 0);
  const int last_column = std::min(here.column + near_columns, columns - 1);
  for (int row = std::max(here.row - near_rows, 0); row <= std::min(here.row + near_rows, rows - 1);
       ++row)
    add_near(lists_, number, first_[static_cast<std::size_t>(row * columns + first_column)],
             first_[static_cast<std::size_t>(row * columns + last_column) + 1], sums);
  const float weights = sum_of(sums.weight);
  // A normal that is no number counts nowhere, not even here.
  if (!(weights > 0.0f)) return {lists_.red[i], lists_.green[i], lists_.blue[i]};
  return Color{sum_of(sums.red), sum_of(sums.green), sum_of(sums.blue)} / weights;
}

void SharedSky::subtract() {
  for (std::size_t i = 0; i < lanes; ++i) append(Vec3::Zero(), 0.0f, -1);
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  for (std::size_t i = 0; i < samples_.size(); ++i)
    add_light(samples_[i].sample, &Pixel::figure,
              -(samples_[i].albedo * mean_near(static_cast<int>(i))));
}

}  // namespace mien::render
