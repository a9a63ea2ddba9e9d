#pragma once

#include <array>
#include <optional>
#include <span>

#include "render/tracer/prepared_scene.h"
#include "render/tracer/samples.h"

namespace mien::render {

/// Returns the sample of a pixel with this index: when it is taken and which figures are present.
Sample sample_at(const PreparedScene& prepared, Pixel& pixel, int index);

/// Returns the rays of up to eight samples; they end at the floor.
RayPacket camera_rays(const PreparedScene& prepared, std::span<const Sample> samples);

/// Returns the point of the floor at which a ray ends; nothing if it goes past the floor.
std::optional<Vec3> floor_point(const RayPacket& rays, int ray);

/// Returns the distance at which a ray of light from the sky ends: the floor occludes nothing, but
/// what lies below it does not occlude either.
float distance_to_end(const Scene& scene, const Vec3& origin, const Vec3& direction);

/// The solid that a camera ray meets first.
struct FirstHit {
  int shape = -1;  ///< index into the figure's shapes, or the static ones; −1: none
  bool of_figure = false;
  float distance = 0.0f;  ///< metres

  bool exists() const { return shape >= 0; }
};

/// Returns what each ray meets first. Without `with_figure`, static solids only.
std::array<FirstHit, packet_size> first_hits(const PreparedScene& prepared, const RayPacket& rays,
                                             bool with_figure = true);

/// Returns whether two hits of figures in one pixel are of one triangle, of one round cone that
/// hardly bends within a pixel, or of triangles of one mesh at about the same distance and with
/// about the same normal.
bool are_of_one_surface(const PreparedScene& prepared, const FirstHit& one, const FirstHit& other);

/// Returns the surface of a solid that a ray hit, as seen along `direction` at a point.
Surface surface_at(const PreparedScene& prepared, const FirstHit& hit, const Vec3& point,
                   const Vec3& direction, float time);

/// Returns the surface that a ray meets.
Surface surface_at(const PreparedScene& prepared, const RayPacket& rays, int ray,
                   const FirstHit& hit);

}  // namespace mien::render
