#pragma once

#include <array>

#include "render/light/shading.h"
#include "render/tracer/light_queries.h"
#include "render/tracer/line_queries.h"
#include "render/tracer/picture.h"
#include "render/tracer/pixel.h"

namespace mien::render {

/// Up to eight samples and the surfaces that they show.
struct SurfaceSamples {
  Samples samples;
  std::array<Surface, lanes> surfaces;

  void push(const Sample& sample, const Surface& surface) {
    surfaces[static_cast<std::size_t>(samples.count)] = surface;
    samples.push(sample);
  }
};

/// Up to eight samples and the points of the floor that they show.
struct FloorSamples {
  Samples samples;
  LaneVectors points;

  void push(const Sample& sample, const Vec3& point) {
    points.set(samples.count, point);
    samples.push(sample);
  }
};

/// All the light that surfaces send to the eye, from the lights and the sky.
void light_surfaces(const Picture& picture, const SurfaceSamples& batch, bool of_figure,
                    LightQueries& queries);

/// What the figure hides of the lights and the sky from a standing solid.
void darken_wall(const Picture& picture, const Sample& sample, const Surface& surface,
                 LightQueries& queries);

/// What the figure hides of the lights from the floor, and of the sky as far as the pixels are
/// planned to look for themselves.
void darken_floor(const Picture& picture, const FloorSamples& batch, LightQueries& queries,
                  LineQueries& lines);

/// The backdrop or floor at the end of a ray, with the shadows of everything: adds to the set of
/// the sample's pixel.
void show_open_set(const Picture& picture, const Sample& sample, const CameraFrame& camera,
                   const EyeRay& ray, LightQueries& queries);

}  // namespace mien::render
