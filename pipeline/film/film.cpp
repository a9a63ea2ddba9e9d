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

/// Two pictures of the same height as one.
render::Film beside(const render::Film& left, const render::Film& right) {
  render::Film both(left.width + right.width, left.height);
  for (int y = 0; y < both.height; ++y) {
    std::copy_n(left.at(0, y), 3 * left.width, both.at(0, y));
    std::copy_n(right.at(0, y), 3 * right.width, both.at(left.width, y));
  }
  return both;
}

/// The frame towards which a shutter opens: the next one, and from the last back to the one before.
int frame_after(const scenes::Shot& shot, int frame) {
  return frame + 1 < shot.frame_count() ? frame + 1 : std::max(frame - 1, 0);
}

render::Film exposed(render::Tracer& tracer, const scenes::Shot& shot, int frame,
                     const render::Quality& quality, render::Film used) {
  const render::Scene scene = scene_at(shot, frame);
  const std::vector<render::Camera> cameras = cameras_at(shot, frame);
  const bool blurs = quality.shutter > 0.0f;
  const int after = frame_after(shot, frame);
  const render::Scene closing = blurs ? scene_at(shot, after, frame) : render::Scene{};
  const std::vector<render::Camera> there = cameras_at(shot, after);
  const bool camera_moves = shot.cameras.cameras.size() > 1;
  const auto seen_by = [&](std::size_t eye) {
    if (!blurs) return tracer.trace(scene, cameras[eye], quality, std::move(used));
    return tracer
        .expose(scene, cameras[eye], quality, &closing, camera_moves ? &there[eye] : nullptr)
        .film;
  };
  if (cameras.size() == 1) return seen_by(0);
  return beside(seen_by(0), seen_by(cameras.size() - 1));
}

/// Whether the set looks another way in each frame, by a camera or ground that moves.
bool set_moves(const scenes::Shot& shot) {
  const bool ground_moves = shot.set.in_place && shot.set.ground &&
                            shot.set.ground->line_spacing > 0.0f && !shot.step.isZero();
  return shot.cameras.cameras.size() > 1 || ground_moves;
}

/// False when it was given up because of a stop request.
bool draw_frame(render::Tracer& tracer, const scenes::Shot& shot, const FilmSettings& settings,
                const render::Quality& quality, render::Film& used, Exposure& exposure) {
  const Stopwatch::Running tracing(settings.drawing);
  const double begin = steady_seconds();
  try {
    if (settings.output.frames == FrameFormat::layers)
      exposure.picture = layers_of(tracer, shot, exposure.frame, quality);
    else
      exposure.picture = exposed(tracer, shot, exposure.frame, quality, std::move(used));
  } catch (const render::Stopped&) {
    return false;
  }
  if (settings.drew) settings.drew(steady_seconds() - begin);
  return true;
}

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
  render::Tracer tracer(tracer_options(settings, shot, stop));
  const render::Quality quality = quality_of(settings, shot);
  render::Film used;  // of the frame before
  const FrameFormat kept = store != nullptr ? settings.output.frames : FrameFormat::none;
  const bool keeps = kept != FrameFormat::none;
  const bool develops = kept != FrameFormat::exr;
  FrameTaker taker(settings, shot.tone, keeps ? store : nullptr, sink);
  double done = 0.0;
  for (const int frame : frames) {
    if (stop.stop_requested()) break;
    Exposure exposure;
    exposure.frame = frame;
    if (auto stored = stored_frame(store, frame, settings.output, shot.tone)) {
      exposure.picture = std::move(*stored);
      exposure.is_stored = true;
    } else if (!draw_frame(tracer, shot, settings, quality, used, exposure)) {
      break;
    }
    // A film has three times the memory of its picture, which is all that is wanted of it.
    if (auto* film = std::get_if<render::Film>(&exposure.picture); film != nullptr && develops) {
      used = std::move(*film);
      exposure.picture = developed(used, kept, shot.tone);
    }
    if (auto* layers = std::get_if<render::Layers>(&exposure.picture); layers != nullptr && !keeps)
      exposure.picture = developed(layers->beauty, kept, shot.tone);
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
