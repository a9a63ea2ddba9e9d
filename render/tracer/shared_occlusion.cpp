#include "render/tracer/shared_occlusion.h"

#include <algorithm>
#include <numeric>

#include "render/math/for_avx2.h"

namespace mien::render {
namespace {

constexpr int floor_part = -1;
constexpr int no_part = -2;
constexpr int near_rows = 3;
constexpr int near_floor_rows = 2;
constexpr int near_columns = 1;

float sum_of(const LaneFloats& values) {
  return std::accumulate(std::begin(values.lane), std::end(values.lane), 0.0f);
}

}  // namespace

void SharedOcclusion::begin_tile(const Tile& tile) {
  x_begin_ = tile.x_begin;
  y_begin_ = tile.y_begin;
  samples_.clear();
}

int SharedOcclusion::add_figure(const Sample& sample, const Surface& surface) {
  samples_.push_back({sample, surface.normal, surface.albedo, surface.part});
  return static_cast<int>(samples_.size()) - 1;
}

int SharedOcclusion::add_floor(const Sample& sample) {
  samples_.push_back({sample, Vec3::UnitY(), Color::Zero(), floor_part});
  return static_cast<int>(samples_.size()) - 1;
}

void SharedOcclusion::make_lists() {
  const auto cell = [this](const SharedSample& sample) {
    return static_cast<std::size_t>(row_of(sample) * columns + column_of(sample));
  };
  first_.fill(0);
  for (const SharedSample& sample : samples_) ++first_[cell(sample) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  const std::size_t count = samples_.size() + lanes;
  for (auto* list : {&lists_.normal_x, &lists_.normal_y, &lists_.normal_z, &lists_.red,
                     &lists_.green, &lists_.blue, &lists_.weight})
    list->assign(count, 0.0f);
  lists_.part.assign(count, no_part);
  places_.clear();
  auto next = first_;
  for (const SharedSample& sample : samples_) {
    const auto place = static_cast<std::size_t>(next[cell(sample)]++);
    places_.push_back(static_cast<int>(place));
    lists_.normal_x[place] = sample.normal.x();
    lists_.normal_y[place] = sample.normal.y();
    lists_.normal_z[place] = sample.normal.z();
    lists_.red[place] = sample.occluded[0];
    lists_.green[place] = sample.occluded[1];
    lists_.blue[place] = sample.occluded[2];
    lists_.weight[place] = sample.sample.weight + sample.sample.partner_weight;
    lists_.part[place] = sample.part;
  }
}

// Weights are 1 for equal normals, and 0 from 60° on. Sums have eight parts, so that they are the
// same on every machine.
MIEN_FOR_AVX2_TOO void SharedOcclusion::add_near(const Lists& lists, int here, int begin, int end,
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

Color SharedOcclusion::mean_near(const SharedSample& sample, int place) const {
  Sums sums;
  const int row = row_of(sample), column = column_of(sample);
  // At the tile's rim, less: means would shift into the tile.
  const int reach = sample.part == floor_part
                        ? std::clamp(std::min(row, rows - 1 - row), 1, near_floor_rows)
                        : near_rows;
  const int first_column = std::max(column - near_columns, 0);
  const int last_column = std::min(column + near_columns, columns - 1);
  for (int y = std::max(row - reach, 0); y <= std::min(row + reach, rows - 1); ++y)
    add_near(lists_, place, first_[static_cast<std::size_t>(y * columns + first_column)],
             first_[static_cast<std::size_t>(y * columns + last_column) + 1], sums);
  const float weights = sum_of(sums.weight);
  // A normal that is no number counts nowhere, not even here.
  if (!(weights > 0.0f)) return sample.occluded;
  return Color{sum_of(sums.red), sum_of(sums.green), sum_of(sums.blue)} / weights;
}

void SharedOcclusion::subtract() {
  make_lists();
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const SharedSample& shared = samples_[i];
    const Sample& sample = shared.sample;
    const Color lacking = mean_near(shared, places_[i]);
    if (shared.part != floor_part) {
      add_light(sample, &Pixel::figure, -(shared.albedo * lacking));
      continue;
    }
    sample.pixel->set -= sample.weight * sample.pixel->floor_albedo * lacking;
    if (sample.partner != nullptr)
      sample.partner->set -= sample.partner_weight * sample.partner->floor_albedo * lacking;
  }
}

}  // namespace mien::render
