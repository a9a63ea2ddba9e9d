#pragma once

#include <memory>
#include <stop_token>
#include <string>

#include "render/image/film.h"
#include "render/image/layers.h"
#include "render/scene/camera.h"
#include "render/scene/quality.h"
#include "render/scene/scene.h"
#include "render/tracer/standing_sets.h"

namespace mien::render {

struct TracerOptions {
  int threads = 0;  ///< 0: one a core. No influence on the picture.

  /// Instruction set that Embree is pinned to: "sse2", "sse4.2", "avx", "avx2", "avx512". Empty:
  /// avx2, or sse4.2 on a machine without. No influence on the picture: Embree only finds
  /// candidates, the intersections are our own.
  std::string instruction_set;

  /// Once a stop is requested, what is being drawn is given up within a fraction of a second.
  std::stop_token stop = {};

  /// Where standing sets are shared with other tracers, and kept for later ones. No influence on
  /// the picture. None for sets that are seen once: where camera or ground move with every frame.
  StandingSets* sets = nullptr;
  KeepLight keep_light = {};
};

/// Thrown when a picture was given up because a stop was requested.
struct Stopped {};

/// Draws scenes with Embree: Lambert surfaces under area lights and a sky, direct light only, soft
/// shadows, filtered by a Blackman–Harris filter.
///
/// A picture depends on the scene, camera and quality alone: not on threads, on what was traced
/// before, nor on the machine. One trace at a time a Tracer; several Tracers may work side by side.
/// Whatever draws throws Stopped when it was asked to stop.
class Tracer {
 public:
  /// Throws Error when the machine cannot run Embree with that instruction set.
  explicit Tracer(const TracerOptions& options = {});
  ~Tracer();
  Tracer(Tracer&&) noexcept;
  Tracer& operator=(Tracer&&) noexcept;

  /// Drawn over a film that is no longer wanted, if one is given: of this size it saves the time
  /// that fresh memory takes. Throws std::invalid_argument when the scene or camera is degenerate
  /// (validate, frame_of).
  Film trace(const Scene& scene, const Camera& camera, const Quality& quality, Film used = {});

  /// As trace, with the alpha that the quality's background asks for, and as seen while a shutter
  /// is open: with `closing`, solids go straight from where they are in `scene` to where they are
  /// there, and likewise the camera; the set stays as it is in `scene`. Throws
  /// std::invalid_argument also when `closing` holds other solids.
  Exposure expose(const Scene& scene, const Camera& camera, const Quality& quality,
                  const Scene* closing = nullptr, const Camera* closing_camera = nullptr);

  /// A picture with all its layers: as `trace`, without blur by lens or shutter. With `next`,
  /// motion tells where each point is in that scene, which holds the same solids, through
  /// `next_camera`. The variance comes from eight pictures with noise patterns of their own.
  Layers layers(const Scene& scene, const Camera& camera, const Quality& quality,
                const Scene* next = nullptr, const Camera* next_camera = nullptr);

  /// For the provenance: "Embree 3.13.5, avx2".
  std::string description() const;

  int threads() const;

 private:
  Exposure expose_on(Film used, const Scene& scene, const Camera& camera, const Quality& quality,
                     const Scene* closing, const Camera* closing_camera);
  void add_variance(const Scene& scene, const Camera& camera, Quality quality, Layers& layers);

  struct Engine;
  std::unique_ptr<Engine> engine_;
};

}  // namespace mien::render
