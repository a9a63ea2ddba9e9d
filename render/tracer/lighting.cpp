#include "render/tracer/lighting.h"

#include <algorithm>
#include <array>

#include "render/light/light.h"
#include "render/math/constants.h"
#include "render/tracer/camera_rays.h"

namespace mien::render {
namespace {

using Condition = ShadowRays::Condition;

/// Points of a light, along its diagonal, whose mean is that of the whole light for all polynomials
/// of second degree but the product of both coordinates (Gauss).
constexpr std::array diagonal_points{0.21132487f, 0.78867513f};

LanePoints point_in_all_lanes(float u, float v) {
  LanePoints points;
  std::fill_n(points.u.lane, lanes, u);
  std::fill_n(points.v.lane, lanes, v);
  return points;
}

bool is_black(const Surface& surface) {
  return (surface.albedo == 0.0f).all() && surface.material->specular_f0 == 0.0f;
}

/// From a surface to a point of a light.
struct LightRay {
  Vec3 towards;    // unit
  float distance;  // metres
  Color irradiance;
};

/// Calls `work` with the number in the batch and the ray of each surface that faces the point `u`
/// of a light; whether anything occludes it is not tested.
template <class Work>
void for_lit(const AreaLight& light, std::span<const ShadingPoint> batch,
             const LaneVectors& origins, const LanePoints& u, const Work& work) {
  const LaneLights chosen = sample(light, origins, u);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const Surface& surface = batch[i].surface;
    const int lane = static_cast<int>(i);
    const Vec3 towards = chosen.towards.at(lane);
    const float irradiance = surface.normal.dot(towards) * chosen.share[lane];
    if (irradiance > 0.0f && !is_black(surface))
      work(i, LightRay{towards, chosen.distance[lane], irradiance * light.radiance});
  }
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

/// Adds what each of the samples that a point represents gets without rays.
void add_known(const Sample& sample, const Color& light, bool of_figure) {
  Pixel& pixel = *sample.pixel;
  (of_figure ? pixel.known_figure : pixel.known_set) += static_cast<float>(sample.count) * light;
}

/// The sum of the light that shadow rays of a sample decide about.
Color& sum_of(const Sample& sample, bool of_figure) {
  return of_figure ? sample.pixel->figure : sample.pixel->set;
}

/// Largest number of samples that a point represents.
int most_samples(std::span<const ShadingPoint> batch) {
  int most = 0;
  for (const ShadingPoint& point : batch) most = std::max(most, point.sample.count);
  return most;
}

/// Where the ray of one of the samples leaves that a point represents.
const Vec3& origin_of(const ShadingPoint& point, int number) {
  return number == 0 ? point.surface.origin
                     : point.more_origins[static_cast<std::size_t>(number) - 1];
}

/// For sample `number`, or the last one of a point that represents fewer.
LaneVectors origins_of(std::span<const ShadingPoint> batch, int number = 0) {
  LaneVectors origins;
  for (int i = 0; const ShadingPoint& point : batch)
    origins.set(i++, origin_of(point, std::min(number, point.sample.count - 1)));
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
    add_known(point.sample, point.surface.material->emission, of_figure);
  if (of_figure && shares_sky_) assign_groups(batch);
  add_area_lights(batch, of_figure);
  add_sky(batch, normals_of(batch), of_figure);
}

void Lighting::add_area_lights(std::span<const ShadingPoint> batch, bool of_figure) {
  const bool shares = of_figure && shares_lights_;
  for (int k = 0; const AreaLight& light : prepared_.scene.lights) {
    const int number = k++;
    const std::uint32_t needing_rays = shares ? add_unoccluded(light, batch) : ~0u;
    for (int ray = 0; needing_rays != 0 && ray < most_samples(batch); ++ray) {
      const LanePoints u = points_for(batch, Dimension::FirstLight, number, 1, ray);
      for_lit(light, batch, origins_of(batch, ray), u, [&](std::size_t i, const LightRay& lit) {
        if (((needing_rays >> i) & 1u) == 0 || ray >= batch[i].sample.count) return;
        const Surface& surface = batch[i].surface;
        Color reflected = reflectance(surface, lit.towards);
        if (shares) reflected -= surface.albedo / pi;
        rays_.push(batch[i].sample, origin_of(batch[i], ray), lit.towards, lit.distance,
                   lit.irradiance * reflected, Condition::visible,
                   sum_of(batch[i].sample, of_figure));
      });
    }
  }
}

// Adds the unoccluded diffuse reflection, of which the occluded share is subtracted later. Returns
// which points (bit i: number i of the batch) need shadow rays for their specular reflection; that
// of the others is small, and added here. The points of the light need not be random.
std::uint32_t Lighting::add_unoccluded(const AreaLight& light,
                                       std::span<const ShadingPoint> batch) {
  const LaneVectors origins = origins_of(batch);
  constexpr float small = 0.25f;  // of the diffuse reflection
  constexpr auto points = static_cast<float>(diagonal_points.size());
  std::array<Color, lanes> diffuse_sum, specular_sum;
  diffuse_sum.fill(Color::Zero());
  specular_sum.fill(Color::Zero());
  for (const float u : diagonal_points) {
    for_lit(light, batch, origins, point_in_all_lanes(u, u),
            [&](std::size_t i, const LightRay& lit) {
              const Surface& surface = batch[i].surface;
              const Color diffuse = surface.albedo / pi;
              diffuse_sum[i] += lit.irradiance * diffuse / points;
              specular_sum[i] +=
                  lit.irradiance * (reflectance(surface, lit.towards) - diffuse) / points;
            });
  }
  std::uint32_t needing_rays = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const bool needs_rays = specular_sum[i].sum() > small * diffuse_sum[i].sum();
    if (needs_rays) needing_rays |= 1u << i;
    add_to_group(i, batch[i].sample,
                 needs_rays ? diffuse_sum[i] : Color(diffuse_sum[i] + specular_sum[i]));
  }
  return needing_rays;
}

// The unoccluded sky's light is known in closed form; what is occluded is shared, or rays subtract
// it.
void Lighting::add_sky(std::span<const ShadingPoint> batch, const LaneVectors& normals,
                       bool of_figure) {
  const Sky& sky = prepared_.scene.sky;
  const bool shares = of_figure && shares_sky_;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const Sample& sample = batch[i].sample;
    const Surface& surface = batch[i].surface;
    if (is_black(surface)) continue;
    const Color light = surface.albedo * unoccluded_sky_light(sky, surface.normal);
    if (shares)
      add_to_group(i, sample, light);
    else
      add_known(sample, light, of_figure);
  }
  if (shares) return;
  const int rays = prepared_.quality.sky_rays;
  const float share = 1.0f / static_cast<float>(rays);
  for (int k = 0; k < rays * most_samples(batch); ++k) {
    const LaneVectors towards =
        cosine_directions(normals, points_for(batch, Dimension::FigureSky, 0, rays, k));
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const Surface& surface = batch[i].surface;
      if (is_black(surface) || k >= rays * batch[i].sample.count) continue;
      const Vec3 direction = towards.at(static_cast<int>(i));
      const Color light = surface.albedo * (share * sky_radiance(sky, direction));
      const Vec3& origin = origin_of(batch[i], k / rays);
      rays_.push(batch[i].sample, origin, direction,
                 distance_to_end(prepared_.scene, origin, direction), -light, Condition::occluded,
                 sum_of(batch[i].sample, of_figure));
    }
  }
}

// Adds light of the figure that is `number` of a batch, of which the occluded share is subtracted
// later.
void Lighting::add_to_group(std::size_t number, const Sample& sample, const Color& light) {
  add_known(sample, light, true);
  groups_[group_numbers_[number]].light += static_cast<float>(sample.count) * light;
}

// Finds or makes the groups of points; those of a pixel come one after the other.
void Lighting::assign_groups(std::span<const ShadingPoint> batch) {
  for (std::size_t i = 0; i < batch.size(); ++i) {
    Pixel* pixel = batch[i].sample.pixel;
    const int part = batch[i].surface.part;
    std::size_t number = groups_.size();
    while (number > 0 && groups_[number - 1].pixel == pixel && groups_[number - 1].part != part)
      --number;
    if (number == 0 || groups_[number - 1].pixel != pixel) {
      groups_.push_back({pixel, part});
      number = groups_.size();
    }
    group_numbers_[i] = number - 1;
    groups_[number - 1].normals +=
        static_cast<float>(batch[i].sample.count) * batch[i].surface.normal;
  }
}

void Lighting::subtract_batch(std::span<const ShadingPoint> batch, bool of_all) {
  const Scene& scene = prepared_.scene;
  const Condition lacking = of_all ? Condition::occluded : Condition::shadowed;
  const LaneVectors origins = origins_of(batch);
  std::uint32_t lights = 0;
  bool any_sky = false;
  for (const ShadingPoint& point : batch) {
    lights |= point.lights;
    any_sky |= point.sample.index < point.sky.rays;
  }
  for (std::size_t k = 0; k < scene.lights.size(); ++k) {
    if (((lights >> k) & 1u) == 0) continue;
    const LanePoints u = points_for(batch, Dimension::FirstLight, static_cast<int>(k));
    for_lit(scene.lights[k], batch, origins, u, [&](std::size_t i, const LightRay& ray) {
      const Vec3& origin = batch[i].surface.origin;
      if (((batch[i].lights >> k) & 1u) == 0) return;
      if (!of_all && !prepared_.quality.exhaustive &&
          !may_intersect(prepared_.bounds, origin, ray.towards))
        return;
      const Color light = ray.irradiance * reflectance(batch[i].surface, ray.towards);
      rays_.push(batch[i].sample, origin, ray.towards, ray.distance, -light, lacking,
                 sum_of(batch[i].sample, false));
    });
  }
  if (!any_sky) return;
  // Static solids may be all around.
  const float radius = of_all ? infinity : prepared_.bounds.radius;
  const LaneSphereRays rays =
      rays_to_sphere(prepared_.bounds.centre, radius, origins, normals_of(batch),
                     points_for(batch, Dimension::FloorSky));
  for (int i = 0; const ShadingPoint& point : batch) {
    const Vec3 towards = rays.towards.at(i);
    const float share = rays.share[i++];
    if (point.sample.index >= point.sky.rays || share <= 0.0f) continue;
    const Color light =
        share * point.sky.samples * point.surface.albedo * sky_radiance(scene.sky, towards);
    rays_.push(point.sample, point.surface.origin, towards,
               distance_to_end(scene, point.surface.origin, towards), -light, lacking,
               sum_of(point.sample, false));
  }
}

void Lighting::finish() {
  rays_.finish();
  for (const Group& group : groups_) {
    if ((group.light == 0.0f).all()) continue;
    Pixel& pixel = *group.pixel;
    pixel.figure -= group.light * prepared_.shared_occlusion.on_figure(pixel.x, pixel.y, group.part,
                                                                       group.normals);
  }
  groups_.clear();
}

}  // namespace mien::render
