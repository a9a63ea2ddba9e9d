#include "pipeline/film/film.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <thread>
#include <utility>
#include <variant>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "pipeline/film/film_frames.h"
#include "pipeline/film/frame_drawer.h"
#include "pipeline/tasks/bounded_queue.h"
#include "pipeline/tasks/progress.h"
#include "render/error.h"
#include "render/image/contact_sheet.h"
#include "render/image/image_io.h"
#include "render/image/resize.h"
#include "render/image/tone.h"
#include "render/tracer/tracer.h"

namespace mien::pipeline {

namespace {

constexpr std::size_t waiting_frames = 1;
constexpr int contact_frames = 12;
constexpr int contact_width = 480;

/// A frame on its way, in the form in which it is kept; or read from the store.
struct Exposure {
  int frame = 0;
  FramePicture picture;
  bool is_stored = false;
};

/// The second half of the work, in a thread of its own.
class FrameTaker {
 public:
  FrameTaker(const FilmSettings& settings, const render::Tone& tone, FrameStore* store,
             const FrameSink& sink)
      : settings_(settings), tone_(tone), store_(store), sink_(sink), queue_(waiting_frames) {
    thread_ = std::thread([this] { take_all(); });
  }

  ~FrameTaker() {
    queue_.close();
    if (thread_.joinable()) thread_.join();
  }

  /// False once the taker has failed.
  bool push(Exposure exposure) { return queue_.push(std::move(exposure)); }

  /// Waits for the last frame and throws what went wrong.
  void finish() {
    queue_.close();
    thread_.join();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void take_all() {
    try {
      Exposure exposure;
      while (queue_.pop(exposure)) {
        const render::Image8 shown = kept(exposure);
        sink_(exposure.frame, shown);
      }
    } catch (...) {
      failure_ = std::current_exception();
      queue_.close();
    }
  }

  /// The frame as the file has it, where it is kept in one; its picture is used up.
  render::Image8 kept(Exposure& exposure) {
    if (exposure.is_stored || store_ == nullptr)
      return std::move(std::get<render::Image8>(exposure.picture));
    const FrameFormat format = settings_.output.frames;
    render::Image8 read_back;
    store_->put(
        frame_name(format, exposure.frame),
        [&](const std::filesystem::path& file) { write_frame(file, exposure.picture); },
        [&](const std::filesystem::path& file) {
          exposure.picture = {};  // as large as what is read
          read_back = read_frame(file, format, settings_.output.shown_size(), tone_);
        });
    return read_back;
  }

  const FilmSettings& settings_;
  const render::Tone& tone_;
  FrameStore* store_;
  const FrameSink& sink_;
  BoundedQueue<Exposure> queue_;
  std::exception_ptr failure_;
  std::thread thread_;
};

/// What loading and staging left free goes back to the system before frames take their place: the
/// many small blocks of a long motion are of no use to films.
void give_back_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

/// A frame that the store has, decoded. One that does not decode is thrown away.
std::optional<render::Image8> stored_frame(FrameStore* store, int frame, const Output& output,
                                           const render::Tone& tone) {
  if (store == nullptr) return std::nullopt;
  const FrameFormat format = output.frames == FrameFormat::none ? FrameFormat::png : output.frames;
  const std::string name = frame_name(format, frame);
  const auto file = store->find(name);
  if (!file) return std::nullopt;
  try {
    return read_frame(*file, format, output.shown_size(), tone);
  } catch (const render::Error&) {
    store->discard(name);
    return std::nullopt;
  }
}

/// Whether the set looks another way in each frame, by a camera or ground that moves.
bool set_moves(const scenes::Shot& shot) {
  const bool ground_moves = shot.set.in_place && shot.set.ground &&
                            shot.set.ground->line_spacing > 0.0f && !shot.step.isZero();
  return shot.cameras.cameras.size() > 1 || ground_moves;
}

/// False when it was given up because of a stop request.
bool draw_frame(FrameDrawer& drawer, std::optional<int> next, const FilmSettings& settings,
                Exposure& exposure) {
  const Stopwatch::Running tracing(settings.drawing);
  const double begin = steady_seconds();
  try {
    exposure.picture = drawer.draw(exposure.frame, next);
  } catch (const render::Stopped&) {
    return false;
  }
  if (settings.drew) settings.drew(steady_seconds() - begin);
  return true;
}

/// A frame that is to come, with its picture where the store has it.
struct Coming {
  int frame = 0;
  std::optional<render::Image8> stored;
};

}  // namespace

render::Quality quality_of(const FilmSettings& settings) {
  render::Quality quality = settings.output.quality == Quality::draft ? render::draft_quality()
                            : settings.output.quality == Quality::final
                                ? render::final_quality()
                                : render::standard_quality();
  quality.seed = settings.seed;
  quality.shutter = static_cast<float>(settings.output.shutter / 360.0);
  return quality;
}

render::TracerOptions tracer_options(const FilmSettings& settings, const scenes::Shot& shot,
                                     const std::stop_token& stop) {
  render::TracerOptions options{.threads = settings.threads, .instruction_set = "", .stop = stop};
  if (set_moves(shot)) return options;
  options.sets = settings.sets;
  options.keep_light = settings.keep_light;
  return options;
}

render::Quality quality_of(const FilmSettings& settings, const scenes::Shot& shot) {
  render::Quality quality = quality_of(settings);
  if (set_moves(shot))
    quality.standing_samples = std::min(quality.standing_samples, quality.samples_per_pixel);
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

void draw_frames(const scenes::Shot& shot, const std::vector<int>& frames,
                 const FilmSettings& settings, FrameStore* store, const FrameSink& sink,
                 const std::stop_token& stop, const std::function<void(double)>& progress) {
  give_back_memory();
  const FrameFormat kept = store != nullptr ? settings.output.frames : FrameFormat::none;
  FrameDrawer drawer(shot, settings, kept, stop);
  FrameTaker taker(settings, shot.tone, kept != FrameFormat::none ? store : nullptr, sink);
  const auto coming = [&](std::size_t place) {
    return Coming{frames[place], stored_frame(store, frames[place], settings.output, shot.tone)};
  };
  double done = 0.0;
  Coming next;
  if (!frames.empty()) next = coming(0);
  for (std::size_t place = 0; place < frames.size() && !stop.stop_requested(); ++place) {
    Coming now = std::move(next);
    next = {};
    std::optional<int> drawn_next;
    if (place + 1 < frames.size()) {
      next = coming(place + 1);
      if (!next.stored) drawn_next = next.frame;
    }
    Exposure exposure;
    exposure.frame = now.frame;
    if (now.stored) {
      exposure.picture = std::move(*now.stored);
      exposure.is_stored = true;
    } else if (!draw_frame(drawer, drawn_next, settings, exposure)) {
      break;
    }
    if (!taker.push(std::move(exposure))) break;
    progress(++done / static_cast<double>(frames.size()));
  }
  taker.finish();  // frames that are drawn are kept, also of a film that is given up
  if (stop.stop_requested() && done < static_cast<double>(frames.size())) throw Interrupted{};
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
