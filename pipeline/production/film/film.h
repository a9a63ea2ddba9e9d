#pragma once

#include <cstdint>
#include <functional>
#include <limits>
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

/// Settings for rendering a shot.
struct FilmSettings {
  Output output;
  std::uint64_t seed = 0;        ///< seed of the renderer's noise
  int threads = 1;               ///< does not affect the pictures
  Stopwatch* drawing = nullptr;  ///< if not null, runs while frames are prepared, traced or encoded
  int eyes = 1;                  ///< pictures side by side in each frame: 2 for a stereo pair
  bool loops = false;            ///< animated pictures repeat endlessly

  /// Where the output has no frames, those are stored nevertheless that are passed on when drawing
  /// has taken this long.
  double kept_after_seconds = std::numeric_limits<double>::infinity();

  /// Called for each rendered frame with the seconds since its rendering began or since the
  /// previous frame was passed on, whichever was later. The sum of these is the rendering time.
  std::function<void(double)> on_frame_drawn = {};

  /// Static backgrounds shared with other films, and their light cached on disk. They do not affect
  /// the pictures.
  render::StaticBackgroundCache* sets = nullptr;
  render::LightCache light_cache = {};
};

/// Returns the renderer's options for a film of that shot. Sets that change between frames are not
/// shared.
render::TracerOptions tracer_options(const FilmSettings& settings, const scenes::Shot& shot,
                                     const std::stop_token& stop = {});

/// Returns the renderer's quality settings for these film settings.
render::Quality quality_of(const FilmSettings& settings);

/// Returns the renderer's quality settings for a shot. A background that changes between frames,
/// because of a moving camera or ground, gets no additional samples.
render::Quality quality_of(const FilmSettings& settings, const scenes::Shot& shot);

/// Renders a frame with its layers and, except for the last frame, its motion vectors to the next
/// frame.
render::Layers layers_of(render::Tracer& tracer, const scenes::Shot& shot, int frame,
                         const render::Quality& quality);

/// Returns the frame numbers first … end − 1.
std::vector<int> frames_between(int first, int end);

/// Receives the frames in order, tone-mapped to 8 bits per channel for a display.
using FrameSink = std::function<void(int frame, const render::Image8& picture)>;

/// Renders frames, several at a time (FrameDrawer::in_flight). A separate thread stores them and
/// reads them back, if there is a store, and passes them to the sink; at most one rendered frame
/// waits for this thread. If a film is abandoned, the frames in flight are lost.
///
/// With `store`, frames that it contains are not rendered again, and each new frame is stored. If
/// the output's frame format is none, new frames are not stored before `kept_after_seconds`, but
/// PNG frames that the store contains are used. The sink receives the stored pictures, so that a
/// resumed film is identical. Throws Interrupted soon after a stop request, and whatever the
/// tracer, the store or the sink throw.
void draw_frames(const scenes::Shot& shot, const std::vector<int>& frames,
                 const FilmSettings& settings, FrameStore* store, const FrameSink& sink,
                 const std::stop_token& stop, const std::function<void(double)>& progress);

/// Collects at most 12 evenly spaced frames, each at most 480 pixels wide, into one picture.
class ContactSheetBuilder {
 public:
  explicit ContactSheetBuilder(int frame_count);

  /// Returns the frames that the sheet needs, ascending.
  const std::vector<int>& frames() const { return frames_; }

  /// Adds a frame if the sheet needs it.
  void add(int frame, const render::Image8& picture);

  render::Image8 build() const;

 private:
  std::vector<int> frames_;
  std::vector<render::Image8> pictures_;
};

}  // namespace mien::pipeline
