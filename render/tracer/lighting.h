#pragma once

#include <array>

#include "render/light/shading.h"
#include "render/tracer/line_queries.h"
#include "render/tracer/picture.h"
#include "render/tracer/pixel.h"

namespace mien::render {

/// What becomes of the light that a query stands for.
enum class Effect {
  arrives_at_figure,         ///< unless something blocks the ray
  arrives_at_set,            ///< unless something blocks the ray
  taken_from_figure,         ///< when something blocks the ray, of what arrives without
  taken_from_set,            ///< likewise
  taken_when_figure_blocks,  ///< from what the set shows with nobody in it
  taken_when_blocked         ///< from what the open set shows, without its solids
};

/// Rays that ask whether light gets through, gathered and traced eight at a time. What they find is
/// added to the pixels, which have to stay where they are until `trace`.
class LightQueries {
 public:
  explicit LightQueries(const Picture& picture) : picture_(picture) {}

  /// `light`: of each sample that this one stands for.
  void ask(const Sample& sample, const Vec3& origin, const Vec3& direction, float distance,
           const Color& light, Effect effect) {
    if ((light == 0.0f).all()) return;
    queries_[static_cast<std::size_t>(rays_.count)] = {sample, light, effect};
    rays_.push(origin, direction, distance, sample.time, sample.present);
    if (rays_.count == packet_size) trace();
  }

  /// Those that are still waiting.
  void trace();

 private:
  struct Query {
    Sample sample;
    Color light = Color::Zero();
    Effect effect = Effect::arrives_at_figure;
  };

  const Picture& picture_;
  RayPacket rays_;
  std::array<Query, packet_size> queries_;
};

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
