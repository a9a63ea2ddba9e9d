#include "render/tracer/pixel_plan.h"

#include <algorithm>
#include <cmath>
#include <cstring>
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

/// Whether a part of the film shows no floor: how steep rays fall is linear on it, so the corners
/// tell.
bool is_above_horizon(const CameraFrame& camera, const FilmArea& film) {
  for (const float x : {film.x_min, film.x_max}) {
    for (const float y : {film.y_min, film.y_max}) {
      const EyeRay ray = camera.line_through(x, y);
      if (distance_to_floor(ray.origin, ray.direction)) return false;
    }
  }
  return true;
}

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

/// Eight numbers of the compiler's, with which it needs no gathering.
using Octet = float __attribute__((vector_size(32), aligned(4)));
using Places = int __attribute__((vector_size(32)));

/// The numbers of eight pixels, each three times: for eight of the 24 channels, from the first, the
/// second or the third eight on.
constexpr Places thrice[3] = {
    {0, 0, 0, 1, 1, 1, 2, 2}, {2, 3, 3, 3, 4, 4, 4, 5}, {5, 5, 6, 6, 6, 7, 7, 7}};

/// The hidden light of a cell for each of those channels.
struct CellLight {
  Octet at_corner[3];
  Octet along_x[3];
  Octet along_z[3];
  Octet along_both[3];
};

/// Shows the pixels first … end − 1, whose floor lies in one cell, less the sky that is hidden
/// there: writes their channels from `out` on.
MIEN_FOR_AVX2_TOO void show_cell(const StandingSet& set, const FloorSky::Cell& cell,
                                 std::size_t first, std::size_t end, float* out) {
  const float x = cell.x, z = cell.z, inverse_side = cell.inverse_side;
  const float *floor_x = set.floor_x.data() + first, *floor_z = set.floor_z.data() + first;
  const float* radiance = set.radiance.channels.data() + 3 * first;
  const float* albedo = set.floor_albedo.channels.data() + 3 * first;
  CellLight light;
  for (int part = 0; part < 3; ++part) {
    for (int i = 0; i < 8; ++i) {
      const int c = (8 * part + i) % 3;
      light.at_corner[part][i] = cell.at_corner[c];
      light.along_x[part][i] = cell.along_x[c];
      light.along_z[part][i] = cell.along_z[c];
      light.along_both[part][i] = cell.along_both[c];
    }
  }
  const std::size_t count = end - first;
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    Octet px, pz;
    std::memcpy(&px, floor_x + i, sizeof px);
    std::memcpy(&pz, floor_z + i, sizeof pz);
    const Octet along = (px - x) * inverse_side, across = (pz - z) * inverse_side;
    for (int part = 0; part < 3; ++part) {
      const Octet u = __builtin_shuffle(along, thrice[part]);
      const Octet v = __builtin_shuffle(across, thrice[part]);
      const std::size_t place = 3 * i + 8 * static_cast<std::size_t>(part);
      Octet lit, of_light;
      std::memcpy(&lit, radiance + place, sizeof lit);
      std::memcpy(&of_light, albedo + place, sizeof of_light);
      lit -= of_light * (light.at_corner[part] + u * light.along_x[part] +
                         v * (light.along_z[part] + u * light.along_both[part]));
      std::memcpy(out + place, &lit, sizeof lit);
    }
  }
  for (; i < count; ++i) {
    const float u = (floor_x[i] - x) * inverse_side, v = (floor_z[i] - z) * inverse_side;
    for (int c = 0; c < 3; ++c) {
      const std::size_t place = 3 * i + static_cast<std::size_t>(c);
      out[place] =
          radiance[place] - albedo[place] * (cell.at_corner[c] + u * cell.along_x[c] +
                                             v * (cell.along_z[c] + u * cell.along_both[c]));
    }
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

constexpr int together = 8;  // pixels of a row

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
  const bool no_floor = !area && is_above_horizon(picture_.camera, film);
  tile_lights_ = 0;
  shaded_everywhere_ = true;
  for (std::size_t i = 0; i < picture_.shadow_masks.size(); ++i) {
    const ShadowMask& mask = picture_.shadow_masks[i];
    if (!whole && (area ? !mask.may_shade(*area) : no_floor)) continue;
    tile_lights_ |= 1u << i;
    shaded_everywhere_ &= area && mask.may_shade_all(*area);
  }
  find_casters(tile, area);
  // What a pixel's neighbour shows may stand for what it shows itself.
  stretch_ = {};
  const PixelBlock block = block_of(shared_line(lines_, picture_.quality.samples_per_pixel));
  if (tile_lights_ != 0)
    floor_reach_ = floor_reach(picture_.camera, film, margin + static_cast<float>(block.width - 1));
  first_row_ = tile.y_begin;
  figure_rows_ = 0;
  for (int y = tile.y_begin; y < tile.y_end; ++y)
    if (whole || picture_.film_mask.may_meet_row(tile.x_begin, tile.x_end, y))
      figure_rows_ |= 1u << (y - first_row_);
  end_ = tile.x_end;
  is_alone_ = tile_lights_ == 0 && figure_rows_ == 0 && !piecemeal_ && !picture_.walls;
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

void PixelPlanner::show_set(const Tile& band, const Canvas& canvas,
                            std::vector<std::uint8_t>& open) {
  const StandingSet& set = picture_.set;
  for (int y = band.y_begin; y < band.y_end; ++y) {
    const std::size_t begin = set.place_of(band.x_begin, y);
    const std::size_t end = begin + static_cast<std::size_t>(band.x_end - band.x_begin);
    float* const row = canvas.film(band.x_begin, y);
    for (std::size_t place = begin; place < end;) {
      const std::size_t first = place;
      if (set.floor[first] != 0 && !cell_->holds(set.floor_x[first], set.floor_z[first]))
        cell_ = &picture_.floor_sky.cell_at(set.floor_x[first], set.floor_z[first]);
      if (set.floor[first] == 0 || (cell_->known && cell_->inverse_side == 0.0f)) {
        do ++place;
        while (place < end && set.floor[place] == 0);
        std::copy_n(set.radiance.channels.data() + 3 * first, 3 * (place - first),
                    row + 3 * (first - begin));
      } else if (!cell_->known) {
        open[(place - begin) / tile_size] = 1;
        ++place;
      } else {
        place = end_of_cell(set, *cell_, first, end);
        show_cell(set, *cell_, first, place, row + 3 * (first - begin));
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

PixelPlan PixelPlanner::plan(int x, int y) {
  const StandingSet& set = picture_.set;
  const std::size_t place = set.place_of(x, y);
  const bool somebody = picture_.bounds.radius >= 0.0f;
  const bool solid = picture_.walls != nullptr && set.solid[place] != 0;
  const bool figure = ((figure_rows_ >> (y - first_row_)) & 1u) != 0 &&
                      (picture_.quality.exhaustive || picture_.film_mask.may_meet(x, y));
  PixelPlan plan;
  if (piecemeal_ || (figure && solid)) {
    plan.kind = PixelKind::piecemeal;
    return plan;
  }
  if (figure) {
    plan.kind = PixelKind::figure;
  } else if (solid && somebody) {
    plan.kind = PixelKind::wall;
  }
  if (set.floor[place] != 0 && somebody) plan.shadow_lights = shadow_lights(x, y);
  if (plan.kind == PixelKind::untouched && plan.shadow_lights != 0) plan.kind = PixelKind::floor;
  return plan;
}

int PixelPlanner::end_of_untouched(int x, int y) {
  if (piecemeal_ || picture_.walls != nullptr || picture_.quality.exhaustive) return x;
  const bool figure = ((figure_rows_ >> (y - first_row_)) & 1u) != 0;
  if (!figure && tile_lights_ == 0) return end_;
  while (x < end_ && x % together == 0) {
    const int end = std::min(x + together, end_);
    if (figure && picture_.film_mask.may_meet_row(x, end, y)) break;
    if (tile_lights_ != 0 && !is_lit(x, end, y)) break;
    x = end;
  }
  return x;
}

bool PixelPlanner::is_lit(int x, int end, int y) {
  const std::vector<std::uint8_t>& floor = picture_.set.floor;
  const std::size_t first = picture_.set.place_of(x, y), last = picture_.set.place_of(end - 1, y);
  return floor[first] != 0 && floor[last] != 0 && shadow_lights(x, y) == 0;
}

// Looked up for eight pixels at once where both ends show the floor: a row shows a straight line of
// it.
std::uint32_t PixelPlanner::shadow_lights(int x, int y) {
  if (shaded_everywhere_ || picture_.quality.exhaustive || !floor_reach_) return tile_lights_;
  const StandingSet& set = picture_.set;
  const std::size_t place = set.place_of(x, y);
  if (place >= stretch_.first && place < stretch_.end) return stretch_.lights;
  const int begin = x / together * together;
  const int end = std::min(begin + together, end_);
  stretch_ = {set.place_of(begin, y), set.place_of(end, y)};
  if (set.floor[stretch_.first] == 0 || set.floor[stretch_.end - 1] == 0)
    stretch_ = {place, place + 1};
  stretch_.lights = lights_hidden_in(stretch_.first, stretch_.end - 1);
  return stretch_.lights;
}

std::uint32_t PixelPlanner::lights_hidden_in(std::size_t first, std::size_t last) const {
  const auto [x_min, x_max] = std::minmax(picture_.set.floor_x[first], picture_.set.floor_x[last]);
  const auto [z_min, z_max] = std::minmax(picture_.set.floor_z[first], picture_.set.floor_z[last]);
  const FloorArea area{x_min - floor_reach_->x, x_max + floor_reach_->x, z_min - floor_reach_->z,
                       z_max + floor_reach_->z};
  std::uint32_t hidden = 0;
  for (std::size_t i = 0; i < picture_.shadow_masks.size(); ++i)
    if (((tile_lights_ >> i) & 1u) != 0 && picture_.shadow_masks[i].may_shade(area))
      hidden |= 1u << i;
  return hidden;
}

FloorPixel PixelPlanner::floor_pixel(int x, int y, const PixelPlan& plan,
                                     const Color& radiance) const {
  return {.x = x,
          .y = y,
          .shadow_lights = plan.shadow_lights,
          .radiance = radiance,
          .floor_albedo = Eigen::Map<const Color>(picture_.set.floor_albedo.at(x, y))};
}

void PixelPlanner::set_out(Pixel& pixel, int x, int y, const PixelPlan& plan,
                           const SetLight& set_light) const {
  const StandingSet& set = picture_.set;
  const std::size_t place = set.place_of(x, y);
  pixel.x = x;
  pixel.y = y;
  pixel.kind = plan.kind;
  pixel.sampler = picture_.sampler.of_neighbour(x, y);
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
