#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "render/image/framebuffer.h"
#include "render/image/layers.h"
#include "render/image/window.h"
#include "render/scene/camera.h"
#include "render/scene/quality.h"
#include "render/scene/scene.h"
#include "render/tracer/static_background_cache.h"

namespace mien::render {

struct TracerOptions {
  int threads = 0;  ///< 0: one per core. Does not affect the picture.

  /// Instruction set that Embree is pinned to: "sse2", "sse4.2", "avx", "avx2", "avx512". Empty:
  /// avx2, or sse4.2 on a machine without AVX2. Does not affect the picture: Embree only finds
  /// candidates, the intersection tests are our own.
  std::string instruction_set;

  /// Once a stop is requested, rendering is aborted within a fraction of a second.
  std::stop_token stop = {};

  /// Caches by which static backgrounds are shared with other tracers and stored for later ones.
  /// They do not affect the picture. Leave them empty if each background is seen only once, because
  /// the camera or the ground moves with every frame.
  StaticBackgroundCache* backgrounds = nullptr;
  LightCache light_cache = {};
};

/// Thrown when rendering was aborted because a stop was requested.
struct Stopped {};

class Engine;  // the implementation (engine.h)

/// The scene, camera and quality of a picture.
struct View {
  Scene scene;
  Camera camera;
  Quality quality;

  /// Motion blur: the solids and the camera at the end of the frame interval, when a shutter of 1
  /// (Quality::shutter) closes. They move there in straight lines from their positions in `scene`
  /// and `camera`, which hold when the shutter opens. The set stays as in `scene`.
  std::optional<Scene> closing;
  std::optional<Camera> closing_camera;
};

/// A view prepared for rendering: acceleration structures and culling masks. It is rendered once,
/// by the tracer that prepared it, which must outlive it.
class PreparedView {
 public:
  PreparedView();
  ~PreparedView();
  PreparedView(PreparedView&&) noexcept;
  PreparedView& operator=(PreparedView&&) noexcept;

 private:
  friend class Tracer;
  struct Contents;
  std::unique_ptr<Contents> contents_;  // null: nothing is prepared
};

/// A rectangle of finished pixels.
struct RenderedRegion {
  const Framebuffer& framebuffer;  ///< contains the finished pixels, and possibly others
  Window pixels;                   ///< which pixels of the framebuffer
  /// Position of the region in the part that is rendered (window_of), pixels.
  int x = 0;
  int y = 0;
};
using OnRegion = std::function<void(const RenderedRegion& part)>;

/// Callbacks for the frames of a clip, numbered from 0.
struct FrameCallbacks {
  /// Called in order, one frame at a time. Returns false if there is neither this frame nor any
  /// later one.
  std::function<bool(std::size_t frame)> begin;

  /// Called for several frames concurrently.
  std::function<void(std::size_t frame)> draw;

  /// Called in order, one frame at a time.
  std::function<void(std::size_t frame)> end;
};

/// Renders scenes with Embree: diffuse surfaces with an optional specular lobe under area lights
/// and a sky, with direct light and soft shadows only. Pixels are reconstructed with a
/// Blackman–Harris filter.
///
/// A picture depends on the scene, camera and quality alone: not on the threads, previous pictures
/// or the machine. A Tracer may render several prepared views at a time while another is being
/// prepared (`trace`, `render_view` and `layers` prepare their own); several Tracers may work
/// concurrently. All rendering functions throw Stopped when a stop was requested.
class Tracer {
 public:
  /// Throws Error when the machine cannot run Embree with that instruction set.
  explicit Tracer(const TracerOptions& options = {});
  ~Tracer();
  Tracer(Tracer&&) noexcept;
  Tracer& operator=(Tracer&&) noexcept;

  /// Throws std::invalid_argument when a scene or camera is degenerate (validate, frame_of), a
  /// setting of the quality is out of range, or `closing` holds other solids than the scene.
  PreparedView prepare(View view);

  /// Renders a picture, with alpha if the quality's background asks for it. Throws std::logic_error
  /// when nothing is prepared.
  RenderTarget draw(PreparedView ready);

  /// Renders a picture whose background is shown and passes each region on as soon as it is
  /// finished, several at a time, so that no framebuffer of the whole is needed. Throws
  /// std::logic_error when nothing is prepared or the background is not shown, and what `take`
  /// throws.
  void draw(PreparedView ready, const OnRegion& take);

  /// Renders the frames of a clip with the tracer's threads, at most `in_flight` at a time. While
  /// one is prepared or its last parts are rendered, threads render the next one. Throws what the
  /// callbacks throw; `begin` may then have been called for frames for which `end` never is.
  void for_frames(const FrameCallbacks& work, int in_flight);

  /// Prepares and renders a picture with its background shown. Throws as `prepare`.
  Framebuffer trace(Scene scene, const Camera& camera, const Quality& quality);

  /// Prepares and renders a view, with the background that its quality selects. Throws as
  /// `prepare`.
  RenderTarget render_view(View view);

  /// A picture with all its layers: as `trace`, without depth of field or motion blur. Motion
  /// vectors point to the position of each point in `next`, a scene of the same solids, as seen by
  /// `next_camera`; without `next` nothing moves, and without `next_camera` the camera stays. The
  /// variance is that of eight pictures with different noise patterns. Throws as `prepare`, also
  /// when `next` has other solids.
  Layers layers(const Scene& scene, const Camera& camera, const Quality& quality,
                const Scene* next = nullptr, const Camera* next_camera = nullptr);

  /// Renderer version for provenance records: "Embree 3.13.5, avx2".
  std::string description() const;

  int threads() const;

 private:
  static const PreparedView::Contents& contents_of(const PreparedView& ready);
  void add_variance(const Scene& scene, const Camera& camera, Quality quality, Layers& layers);

  std::unique_ptr<Engine> engine_;
};

}  // namespace mien::render
