#pragma once

#include "render/tracer/pixel.h"
#include "render/tracer/prepared_scene.h"

namespace mien::render {

/// The camera at the time of a sample.
CameraFrame camera_of(const PreparedScene& prepared, const Sample& sample);

/// The primary rays of up to eight samples.
void primary_rays(const PreparedScene& prepared, const Samples& samples, LaneVectors& origins,
                  LaneVectors& directions);

/// The point of the floor at that distance along a primary ray.
inline Vec3 floor_point(const CameraRay& ray, float distance) {
  Vec3 point = ray.origin + distance * ray.direction;
  point.y() = 0.0f;
  return point;
}

}  // namespace mien::render
