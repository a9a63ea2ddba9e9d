#include "pipeline/production/film/film.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <optional>
#include <utility>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "pipeline/production/film/film_frames.h"
#include "pipeline/production/film/frame_drawer.h"
#include "pipeline/production/film/frame_reuse.h"
#include "pipeline/production/film/frame_writer.h"
#include "pipeline/tasks/progress.h"
#include "pipeline/tasks/task_graph.h"
#include "render/image/contact_sheet.h"
#include "render/image/resize.h"
#include "render/image/tone.h"

namespace mien::pipeline {

namespace {

constexpr int contact_frames = 12;
constexpr int contact_width = 480;

/// What loading and staging left free goes back to the system before frames take their place: the
/// many small blocks of a long motion are of no use to films.
void give_back_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

/// Whether the set looks another way in each frame, by a camera or ground that moves.
bool set_moves(const scenes::Shot& shot) {
  const bool ground_moves = shot.set.in_place && shot.set.ground &&
                            shot.set.ground->line_spacing > 0.0f && !shot.step.isZero();
  return shot.cameras.cameras.size() > 1 || ground_moves;
}

/// Frames on their way through the threads of a drawer, from the store or drawn anew, to the
/// writer.
class FramesInFlight {
 public:
  FramesInFlight(FrameDrawer& drawer, FrameWriter& writer, const std::vector<int>& frames,
                 const FilmSettings& settings, const std::stop_token& stop)
      : drawer_(drawer),
        writer_(writer),
        frames_(frames),
        settings_(settings),
        stop_(stop),
        in_flight_(static_cast<std::size_t>(drawer.in_flight())) {}

  /// `stored` looks for a frame's picture in the store. Whether all frames were taken.
  bool run(const std::function<std::optional<render::Image8>(int frame)>& stored,
           const std::function<void(double)>& progress) {
    drawer_.for_frames({.begin = [&](std::size_t place) { return begin(place, stored); },
                        .draw = [&](std::size_t place) { draw(frame_in_flight(place)); },
                        .end =
                            [&](std::size_t place) {
                              if (!end(frame_in_flight(place))) return;
                              progress(static_cast<double>(++taken_) /
                                       static_cast<double>(frames_.size()));
                            }});
    return taken_ == frames_.size();
  }

 private:
  struct FrameInFlight {
    PendingFrame frame;
    ReadyFrame ready;
    bool is_abandoned = false;  // because of a stop request
    double began = 0.0;
  };

  /// Free as soon as the frame has ended that had it before.
  FrameInFlight& frame_in_flight(std::size_t place) {
    return in_flight_[place % in_flight_.size()];
  }

  bool begin(std::size_t place,
             const std::function<std::optional<render::Image8>(int frame)>& stored) {
    if (place == frames_.size() || is_stopped_ || stop_.stop_requested()) return false;
    FrameInFlight& now = frame_in_flight(place) = {};
    now.frame.number = frames_[place];
    now.began = steady_seconds();
    if (std::optional<render::Image8> picture = stored(now.frame.number)) {
      now.frame.picture = std::move(*picture);
      now.frame.is_stored = true;
      return true;
    }
    const Stopwatch::Running preparing(settings_.drawing);
    try {
      now.ready = drawer_.prepare(now.frame.number);
    } catch (const render::Stopped&) {
      return false;
    }
    return true;
  }

  void draw(FrameInFlight& now) {
    if (now.frame.is_stored) return;
    const Stopwatch::Running tracing(settings_.drawing);
    try {
      now.frame.picture = drawer_.draw(std::move(now.ready));
    } catch (const render::Stopped&) {
      now.is_abandoned = true;
    }
  }

  /// Whether the frame was taken, as none is after one that was not.
  bool end(FrameInFlight& now) {
    is_stopped_ = is_stopped_ || now.is_abandoned;
    if (is_stopped_) return false;
    if (settings_.on_frame_drawn && !now.frame.is_stored) {
      settings_.on_frame_drawn(steady_seconds() - std::max(now.began, ended_));
    }
    is_stopped_ = !writer_.push(std::move(now.frame));
    if (settings_.on_frame_drawn)
      ended_ = steady_seconds();  // to wait for the writer is not to draw
    return !is_stopped_;
  }

  FrameDrawer& drawer_;
  FrameWriter& writer_;
  const std::vector<int>& frames_;
  const FilmSettings& settings_;
  const std::stop_token& stop_;
  std::vector<FrameInFlight> in_flight_;
  std::atomic<bool> is_stopped_ = false;
  double ended_ = 0.0;  // when the last frame was taken
  std::size_t taken_ = 0;
};

render::Quality quality_named(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return render::draft_quality();
    case Quality::standard:
      return render::standard_quality();
    case Quality::final:
      return render::final_quality();
    case Quality::reference:
      return render::reference_quality();
  }
  return render::standard_quality();
}

}  // namespace

render::Quality quality_of(const FilmSettings& settings) {
  render::Quality quality = quality_named(settings.output.quality);
  if (quality.reference) quality.samples_per_pixel = settings.output.samples;
  quality.seed = settings.seed;
  quality.shutter = static_cast<float>(settings.output.shutter / 360.0);
  return quality;
}

render::TracerOptions tracer_options(const FilmSettings& settings, const scenes::Shot& shot,
                                     const std::stop_token& stop) {
  render::TracerOptions options{.threads = settings.threads, .instruction_set = "", .stop = stop};
  if (set_moves(shot)) return options;
  options.backgrounds = settings.sets;
  options.light_cache = settings.light_cache;
  return options;
}

render::Quality quality_of(const FilmSettings& settings, const scenes::Shot& shot) {
  render::Quality quality = quality_of(settings);
  if (set_moves(shot))
    quality.static_samples = std::min(quality.static_samples, quality.samples_per_pixel);
  return quality;
}

render::Layers layers_of(render::Tracer& tracer, const scenes::Shot& shot, int frame,
                         const render::Quality& quality) {
  if (frame + 1 >= shot.frame_count())
    return tracer.layers(scene_at(shot, frame), camera_at(shot, frame), quality);
  const render::Scene next = scene_at(shot, frame + 1, frame);
  return tracer.layers(scene_at(shot, frame), camera_at(shot, frame), quality, &next,
                       &camera_at(shot, frame + 1));
}

std::vector<int> frames_between(int first, int end) {
  std::vector<int> frames(static_cast<std::size_t>(end - first));
  std::iota(frames.begin(), frames.end(), first);
  return frames;
}

void draw_frames(const scenes::Shot& shot, const std::vector<int>& frames,
                 const FilmSettings& settings, FrameStore* store, const FrameSink& sink,
                 const std::stop_token& stop, const std::function<void(double)>& progress) {
  give_back_memory();
  const FrameFormat kept = store != nullptr ? settings.output.frames : FrameFormat::none;
  FrameDrawer drawer(shot, settings, kept, stop);
  const double wait = kept == FrameFormat::none ? settings.kept_after_seconds : 0.0;
  FrameWriter writer(settings, shot.tone, {store, steady_seconds() + wait}, sink);
  const auto stored = [&](int frame) {
    return reusable_frame(store, frame, settings.output, shot.tone);
  };
  const bool all = FramesInFlight(drawer, writer, frames, settings, stop).run(stored, progress);
  writer.finish();  // frames handed over are kept, even if the film is abandoned
  if (stop.stop_requested() && !all) throw Interrupted{};
}

ContactSheetBuilder::ContactSheetBuilder(int frame_count)
    : frames_(render::evenly_spread(frame_count, contact_frames)) {}

void ContactSheetBuilder::add(int frame, const render::Image8& picture) {
  if (!std::binary_search(frames_.begin(), frames_.end(), frame)) return;
  const int width = std::min(contact_width, picture.width);
  const int height = std::max(1, picture.height * width / picture.width);
  pictures_.push_back(render::resized(picture, width, height));
}

render::Image8 ContactSheetBuilder::build() const { return render::contact_sheet(pictures_); }

}  // namespace mien::pipeline
