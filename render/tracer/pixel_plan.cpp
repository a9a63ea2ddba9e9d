#include "render/tracer/pixel_plan.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/light/floor.h"
#include "render/light/sky_cone.h"
#include "render/math/constants.h"
#include "render/math/for_avx2.h"

namespace mien::render {
namespace {

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

/// How far the floor that samples of a pixel show can be from what its middle shows, for all pixels
/// of a part of the film; `reach` pixels is how far samples go. Nothing where that goes on to the
/// horizon. Floor is seen at o + t·d with t = −o.y / d.y, and o and d are linear on the film, so
/// the derivatives of that are bounded by what the corners show.
std::optional<FloorReach> floor_reach(const CameraFrame& camera, const FilmArea& film,
                                      float reach) {
  float steepest = -infinity;
  Vec3 widest = Vec3::Zero();
  for (const float x : {film.x_min, film.x_max}) {
    for (const float y : {film.y_min, film.y_max}) {
      const EyeRay ray = camera.line_through(x, y);
      if (!distance_to_floor(ray.origin, ray.direction)) return std::nullopt;
      steepest = std::max(steepest, ray.direction.y());
      widest = widest.cwiseMax(ray.direction.cwiseAbs());
    }
  }
  const float distance = camera.parallel ? 1.0f : camera.position.y() / -steepest;
  const Vec3 slope = widest / -steepest;
  FloorReach floor{0.0f, 0.0f};
  for (const Vec3& step : {camera.step_right, camera.step_down}) {
    const float drop = std::abs(step.y());
    floor.x += reach * distance * (std::abs(step.x()) + drop * slope.x());
    floor.z += reach * distance * (std::abs(step.z()) + drop * slope.z());
  }
  return floor;
}

/// Shows the pixels first … end − 1, whose floor lies in one cell, less the sky that is hidden
/// there.
MIEN_FOR_AVX2_TOO void show_cell(const StandingSet& set, const FloorSky::Cell& cell,
                                 std::size_t first, std::size_t end, Film& film) {
  const float x = cell.x, z = cell.z, inverse_side = cell.inverse_side;
  const float a0 = cell.at_corner[0], a1 = cell.at_corner[1], a2 = cell.at_corner[2];
  const float x0 = cell.along_x[0], x1 = cell.along_x[1], x2 = cell.along_x[2];
  const float z0 = cell.along_z[0], z1 = cell.along_z[1], z2 = cell.along_z[2];
  const float b0 = cell.along_both[0], b1 = cell.along_both[1], b2 = cell.along_both[2];
  const float *floor_x = set.floor_x.data() + first, *floor_z = set.floor_z.data() + first;
  const float* radiance = set.radiance.channels.data() + 3 * first;
  const float* albedo = set.floor_albedo.channels.data() + 3 * first;
  float* out = film.channels.data() + 3 * first;
  const std::size_t count = end - first;
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    const float u = (floor_x[i] - x) * inverse_side;
    const float v = (floor_z[i] - z) * inverse_side;
    out[3 * i] = radiance[3 * i] - albedo[3 * i] * (a0 + u * x0 + v * (z0 + u * b0));
    out[3 * i + 1] = radiance[3 * i + 1] - albedo[3 * i + 1] * (a1 + u * x1 + v * (z1 + u * b1));
    out[3 * i + 2] = radiance[3 * i + 2] - albedo[3 * i + 2] * (a2 + u * x2 + v * (z2 + u * b2));
  }
}

/// Where the pixels of a row end that lie in the cell of the first. A row shows a straight line of
/// the floor, and cells are convex, as is the floor: where two pixels lie in a cell so do all
/// between.
std::size_t end_of_cell(const StandingSet& set, const FloorSky::Cell& cell, std::size_t first,
                        std::size_t end) {
  const auto inside = [&](std::size_t place) {
    return set.floor[place] != 0 && cell.holds(set.floor_x[place], set.floor_z[place]);
  };
  std::size_t last = first, step = 1;
  while (last + step < end && inside(last + step)) {
    last += step;
    step *= 2;
  }
  for (; step > 0; step /= 2)
    if (last + step < end && inside(last + step)) last += step;
  return last + 1;
}

/// Metres of floor that a pixel of a tile shows, at most.
float pixel_step(const FloorArea& area, const Tile& tile) {
  const int side = std::max(std::min(tile.x_end - tile.x_begin, tile.y_end - tile.y_begin), 1);
  return std::max(area.x_max - area.x_min, area.z_max - area.z_min) / static_cast<float>(side);
}

/// How wide the half shadow is, metres, that an edge at a height casts on the floor, at least.
float half_shadow(const AreaLight& light, float height) {
  if (height >= light.centre.y()) return infinity;
  const float width = 2.0f * std::min(light.half_u.norm(), light.half_v.norm());
  return width * height / (light.centre.y() - height);
}

}  // namespace

void PixelPlanner::turn_to(const Tile& tile) {
  const bool whole = picture_.quality.exhaustive;
  const float margin = picture_.filter.half_width();
  const FilmArea film{
      static_cast<float>(tile.x_begin) - margin, static_cast<float>(tile.x_end) + margin,
      static_cast<float>(tile.y_begin) - margin, static_cast<float>(tile.y_end) + margin};
  const std::optional<FloorArea> area = floor_under(picture_.camera, film);
  tile_lights_ = 0;
  for (std::size_t i = 0; i < picture_.shadow_masks.size(); ++i)
    if (whole || !area || picture_.shadow_masks[i].may_shade(*area)) tile_lights_ |= 1u << i;
  find_casters(tile, area);
  // What a pixel's neighbour shows may stand for what it shows itself.
  const bool alone = shared_line(lines_, picture_.quality.samples_per_pixel).pixels == 1;
  if (tile_lights_ != 0)
    floor_reach_ = floor_reach(picture_.camera, film, margin + (alone ? 0.0f : 1.0f));
  is_alone_ = tile_lights_ == 0 && !whole && !picture_.piecemeal() && !picture_.walls;
  for (int y = tile.y_begin; y < tile.y_end && is_alone_; ++y)
    is_alone_ = !picture_.film_mask.may_meet_row(tile.x_begin, tile.x_end, y);
}

void PixelPlanner::find_casters(const Tile& tile, const std::optional<FloorArea>& area) {
  lines_.casters.resize(picture_.shadow_masks.size());
  lines_.lights = picture_.line_lights;
  lines_.half_shadow = area ? infinity : 0.0f;
  const float step = area ? pixel_step(*area, tile) : 0.0f;
  for (std::size_t i = 0; i < lines_.casters.size(); ++i) {
    std::vector<int>& casters = lines_.casters[i];
    casters.clear();
    if (((picture_.line_lights >> i) & 1u) == 0) continue;
    if (area && ((tile_lights_ >> i) & 1u) != 0) {
      const float height = picture_.shadow_masks[i].add_casters(*area, casters);
      lines_.half_shadow =
          std::min(lines_.half_shadow, half_shadow(picture_.scene.lights[i], height) / step);
    }
    if (area && !picture_.quality.exhaustive) continue;
    casters.clear();
    const std::vector<RoundCone>& cones = picture_.figure.shapes().cones;
    for (std::size_t cone = 0; cone < cones.size(); ++cone)
      if (!is_behind(picture_.scene.lights[i], cones[cone]))
        casters.push_back(static_cast<int>(cone));
  }
}

void PixelPlanner::show_set(const Tile& band, Film& film, std::vector<std::uint8_t>& open) {
  const StandingSet& set = picture_.set;
  for (int y = band.y_begin; y < band.y_end; ++y) {
    const std::size_t begin = set.place_of(band.x_begin, y);
    const std::size_t end = begin + static_cast<std::size_t>(band.x_end - band.x_begin);
    for (std::size_t place = begin; place < end;) {
      const std::size_t first = place;
      if (set.floor[first] != 0 && !cell_->holds(set.floor_x[first], set.floor_z[first]))
        cell_ = &picture_.floor_sky.cell_at(set.floor_x[first], set.floor_z[first]);
      if (set.floor[first] == 0 || (cell_->known && cell_->inverse_side == 0.0f)) {
        do ++place;
        while (place < end && set.floor[place] == 0);
        std::copy_n(set.radiance.channels.data() + 3 * first, 3 * (place - first),
                    film.channels.data() + 3 * first);
      } else if (!cell_->known) {
        open[(place - begin) / tile_size] = 1;
        ++place;
      } else {
        place = end_of_cell(set, *cell_, first, end);
        show_cell(set, *cell_, first, place, film);
      }
    }
  }
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

PixelPlan PixelPlanner::plan(int x, int y) const {
  const StandingSet& set = picture_.set;
  const std::size_t place = set.place_of(x, y);
  const bool somebody = picture_.bounds.radius >= 0.0f;
  const bool solid = set.solid[place] != 0;
  const bool figure = picture_.quality.exhaustive || picture_.film_mask.may_meet(x, y);
  PixelPlan plan;
  if (picture_.piecemeal() || (figure && solid)) {
    plan.kind = PixelKind::piecemeal;
    return plan;
  }
  if (figure) {
    plan.kind = PixelKind::figure;
  } else if (solid && somebody) {
    plan.kind = PixelKind::wall;
  }
  if (set.floor[place] != 0 && somebody) plan.shadow_lights = shadow_lights(place);
  if (plan.kind == PixelKind::untouched && plan.shadow_lights != 0) plan.kind = PixelKind::floor;
  return plan;
}

std::uint32_t PixelPlanner::shadow_lights(std::size_t place) const {
  if (tile_lights_ == 0 || picture_.quality.exhaustive || !floor_reach_) return tile_lights_;
  const float x = picture_.set.floor_x[place], z = picture_.set.floor_z[place];
  const FloorArea area{x - floor_reach_->x, x + floor_reach_->x, z - floor_reach_->z,
                       z + floor_reach_->z};
  std::uint32_t hidden = 0;
  for (std::size_t i = 0; i < picture_.shadow_masks.size(); ++i)
    if (((tile_lights_ >> i) & 1u) != 0 && picture_.shadow_masks[i].may_shade(area))
      hidden |= 1u << i;
  return hidden;
}

void PixelPlanner::set_out(Pixel& pixel, int x, int y, const PixelPlan& plan,
                           const SetLight& set_light) const {
  const StandingSet& set = picture_.set;
  const std::size_t place = set.place_of(x, y);
  pixel.x = x;
  pixel.y = y;
  pixel.kind = plan.kind;
  pixel.sampler = PixelSampler::among_neighbours(picture_.quality.seed, x, y,
                                                 picture_.quality.samples_per_pixel);
  pixel.radiance = set_light.radiance;
  pixel.floor_albedo = Eigen::Map<const Color>(set.floor_albedo.at(x, y));
  pixel.shows_floor = set.floor[place] != 0;
  pixel.shadow_lights = plan.shadow_lights;
  const bool open = plan.kind == PixelKind::untouched || plan.kind == PixelKind::floor;
  if (open) pixel.set_samples = picture_.quality.samples_per_pixel;
  if (set_light.complete || plan.kind == PixelKind::piecemeal || picture_.bounds.radius < 0.0f)
    return;
  const SkyRays sky = sky_rays_of(picture_.bounds, {set.floor_x[place], 0.0f, set.floor_z[place]},
                                  Vec3::UnitY(), picture_.quality.samples_per_pixel, pixel.sampler);
  pixel.floor_sky_rays = sky.rays;
  pixel.floor_sky_samples = sky.samples;
}

}  // namespace mien::render
