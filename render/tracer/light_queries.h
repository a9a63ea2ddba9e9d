#pragma once

#include <array>

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

}  // namespace mien::render
