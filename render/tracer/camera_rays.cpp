#include "render/tracer/camera_rays.h"

#include <algorithm>
#include <cmath>

#include "render/light/floor.h"
#include "render/math/constants.h"
#include "render/math/directions.h"

namespace mien::render {
namespace {

CameraFrame between(const CameraFrame& from, const CameraFrame& to, float time) {
  CameraFrame frame = from;
  frame.position += time * (to.position - from.position);
  frame.forward = (from.forward + time * (to.forward - from.forward)).normalized();
  frame.step_right += time * (to.step_right - from.step_right);
  frame.step_down += time * (to.step_down - from.step_down);
  return frame;
}

/// Returns the ray of a sample whose camera moves or has an aperture.
CameraRay own_ray(const PreparedScene& prepared, const Sample& sample, float x, float y) {
  const DiscPoint lens = disc_point(sample.pixel->sampler.point(Dimension::Lens, sample.index));
  const CameraFrame camera = prepared.closing_camera
                                 ? between(prepared.camera, *prepared.closing_camera, sample.time)
                                 : prepared.camera;
  return camera.ray(x, y, lens.x, lens.y);
}

}  // namespace

Sample sample_at(const PreparedScene& prepared, Pixel& pixel, int index) {
  Sample sample;
  sample.pixel = &pixel;
  sample.index = index;
  if (prepared.closing_solids != nullptr || prepared.closing_camera)
    sample.time = prepared.quality.shutter * pixel.sampler.point(Dimension::Time, index).u;
  if (!prepared.figure.shapes().all_present)
    sample.present = present_figures(pixel.sampler, prepared.opacities, index);
  return sample;
}

RayPacket camera_rays(const PreparedScene& prepared, std::span<const Sample> samples) {
  const LanePoints u = points_for(samples, Dimension::PixelPosition);
  LaneFloats x, y;
  for (int i = 0; const Sample& sample : samples) {
    x[i] = static_cast<float>(sample.pixel->x) + 0.5f + prepared.filter.offset(u.u[i]);
    y[i] = static_cast<float>(sample.pixel->y) + 0.5f + prepared.filter.offset(u.v[i]);
    ++i;
  }
  LaneRays found;
  if (prepared.is_per_sample()) {
    for (int i = 0; const Sample& sample : samples) {
      const CameraRay ray = own_ray(prepared, sample, x[i], y[i]);
      found.origin.set(i, ray.origin);
      found.direction.set(i++, ray.direction);
    }
  } else {
    found = camera_rays(prepared.camera, x, y);
  }
  RayPacket rays;
  for (const Sample& sample : samples) {
    const Vec3 origin = found.origin.at(rays.count), direction = found.direction.at(rays.count);
    const std::optional<float> floor =
        prepared.scene.has_ground ? distance_to_floor(origin, direction) : std::nullopt;
    rays.push(origin, direction, floor.value_or(infinity), sample.time, sample.present);
  }
  return rays;
}

std::optional<Vec3> floor_point(const RayPacket& rays, int ray) {
  if (rays.reach[ray] == infinity) return std::nullopt;
  Vec3 point = rays.origin(ray) + rays.reach[ray] * rays.direction(ray);
  point.y() = 0.0f;
  return point;
}

float distance_to_end(const Scene& scene, const Vec3& origin, const Vec3& direction) {
  if (!scene.has_ground) return infinity;
  return distance_to_floor(origin, direction).value_or(infinity);
}

std::array<FirstHit, packet_size> first_hits(const PreparedScene& prepared, const RayPacket& rays,
                                             bool with_figure) {
  std::array<FirstHit, packet_size> first;
  const auto add = [&](const EmbreeScene& scene, bool of_figure) {
    const Hits hits = scene.intersect(rays);
    for (int i = 0; i < rays.count; ++i) {
      FirstHit& nearest = first[static_cast<std::size_t>(i)];
      if (hits.shape[i] >= 0 && (!nearest.exists() || hits.distance[i] < nearest.distance))
        nearest = {hits.shape[i], of_figure, hits.distance[i]};
    }
  };
  if (with_figure) add(prepared.figure, true);
  if (prepared.static_solids != nullptr) add(*prepared.static_solids, false);
  return first;
}

Surface surface_at(const PreparedScene& prepared, const FirstHit& hit, const Vec3& point,
                   const Vec3& direction, float time) {
  if (hit.of_figure)
    return surface_at(prepared.scene, prepared.solids, prepared.closing_solids,
                      prepared.figure.shapes(), hit.shape, point, direction, time);
  return surface_at(prepared.scene, prepared.scene.static_solids, nullptr,
                    prepared.static_solids->shapes(), hit.shape, point, direction, 0.0f);
}

Surface surface_at(const PreparedScene& prepared, const RayPacket& rays, int ray,
                   const FirstHit& hit) {
  const Vec3 direction = rays.direction(ray);
  return surface_at(prepared, hit, rays.origin(ray) + hit.distance * direction, direction,
                    rays.time[ray]);
}

bool are_of_one_surface(const PreparedScene& prepared, const FirstHit& one, const FirstHit& other) {
  constexpr float pixels_of_radius = 3.0f, pixels_of_distance = 2.0f, cosine = 0.95f;
  const float pixel = prepared.camera.step_right.norm() *
                      (prepared.camera.parallel ? 1.0f : one.distance);  // width, metres
  const Shapes& shapes = prepared.figure.shapes();
  const int cones = static_cast<int>(shapes.cones.size());
  if (one.shape < cones || other.shape < cones) {
    if (one.shape != other.shape) return false;
    const PreparedCone& cone = shapes.cones[static_cast<std::size_t>(one.shape)];
    return std::min(cone.radius_a, cone.radius_b) > pixels_of_radius * pixel;
  }
  if (one.shape == other.shape) return true;
  const auto source = [&](const FirstHit& hit) {
    return shapes.sources[static_cast<std::size_t>(hit.shape - cones)];
  };
  if (source(one).mesh != source(other).mesh ||
      std::abs(one.distance - other.distance) >= pixels_of_distance * pixel)
    return false;
  const Mesh& mesh = prepared.solids.meshes[static_cast<std::size_t>(source(one).mesh)];
  const auto normal = [&](const FirstHit& hit) -> const Vec3& {
    const auto& corners = mesh.triangles[static_cast<std::size_t>(source(hit).triangle)];
    return mesh.normals[static_cast<std::size_t>(corners[0])];
  };
  return normal(one).dot(normal(other)) > cosine;
}

}  // namespace mien::render
