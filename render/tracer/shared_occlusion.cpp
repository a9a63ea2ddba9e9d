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

void SharedOcclusion::set_floor_row(int number, std::span<const Found> found) {
  if (found.empty()) return;
  FloorSamples& row = floor_rows_[static_cast<std::size_t>(number)];
  row.begin = found.front().x;
  row.columns.assign(static_cast<std::size_t>(found.back().x - row.begin) + 1,
                     Eigen::Array4f::Zero());
  for (const Found& one : found)
    row.columns[static_cast<std::size_t>(one.x - row.begin)] +=
        Eigen::Array4f(one.occluded[0], one.occluded[1], one.occluded[2], 1.0f);
}

void SharedOcclusion::set_figure_row(int number, std::span<const Found> found) {
  if (found.empty()) return;
  FigureSamples& row = figure_rows_[static_cast<std::size_t>(number)];
  const std::size_t size = found.size() + lanes;  // at most
  row.values.resize(FigureSamples::lists * size);
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
    const Color share = (one.light > 0.0f).select(one.occluded / one.light, 0.0f);
    const float light = one.light.mean();
    const float values[FigureSamples::lists] = {
        one.normal.x(),   one.normal.y(),   one.normal.z(), light * share[0],
        light * share[1], light * share[2], light};
    for (std::size_t list = 0; list < FigureSamples::lists; ++list)
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
[[gnu::always_inline]] inline void SharedOcclusion::add(const FigureSamples& row, int first,
                                                        int last, const Look& look, Sums& sums) {
  const float x = look.normal.x(), y = look.normal.y(), z = look.normal.z();
  const float offset = look.offset;
  const int part = look.part;
  for (int begin = first; begin < last; begin += static_cast<int>(lanes)) {
    const float *nx = row.at(FigureSamples::normal_x, begin),
                *ny = row.at(FigureSamples::normal_y, begin),
                *nz = row.at(FigureSamples::normal_z, begin),
                *red = row.at(FigureSamples::red, begin),
                *green = row.at(FigureSamples::green, begin),
                *blue = row.at(FigureSamples::blue, begin),
                *light = row.at(FigureSamples::light, begin);
    const int* parts = &row.parts[static_cast<std::size_t>(begin)];
    const int count = last - begin;
#pragma omp simd
    for (int i = 0; i < static_cast<int>(lanes); ++i) {
      const float above = 2.0f * (x * nx[i] + y * ny[i] + z * nz[i]) + offset;
      const bool counts = (i < count) & (parts[i] == part) & (above > 0.0f);
      const float weight = counts ? above * above : 0.0f;
      sums.red.lane[i] += weight * red[i];
      sums.green.lane[i] += weight * green[i];
      sums.blue.lane[i] += weight * blue[i];
      sums.light.lane[i] += weight * light[i];
    }
  }
}

// Pixels without samples add zeros: so sums are the same wherever a row begins.
std::optional<Color> SharedOcclusion::floor_mean(int x, int y, int reach) const {
  Eigen::Array4f sum = Eigen::Array4f::Zero();
  const int last_row = std::min(y + reach, static_cast<int>(floor_rows_.size()) - 1);
  for (int number = std::max(y - reach, 0); number <= last_row; ++number) {
    const FloorSamples& row = floor_rows_[static_cast<std::size_t>(number)];
    const int begin = std::max(x - reach - row.begin, 0);
    const int end = std::min(x + reach + 1 - row.begin, static_cast<int>(row.columns.size()));
    for (int column = begin; column < end; ++column)
      sum += row.columns[static_cast<std::size_t>(column)];
  }
  if (!(sum[3] > 0.0f)) return std::nullopt;
  return Color(sum.head<3>() / sum[3]);
}

Color SharedOcclusion::on_floor(int x, int y) const {
  if (const auto near = floor_mean(x, y, floor_reach_)) return *near;
  return floor_mean(x, y, 2 * floor_reach_).value_or(Color::Zero());
}

MIEN_FOR_AVX2_TOO std::optional<Color> SharedOcclusion::figure_mean(int x, int y, int reach,
                                                                    const Look& look) const {
  Sums sums;
  const int last_row = std::min(y + reach, static_cast<int>(figure_rows_.size()) - 1);
  for (int number = std::max(y - reach, 0); number <= last_row; ++number) {
    const FigureSamples& row = figure_rows_[static_cast<std::size_t>(number)];
    if (row.first.empty()) continue;
    const int last = static_cast<int>(row.first.size()) - 1;
    const int column = x - row.begin;
    const auto from = static_cast<std::size_t>(std::clamp(column - reach, 0, last));
    const auto to = static_cast<std::size_t>(std::clamp(column + reach + 1, 0, last));
    if (row.first[from] < row.first[to]) add(row, row.first[from], row.first[to], look, sums);
  }
  const float light = sum_of(sums.light);
  if (!(light > 0.0f)) return std::nullopt;
  return Color{sum_of(sums.red), sum_of(sums.green), sum_of(sums.blue)} / light;
}

Color SharedOcclusion::on_figure(int x, int y, int part, const Vec3& normal) const {
  const Look alike{part, normal.normalized(), -1.0f}, any{part, Vec3::Zero(), 1.0f};
  if (const auto found = figure_mean(x, y, figure_reach_, alike)) return *found;
  if (const auto found = figure_mean(x, y, figure_reach_, any)) return *found;
  return figure_mean(x, y, 2 * figure_reach_, any).value_or(Color::Zero());
}

}  // namespace mien::render
