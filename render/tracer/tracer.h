#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "render/image/film.h"
#include "render/image/layers.h"
#include "render/image/window.h"
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

class Engine;  // what a tracer works with (engine.h)

/// What a picture shows.
struct View {
  Scene scene;
  Camera camera;
  Quality quality;

  /// Where solids are and from where they are seen when a shutter closes that was open from
  /// `scene` and `camera` on: they go straight there. The set stays as it is in `scene`.
  std::optional<Scene> closing;
  std::optional<Camera> closing_camera;
};

/// A view made ready: where its figures and their shadows can be is known, and rays find their way.
/// Drawn once, by the tracer that made it ready and outlives it.
class ReadyPicture {
 public:
  ReadyPicture();
  ~ReadyPicture();
  ReadyPicture(ReadyPicture&&) noexcept;
  ReadyPicture& operator=(ReadyPicture&&) noexcept;

 private:
  friend class Tracer;
  struct Contents;
  std::unique_ptr<Contents> contents_;  // null: nothing is ready
};

/// Pixels of a picture that have their light.
struct DrawnPart {
  const Film& film;  ///< holds them, and may hold others
  Window pixels;     ///< which of that film's
  int x = 0;         ///< where the first of them is in what the camera shows
  int y = 0;
};
using TakePart = std::function<void(const DrawnPart& part)>;

/// What is done for the frames of a film, which are numbered from 0 on.
struct FrameWork {
  /// In order, one at a time; false: there is no such frame, and no further one.
  std::function<bool(std::size_t frame)> begin;

  /// Several at a time.
  std::function<void(std::size_t frame)> draw;

  /// In order, one at a time.
  std::function<void(std::size_t frame)> end;
};

/// Draws scenes with Embree: Lambert surfaces under area lights and a sky, direct light only, soft
/// shadows, filtered by a Blackman–Harris filter.
///
/// A picture depends on the scene, camera and quality alone: not on threads, on what was traced
/// before, nor on the machine. Several pictures that are ready may be drawn by a Tracer at a time,
/// and one made ready meanwhile, as `trace`, `expose` and `layers` do themselves; several Tracers
/// may work side by side. Whatever draws throws Stopped when it was asked to stop.
class Tracer {
 public:
  /// Throws Error when the machine cannot run Embree with that instruction set.
  explicit Tracer(const TracerOptions& options = {});
  ~Tracer();
  Tracer(Tracer&&) noexcept;
  Tracer& operator=(Tracer&&) noexcept;

  /// Throws std::invalid_argument when a scene or camera is degenerate (validate, frame_of), or
  /// `closing` holds other solids than the scene.
  ReadyPicture prepare(View view);

  /// With the alpha that the quality's background asks for. Throws std::logic_error when nothing is
  /// ready.
  Exposure draw(ReadyPicture ready);

  /// A picture whose background is shown, part by part, several at a time: what takes the light of
  /// each as soon as it is there needs no film of the whole. Throws likewise, and what `take`
  /// throws.
  void draw(ReadyPicture ready, const TakePart& take);

  /// Works on a film with the tracer's threads: so many frames at most have begun and not ended.
  /// While one is made ready or its last parts are drawn, threads draw the next one. Throws what
  /// the work throws, and then some frames may have begun that do not end.
  void for_frames(const FrameWork& work, int in_flight);

  /// A picture without more ado, its background shown. Throws as prepare.
  Film trace(Scene scene, const Camera& camera, const Quality& quality);

  /// Likewise as its quality has it.
  Exposure expose(View view);

  /// A picture with all its layers: as `trace`, without blur by lens or shutter. With `next`,
  /// motion tells where each point is in that scene, which holds the same solids, through
  /// `next_camera`. The variance comes from eight pictures with noise patterns of their own.
  Layers layers(const Scene& scene, const Camera& camera, const Quality& quality,
                const Scene* next = nullptr, const Camera* next_camera = nullptr);

  /// For the provenance: "Embree 3.13.5, avx2".
  std::string description() const;

  int threads() const;

 private:
  static const ReadyPicture::Contents& contents_of(const ReadyPicture& ready);
  void add_variance(const Scene& scene, const Camera& camera, Quality quality, Layers& layers);

  std::unique_ptr<Engine> engine_;
};

}  // namespace mien::render
