#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/tasks/stopwatch.h"
#include "pipeline/tasks/store.h"
#include "render/image/image.h"
#include "render/image/layers.h"
#include "render/scene/quality.h"
#include "render/tracer/static_background_cache.h"
#include "render/tracer/tracer.h"
#include "scenes/stage/shot.h"

namespace mien::pipeline {

/// How a shot is drawn.
struct FilmSettings {
  Output output;
  std::uint64_t seed = 0;        ///< of the renderer's noise
  int threads = 1;               ///< no influence on the pictures
  Stopwatch* drawing = nullptr;  ///< if any, runs while a frame is traced or encoded
  int eyes = 1;                  ///< pictures side by side in each frame: 2 of a stereo pair
  bool loops = false;            ///< animated pictures repeat for ever

  /// Called for each frame that was rendered with the seconds since the one before was handed on,
  /// or since its own beginning: their sum is the rendering time.
  std::function<void(double)> on_frame_drawn = {};

  /// Static backgrounds shared with other films, and their light cached on disk. No influence on
  /// the pictures.
  render::StaticBackgroundCache* sets = nullptr;
  render::LightCache light_cache = {};
};

/// The renderer's options for a film of that shot. Sets that change from frame to frame are not
/// shared.
render::TracerOptions tracer_options(const FilmSettings& settings, const scenes::Shot& shot,
                                     const std::stop_token& stop = {});

/// The renderer's settings for them.
render::Quality quality_of(const FilmSettings& settings);

/// The renderer's settings for a shot. A background that changes from frame to frame, by a moving
/// camera or ground, gets no more samples than the rest.
render::Quality quality_of(const FilmSettings& settings, const scenes::Shot& shot);

/// A frame with its layers, and motion to the next one.
render::Layers layers_of(render::Tracer& tracer, const scenes::Shot& shot, int frame,
                         const render::Quality& quality);

/// Numbers of frames, from `first` to the one before `end`.
std::vector<int> frames_between(int first, int end);

/// Takes the frames, in order, as a display shows them.
using FrameSink = std::function<void(int frame, const render::Image8& picture)>;

/// Draws frames, some at a time (FrameDrawer::in_flight), and hands them on. Meanwhile earlier ones
/// are written, read back and taken by the sink in a thread of its own; at most one waits in
/// between, however long the shot. Of a film that is given up, frames are lost that are in flight
/// then.
///
/// With `store`, frames that it has are not drawn again, and each new one is kept there unless the
/// output's frames are none (those that it has are then PNG); the sink gets what was stored, so a
/// resumed film is the same to the last bit. Throws Interrupted soon after a stop request, and what
/// the tracer, the store or the sink throw.
void draw_frames(const scenes::Shot& shot, const std::vector<int>& frames,
                 const FilmSettings& settings, FrameStore* store, const FrameSink& sink,
                 const std::stop_token& stop, const std::function<void(double)>& progress);

/// Collects evenly spread frames, at a size that fits a page, into one picture.
class ContactSheetBuilder {
 public:
  explicit ContactSheetBuilder(int frame_count);

  /// The frames that it needs, ascending.
  const std::vector<int>& frames() const { return frames_; }

  /// Takes a frame if it is one of them.
  void add(int frame, const render::Image8& picture);

  render::Image8 build() const;

 private:
  std::vector<int> frames_;
  std::vector<render::Image8> pictures_;
};

}  // namespace mien::pipeline
