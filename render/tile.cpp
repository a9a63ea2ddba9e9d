#include "render/tile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "render/directions.h"
#include "render/floor.h"
#include "render/floor_sky.h"
#include "render/light.h"
#include "render/sampler.h"
#include "render/shading.h"

namespace mien::render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float pi = std::numbers::pi_v<float>;

/// How a pixel is drawn.
enum class Kind {
  untouched,  // the set, and what the figure hides of the sky from its floor
  floor,      // likewise, and what it hides of the lights
  wall,       // a standing solid may show, and no figure
  figure,     // the figure may show, and no standing solid
  piecemeal   // every sample by itself: figure and standing solids may both show
};

struct Pixel {
  int x = 0;
  int y = 0;
  Kind kind = Kind::untouched;
  PixelSampler sampler;
  Color radiance = Color::Zero();  // of the set
  Color floor_albedo = Color::Zero();
  bool shows_floor = false;
  int floor_sky_rays = 0;           // so many of the samples look from the floor at the sky
  float floor_sky_samples = 0.0f;   // that each of those stands for
  std::uint32_t shadow_lights = 0;  // bit i: the figure may hide light i from here
  int set_samples = 0;              // samples that show the set as it is known
  int covered = 0;                  // samples that show the figure
  Color figure = Color::Zero();     // sums over the samples: light from the figure,
  Color set = Color::Zero();        // from the set, sample by sample,
  Color taken = Color::Zero();      // and what the figure takes away from it
};

// One primary ray of a pixel.
struct Sample {
  Pixel* pixel = nullptr;
  int index = 0;
  float time = 0.0f;
  std::uint32_t present = ~0u;
};

// What becomes of the light that a query stands for.
enum class Effect {
  arrives_unless_blocked,    // at a surface, from a light or the sky
  taken_when_figure_blocks,  // from what the set shows with nobody in it
  taken_when_blocked         // from what the open set shows, without its solids
};

struct Query {
  Pixel* pixel = nullptr;
  Color light = Color::Zero();
  Effect effect = Effect::arrives_unless_blocked;
  bool from_figure = true;  // the surface that it lights
};

// Box around the floor that the filter of a pixel covers; nothing when that goes on to the horizon.
std::optional<FloorArea> floor_under(const CameraFrame& camera, float x, float y,
                                     float half_width) {
  FloorArea area{infinity, -infinity, infinity, -infinity};
  for (const float dx : {-half_width, half_width}) {
    for (const float dy : {-half_width, half_width}) {
      const EyeRay ray = camera.ray(x + dx, y + dy);
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

class TilePainter {
 public:
  explicit TilePainter(const Picture& picture) : picture_(picture) {}
  void draw(const Tile& tile, Exposure& exposure);

 private:
  void plan(Pixel& pixel, int x, int y) const;
  void plan_floor(Pixel& pixel) const;
  void plan_floor_sky(Pixel& pixel, const Vec3& point) const;
  int samples_of(const Pixel& pixel) const;
  Sample sample_of(Pixel& pixel, int index) const;
  EyeRay eye_ray(const Sample& sample) const;
  CameraFrame camera_of(const Sample& sample) const;
  void trace(const Sample& sample, const EyeRay& ray);
  void trace_primaries();
  void take_primary(const Sample& sample, int lane, const Hits& figure, const Hits& standing);
  Surface surface(int lane, const Hits& hits, bool of_figure, float time) const;
  void light_surface(const Sample& sample, const Surface& surface, bool of_figure);
  void darken_wall(const Sample& sample, const Surface& surface);
  void show_open_set(const Sample& sample, const EyeRay& ray);
  void shade_floor(const Sample& sample, const EyeRay& ray);
  void hide_light(const Sample& sample, const Vec3& point, std::size_t light, const Color& albedo,
                  Effect effect);
  void hide_sky(const Sample& sample, const Vec3& point);
  void ask(const Sample& sample, const Vec3& origin, const Vec3& direction, float distance,
           const Query& query);
  void trace_queries();
  void develop(const Pixel& pixel, Exposure& exposure) const;

  const Picture& picture_;
  std::array<Pixel, tile_size * tile_size> pixels_;
  RayPacket primaries_;
  std::array<Sample, packet_size> samples_;
  RayPacket rays_;
  std::array<Query, packet_size> queries_;
};

void TilePainter::draw(const Tile& tile, Exposure& exposure) {
  std::size_t count = 0;
  for (int y = tile.y_begin; y < tile.y_end; ++y) {
    for (int x = tile.x_begin; x < tile.x_end; ++x) {
      Pixel& pixel = pixels_[count++];
      plan(pixel, x, y);
      const int needed = samples_of(pixel);
      for (int i = 0; i < needed; ++i) {
        const Sample sample = sample_of(pixel, i);
        const EyeRay ray = eye_ray(sample);
        if (pixel.kind == Kind::untouched || pixel.kind == Kind::floor)
          shade_floor(sample, ray);
        else
          trace(sample, ray);
      }
    }
  }
  trace_primaries();
  trace_queries();
  for (std::size_t i = 0; i < count; ++i) develop(pixels_[i], exposure);
}

void TilePainter::plan(Pixel& pixel, int x, int y) const {
  const StandingSet& set = picture_.set;
  const std::size_t place =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(set.radiance.width) +
      static_cast<std::size_t>(x);
  pixel = Pixel{};
  pixel.x = x;
  pixel.y = y;
  pixel.radiance = Eigen::Map<const Color>(set.radiance.at(x, y));
  pixel.floor_albedo = Eigen::Map<const Color>(set.floor_albedo.at(x, y));
  pixel.shows_floor = set.floor[place] != 0;
  pixel.sampler = PixelSampler(picture_.quality.seed, x, y);
  const bool somebody = picture_.bounds.radius >= 0.0f;
  const bool solid = set.solid[place] != 0;
  const bool figure = picture_.quality.exhaustive || picture_.film_mask.may_meet(x, y);
  if (picture_.piecemeal() || (figure && solid)) {
    pixel.kind = Kind::piecemeal;
  } else if (figure) {
    pixel.kind = Kind::figure;
  } else if (solid && somebody) {
    pixel.kind = Kind::wall;
  }
  if (pixel.shows_floor && somebody && pixel.kind != Kind::piecemeal) plan_floor(pixel);
  if (pixel.kind == Kind::untouched && pixel.shadow_lights != 0) pixel.kind = Kind::floor;
  if (pixel.kind == Kind::untouched || pixel.kind == Kind::floor)
    pixel.set_samples = picture_.quality.samples_per_pixel;
}

void TilePainter::plan_floor(Pixel& pixel) const {
  const auto x = static_cast<float>(pixel.x) + 0.5f, y = static_cast<float>(pixel.y) + 0.5f;
  const EyeRay ray = picture_.camera.ray(x, y);
  const std::optional<float> distance = distance_to_floor(ray.origin, ray.direction);
  if (!distance) return;
  plan_floor_sky(pixel, floor_point(ray, *distance));
  const std::optional<FloorArea> area =
      floor_under(picture_.camera, x, y, picture_.filter.half_width());
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
  return pixel.kind == Kind::untouched ? pixel.floor_sky_rays : picture_.quality.samples_per_pixel;
}

Sample TilePainter::sample_of(Pixel& pixel, int index) const {
  Sample sample{&pixel, index};
  if (picture_.closing_solids != nullptr || picture_.closing_camera)
    sample.time = pixel.sampler.point(Dimension::Time, index).u;
  if (picture_.figure.shapes().all_present) return sample;
  for (std::size_t f = 0; f < picture_.opacities.size(); ++f) {
    const float opacity = picture_.opacities[f];
    if (opacity < 1.0f &&
        !(pixel.sampler.point(Dimension::FirstFigure, static_cast<int>(f), index).u < opacity))
      sample.present &= ~(1u << f);
  }
  return sample;
}

CameraFrame TilePainter::camera_of(const Sample& sample) const {
  return picture_.closing_camera ? between(picture_.camera, *picture_.closing_camera, sample.time)
                                 : picture_.camera;
}

EyeRay TilePainter::eye_ray(const Sample& sample) const {
  const Pixel& pixel = *sample.pixel;
  const Point2 u = pixel.sampler.point(Dimension::FilmPosition, sample.index);
  const float x = static_cast<float>(pixel.x) + 0.5f + picture_.filter.offset(u.u);
  const float y = static_cast<float>(pixel.y) + 0.5f + picture_.filter.offset(u.v);
  if (!picture_.piecemeal()) return picture_.camera.ray(x, y);
  const CameraFrame camera = camera_of(sample);
  const DiscPoint lens = disc_point(pixel.sampler.point(Dimension::Lens, sample.index));
  return camera.ray(x, y, lens.x, lens.y);
}

void TilePainter::trace(const Sample& sample, const EyeRay& ray) {
  const std::optional<float> floor =
      picture_.scene.has_ground ? distance_to_floor(ray.origin, ray.direction) : std::nullopt;
  samples_[static_cast<std::size_t>(primaries_.count)] = sample;
  primaries_.push(ray.origin, ray.direction, floor.value_or(infinity), sample.time, sample.present);
  if (primaries_.count == packet_size) trace_primaries();
}

void TilePainter::trace_primaries() {
  if (primaries_.count == 0) return;
  const Hits figure = picture_.figure.intersect(primaries_);
  Hits standing;
  std::fill_n(standing.shape, packet_size, -1);
  if (picture_.set.solids) standing = picture_.set.solids->intersect(primaries_);
  const int count = primaries_.count;
  for (int i = 0; i < count; ++i)
    take_primary(samples_[static_cast<std::size_t>(i)], i, figure, standing);
  primaries_.count = 0;
}

void TilePainter::take_primary(const Sample& sample, int lane, const Hits& figure,
                               const Hits& standing) {
  Pixel& pixel = *sample.pixel;
  const bool wall = standing.shape[lane] >= 0;
  if (figure.shape[lane] >= 0 && (!wall || figure.distance[lane] <= standing.distance[lane])) {
    ++pixel.covered;
    return light_surface(sample, surface(lane, figure, true, sample.time), true);
  }
  const EyeRay ray{primaries_.origin(lane), primaries_.direction(lane)};
  if (pixel.kind == Kind::piecemeal) {
    if (wall) return light_surface(sample, surface(lane, standing, false, 0.0f), false);
    return show_open_set(sample, ray);
  }
  ++pixel.set_samples;
  if (wall) return darken_wall(sample, surface(lane, standing, false, 0.0f));
  shade_floor(sample, ray);
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

// All the light that a surface sends to the eye.
void TilePainter::light_surface(const Sample& sample, const Surface& surface, bool of_figure) {
  const Scene& scene = picture_.scene;
  Pixel& pixel = *sample.pixel;
  (of_figure ? pixel.figure : pixel.set) += surface.material->emission;
  if ((surface.albedo == 0.0f).all() && surface.material->sheen == 0.0f) return;
  const auto arrives = [&](const Color& light) {
    return Query{&pixel, light, Effect::arrives_unless_blocked, of_figure};
  };
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Point2 u = pixel.sampler.light_point(static_cast<int>(i), sample.index);
    const LightSample light = render::sample(scene.lights[i], surface.origin, u);
    const float cosine = surface.normal.dot(light.towards);
    if (cosine <= 0.0f) continue;
    ask(sample, surface.origin, light.towards, light.distance,
        arrives(cosine * light.perpendicular * reflectance(surface, light.towards)));
  }

  const int rays = picture_.quality.sky_rays;
  const Color share = surface.albedo / static_cast<float>(rays);
  for (int i = 0; i < rays; ++i) {
    const Point2 u = pixel.sampler.point(Dimension::FigureSky, rays * sample.index + i);
    const Vec3 towards = cosine_direction(surface.normal, u);
    const std::optional<float> floor =
        scene.has_ground ? distance_to_floor(surface.origin, towards) : std::nullopt;
    ask(sample, surface.origin, towards, floor.value_or(infinity),
        arrives(share * sky_radiance(scene.sky, towards)));
  }
}

// What the figure hides from a standing solid.
void TilePainter::darken_wall(const Sample& sample, const Surface& surface) {
  const Scene& scene = picture_.scene;
  const auto taken = [&](const Color& light) {
    return Query{sample.pixel, -light, Effect::taken_when_figure_blocks, false};
  };
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Point2 u = sample.pixel->sampler.light_point(static_cast<int>(i), sample.index);
    const LightSample light = render::sample(scene.lights[i], surface.origin, u);
    const float cosine = surface.normal.dot(light.towards);
    if (cosine <= 0.0f) continue;
    ask(sample, surface.origin, light.towards, light.distance,
        taken(cosine * light.perpendicular * reflectance(surface, light.towards)));
  }

  const Point2 u = sample.pixel->sampler.point(Dimension::FloorSky, sample.index);
  const std::optional<Cone> cone = cone_of(picture_.bounds, surface.origin);
  const Vec3 towards =
      cone ? cone_direction(cone->axis, cone->cosine, u) : cosine_direction(surface.normal, u);
  const float cosine = towards.dot(surface.normal);
  if (cosine <= 0.0f) return;
  const float share = cone ? cone->solid_angle() / pi * cosine : 1.0f;
  const std::optional<float> floor =
      scene.has_ground ? distance_to_floor(surface.origin, towards) : std::nullopt;
  ask(sample, surface.origin, towards, floor.value_or(infinity),
      taken(share * surface.albedo * sky_radiance(scene.sky, towards)));
}

// The backdrop or floor at the end of a ray, with the shadows of everything.
void TilePainter::show_open_set(const Sample& sample, const EyeRay& ray) {
  Pixel& pixel = *sample.pixel;
  // Where all rays of a pixel start at one point, the set is what its centre shows.
  const EyeRay seen = picture_.piecemeal()
                          ? ray
                          : picture_.camera.ray(static_cast<float>(pixel.x) + 0.5f,
                                                static_cast<float>(pixel.y) + 0.5f);
  const SetPixel set = set_pixel(picture_.scene, camera_of(sample), seen);
  pixel.set += set.radiance;
  const std::optional<float> distance = distance_to_floor(ray.origin, ray.direction);
  if (!set.shows_floor || !distance) return;
  const Vec3 point = floor_point(ray, *distance);
  for (std::size_t i = 0; i < picture_.scene.lights.size(); ++i)
    hide_light(sample, point, i, set.visible_albedo, Effect::taken_when_blocked);
  const Vec3 towards =
      cosine_direction(Vec3::UnitY(), pixel.sampler.point(Dimension::FloorSky, sample.index));
  if (towards.y() <= 0.0f) return;
  ask(sample, point, towards, infinity,
      {&pixel, -set.visible_albedo * sky_radiance(picture_.scene.sky, towards),
       Effect::taken_when_blocked, false});
}

// What the figure hides from a point of the floor.
void TilePainter::shade_floor(const Sample& sample, const EyeRay& ray) {
  const Pixel& pixel = *sample.pixel;
  if (!pixel.shows_floor) return;
  const std::optional<float> distance = distance_to_floor(ray.origin, ray.direction);
  if (!distance) return;
  const Vec3 point = floor_point(ray, *distance);
  for (std::uint32_t lights = pixel.shadow_lights; lights != 0; lights &= lights - 1)
    hide_light(sample, point, static_cast<std::size_t>(std::countr_zero(lights)),
               pixel.floor_albedo, Effect::taken_when_figure_blocks);
  if (sample.index < pixel.floor_sky_rays) hide_sky(sample, point);
}

void TilePainter::hide_light(const Sample& sample, const Vec3& point, std::size_t light,
                             const Color& albedo, Effect effect) {
  const LightSample chosen =
      render::sample(picture_.scene.lights[light], point,
                     sample.pixel->sampler.light_point(static_cast<int>(light), sample.index));
  const float cosine = chosen.towards.y();
  if (cosine <= 0.0f) return;
  ask(sample, point, chosen.towards, chosen.distance,
      {sample.pixel, -cosine / pi * chosen.perpendicular * albedo, effect, false});
}

void TilePainter::hide_sky(const Sample& sample, const Vec3& point) {
  const Pixel& pixel = *sample.pixel;
  const Point2 u = pixel.sampler.point(Dimension::FloorSky, sample.index);
  const std::optional<Cone> cone = cone_of(picture_.bounds, point);
  const Vec3 towards =
      cone ? cone_direction(cone->axis, cone->cosine, u) : cosine_direction(Vec3::UnitY(), u);
  if (towards.y() <= 0.0f) return;
  const float share = cone ? cone->solid_angle() / pi * towards.y() : 1.0f;
  ask(sample, point, towards, infinity,
      {sample.pixel,
       -share * pixel.floor_sky_samples * pixel.floor_albedo *
           sky_radiance(picture_.scene.sky, towards),
       Effect::taken_when_figure_blocks, false});
}

void TilePainter::ask(const Sample& sample, const Vec3& origin, const Vec3& direction,
                      float distance, const Query& query) {
  if ((query.light == 0.0f).all()) return;
  queries_[static_cast<std::size_t>(rays_.count)] = query;
  rays_.push(origin, direction, distance, sample.time, sample.present);
  if (rays_.count == packet_size) trace_queries();
}

void TilePainter::trace_queries() {
  if (rays_.count == 0) return;
  const std::uint32_t by_figure = picture_.figure.occluded(rays_);
  const std::uint32_t by_set = picture_.set.solids ? picture_.set.solids->occluded(rays_) : 0;
  for (int i = 0; i < rays_.count; ++i) {
    const Query& query = queries_[static_cast<std::size_t>(i)];
    const bool figure = (by_figure >> i) & 1u, set = (by_set >> i) & 1u;
    switch (query.effect) {
      case Effect::arrives_unless_blocked:
        if (!figure && !set)
          (query.from_figure ? query.pixel->figure : query.pixel->set) += query.light;
        break;
      case Effect::taken_when_figure_blocks:
        if (figure && !set) query.pixel->taken += query.light;
        break;
      case Effect::taken_when_blocked:
        if (figure || set) query.pixel->taken += query.light;
        break;
    }
  }
  rays_.count = 0;
}

float luminance(const Color& color) {
  return 0.2126f * color.x() + 0.7152f * color.y() + 0.0722f * color.z();
}

void TilePainter::develop(const Pixel& pixel, Exposure& exposure) const {
  const float share = 1.0f / static_cast<float>(picture_.quality.samples_per_pixel);
  const Color set =
      (share * static_cast<float>(pixel.set_samples)) * pixel.radiance + share * pixel.set;
  const Color figure = share * pixel.figure;
  const Color taken = share * pixel.taken;
  if (picture_.quality.background == Background::shown) {
    const Color color = set + (figure + taken);
    std::copy_n(color.data(), 3, exposure.film.at(pixel.x, pixel.y));
    return;
  }
  float alpha = share * static_cast<float>(pixel.covered);
  if (picture_.quality.background == Background::shadow) {
    const float open = luminance(pixel.radiance);
    if (open > 0.0f) alpha += std::clamp(-luminance(taken) / open, 0.0f, 1.0f - alpha);
  }
  std::copy_n(figure.data(), 3, exposure.film.at(pixel.x, pixel.y));
  exposure.alpha[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(exposure.film.width) +
                 static_cast<std::size_t>(pixel.x)] = alpha;
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
