#include "render/pixel_plan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "render/floor.h"
#include "render/sky_cone.h"

namespace mien::render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct FilmArea {
  float x_min;
  float x_max;
  float y_min;
  float y_max;
};

// Box around the floor that a part of the film shows; nothing when that goes on to the horizon.
std::optional<FloorArea> floor_under(const CameraFrame& camera, const FilmArea& film) {
  FloorArea area{infinity, -infinity, infinity, -infinity};
  for (const float x : {film.x_min, film.x_max}) {
    for (const float y : {film.y_min, film.y_max}) {
      const EyeRay ray = camera.line_through(x, y);
      const std::optional<float> distance = distance_to_floor(ray.origin, ray.direction);
      if (!distance) return std::nullopt;
      const Vec3 point = ray.origin + *distance * ray.direction;
      area.x_min = std::min(area.x_min, point.x());
      area.x_max = std::max(area.x_max, point.x());
      area.z_min = std::min(area.z_min, point.z());
      area.z_max = std::max(area.z_max, point.z());
    }
  }
  return area;
}

/// Shows the pixels first … end − 1, whose floor lies in one cell, less the sky that is hidden
/// there.
void show_cell(const StandingSet& set, const FloorSky::Cell& given, std::size_t first,
               std::size_t end, Film& film) {
  const FloorSky::Cell cell = given;  // a copy: the compiler knows that no pixel changes it
  for (std::size_t place = first; place < end; ++place) {
    const float u = (set.floor_x[place] - cell.x) * cell.inverse_side;
    const float v = (set.floor_z[place] - cell.z) * cell.inverse_side;
    const float* radiance = set.radiance.channels.data() + 3 * place;
    const float* albedo = set.floor_albedo.channels.data() + 3 * place;
    float* out = film.channels.data() + 3 * place;
    for (int c = 0; c < 3; ++c) {
      const float hidden =
          cell.at_corner[c] + u * cell.along_x[c] + v * (cell.along_z[c] + u * cell.along_both[c]);
      out[c] = radiance[c] - albedo[c] * hidden;
    }
  }
}

}  // namespace

void PixelPlanner::turn_to(const Tile& tile) {
  const bool whole = picture_.quality.exhaustive;
  const float margin = picture_.filter.half_width();
  const std::optional<FloorArea> area = floor_under(
      picture_.camera,
      {static_cast<float>(tile.x_begin) - margin, static_cast<float>(tile.x_end) + margin,
       static_cast<float>(tile.y_begin) - margin, static_cast<float>(tile.y_end) + margin});
  tile_lights_ = 0;
  for (std::size_t i = 0; i < picture_.shadow_masks.size(); ++i)
    if (whole || !area || picture_.shadow_masks[i].may_shade(*area)) tile_lights_ |= 1u << i;
  is_alone_ = tile_lights_ == 0 && !whole && !picture_.piecemeal() && !picture_.set.solids;
  for (int y = tile.y_begin; y < tile.y_end && is_alone_; ++y)
    is_alone_ = !picture_.film_mask.may_meet_row(tile.x_begin, tile.x_end, y);
}

bool PixelPlanner::show_alone(const Tile& tile, Film& film) {
  const StandingSet& set = picture_.set;
  for (int y = tile.y_begin; y < tile.y_end; ++y) {
    const std::size_t end =
        set.place_of(tile.x_begin, y) + static_cast<std::size_t>(tile.x_end - tile.x_begin);
    for (std::size_t place = set.place_of(tile.x_begin, y); place < end;) {
      const std::size_t first = place;
      if (set.floor[first] != 0 && !cell_->holds(set.floor_x[first], set.floor_z[first]))
        cell_ = &picture_.floor_sky.cell_at(set.floor_x[first], set.floor_z[first]);
      if (set.floor[first] == 0 || (cell_->known && cell_->inverse_side == 0.0f)) {
        std::copy_n(set.radiance.channels.data() + 3 * first, 3, film.channels.data() + 3 * first);
        ++place;
        continue;
      }
      if (!cell_->known) return false;
      do ++place;
      while (place < end && set.floor[place] != 0 &&
             cell_->holds(set.floor_x[place], set.floor_z[place]));
      show_cell(set, *cell_, first, place, film);
    }
  }
  return true;
}

SetLight PixelPlanner::set_at(int x, int y) {
  const StandingSet& set = picture_.set;
  const std::size_t place = set.place_of(x, y);
  const Color radiance = Eigen::Map<const Color>(set.radiance.channels.data() + 3 * place);
  if (set.floor[place] == 0) return {radiance, true};
  const float floor_x = set.floor_x[place], floor_z = set.floor_z[place];
  if (!cell_->holds(floor_x, floor_z)) cell_ = &picture_.floor_sky.cell_at(floor_x, floor_z);
  if (!cell_->known || cell_->inverse_side == 0.0f) return {radiance, cell_->known};
  const Color albedo = Eigen::Map<const Color>(set.floor_albedo.channels.data() + 3 * place);
  return {radiance - albedo * cell_->hidden(floor_x, floor_z), true};
}

void PixelPlanner::plan(Pixel& pixel, int x, int y, const SetLight& set_light) const {
  const StandingSet& set = picture_.set;
  const std::size_t place = set.place_of(x, y);
  pixel.x = x;
  pixel.y = y;
  pixel.radiance = set_light.radiance;
  pixel.floor_albedo = Eigen::Map<const Color>(set.floor_albedo.at(x, y));
  pixel.shows_floor = set.floor[place] != 0;
  pixel.sampler = PixelSampler(picture_.quality.seed, x, y);
  const bool somebody = picture_.bounds.radius >= 0.0f;
  const bool solid = set.solid[place] != 0;
  const bool figure = picture_.quality.exhaustive || picture_.film_mask.may_meet(x, y);
  if (picture_.piecemeal() || (figure && solid)) {
    pixel.kind = PixelKind::piecemeal;
  } else if (figure) {
    pixel.kind = PixelKind::figure;
  } else if (solid && somebody) {
    pixel.kind = PixelKind::wall;
  }
  if (pixel.shows_floor && somebody && pixel.kind != PixelKind::piecemeal)
    plan_floor(pixel, {set.floor_x[place], 0.0f, set.floor_z[place]}, set_light.complete);
  if (pixel.kind == PixelKind::untouched && pixel.shadow_lights != 0) pixel.kind = PixelKind::floor;
  if (pixel.kind == PixelKind::untouched || pixel.kind == PixelKind::floor)
    pixel.set_samples = picture_.quality.samples_per_pixel;
}

void PixelPlanner::plan_floor(Pixel& pixel, const Vec3& point, bool sky_is_known) const {
  if (!sky_is_known) plan_floor_sky(pixel, point);
  if (tile_lights_ == 0) return;
  const float reach = picture_.filter.half_width();
  const auto x = static_cast<float>(pixel.x) + 0.5f, y = static_cast<float>(pixel.y) + 0.5f;
  const std::optional<FloorArea> area =
      floor_under(picture_.camera, {x - reach, x + reach, y - reach, y + reach});
  for (std::size_t i = 0; i < picture_.shadow_masks.size(); ++i)
    if (((tile_lights_ >> i) & 1u) != 0 &&
        (picture_.quality.exhaustive || !area || picture_.shadow_masks[i].may_shade(*area)))
      pixel.shadow_lights |= 1u << i;
}

void PixelPlanner::plan_floor_sky(Pixel& pixel, const Vec3& point) const {
  const int spp = picture_.quality.samples_per_pixel;
  const float wanted = sky_rays_from(picture_.bounds, point, spp);
  const auto all = static_cast<float>(spp);
  if (wanted < 1.0f) {
    const bool chosen = pixel.sampler.point(Dimension::FloorSkyChoice, 0).u < wanted;
    pixel.floor_sky_rays = chosen ? 1 : 0;
    pixel.floor_sky_samples = all / wanted;
    return;
  }
  // A power of two: such a block of the sequence is well spread.
  const auto rays = static_cast<unsigned>(std::ceil(wanted));
  pixel.floor_sky_rays = std::min(static_cast<int>(std::bit_ceil(rays)), spp);
  pixel.floor_sky_samples = all / static_cast<float>(pixel.floor_sky_rays);
}

}  // namespace mien::render
