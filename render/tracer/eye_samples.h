#pragma once

#include "render/tracer/picture.h"
#include "render/tracer/pixel.h"

namespace mien::render {

/// The camera at the time of a sample.
CameraFrame camera_of(const Picture& picture, const Sample& sample);

/// The rays from the eye of up to eight samples.
void aim(const Picture& picture, const Samples& samples, LaneVectors& origins,
         LaneVectors& directions);

/// The point of the floor at that distance along a ray from the eye.
inline Vec3 floor_point(const EyeRay& ray, float distance) {
  Vec3 point = ray.origin + distance * ray.direction;
  point.y() = 0.0f;
  return point;
}

}  // namespace mien::render
