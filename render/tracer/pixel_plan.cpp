#include "render/tracer/pixel_plan.h"

#include <algorithm>
#include <cmath>

#include "render/light/sky_cone.h"
#include "render/math/constants.h"
#include "render/math/for_avx2.h"

namespace mien::render {
namespace {

/// The floor that a part of the image shows, and a margin around it. The slope of rays is linear on
/// the image, so the rays through its corners decide.
struct FloorInView {
  bool any = false;               ///< whether there may be any
  std::optional<FloorArea> area;  ///< its bounding box; nothing when it extends to the horizon
  float steepest = -infinity;     ///< greatest y of the rays' directions, which have depth 1
  Vec3 widest = Vec3::Zero();     ///< greatest absolute components of these directions
};

FloorInView floor_in(const CameraFrame& camera, const Window& image, float margin) {
  FloorInView view;
  FloorArea area{infinity, -infinity, infinity, -infinity};
  bool all = true;
  for (const float x :
       {static_cast<float>(image.x) - margin, static_cast<float>(image.x_end()) + margin}) {
    for (const float y :
         {static_cast<float>(image.y) - margin, static_cast<float>(image.y_end()) + margin}) {
      const CameraRay ray = camera.unnormalised_ray(x, y);
      const std::optional<float> distance = distance_to_floor(ray.origin, ray.direction);
      view.any |= distance.has_value();
      all &= distance.has_value();
      if (!distance) continue;
      const Vec3 point = ray.origin + *distance * ray.direction;
      area.x_min = std::min(area.x_min, point.x());
      area.x_max = std::max(area.x_max, point.x());
      area.z_min = std::min(area.z_min, point.z());
      area.z_max = std::max(area.z_max, point.z());
      view.steepest = std::max(view.steepest, ray.direction.y());
      view.widest = view.widest.cwiseMax(ray.direction.cwiseAbs());
    }
  }
  if (all) view.area = area;
  return view;
}

/// Largest distance of the floor shown by a pixel's samples, which lie within `reach` pixels, from
/// that at its centre, for all pixels of a part of the image that shows no horizon. The floor is at
/// o + t·d with t = −o.y / d.y, and o and d are linear on the image, so the derivatives are bounded
/// by those at the corners.
FloorPlace floor_reach(const CameraFrame& camera, const FloorInView& view, float reach) {
  const float distance = camera.parallel ? 1.0f : camera.position.y() / -view.steepest;
  const Vec3 slope = view.widest / -view.steepest;
  FloorPlace floor{0.0f, 0.0f};
  for (const Vec3& step : {camera.step_right, camera.step_down}) {
    const float drop = std::abs(step.y());
    floor.x += reach * distance * (std::abs(step.x()) + drop * slope.x());
    floor.z += reach * distance * (std::abs(step.z()) + drop * slope.z());
  }
  return floor;
}

/// Writes the radiance less the occluded sky light of the pixels [first, end) of a row, whose floor
/// is in one cell.
MIEN_FOR_AVX2_TOO void show_cell(const StaticBackground& background, const FloorRow& floor_row,
                                 const FloorSky::Cell& cell, int y, int first, int end,
                                 const Canvas& canvas) {
  constexpr int at_once = 32;
  const FloorRow row = floor_row;
  const float x = cell.x, z = cell.z, inverse_side = cell.inverse_side;
  for (int begin = first; begin < end; begin += at_once) {
    const int count = std::min(at_once, end - begin);
    float right[at_once], far[at_once];
#pragma omp simd
    for (int i = 0; i < count; ++i) {
      const FloorPlace place = row.at(begin + i);
      right[i] = (place.x - x) * inverse_side;
      far[i] = (place.z - z) * inverse_side;
    }
    for (int c = 0; c < 3; ++c) {
      const float at_corner = cell.at_corner[c], along_x = cell.along_x[c];
      const float along_z = cell.along_z[c], along_both = cell.along_both[c];
      const float *radiance = background.radiance.at(begin, y) + c,
                  *albedo = background.albedo.at(begin, y) + c;
      float* shown = canvas.color(begin, y) + c;
#pragma omp simd
      for (int i = 0; i < count; ++i)
        shown[3 * i] =
            radiance[3 * i] - albedo[3 * i] * (at_corner + right[i] * along_x +
                                               far[i] * (along_z + right[i] * along_both));
    }
  }
}

/// Where the pixels of a row end that lie in the cell of the first, at column `end` at the latest.
/// A row shows a straight line of the floor, and cells are convex, as is the floor: where two
/// pixels lie in a cell so do all between.
int end_of_cell(const StaticBackground& background, const FloorRow& row, const FloorSky::Cell& cell,
                int first, int y, int end) {
  const auto inside = [&](int column) {
    const FloorPlace place = row.at(column);
    return cell.holds(place.x, place.z) && background.shows_floor(column, y);
  };
  int last = first;
  if (!row.is_in_order()) {
    while (last + 1 < end && inside(last + 1)) ++last;
    return last + 1;
  }
  int step = 1;
  while (last + step < end && inside(last + step)) {
    last += step;
    step *= 2;
  }
  for (; step > 0; step /= 2)
    if (last + step < end && inside(last + step)) last += step;
  return last + 1;
}

constexpr int run_pixels = 8;  // planned at once

}  // namespace

void PixelPlanner::begin_tile(const Window& tile) {
  tile_ = tile;
  const bool whole = prepared_.quality.exhaustive;
  const float margin = prepared_.filter.half_width();
  const FloorInView floor = floor_in(prepared_.camera, tile, margin);
  tile_lights_ = 0;
  for (std::size_t i = 0; i < prepared_.shadow_masks.size(); ++i) {
    const ShadowMask& mask = prepared_.shadow_masks[i];
    if (!asks_all_lights_ && (floor.area ? !mask.may_shade(*floor.area) : !floor.any)) continue;
    tile_lights_ |= 1u << i;
  }
  floor_reach_.reset();
  if (tile_lights_ != 0 && floor.area) floor_reach_ = floor_reach(prepared_.camera, floor, margin);
  figure_rows_ = 0;
  for (int y = tile.y; y < tile.y_end(); ++y)
    if (whole || prepared_.pixel_mask.may_intersect_row(tile.x, tile.x_end(), y))
      figure_rows_ |= 1u << (y - tile.y);
  shows_background_only_ =
      tile_lights_ == 0 && figure_rows_ == 0 && !per_sample_ && !prepared_.static_solids;
}

// The lights of eight pixels are looked up at once if both ends show the floor, because a row shows
// a straight line of it.
const std::array<PixelPlan, tile_size>& PixelPlanner::plan_row(int y) {
  const bool figure_exists = prepared_.bounds.radius >= 0.0f;
  const StaticBackground& background = prepared_.background;
  for (int begin = tile_.x; begin < tile_.x_end(); begin += run_pixels) {
    const int end = std::min(begin + run_pixels, tile_.x_end());
    const bool together = background.shows_floor(begin, y) && background.shows_floor(end - 1, y);
    std::uint32_t lights = 0;
    if (figure_exists && tile_lights_ != 0 && together) lights = shadow_lights(begin, end - 1, y);
    for (int x = begin; x < end; ++x) {
      if (figure_exists && tile_lights_ != 0 && !together)
        lights = background.shows_floor(x, y) ? shadow_lights(x, x, y) : 0;
      plans_[static_cast<std::size_t>(x - tile_.x)] = plan(x, y, lights);
    }
  }
  return plans_;
}

PixelPlan PixelPlanner::plan(int x, int y, std::uint32_t lights) const {
  const bool solid =
      prepared_.static_solids != nullptr && prepared_.background.may_show_solid(x, y);
  const bool figure = ((figure_rows_ >> (y - tile_.y)) & 1u) != 0 &&
                      (prepared_.quality.exhaustive || prepared_.pixel_mask.may_intersect(x, y));
  if (per_sample_ || (figure && solid)) return {PixelKind::per_sample, 0};
  const bool is_traced = figure || (solid && prepared_.bounds.radius >= 0.0f);
  return {is_traced ? PixelKind::traced : PixelKind::background,
          prepared_.background.shows_floor(x, y) ? lights : 0};
}

// Of the floor that the pixels from `first` to `last` of a row show.
std::uint32_t PixelPlanner::shadow_lights(int first, int last, int y) {
  if (asks_all_lights_ || !floor_reach_) return tile_lights_;
  const FloorRow& row = floor_row(y);
  const FloorPlace from = row.at(first), to = row.at(last);
  const auto [x_min, x_max] = std::minmax(from.x, to.x);
  const auto [z_min, z_max] = std::minmax(from.z, to.z);
  const FloorArea area{x_min - floor_reach_->x, x_max + floor_reach_->x, z_min - floor_reach_->z,
                       z_max + floor_reach_->z};
  std::uint32_t hidden = 0;
  for (std::size_t i = 0; i < prepared_.shadow_masks.size(); ++i)
    if (((tile_lights_ >> i) & 1u) != 0 && prepared_.shadow_masks[i].may_shade(area))
      hidden |= 1u << i;
  return hidden;
}

void PixelPlanner::write_background(const Window& band, const Canvas& canvas,
                                    std::vector<std::uint8_t>& is_known) {
  const StaticBackground& background = prepared_.background;
  for (int y = band.y; y < band.y_end(); ++y) {
    const FloorRow& row = floor_row(y);
    for (int x = band.x; x < band.x_end();) {
      const int first = x;
      const bool floor = background.shows_floor(first, y);
      const FloorPlace place = row.at(first);
      if (floor && !cell_->holds(place.x, place.z))
        cell_ = &prepared_.floor_sky.cell_at(place.x, place.z);
      if (floor && !cell_->known) {
        is_known[static_cast<std::size_t>((first - band.x) / tile_size)] = 0;
        ++x;
      } else if (!floor || cell_->inverse_side == 0.0f) {
        do ++x;
        while (x < band.x_end() && !background.shows_floor(x, y));
        std::copy_n(background.radiance.at(first, y), 3 * (x - first), canvas.color(first, y));
      } else {
        x = end_of_cell(background, row, *cell_, first, y, band.x_end());
        show_cell(background, row, *cell_, y, first, x, canvas);
      }
    }
  }
}

const FloorRow& PixelPlanner::floor_row(int y) {
  if (y != row_number_) {
    row_ = FloorRow(prepared_.background.camera, y);
    row_number_ = y;
  }
  return row_;
}

std::optional<Color> PixelPlanner::background_at(int x, int y) {
  const StaticBackground& background = prepared_.background;
  const Color radiance = Eigen::Map<const Color>(background.radiance.at(x, y));
  if (!background.shows_floor(x, y)) return radiance;
  const FloorPlace place = floor_row(y).at(x);
  if (!cell_->holds(place.x, place.z)) cell_ = &prepared_.floor_sky.cell_at(place.x, place.z);
  if (!cell_->known) return std::nullopt;
  if (cell_->inverse_side == 0.0f) return radiance;
  return radiance - background.floor_albedo(x, y) * cell_->hidden(place.x, place.z);
}

SkyRays PixelPlanner::floor_sky_rays(int x, int y) {
  if (prepared_.bounds.radius < 0.0f) return {};
  const FloorPlace place = floor_row(y).at(x);
  return sky_rays_of(prepared_.bounds, {place.x, 0.0f, place.z}, Vec3::UnitY(),
                     prepared_.quality.samples_per_pixel, prepared_.sampler.for_pixel(x, y));
}

}  // namespace mien::render
