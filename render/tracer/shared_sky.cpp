#include "render/tracer/shared_sky.h"

#include <algorithm>

namespace mien::render {
namespace {

constexpr int near_rows = 3;
constexpr int near_columns = 1;

/// 1 for equal normals, 0 from 60° on and for what is no normal.
float likeness(const Vec3& a, const Vec3& b) {
  const float above = std::max(0.0f, 2.0f * a.dot(b) - 1.0f);
  return above * above;
}

/// The number of samples that a shaded one represents.
float represented(const Sample& sample) { return sample.weight + sample.partner_weight; }

}  // namespace

void SharedSky::begin_tile(const Tile& tile) {
  x_begin_ = tile.x_begin;
  y_begin_ = tile.y_begin;
  samples_.clear();
  first_.fill(-1);
}

int SharedSky::add(const Sample& sample, const Surface& surface) {
  const int row = sample.pixel->y - y_begin_, column = (sample.pixel->x - x_begin_) / 2;
  const auto number = static_cast<int>(samples_.size());
  int& first = first_[static_cast<std::size_t>(row * columns + column)];
  samples_.push_back(
      {sample, surface.normal, surface.albedo, Color::Zero(), surface.part, row, column, first});
  first = number;
  return number;
}

Color SharedSky::mean_near(const SkySample& here) const {
  float weights = represented(here.sample);
  Color sum = weights * here.occluded;
  const int last_row = std::min(here.row + near_rows, rows - 1);
  const int last_column = std::min(here.column + near_columns, columns - 1);
  for (int row = std::max(here.row - near_rows, 0); row <= last_row; ++row) {
    for (int column = std::max(here.column - near_columns, 0); column <= last_column; ++column) {
      int number = first_[static_cast<std::size_t>(row * columns + column)];
      while (number >= 0) {
        const SkySample& other = samples_[static_cast<std::size_t>(number)];
        number = other.next;
        if (other.part != here.part || &other == &here) continue;
        const float weight = represented(other.sample) * likeness(other.normal, here.normal);
        if (!(weight > 0.0f)) continue;
        sum += weight * other.occluded;
        weights += weight;
      }
    }
  }
  return sum / weights;
}

void SharedSky::subtract() const {
  for (const SkySample& each : samples_)
    add_light(each.sample, &Pixel::figure, -(each.albedo * mean_near(each)));
}

}  // namespace mien::render
