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
#include "render/light.h"
#include "render/sampler.h"
#include "render/shading.h"

namespace mien::render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float pi = std::numbers::pi_v<float>;

struct Pixel {
  int x = 0;
  int y = 0;
  SetPixel set;
  PixelSampler sampler;
  bool may_meet_figure = false;
  int floor_sky_rays = 0;          // so many of the samples look from the floor at the sky
  float floor_sky_samples = 0.0f;  // that each of those stands for
  std::vector<int> shadow_lights;  // lights that the figure may hide from here
  int set_samples = 0;             // samples that met no figure
  Color sum = Color::Zero();       // over the samples, of all but the set
};

// One primary ray of a pixel.
struct Sample {
  Pixel* pixel = nullptr;
  int index = 0;
};

// A ray that asks whether `light` counts: if nothing blocks the ray, or if something does.
struct Query {
  Pixel* pixel = nullptr;
  Color light = Color::Zero();
  bool counts_when_blocked = false;
};

// Where the figure covers little of the sky, few rays from the floor are enough. So many that the
// noise stays below `sky_noise` of the sky's light, when a figure fills about a ninth of the sphere
// round it; and so many that one ray that is blocked takes away no more than `sky_share_of_a_ray`.
constexpr float sky_noise = 0.02f;
constexpr float sky_share_of_a_ray = 0.05f;
constexpr float figure_deviation = 0.32f;  // of a ray that is blocked one time in nine

// The directions from a point of the floor that may meet the figure, where they are few.
struct Cone {
  Vec3 axis;
  float cosine;  // of its half angle

  float solid_angle() const { return 2.0f * pi * (1.0f - cosine); }
};

std::optional<Cone> cone_of(const BoundingSphere& bounds, const Vec3& point) {
  const Vec3 towards = bounds.centre - point;
  const float squared = towards.squaredNorm();
  const float sine_squared = bounds.radius * bounds.radius / squared;
  if (!(sine_squared < 0.6f)) return std::nullopt;
  return Cone{towards / std::sqrt(squared), std::sqrt(1.0f - sine_squared)};
}

// The most that one ray within the cone can stand for, as a share of the sky over a floor.
float greatest_share(const Cone& cone) {
  const float sine = std::sqrt(1.0f - cone.cosine * cone.cosine);
  const float elevation_cosine = std::sqrt(std::max(0.0f, 1.0f - cone.axis.y() * cone.axis.y()));
  const float highest = cone.axis.y() * cone.cosine + elevation_cosine * sine;
  return cone.solid_angle() / pi * std::clamp(highest, 0.0f, 1.0f);
}

// How many rays towards the sky a pixel of the floor is worth; below 1, the chance of one.
float sky_rays_from(const BoundingSphere& bounds, const Vec3& point, int spp) {
  const std::optional<Cone> cone = cone_of(bounds, point);
  if (!cone) return static_cast<float>(spp);
  const float share = greatest_share(*cone);
  const float quiet = share * figure_deviation / sky_noise;
  return std::max(quiet * quiet, share / sky_share_of_a_ray);
}

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

class TilePainter {
 public:
  explicit TilePainter(const Picture& picture) : picture_(picture) {}
  void draw(const Tile& tile, Film& film);

 private:
  void plan(Pixel& pixel, int x, int y) const;
  void plan_floor(Pixel& pixel) const;
  void plan_floor_sky(Pixel& pixel) const;
  Vec3 camera_direction(const Sample& sample) const;
  void trace(const Sample& sample, const Vec3& direction);
  void trace_primaries();
  void light_figure(const Sample& sample, const Surface& surface);
  void shade_floor(const Sample& sample, const Vec3& direction);
  void hide_sky(const Sample& sample, const Vec3& point);
  void ask(const Vec3& origin, const Vec3& direction, float distance, const Query& query);
  void trace_queries();

  const Picture& picture_;
  std::array<Pixel, tile_size * tile_size> pixels_;
  RayPacket primaries_;
  std::array<Sample, packet_size> samples_;
  RayPacket rays_;
  std::array<Query, packet_size> queries_;
};

void TilePainter::draw(const Tile& tile, Film& film) {
  const int spp = picture_.quality.samples_per_pixel;
  std::size_t count = 0;
  for (int y = tile.y_begin; y < tile.y_end; ++y) {
    for (int x = tile.x_begin; x < tile.x_end; ++x) {
      Pixel& pixel = pixels_[count++];
      plan(pixel, x, y);
      const int needed =
          pixel.may_meet_figure || !pixel.shadow_lights.empty() ? spp : pixel.floor_sky_rays;
      pixel.set_samples = pixel.may_meet_figure ? 0 : spp;
      for (int i = 0; i < needed; ++i) {
        const Sample sample{&pixel, i};
        if (pixel.may_meet_figure)
          trace(sample, camera_direction(sample));
        else
          shade_floor(sample, camera_direction(sample));
      }
    }
  }
  trace_primaries();
  trace_queries();

  const float share = 1.0f / static_cast<float>(spp);
  for (std::size_t i = 0; i < count; ++i) {
    const Pixel& pixel = pixels_[i];
    const Color color =
        (share * static_cast<float>(pixel.set_samples)) * pixel.set.radiance + share * pixel.sum;
    std::copy_n(color.data(), 3, film.at(pixel.x, pixel.y));
  }
}

void TilePainter::plan(Pixel& pixel, int x, int y) const {
  const auto centre_x = static_cast<float>(x) + 0.5f;
  const auto centre_y = static_cast<float>(y) + 0.5f;
  pixel.x = x;
  pixel.y = y;
  pixel.set = set_pixel(picture_.scene, picture_.camera, centre_x, centre_y);
  pixel.sampler = PixelSampler(picture_.quality.seed, x, y);
  pixel.may_meet_figure = picture_.quality.exhaustive || picture_.film_mask.may_meet(x, y);
  pixel.floor_sky_rays = 0;
  pixel.shadow_lights.clear();
  pixel.sum.setZero();
  if (pixel.set.shows_floor && picture_.bounds.radius >= 0.0f) plan_floor(pixel);
}

void TilePainter::plan_floor(Pixel& pixel) const {
  plan_floor_sky(pixel);
  const std::optional<FloorArea> area =
      floor_under(picture_.camera, static_cast<float>(pixel.x) + 0.5f,
                  static_cast<float>(pixel.y) + 0.5f, picture_.filter.half_width());
  for (std::size_t i = 0; i < picture_.shadow_masks.size(); ++i)
    if (picture_.quality.exhaustive || !area || picture_.shadow_masks[i].may_shade(*area))
      pixel.shadow_lights.push_back(static_cast<int>(i));
}

void TilePainter::plan_floor_sky(Pixel& pixel) const {
  const int spp = picture_.quality.samples_per_pixel;
  const float wanted = sky_rays_from(picture_.bounds, pixel.set.point, spp);
  const auto all = static_cast<float>(spp);
  if (wanted < 1.0f) {
    const bool chosen = pixel.sampler.point(Dimension::FloorSkyChoice, 0).u < wanted;
    pixel.floor_sky_rays = chosen ? 1 : 0;
    pixel.floor_sky_samples = all / wanted;
    return;
  }
  // A power of two: such a block of the sequence is well spread.
  const auto rays = static_cast<unsigned>(std::min(std::ceil(wanted), 65536.0f));
  pixel.floor_sky_rays = std::min(static_cast<int>(std::bit_ceil(rays)), spp);
  pixel.floor_sky_samples = all / static_cast<float>(pixel.floor_sky_rays);
}

Vec3 TilePainter::camera_direction(const Sample& sample) const {
  const Pixel& pixel = *sample.pixel;
  const Point2 u = pixel.sampler.point(Dimension::FilmPosition, sample.index);
  return picture_.camera
      .ray(static_cast<float>(pixel.x) + 0.5f + picture_.filter.offset(u.u),
           static_cast<float>(pixel.y) + 0.5f + picture_.filter.offset(u.v))
      .direction;
}

void TilePainter::trace(const Sample& sample, const Vec3& direction) {
  const Vec3& eye = picture_.camera.position;
  const std::optional<float> floor =
      picture_.scene.has_ground ? distance_to_floor(eye, direction) : std::nullopt;
  samples_[static_cast<std::size_t>(primaries_.count)] = sample;
  primaries_.push(eye, direction, floor.value_or(infinity));
  if (primaries_.count == packet_size) trace_primaries();
}

void TilePainter::trace_primaries() {
  if (primaries_.count == 0) return;
  const Hits hits = picture_.figure.intersect(primaries_);
  for (int i = 0; i < primaries_.count; ++i) {
    const Sample& sample = samples_[static_cast<std::size_t>(i)];
    const Vec3 direction = primaries_.direction(i);
    if (hits.cone[i] < 0) {
      ++sample.pixel->set_samples;
      shade_floor(sample, direction);
      continue;
    }
    const RoundCone& cone = picture_.figure.cones()[static_cast<std::size_t>(hits.cone[i])];
    const Vec3 point = picture_.camera.position + hits.distance[i] * direction;
    light_figure(sample, {point, normal_at(cone, point), -direction,
                          &picture_.scene.materials[static_cast<std::size_t>(cone.material)]});
  }
  primaries_.count = 0;
}

void TilePainter::light_figure(const Sample& sample, const Surface& surface) {
  const Scene& scene = picture_.scene;
  sample.pixel->sum += surface.material->emission;
  const Vec3 origin = ray_origin(surface);
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Point2 u = sample.pixel->sampler.light_point(static_cast<int>(i), sample.index);
    const LightSample light = render::sample(scene.lights[i], origin, u);
    const float cosine = surface.normal.dot(light.towards);
    if (cosine <= 0.0f) continue;
    ask(origin, light.towards, light.distance,
        {sample.pixel, cosine * light.perpendicular * reflectance(surface, light.towards), false});
  }

  const int rays = picture_.quality.sky_rays;
  const Color share = surface.material->albedo / static_cast<float>(rays);
  for (int i = 0; i < rays; ++i) {
    const Point2 u = sample.pixel->sampler.point(Dimension::FigureSky, rays * sample.index + i);
    const Vec3 towards = cosine_direction(surface.normal, u);
    const std::optional<float> floor =
        scene.has_ground ? distance_to_floor(origin, towards) : std::nullopt;
    ask(origin, towards, floor.value_or(infinity),
        {sample.pixel, share * sky_radiance(scene.sky, towards), false});
  }
}

// What the figure hides from a point of the floor.
void TilePainter::shade_floor(const Sample& sample, const Vec3& direction) {
  const Pixel& pixel = *sample.pixel;
  if (!pixel.set.shows_floor) return;
  const Vec3& eye = picture_.camera.position;
  const std::optional<float> distance = distance_to_floor(eye, direction);
  if (!distance) return;
  Vec3 point = eye + *distance * direction;
  point.y() = 0.0f;

  for (const int i : pixel.shadow_lights) {
    const LightSample light = render::sample(picture_.scene.lights[static_cast<std::size_t>(i)],
                                             point, pixel.sampler.light_point(i, sample.index));
    const float cosine = light.towards.y();
    if (cosine <= 0.0f) continue;
    ask(point, light.towards, light.distance,
        {sample.pixel, -cosine / pi * light.perpendicular * pixel.set.visible_albedo, true});
  }
  if (sample.index < pixel.floor_sky_rays) hide_sky(sample, point);
}

void TilePainter::hide_sky(const Sample& sample, const Vec3& point) {
  const Pixel& pixel = *sample.pixel;
  const Point2 u = pixel.sampler.point(Dimension::FloorSky, sample.index);
  const std::optional<Cone> cone = cone_of(picture_.bounds, point);
  const Vec3 towards =
      cone ? cone_direction(cone->axis, cone->cosine, u) : cosine_direction(Vec3::UnitY(), u);
  if (towards.y() <= 0.0f) return;
  const float share = cone ? cone->solid_angle() / pi * towards.y() : 1.0f;
  ask(point, towards, infinity,
      {sample.pixel,
       -share * pixel.floor_sky_samples * pixel.set.visible_albedo *
           sky_radiance(picture_.scene.sky, towards),
       true});
}

void TilePainter::ask(const Vec3& origin, const Vec3& direction, float distance,
                      const Query& query) {
  if ((query.light == 0.0f).all()) return;
  queries_[static_cast<std::size_t>(rays_.count)] = query;
  rays_.push(origin, direction, distance);
  if (rays_.count == packet_size) trace_queries();
}

void TilePainter::trace_queries() {
  if (rays_.count == 0) return;
  const std::uint32_t blocked = picture_.figure.occluded(rays_);
  for (int i = 0; i < rays_.count; ++i) {
    const Query& query = queries_[static_cast<std::size_t>(i)];
    if (((blocked >> i) & 1u) == (query.counts_when_blocked ? 1u : 0u))
      query.pixel->sum += query.light;
  }
  rays_.count = 0;
}

}  // namespace

Tile tile_at(const Film& film, int column, int row) {
  const int x = column * tile_size;
  const int y = row * tile_size;
  return {x, std::min(x + tile_size, film.width), y, std::min(y + tile_size, film.height)};
}

void draw(const Picture& picture, const Tile& tile, Film& film) {
  TilePainter(picture).draw(tile, film);
}

}  // namespace mien::render
