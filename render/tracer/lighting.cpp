#include "render/tracer/lighting.h"

#include <bit>
#include <optional>

#include "render/light/floor.h"
#include "render/light/light.h"
#include "render/light/sky_cone.h"
#include "render/math/constants.h"
#include "render/math/directions.h"

namespace mien::render {

namespace {

float distance_to_end(const Scene& scene, const Vec3& origin, const Vec3& direction) {
  if (!scene.has_ground) return infinity;
  return distance_to_floor(origin, direction).value_or(infinity);
}

bool is_dull(const Surface& surface) {
  return (surface.albedo == 0.0f).all() && surface.material->sheen == 0.0f;
}

void light_from_lights(const Picture& picture, const SurfaceSamples& batch,
                       const LaneVectors& origins, Effect arrives, LightQueries& queries) {
  const std::vector<AreaLight>& lights = picture.scene.lights;
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const LanePoints u = points_for(batch.samples, Dimension::FirstLight, static_cast<int>(k));
    const LaneLights light = sample_lights(lights[k], origins, u);
    for (int i = 0; i < batch.samples.count; ++i) {
      const Surface& surface = batch.surfaces[static_cast<std::size_t>(i)];
      const Vec3 towards = light.towards.at(i);
      const float cosine = surface.normal.dot(towards);
      if (cosine <= 0.0f || light.share[i] <= 0.0f) continue;
      queries.ask(batch.samples[i], surface.origin, towards, light.distance[i],
                  (cosine * light.share[i]) * lights[k].radiance * reflectance(surface, towards),
                  arrives);
    }
  }
}

// The sky's light is known where nothing is in the way; rays tell what is hidden of it.
void light_from_sky(const Picture& picture, const SurfaceSamples& batch, const LaneVectors& normals,
                    bool of_figure, LightQueries& queries) {
  const Sky& sky = picture.scene.sky;
  for (int i = 0; i < batch.samples.count; ++i) {
    const Surface& surface = batch.surfaces[static_cast<std::size_t>(i)];
    add_light(batch.samples[i], of_figure ? &Pixel::known_figure : &Pixel::known_set,
              surface.albedo * open_sky_light(sky, surface.normal));
  }
  const Effect taken = of_figure ? Effect::taken_from_figure : Effect::taken_from_set;
  const int rays = picture.quality.sky_rays;
  const float share = 1.0f / static_cast<float>(rays);
  for (int k = 0; k < rays; ++k) {
    const LanePoints u = points_for(batch.samples, Dimension::FigureSky, 0, rays, k);
    const LaneVectors towards = cosine_directions(normals, u);
    for (int i = 0; i < batch.samples.count; ++i) {
      const Surface& surface = batch.surfaces[static_cast<std::size_t>(i)];
      const Vec3 direction = towards.at(i);
      queries.ask(batch.samples[i], surface.origin, direction,
                  distance_to_end(picture.scene, surface.origin, direction),
                  share * surface.albedo * sky_radiance(sky, direction), taken);
    }
  }
}

/// A ray that looks from a surface for a figure before the sky, and the share of an even sky's
/// light that it stands for.
struct SkyRay {
  Vec3 towards;
  float share;
};

SkyRay sky_ray(const BoundingSphere& bounds, const Vec3& point, const Vec3& normal, Point2 u) {
  const std::optional<Cone> cone = cone_of(bounds, point);
  if (!cone) return {cosine_direction(normal, u), 1.0f};
  const Vec3 towards = cone_direction(cone->axis, cone->cosine, u);
  return {towards, cone->solid_angle() / pi * towards.dot(normal)};
}

void ask_for_light(const AreaLight& light, int k, const FloorSamples& batch,
                   LightQueries& queries) {
  const LaneLights chosen =
      sample_lights(light, batch.points, points_for(batch.samples, Dimension::FirstLight, k));
  for (int i = 0; i < batch.samples.count; ++i) {
    const Pixel& pixel = *batch.samples[i].pixel;
    const float cosine = chosen.towards.y[i];
    if (!pixel.may_lack(k) || cosine <= 0.0f) continue;
    queries.ask(batch.samples[i], batch.points.at(i), chosen.towards.at(i), chosen.distance[i],
                (cosine / pi * chosen.share[i]) * light.radiance * pixel.floor_albedo,
                Effect::taken_when_figure_blocks);
  }
}

void look_at_floor_sky(const Picture& picture, const FloorSamples& batch, LightQueries& queries) {
  const auto looks = [&](int i) {
    return batch.samples[i].index < batch.samples[i].pixel->floor_sky_rays;
  };
  bool any = false;
  for (int i = 0; i < batch.samples.count && !any; ++i) any = looks(i);
  if (!any) return;
  const LaneSkyRays rays =
      floor_sky_rays(picture.bounds.centre, picture.bounds.radius, batch.points,
                     points_for(batch.samples, Dimension::FloorSky));
  for (int i = 0; i < batch.samples.count; ++i) {
    const Vec3 towards = rays.towards.at(i);
    if (!looks(i) || towards.y() <= 0.0f) continue;
    const Pixel& pixel = *batch.samples[i].pixel;
    queries.ask(batch.samples[i], batch.points.at(i), towards, infinity,
                rays.share[i] * pixel.floor_sky_samples * pixel.floor_albedo *
                    sky_radiance(picture.scene.sky, towards),
                Effect::taken_when_figure_blocks);
  }
}

/// All samples of a pixel stand together.
void ask_lines(const Picture& picture, const FloorSamples& batch, LineQueries& lines) {
  const Samples& samples = batch.samples;
  const int shared = shared_line(lines.of_tile(), picture.quality.samples_per_pixel).samples;
  for (int first = 0, last = 0; first < samples.count; first = last) {
    Pixel& pixel = *samples[first].pixel;
    const int group = samples[first].index / shared;
    while (last < samples.count && samples[last].pixel == &pixel &&
           samples[last].index / shared == group)
      ++last;
    if ((pixel.shadow_lights & lines.of_tile().lights) != 0)
      lines.ask(pixel, samples[first].index, last - first);
  }
}

}  // namespace

void LightQueries::trace() {
  if (rays_.count == 0) return;
  const std::uint32_t by_figure = picture_.figure.occluded(rays_);
  const std::uint32_t by_set = picture_.walls ? picture_.walls->occluded(rays_) : 0;
  for (int i = 0; i < rays_.count; ++i) {
    const Query& query = queries_[static_cast<std::size_t>(i)];
    const bool figure = ((by_figure >> i) & 1u) != 0, set = ((by_set >> i) & 1u) != 0;
    switch (query.effect) {
      case Effect::arrives_at_figure:
        if (!figure && !set) add_light(query.sample, &Pixel::figure, query.light);
        break;
      case Effect::arrives_at_set:
        if (!figure && !set) add_light(query.sample, &Pixel::set, query.light);
        break;
      case Effect::taken_from_figure:
        if (figure || set) add_light(query.sample, &Pixel::figure, -query.light);
        break;
      case Effect::taken_from_set:
        if (figure || set) add_light(query.sample, &Pixel::set, -query.light);
        break;
      case Effect::taken_when_figure_blocks:
        if (figure && !set) add_light(query.sample, &Pixel::taken, -query.light);
        break;
      case Effect::taken_when_blocked:
        if (figure || set) add_light(query.sample, &Pixel::taken, -query.light);
        break;
    }
  }
  rays_.count = 0;
}

void light_surfaces(const Picture& picture, const SurfaceSamples& batch, bool of_figure,
                    LightQueries& queries) {
  SurfaceSamples lit;
  LaneVectors origins, normals;
  for (int i = 0; i < batch.samples.count; ++i) {
    const Surface& surface = batch.surfaces[static_cast<std::size_t>(i)];
    add_light(batch.samples[i], of_figure ? &Pixel::known_figure : &Pixel::known_set,
              surface.material->emission);
    if (is_dull(surface)) continue;
    origins.set(lit.samples.count, surface.origin);
    normals.set(lit.samples.count, surface.normal);
    lit.push(batch.samples[i], surface);
  }
  if (lit.samples.count == 0) return;
  const Effect arrives = of_figure ? Effect::arrives_at_figure : Effect::arrives_at_set;
  light_from_lights(picture, lit, origins, arrives, queries);
  light_from_sky(picture, lit, normals, of_figure, queries);
}

void darken_wall(const Picture& picture, const Sample& sample, const Surface& surface,
                 LightQueries& queries) {
  const Scene& scene = picture.scene;
  const PixelSampler& sampler = sample.pixel->sampler;
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const Point2 u = sampler.point(Dimension::FirstLight, static_cast<int>(k), sample.index);
    const LightSample light = render::sample(scene.lights[k], surface.origin, u);
    const float cosine = surface.normal.dot(light.towards);
    if (cosine <= 0.0f || !may_meet(picture.bounds, surface.origin, light.towards)) continue;
    queries.ask(sample, surface.origin, light.towards, light.distance,
                cosine * light.perpendicular * reflectance(surface, light.towards),
                Effect::taken_when_figure_blocks);
  }
  const SkyRays sky = sky_rays_of(picture.bounds, surface.origin, surface.normal,
                                  picture.quality.samples_per_pixel, sampler);
  if (sample.index >= sky.rays) return;
  const SkyRay ray = sky_ray(picture.bounds, surface.origin, surface.normal,
                             sampler.point(Dimension::FloorSky, sample.index));
  if (ray.share <= 0.0f) return;
  queries.ask(sample, surface.origin, ray.towards,
              distance_to_end(scene, surface.origin, ray.towards),
              ray.share * sky.samples * surface.albedo * sky_radiance(scene.sky, ray.towards),
              Effect::taken_when_figure_blocks);
}

void darken_floor(const Picture& picture, const FloorSamples& batch, LightQueries& queries,
                  LineQueries& lines) {
  const Scene& scene = picture.scene;
  std::uint32_t shaded = 0;
  for (int i = 0; i < batch.samples.count; ++i) shaded |= batch.samples[i].pixel->shadow_lights;
  if ((shaded & lines.of_tile().lights) != 0) ask_lines(picture, batch, lines);
  for (shaded &= ~lines.of_tile().lights; shaded != 0; shaded &= shaded - 1) {
    const int k = std::countr_zero(shaded);
    ask_for_light(scene.lights[static_cast<std::size_t>(k)], k, batch, queries);
  }
  look_at_floor_sky(picture, batch, queries);
}

void show_open_set(const Picture& picture, const Sample& sample, const CameraFrame& camera,
                   const EyeRay& ray, LightQueries& queries) {
  const Scene& scene = picture.scene;
  Pixel& pixel = *sample.pixel;
  // Where all rays of a pixel start at one point, the set is what its centre shows.
  const EyeRay seen = picture.piecemeal() ? ray
                                          : camera.ray(static_cast<float>(pixel.x) + 0.5f,
                                                       static_cast<float>(pixel.y) + 0.5f);
  const SetPixel set = set_pixel(scene, camera, seen);
  pixel.known_set += set.radiance;
  const std::optional<float> distance = distance_to_floor(ray.origin, ray.direction);
  if (!set.shows_floor || !distance) return;
  Vec3 point = ray.origin + *distance * ray.direction;
  point.y() = 0.0f;
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const LightSample light = render::sample(
        scene.lights[k], point,
        pixel.sampler.point(Dimension::FirstLight, static_cast<int>(k), sample.index));
    if (light.towards.y() <= 0.0f) continue;
    queries.ask(sample, point, light.towards, light.distance,
                light.towards.y() / pi * light.perpendicular * set.visible_albedo,
                Effect::taken_when_blocked);
  }
  const Vec3 towards =
      cosine_direction(Vec3::UnitY(), pixel.sampler.point(Dimension::FloorSky, sample.index));
  if (towards.y() <= 0.0f) return;
  queries.ask(sample, point, towards, infinity,
              set.visible_albedo * sky_radiance(scene.sky, towards), Effect::taken_when_blocked);
}

}  // namespace mien::render
