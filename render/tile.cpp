#include "render/tile.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "render/directions.h"
#include "render/floor.h"
#include "render/floor_sky.h"
#include "render/lighting.h"
#include "render/pixel.h"

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
      const EyeRay ray = camera.ray(x, y);
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

Vec3 floor_point(const EyeRay& ray, float distance) {
  Vec3 point = ray.origin + distance * ray.direction;
  point.y() = 0.0f;
  return point;
}

CameraFrame between(const CameraFrame& from, const CameraFrame& to, float time) {
  CameraFrame frame = from;
  frame.position += time * (to.position - from.position);
  frame.forward = (from.forward + time * (to.forward - from.forward)).normalized();
  frame.step_right += time * (to.step_right - from.step_right);
  frame.step_down += time * (to.step_down - from.step_down);
  return frame;
}

float luminance(const Color& color) {
  return 0.2126f * color.x() + 0.7152f * color.y() + 0.0722f * color.z();
}

class TilePainter {
 public:
  explicit TilePainter(const Picture& picture)
      : picture_(picture), cell_(&picture.floor_sky.cell_at(0.0f, 0.0f)), queries_(picture) {}
  void draw(const Tile& tile, Exposure& exposure);

 private:
  bool is_alone(const Tile& tile) const;
  bool show_alone(const Tile& tile, Exposure& exposure);
  std::size_t place_of(int x, int y) const;
  Color set_at(std::size_t place);
  void plan(Pixel& pixel, int x, int y, const Color& set_color);
  void plan_floor(Pixel& pixel, const Vec3& point);
  void plan_floor_sky(Pixel& pixel, const Vec3& point) const;
  int samples_of(const Pixel& pixel) const;
  Sample sample_of(Pixel& pixel, int index) const;
  CameraFrame camera_of(const Sample& sample) const;
  void aim(const Samples& samples, LaneVectors& origins, LaneVectors& directions) const;
  void show_floor(Samples& samples);
  void trace(Samples& samples);
  void take_primary(const Sample& sample, int lane, const Hits& figure, const Hits& standing);
  Surface surface(int lane, const Hits& hits, bool of_figure, float time) const;
  void take_samples(Pixel& pixel, int first, int last);
  void push_floor(const Sample& sample, const EyeRay& ray);
  void light_floor();
  void finish();
  float missing(const Color& left, int x, int y) const;
  void show_set(const Color& set, int x, int y, Exposure& exposure) const;
  void develop(const Pixel& pixel, Exposure& exposure) const;

  const Picture& picture_;
  const FloorSky::Cell* cell_;  // of the floor, that was looked at last
  std::vector<Pixel> pixels_;   // those that are traced; they stay where they are
  Samples floor_;               // samples that show no solid, not yet aimed
  Samples traced_;              // samples that may, not yet aimed
  RayPacket primaries_;
  SurfaceSamples figure_surfaces_;
  SurfaceSamples set_surfaces_;
  FloorSamples floor_points_;
  LightQueries queries_;
};

void TilePainter::draw(const Tile& tile, Exposure& exposure) {
  const bool alone = is_alone(tile);
  if (alone && picture_.quality.background == Background::shown && show_alone(tile, exposure))
    return;
  pixels_.clear();
  for (int y = tile.y_begin; y < tile.y_end; ++y) {
    for (int x = tile.x_begin; x < tile.x_end; ++x) {
      const std::size_t place = place_of(x, y);
      const Color set = set_at(place);
      if (alone && (cell_->known || picture_.set.floor[place] == 0)) {
        show_set(set, x, y, exposure);
        continue;
      }
      if (pixels_.capacity() == 0) pixels_.reserve(tile_size * tile_size);
      Pixel& pixel = pixels_.emplace_back();
      plan(pixel, x, y, set);
      const int needed = samples_of(pixel);
      if (needed == 0) {
        show_set(set, x, y, exposure);
        pixels_.pop_back();
        continue;
      }
      for (int first = 0; first < needed; first += static_cast<int>(lanes))
        take_samples(pixel, first, std::min(first + static_cast<int>(lanes), needed));
    }
  }
  finish();
  for (const Pixel& pixel : pixels_) develop(pixel, exposure);
}

// A tile that shows neither the figure nor its shadow, less what the figure hides of the sky. False
// when that is not known everywhere: then nothing is final yet.
bool TilePainter::show_alone(const Tile& tile, Exposure& exposure) {
  const StandingSet& set = picture_.set;
  for (int y = tile.y_begin; y < tile.y_end; ++y) {
    const std::size_t row = place_of(tile.x_begin, y);
    const float* radiance = set.radiance.channels.data() + 3 * row;
    const float* albedo = set.floor_albedo.channels.data() + 3 * row;
    float* out = exposure.film.channels.data() + 3 * row;
    const int width = tile.x_end - tile.x_begin;
    for (int i = 0; i < width; ++i, radiance += 3, albedo += 3, out += 3) {
      const std::size_t place = row + static_cast<std::size_t>(i);
      const float x = set.floor_x[place], z = set.floor_z[place];
      if (set.floor[place] != 0 && !cell_->holds(x, z)) cell_ = &picture_.floor_sky.cell_at(x, z);
      if (set.floor[place] == 0 || (cell_->known && cell_->inverse_side == 0.0f)) {
        std::copy_n(radiance, 3, out);
        continue;
      }
      if (!cell_->known) return false;
      const FloorSky::Cell& cell = *cell_;
      const float u = (x - cell.x) * cell.inverse_side, v = (z - cell.z) * cell.inverse_side;
      for (int c = 0; c < 3; ++c) {
        const float hidden = cell.at_corner[c] + u * cell.along_x[c] +
                             v * (cell.along_z[c] + u * cell.along_both[c]);
        out[c] = radiance[c] - albedo[c] * hidden;
      }
    }
  }
  return true;
}

// Whether a tile shows no figure and none of its shadow.
bool TilePainter::is_alone(const Tile& tile) const {
  if (picture_.quality.exhaustive || picture_.piecemeal() || picture_.set.solids) return false;
  for (int y = tile.y_begin; y < tile.y_end; ++y)
    if (picture_.film_mask.may_meet_row(tile.x_begin, tile.x_end, y)) return false;
  const float margin = picture_.filter.half_width();
  const std::optional<FloorArea> area = floor_under(
      picture_.camera,
      {static_cast<float>(tile.x_begin) - margin, static_cast<float>(tile.x_end) + margin,
       static_cast<float>(tile.y_begin) - margin, static_cast<float>(tile.y_end) + margin});
  for (const ShadowMask& mask : picture_.shadow_masks)
    if (!area || mask.may_shade(*area)) return false;
  return true;
}

std::size_t TilePainter::place_of(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.set.radiance.width) +
         static_cast<std::size_t>(x);
}

// The set, less what the figure hides of the sky where that is known.
Color TilePainter::set_at(std::size_t place) {
  const StandingSet& set = picture_.set;
  const Color radiance = Eigen::Map<const Color>(set.radiance.channels.data() + 3 * place);
  if (set.floor[place] == 0) return radiance;
  const float x = set.floor_x[place], z = set.floor_z[place];
  if (!cell_->holds(x, z)) cell_ = &picture_.floor_sky.cell_at(x, z);
  if (!cell_->known || cell_->inverse_side == 0.0f) return radiance;
  return radiance - Eigen::Map<const Color>(set.floor_albedo.channels.data() + 3 * place) *
                        cell_->hidden(x, z);
}

void TilePainter::plan(Pixel& pixel, int x, int y, const Color& set_color) {
  const StandingSet& set = picture_.set;
  const std::size_t place = place_of(x, y);
  pixel.x = x;
  pixel.y = y;
  pixel.radiance = set_color;
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
    plan_floor(pixel, {set.floor_x[place], 0.0f, set.floor_z[place]});
  if (pixel.kind == PixelKind::untouched && pixel.shadow_lights != 0) pixel.kind = PixelKind::floor;
  if (pixel.kind == PixelKind::untouched || pixel.kind == PixelKind::floor)
    pixel.set_samples = picture_.quality.samples_per_pixel;
}

void TilePainter::plan_floor(Pixel& pixel, const Vec3& point) {
  if (!cell_->known) plan_floor_sky(pixel, point);
  if (picture_.shadow_masks.empty()) return;
  const float reach = picture_.filter.half_width();
  const auto x = static_cast<float>(pixel.x) + 0.5f, y = static_cast<float>(pixel.y) + 0.5f;
  const std::optional<FloorArea> area =
      floor_under(picture_.camera, {x - reach, x + reach, y - reach, y + reach});
  for (std::size_t i = 0; i < picture_.shadow_masks.size(); ++i)
    if (picture_.quality.exhaustive || !area || picture_.shadow_masks[i].may_shade(*area))
      pixel.shadow_lights |= 1u << i;
}

void TilePainter::plan_floor_sky(Pixel& pixel, const Vec3& point) const {
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

int TilePainter::samples_of(const Pixel& pixel) const {
  return pixel.kind == PixelKind::untouched ? pixel.floor_sky_rays
                                            : picture_.quality.samples_per_pixel;
}

Sample TilePainter::sample_of(Pixel& pixel, int index) const {
  Sample sample{&pixel, index};
  if (picture_.closing_solids != nullptr || picture_.closing_camera)
    sample.time = picture_.quality.shutter * pixel.sampler.point(Dimension::Time, index).u;
  if (!picture_.figure.shapes().all_present)
    sample.present = present_figures(pixel.sampler, picture_.opacities, index);
  return sample;
}

CameraFrame TilePainter::camera_of(const Sample& sample) const {
  return picture_.closing_camera ? between(picture_.camera, *picture_.closing_camera, sample.time)
                                 : picture_.camera;
}

void TilePainter::aim(const Samples& samples, LaneVectors& origins, LaneVectors& directions) const {
  const LanePoints u = points_for(samples, Dimension::FilmPosition);
  LaneFloats x, y;
  for (int i = 0; i < samples.count; ++i) {
    const Pixel& pixel = *samples[i].pixel;
    x[i] = static_cast<float>(pixel.x) + 0.5f + picture_.filter.offset(u.u[i]);
    y[i] = static_cast<float>(pixel.y) + 0.5f + picture_.filter.offset(u.v[i]);
  }
  if (!picture_.piecemeal()) return eye_rays(picture_.camera, x, y, origins, directions);
  for (int i = 0; i < samples.count; ++i) {
    const DiscPoint lens =
        disc_point(samples[i].pixel->sampler.point(Dimension::Lens, samples[i].index));
    const EyeRay ray = camera_of(samples[i]).ray(x[i], y[i], lens.x, lens.y);
    origins.set(i, ray.origin);
    directions.set(i, ray.direction);
  }
}

void TilePainter::show_floor(Samples& samples) {
  LaneVectors origins, directions;
  aim(samples, origins, directions);
  for (int i = 0; i < samples.count; ++i) push_floor(samples[i], {origins.at(i), directions.at(i)});
  samples.count = 0;
  light_floor();
}

// Samples of a pixel that are aimed and lit together stay together, whatever else is drawn: so its
// light is always added up in the same order.
void TilePainter::take_samples(Pixel& pixel, int first, int last) {
  const bool open = pixel.kind == PixelKind::untouched || pixel.kind == PixelKind::floor;
  Samples& waiting = open ? floor_ : traced_;
  if (waiting.count + last - first > static_cast<int>(lanes))
    open ? show_floor(floor_) : trace(traced_);
  for (int i = first; i < last; ++i) waiting.push(sample_of(pixel, i));
}

void TilePainter::push_floor(const Sample& sample, const EyeRay& ray) {
  if (!sample.pixel->shows_floor) return;
  const std::optional<float> distance = distance_to_floor(ray.origin, ray.direction);
  if (distance) floor_points_.push(sample, floor_point(ray, *distance));
}

void TilePainter::light_floor() {
  darken_floor(picture_, floor_points_, queries_);
  floor_points_.samples.count = 0;
}

void TilePainter::trace(Samples& samples) {
  if (samples.count == 0) return;
  LaneVectors origins, directions;
  aim(samples, origins, directions);
  primaries_.count = 0;
  for (int i = 0; i < samples.count; ++i) {
    const Vec3 origin = origins.at(i), direction = directions.at(i);
    const std::optional<float> floor =
        picture_.scene.has_ground ? distance_to_floor(origin, direction) : std::nullopt;
    primaries_.push(origin, direction, floor.value_or(infinity), samples[i].time,
                    samples[i].present);
  }
  const Hits figure = picture_.figure.intersect(primaries_);
  Hits standing;
  std::fill_n(standing.shape, packet_size, -1);
  if (picture_.set.solids) standing = picture_.set.solids->intersect(primaries_);
  for (int i = 0; i < samples.count; ++i) take_primary(samples[i], i, figure, standing);
  samples.count = 0;
  light_surfaces(picture_, figure_surfaces_, true, queries_);
  light_surfaces(picture_, set_surfaces_, false, queries_);
  figure_surfaces_.samples.count = set_surfaces_.samples.count = 0;
  light_floor();
}

void TilePainter::take_primary(const Sample& sample, int lane, const Hits& figure,
                               const Hits& standing) {
  Pixel& pixel = *sample.pixel;
  const bool wall = standing.shape[lane] >= 0;
  if (figure.shape[lane] >= 0 && (!wall || figure.distance[lane] <= standing.distance[lane])) {
    ++pixel.covered;
    return figure_surfaces_.push(sample, surface(lane, figure, true, sample.time));
  }
  const EyeRay ray{primaries_.origin(lane), primaries_.direction(lane)};
  if (pixel.kind == PixelKind::piecemeal) {
    if (wall) return set_surfaces_.push(sample, surface(lane, standing, false, 0.0f));
    return show_open_set(picture_, sample, camera_of(sample), ray, queries_);
  }
  ++pixel.set_samples;
  if (wall) return darken_wall(picture_, sample, surface(lane, standing, false, 0.0f), queries_);
  push_floor(sample, ray);
}

Surface TilePainter::surface(int lane, const Hits& hits, bool of_figure, float time) const {
  const Vec3 direction = primaries_.direction(lane);
  const Vec3 point = primaries_.origin(lane) + hits.distance[lane] * direction;
  if (of_figure)
    return surface_at(picture_.scene, picture_.solids, picture_.closing_solids,
                      picture_.figure.shapes(), hits.shape[lane], point, direction, time);
  return surface_at(picture_.scene, picture_.scene.standing, nullptr, picture_.set.solids->shapes(),
                    hits.shape[lane], point, direction, time);
}

// All that waits for a full packet.
void TilePainter::finish() {
  show_floor(floor_);
  trace(traced_);
  queries_.trace();
}

// A pixel without figure or shadow.
void TilePainter::show_set(const Color& set, int x, int y, Exposure& exposure) const {
  if (picture_.quality.background == Background::shown)
    std::copy_n(set.data(), 3, exposure.film.at(x, y));
  else if (picture_.quality.background == Background::shadow)
    exposure.alpha[place_of(x, y)] = missing(set, x, y);
}

// How much of the set's light a pixel lacks.
float TilePainter::missing(const Color& left, int x, int y) const {
  const float whole = luminance(Eigen::Map<const Color>(picture_.set.radiance.at(x, y)));
  return whole > 0.0f ? std::clamp(1.0f - luminance(left) / whole, 0.0f, 1.0f) : 0.0f;
}

void TilePainter::develop(const Pixel& pixel, Exposure& exposure) const {
  const float share = 1.0f / static_cast<float>(picture_.quality.samples_per_pixel);
  const Color set = (share * static_cast<float>(pixel.set_samples)) * pixel.radiance +
                    share * (pixel.known_set + pixel.set);
  const Color figure = share * (pixel.known_figure + pixel.figure);
  const Color taken = share * pixel.taken;
  if (picture_.quality.background == Background::shown) {
    const Color color = set + (figure + taken);
    std::copy_n(color.data(), 3, exposure.film.at(pixel.x, pixel.y));
    return;
  }
  const float covered = share * static_cast<float>(pixel.covered);
  std::copy_n(figure.data(), 3, exposure.film.at(pixel.x, pixel.y));
  exposure.alpha[place_of(pixel.x, pixel.y)] =
      picture_.quality.background == Background::transparent
          ? covered
          : std::max(covered, missing(set + taken, pixel.x, pixel.y));
}

}  // namespace

Tile tile_at(const Film& film, int column, int row) {
  const int x = column * tile_size;
  const int y = row * tile_size;
  return {x, std::min(x + tile_size, film.width), y, std::min(y + tile_size, film.height)};
}

void draw(const Picture& picture, const Tile& tile, Exposure& exposure) {
  TilePainter(picture).draw(tile, exposure);
}

}  // namespace mien::render
