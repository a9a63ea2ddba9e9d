#include "render/tracer/lighting.h"

#include <algorithm>

#include "render/light/light.h"
#include "render/math/constants.h"
#include "render/tracer/camera_rays.h"

namespace mien::render {
namespace {

bool is_black(const Surface& surface) {
  return (surface.albedo == 0.0f).all() && surface.material->specular_f0 == 0.0f;
}

/// Splits points into batches of up to eight. Those of a pixel stay together, or begin a batch: so
/// a pixel's light is always summed in the same order, whatever else is rendered.
template <class Work>
void for_batches(std::span<const ShadingPoint> points, const Work& work) {
  std::size_t count = 0;  // of the batch at the beginning of `points`
  while (count < points.size()) {
    std::size_t end = count + 1;
    while (end < points.size() && points[count].sample.pixel == points[end].sample.pixel) ++end;
    if (end > lanes && count > 0) {
      work(points.first(count));
      points = points.subspan(count);
      end -= count;
    }
    for (; end > lanes; end -= lanes) {
      work(points.first(lanes));
      points = points.subspan(lanes);
    }
    count = end;
  }
  if (count > 0) work(points);
}

LaneVectors origins_of(std::span<const ShadingPoint> batch) {
  LaneVectors origins;
  for (int i = 0; const ShadingPoint& point : batch) origins.set(i++, point.surface.origin);
  return origins;
}

LaneVectors normals_of(std::span<const ShadingPoint> batch) {
  LaneVectors normals;
  for (int i = 0; const ShadingPoint& point : batch) normals.set(i++, point.surface.normal);
  return normals;
}

}  // namespace

void Lighting::shade(std::span<const ShadingPoint> points, bool of_figure) {
  for_batches(points, [&](std::span<const ShadingPoint> batch) { shade_batch(batch, of_figure); });
}

void Lighting::subtract(std::span<const ShadingPoint> points, bool of_all) {
  for_batches(points, [&](std::span<const ShadingPoint> batch) { subtract_batch(batch, of_all); });
}

void Lighting::shade_batch(std::span<const ShadingPoint> batch, bool of_figure) {
  for (const ShadingPoint& point : batch)
    add_light(point.sample, of_figure ? &Pixel::known_figure : &Pixel::known_set,
              point.surface.material->emission);
  add_area_lights(batch, origins_of(batch), of_figure ? &Pixel::figure : &Pixel::set);
  add_sky(batch, normals_of(batch), of_figure);
}

void Lighting::add_area_lights(std::span<const ShadingPoint> batch, const LaneVectors& origins,
                               Color Pixel::*sum) {
  for (int k = 0; const AreaLight& light : prepared_.scene.lights) {
    const LaneLights chosen = sample(light, origins, points_for(batch, Dimension::FirstLight, k++));
    for (int i = 0; const ShadingPoint& point : batch) {
      const Vec3 towards = chosen.towards.at(i);
      const float irradiance = point.surface.normal.dot(towards) * chosen.share[i];
      const float distance = chosen.distance[i++];
      if (irradiance <= 0.0f || is_black(point.surface)) continue;
      const Color radiance = irradiance * light.radiance * reflectance(point.surface, towards);
      enqueue({point.sample, radiance, sum, Decision::adds_if_visible}, point.surface.origin,
              towards, distance);
    }
  }
}

// The unoccluded sky's light is known in closed form; what is occluded is shared, or rays subtract
// it.
void Lighting::add_sky(std::span<const ShadingPoint> batch, const LaneVectors& normals,
                       bool of_figure) {
  const Sky& sky = prepared_.scene.sky;
  const bool shares = of_figure && prepared_.quality.sky_sharing_pixels > 0;
  for (const ShadingPoint& point : batch) {
    const Surface& surface = point.surface;
    if (is_black(surface)) continue;
    const Color light = surface.albedo * unoccluded_sky_light(sky, surface.normal);
    add_light(point.sample, of_figure ? &Pixel::known_figure : &Pixel::known_set, light);
    if (shares) add_to_group(point, light);
  }
  if (shares) return;
  Query query;
  query.sum = of_figure ? &Pixel::figure : &Pixel::set;
  query.decision = Decision::subtracts_if_occluded;
  const int rays = prepared_.quality.sky_rays;
  const float share = 1.0f / static_cast<float>(rays);
  for (int k = 0; k < rays; ++k) {
    const LaneVectors towards =
        cosine_directions(normals, points_for(batch, Dimension::FigureSky, 0, rays, k));
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const Surface& surface = batch[i].surface;
      if (is_black(surface)) continue;
      const Vec3 direction = towards.at(static_cast<int>(i));
      query.sample = batch[i].sample;
      query.light = surface.albedo * (share * sky_radiance(sky, direction));
      enqueue(query, surface.origin, direction,
              distance_to_end(prepared_.scene, surface.origin, direction));
    }
  }
}

// `light`: what it reflects of the unoccluded sky.
void Lighting::add_to_group(const ShadingPoint& point, const Color& light) {
  const Sample& sample = point.sample;
  const int part = point.surface.part;
  std::size_t number = groups_.size();
  while (number > 0 && groups_[number - 1].pixel == sample.pixel &&
         groups_[number - 1].part != part)
    --number;
  if (number == 0 || groups_[number - 1].pixel != sample.pixel) {
    groups_.push_back({sample.pixel, part});
    number = groups_.size();
  }
  Group& group = groups_[number - 1];
  group.normals += sample.weight * point.surface.normal;
  group.light += sample.weight * light;
}

void Lighting::subtract_batch(std::span<const ShadingPoint> batch, bool of_all) {
  const Scene& scene = prepared_.scene;
  Query query;
  query.sum = &Pixel::set;
  const Decision subtracts =
      of_all ? Decision::subtracts_if_occluded : Decision::subtracts_if_shadowed;
  const LaneVectors origins = origins_of(batch);
  std::uint32_t lights = 0;
  bool any_sky = false;
  for (const ShadingPoint& point : batch) {
    lights |= point.lights;
    any_sky |= point.sample.index < point.sky.rays;
  }
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    if (((lights >> k) & 1u) == 0) continue;
    const LaneLights chosen = sample(scene.lights[k], origins,
                                     points_for(batch, Dimension::FirstLight, static_cast<int>(k)));
    for (int i = 0; const ShadingPoint& point : batch) {
      const Vec3 towards = chosen.towards.at(i);
      const float irradiance = point.surface.normal.dot(towards) * chosen.share[i];
      const float distance = chosen.distance[i++];
      if (((point.lights >> k) & 1u) == 0 || irradiance <= 0.0f) continue;
      if (!of_all && !prepared_.quality.exhaustive &&
          !may_intersect(prepared_.bounds, point.surface.origin, towards))
        continue;
      const Color light = irradiance * scene.lights[k].radiance;
      query.sample = point.sample;
      query.decision = subtracts;
      query.light = light * reflectance(point.surface, towards);
      enqueue(query, point.surface.origin, towards, distance);
    }
  }
  if (!any_sky) return;
  query.decision = subtracts;
  // Static solids may be all around.
  const float radius = of_all ? infinity : prepared_.bounds.radius;
  const LaneSphereRays rays =
      rays_to_sphere(prepared_.bounds.centre, radius, origins, normals_of(batch),
                     points_for(batch, Dimension::FloorSky));
  for (int i = 0; const ShadingPoint& point : batch) {
    const Vec3 towards = rays.towards.at(i);
    const float share = rays.share[i++];
    if (point.sample.index >= point.sky.rays || share <= 0.0f) continue;
    query.sample = point.sample;
    query.light =
        share * point.sky.samples * point.surface.albedo * sky_radiance(scene.sky, towards);
    enqueue(query, point.surface.origin, towards,
            distance_to_end(scene, point.surface.origin, towards));
  }
}

void Lighting::enqueue(const Query& query, const Vec3& origin, const Vec3& direction,
                       float distance) {
  if ((query.light == 0.0f).all()) return;
  queries_[static_cast<std::size_t>(rays_.count)] = query;
  rays_.push(origin, direction, distance, query.sample.time, query.sample.present);
  if (rays_.count == packet_size) trace();
}

void Lighting::trace() {
  if (rays_.count == 0) return;
  const std::uint32_t by_figure = prepared_.figure.occluded(rays_);
  const std::uint32_t by_set =
      prepared_.static_solids != nullptr ? prepared_.static_solids->occluded(rays_) : 0;
  for (int i = 0; i < rays_.count; ++i) {
    const Query& query = queries_[static_cast<std::size_t>(i)];
    const bool figure = ((by_figure >> i) & 1u) != 0, set = ((by_set >> i) & 1u) != 0;
    switch (query.decision) {
      case Decision::adds_if_visible:
        if (!figure && !set) add_light(query.sample, query.sum, query.light);
        break;
      case Decision::subtracts_if_occluded:
        if (figure || set) add_light(query.sample, query.sum, -query.light);
        break;
      case Decision::subtracts_if_shadowed:
        if (figure && !set) add_light(query.sample, query.sum, -query.light);
        break;
    }
  }
  rays_.count = 0;
}

void Lighting::finish() {
  trace();
  for (const Group& group : groups_) {
    Pixel& pixel = *group.pixel;
    pixel.figure -= group.light * prepared_.shared_occlusion.on_figure(pixel.x, pixel.y, group.part,
                                                                       group.normals);
  }
  groups_.clear();
}

}  // namespace mien::render
