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

bool is_black(const Surface& surface) {
  return (surface.albedo == 0.0f).all() && surface.material->specular_f0 == 0.0f;
}

void add_area_lights(const PreparedScene& prepared, const SurfaceSamples& batch,
                     const LaneVectors& origins, Contribution contribution,
                     ShadowRayQueue& shadow_rays) {
  const std::vector<AreaLight>& lights = prepared.scene.lights;
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const LanePoints u = points_for(batch.samples, Dimension::FirstLight, static_cast<int>(k));
    const LaneLights light = sample_lights(lights[k], origins, u);
    for (int i = 0; i < batch.samples.count; ++i) {
      const Surface& surface = batch.surfaces[static_cast<std::size_t>(i)];
      const Vec3 towards = light.towards.at(i);
      const float cosine = surface.normal.dot(towards);
      if (cosine <= 0.0f || light.share[i] <= 0.0f) continue;
      shadow_rays.enqueue(
          batch.samples[i], surface.origin, towards, light.distance[i],
          (cosine * light.share[i]) * lights[k].radiance * reflectance(surface, towards),
          contribution);
    }
  }
}

// The unoccluded sky's light is known in closed form; rays subtract what is occluded.
void add_sky(const PreparedScene& prepared, const SurfaceSamples& batch, const LaneVectors& normals,
             bool of_figure, ShadowRayQueue& shadow_rays) {
  const Sky& sky = prepared.scene.sky;
  for (int i = 0; i < batch.samples.count; ++i) {
    const Surface& surface = batch.surfaces[static_cast<std::size_t>(i)];
    add_light(batch.samples[i], of_figure ? &Pixel::known_figure : &Pixel::known_background,
              surface.albedo * unoccluded_sky_light(sky, surface.normal));
  }
  const bool shares = of_figure && prepared.quality.shares_figure_sky;
  const Contribution occluded = shares      ? Contribution::shared_sky_if_occluded
                                : of_figure ? Contribution::minus_figure_if_occluded
                                            : Contribution::minus_background_if_occluded;
  std::array<int, lanes> numbers{};
  for (int i = 0; shares && i < batch.samples.count; ++i)
    numbers[static_cast<std::size_t>(i)] =
        shadow_rays.shared_sky().add(batch.samples[i], batch.surfaces[static_cast<std::size_t>(i)]);
  const int rays = prepared.quality.sky_rays;
  const float share = 1.0f / static_cast<float>(rays);
  for (int k = 0; k < rays; ++k) {
    const LanePoints u = points_for(batch.samples, Dimension::FigureSky, 0, rays, k);
    const LaneVectors towards = cosine_directions(normals, u);
    for (int i = 0; i < batch.samples.count; ++i) {
      const Surface& surface = batch.surfaces[static_cast<std::size_t>(i)];
      const Vec3 direction = towards.at(i);
      const Color light = share * sky_radiance(sky, direction);
      shadow_rays.enqueue(batch.samples[i], surface.origin, direction,
                          distance_to_end(prepared.scene, surface.origin, direction),
                          shares ? light : Color(surface.albedo * light), occluded,
                          numbers[static_cast<std::size_t>(i)]);
    }
  }
}

/// A ray that tests the figure's occlusion of the sky from a surface, and the share of a uniform
/// sky's light that it represents.
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

void enqueue_light(const AreaLight& light, int k, const FloorSamples& batch,
                   ShadowRayQueue& shadow_rays) {
  const LaneLights chosen =
      sample_lights(light, batch.points, points_for(batch.samples, Dimension::FirstLight, k));
  for (int i = 0; i < batch.samples.count; ++i) {
    const Pixel& pixel = *batch.samples[i].pixel;
    const float cosine = chosen.towards.y[i];
    if (!pixel.may_be_shadowed(k) || cosine <= 0.0f) continue;
    shadow_rays.enqueue(batch.samples[i], batch.points.at(i), chosen.towards.at(i),
                        chosen.distance[i],
                        (cosine / pi * chosen.share[i]) * light.radiance * pixel.floor_albedo,
                        Contribution::shadow_if_figure_occludes);
  }
}

void enqueue_floor_sky(const PreparedScene& prepared, const FloorSamples& batch,
                       ShadowRayQueue& shadow_rays) {
  const auto looks = [&](int i) {
    return batch.samples[i].index < batch.samples[i].pixel->floor_sky_rays;
  };
  bool any = false;
  for (int i = 0; i < batch.samples.count && !any; ++i) any = looks(i);
  if (!any) return;
  const LaneSkyRays rays =
      floor_sky_rays(prepared.bounds.centre, prepared.bounds.radius, batch.points,
                     points_for(batch.samples, Dimension::FloorSky));
  for (int i = 0; i < batch.samples.count; ++i) {
    const Vec3 towards = rays.towards.at(i);
    if (!looks(i) || towards.y() <= 0.0f) continue;
    const Pixel& pixel = *batch.samples[i].pixel;
    shadow_rays.enqueue(batch.samples[i], batch.points.at(i), towards, infinity,
                        rays.share[i] * pixel.floor_sky_samples * pixel.floor_albedo *
                            sky_radiance(prepared.scene.sky, towards),
                        Contribution::shadow_if_figure_occludes);
  }
}

/// The samples of a pixel are adjacent.
void enqueue_lines(const PreparedScene& prepared, const FloorSamples& batch,
                   LineShadowQueue& line_shadows) {
  const Samples& samples = batch.samples;
  const int shared =
      shared_line(line_shadows.of_tile(), prepared.quality.samples_per_pixel).samples;
  for (int first = 0, last = 0; first < samples.count; first = last) {
    Pixel& pixel = *samples[first].pixel;
    const int group = samples[first].index / shared;
    while (last < samples.count && samples[last].pixel == &pixel &&
           samples[last].index / shared == group)
      ++last;
    if ((pixel.shadow_lights & line_shadows.of_tile().lights) != 0)
      line_shadows.enqueue(pixel, samples[first].index, last - first);
  }
}

}  // namespace

void ShadowRayQueue::trace() {
  if (rays_.count == 0) return;
  const std::uint32_t by_figure = prepared_.figure.occluded(rays_);
  const std::uint32_t by_set =
      prepared_.static_solids ? prepared_.static_solids->occluded(rays_) : 0;
  for (int i = 0; i < rays_.count; ++i) {
    const Query& query = queries_[static_cast<std::size_t>(i)];
    const bool figure = ((by_figure >> i) & 1u) != 0, background = ((by_set >> i) & 1u) != 0;
    switch (query.contribution) {
      case Contribution::figure_if_unoccluded:
        if (!figure && !background) add_light(query.sample, &Pixel::figure, query.light);
        break;
      case Contribution::background_if_unoccluded:
        if (!figure && !background) add_light(query.sample, &Pixel::background, query.light);
        break;
      case Contribution::minus_figure_if_occluded:
        if (figure || background) add_light(query.sample, &Pixel::figure, -query.light);
        break;
      case Contribution::shared_sky_if_occluded:
        if (figure || background) shared_sky_.occlude(query.sky_sample, query.light);
        break;
      case Contribution::minus_background_if_occluded:
        if (figure || background) add_light(query.sample, &Pixel::background, -query.light);
        break;
      case Contribution::shadow_if_figure_occludes:
        if (figure && !background) add_light(query.sample, &Pixel::occluded, -query.light);
        break;
      case Contribution::shadow_if_occluded:
        if (figure || background) add_light(query.sample, &Pixel::occluded, -query.light);
        break;
    }
  }
  rays_.count = 0;
}

void shade_surfaces(const PreparedScene& prepared, const SurfaceSamples& batch, bool of_figure,
                    ShadowRayQueue& shadow_rays) {
  SurfaceSamples lit;
  LaneVectors origins, normals;
  for (int i = 0; i < batch.samples.count; ++i) {
    const Surface& surface = batch.surfaces[static_cast<std::size_t>(i)];
    add_light(batch.samples[i], of_figure ? &Pixel::known_figure : &Pixel::known_background,
              surface.material->emission);
    if (is_black(surface)) continue;
    origins.set(lit.samples.count, surface.origin);
    normals.set(lit.samples.count, surface.normal);
    lit.push(batch.samples[i], surface);
  }
  if (lit.samples.count == 0) return;
  const Contribution contribution =
      of_figure ? Contribution::figure_if_unoccluded : Contribution::background_if_unoccluded;
  add_area_lights(prepared, lit, origins, contribution, shadow_rays);
  add_sky(prepared, lit, normals, of_figure, shadow_rays);
}

void shadow_static_solid(const PreparedScene& prepared, const Sample& sample,
                         const Surface& surface, ShadowRayQueue& shadow_rays) {
  const Scene& scene = prepared.scene;
  const PixelSampler& sampler = sample.pixel->sampler;
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const Point2 u = sampler.point(Dimension::FirstLight, static_cast<int>(k), sample.index);
    const LightSample light = render::sample(scene.lights[k], surface.origin, u);
    const float cosine = surface.normal.dot(light.towards);
    if (cosine <= 0.0f || !may_intersect(prepared.bounds, surface.origin, light.towards)) continue;
    shadow_rays.enqueue(sample, surface.origin, light.towards, light.distance,
                        cosine * light.perpendicular * reflectance(surface, light.towards),
                        Contribution::shadow_if_figure_occludes);
  }
  const SkyRays sky = sky_rays_of(prepared.bounds, surface.origin, surface.normal,
                                  prepared.quality.samples_per_pixel, sampler);
  if (sample.index >= sky.rays) return;
  const SkyRay ray = sky_ray(prepared.bounds, surface.origin, surface.normal,
                             sampler.point(Dimension::FloorSky, sample.index));
  if (ray.share <= 0.0f) return;
  shadow_rays.enqueue(
      sample, surface.origin, ray.towards, distance_to_end(scene, surface.origin, ray.towards),
      ray.share * sky.samples * surface.albedo * sky_radiance(scene.sky, ray.towards),
      Contribution::shadow_if_figure_occludes);
}

void shadow_floor(const PreparedScene& prepared, const FloorSamples& batch,
                  ShadowRayQueue& shadow_rays, LineShadowQueue& line_shadows) {
  const Scene& scene = prepared.scene;
  std::uint32_t shaded = 0;
  for (int i = 0; i < batch.samples.count; ++i) shaded |= batch.samples[i].pixel->shadow_lights;
  if ((shaded & line_shadows.of_tile().lights) != 0) enqueue_lines(prepared, batch, line_shadows);
  for (shaded &= ~line_shadows.of_tile().lights; shaded != 0; shaded &= shaded - 1) {
    const int k = std::countr_zero(shaded);
    enqueue_light(scene.lights[static_cast<std::size_t>(k)], k, batch, shadow_rays);
  }
  enqueue_floor_sky(prepared, batch, shadow_rays);
}

void add_unshadowed_background(const PreparedScene& prepared, const Sample& sample,
                               const CameraFrame& camera, const CameraRay& ray,
                               ShadowRayQueue& shadow_rays) {
  const Scene& scene = prepared.scene;
  Pixel& pixel = *sample.pixel;
  // Where all rays of a pixel start at one point, the set is what its centre shows.
  const CameraRay seen = prepared.is_per_sample() ? ray
                                                  : camera.ray(static_cast<float>(pixel.x) + 0.5f,
                                                               static_cast<float>(pixel.y) + 0.5f);
  const BackgroundPixel background = background_pixel(scene, camera, seen);
  pixel.known_background += background.radiance;
  const std::optional<float> distance = distance_to_floor(ray.origin, ray.direction);
  if (!background.shows_floor || !distance) return;
  Vec3 point = ray.origin + *distance * ray.direction;
  point.y() = 0.0f;
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    const LightSample light = render::sample(
        scene.lights[k], point,
        pixel.sampler.point(Dimension::FirstLight, static_cast<int>(k), sample.index));
    if (light.towards.y() <= 0.0f) continue;
    shadow_rays.enqueue(sample, point, light.towards, light.distance,
                        light.towards.y() / pi * light.perpendicular * background.visible_albedo,
                        Contribution::shadow_if_occluded);
  }
  const Vec3 towards =
      cosine_direction(Vec3::UnitY(), pixel.sampler.point(Dimension::FloorSky, sample.index));
  if (towards.y() <= 0.0f) return;
  shadow_rays.enqueue(sample, point, towards, infinity,
                      background.visible_albedo * sky_radiance(scene.sky, towards),
                      Contribution::shadow_if_occluded);
}

}  // namespace mien::render
