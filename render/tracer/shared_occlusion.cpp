#include "render/tracer/shared_occlusion.h"

#include <algorithm>
#include <optional>

#include "render/math/for_avx2.h"

namespace mien::render {
namespace {

/// In an order that is the same on every machine.
float sum_of(const LaneFloats& values) {
  const float* v = values.lane;
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

}  // namespace

void SharedOcclusion::set_row(int number, std::span<const Found> found) {
  const auto place = static_cast<std::size_t>(number);
  std::vector<Found> of_floor, of_figure;
  for (const Found& one : found) (one.part == floor_part ? of_floor : of_figure).push_back(one);
  if (!of_floor.empty()) set_floor_row(of_floor, floor_rows_[place]);
  if (!of_figure.empty()) set_figure_row(of_figure, rows_[place]);
}

void SharedOcclusion::set_floor_row(std::span<const Found> found, FloorRow& row) {
  row.begin = found.front().x;
  row.columns = found.back().x - row.begin + 1;
  for (auto* list : {&row.red, &row.green, &row.blue, &row.samples})
    list->resize(static_cast<std::size_t>(row.columns) + lanes);
  for (const Found& one : found) {
    const auto column = static_cast<std::size_t>(one.x - row.begin);
    row.red[column] += one.occluded[0];
    row.green[column] += one.occluded[1];
    row.blue[column] += one.occluded[2];
    row.samples[column] += 1.0f;
  }
}

void SharedOcclusion::set_figure_row(std::span<const Found> found, Row& row) {
  const std::size_t size = found.size() + lanes;  // at most
  row.values.resize(Row::lists * size);
  row.parts.resize(size);
  row.begin = found.front().x;
  row.first.resize(static_cast<std::size_t>(found.back().x - row.begin) + 2);
  std::size_t count = 0, first = 0;  // of the pixel
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Found& one = found[i];
    if (i == 0 || one.x != found[i - 1].x) {
      const int before = i == 0 ? one.x : found[i - 1].x + 1;
      for (int x = before; x <= one.x; ++x)
        row.first[static_cast<std::size_t>(x - row.begin)] = static_cast<int>(count);
      first = count;
    }
    std::size_t entry = first;
    while (entry < count && row.parts[entry] != one.part) ++entry;
    if (entry == count) row.parts[count++] = one.part;
    const float values[Row::lists] = {one.normal.x(),
                                      one.normal.y(),
                                      one.normal.z(),
                                      one.occluded[0],
                                      one.occluded[1],
                                      one.occluded[2],
                                      1.0f};
    for (std::size_t list = 0; list < Row::lists; ++list)
      row.values[list * size + entry] += values[list];
  }
  row.first.back() = static_cast<int>(count);
  float *x = row.values.data(), *y = x + size, *z = y + size;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 normal = Vec3(x[i], y[i], z[i]).normalized();
    x[i] = normal.x();
    y[i] = normal.y();
    z[i] = normal.z();
  }
}

// Weights are 1 for equal normals, and 0 from 60° on. Sums have eight parts, so that they are the
// same on every machine.
[[gnu::always_inline]] inline void SharedOcclusion::add(const Neighbours& near, Sums& sums) {
  const float x = near.normal.x(), y = near.normal.y(), z = near.normal.z();
  const float offset = near.offset;
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
      const float above = 2.0f * (x * nx[i] + y * ny[i] + z * nz[i]) + offset;
      const bool counts = (i < count) & (parts[i] == part) & (above > 0.0f);
      const float weight = counts ? above * above : 0.0f;
      sums.red.lane[i] += weight * red[i];
      sums.green.lane[i] += weight * green[i];
      sums.blue.lane[i] += weight * blue[i];
      sums.samples.lane[i] += weight * samples[i];
    }
  }
}

std::optional<Color> SharedOcclusion::mean_of(const Sums& sums) {
  const float samples = sum_of(sums.samples);
  if (!(samples > 0.0f)) return std::nullopt;
  return Color{sum_of(sums.red), sum_of(sums.green), sum_of(sums.blue)} / samples;
}

MIEN_FOR_AVX2_TOO Color SharedOcclusion::on_floor(int x, int y) const {
  Sums sums;
  const int last_row = std::min(y + floor_reach_, static_cast<int>(floor_rows_.size()) - 1);
  for (int number = std::max(y - floor_reach_, 0); number <= last_row; ++number) {
    const FloorRow& row = floor_rows_[static_cast<std::size_t>(number)];
    const int begin = std::max(x - floor_reach_ - row.begin, 0);
    const int end = std::min(x + floor_reach_ + 1 - row.begin, row.columns);
    for (int column = begin; column < end; column += static_cast<int>(lanes)) {
      const float *red = &row.red[static_cast<std::size_t>(column)],
                  *green = &row.green[static_cast<std::size_t>(column)],
                  *blue = &row.blue[static_cast<std::size_t>(column)],
                  *samples = &row.samples[static_cast<std::size_t>(column)];
      const int count = end - column;
#pragma omp simd
      for (int i = 0; i < static_cast<int>(lanes); ++i) {
        const float weight = i < count ? 1.0f : 0.0f;
        sums.red.lane[i] += weight * red[i];
        sums.green.lane[i] += weight * green[i];
        sums.blue.lane[i] += weight * blue[i];
        sums.samples.lane[i] += weight * samples[i];
      }
    }
  }
  return mean_of(sums).value_or(Color::Zero());
}

MIEN_FOR_AVX2_TOO Color SharedOcclusion::on_figure(int x, int y, int part,
                                                   const Vec3& normal) const {
  const int reach = figure_reach_;
  const int last_row = std::min(y + reach, static_cast<int>(rows_.size()) - 1);
  const auto mean = [&](const Vec3& direction, float offset) -> std::optional<Color> {
    Sums sums;
    for (int number = std::max(y - reach, 0); number <= last_row; ++number) {
      const Row& row = rows_[static_cast<std::size_t>(number)];
      if (row.first.empty()) continue;
      const int last = static_cast<int>(row.first.size()) - 1;
      const int column = x - row.begin;
      const auto from = static_cast<std::size_t>(std::clamp(column - reach, 0, last));
      const auto to = static_cast<std::size_t>(std::clamp(column + reach + 1, 0, last));
      if (row.first[from] < row.first[to])
        add({row, row.first[from], row.first[to], part, direction, offset}, sums);
    }
    return mean_of(sums);
  };
  if (const auto alike = mean(normal.normalized(), -1.0f)) return *alike;
  return mean(Vec3::Zero(), 1.0f).value_or(Color::Zero());
}

}  // namespace mien::render
