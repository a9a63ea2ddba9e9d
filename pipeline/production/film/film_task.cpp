#include "pipeline/production/film/film_task.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/film/disk_light_cache.h"
#include "pipeline/production/film/film_frames.h"
#include "pipeline/production/film/film_presentation.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/production/film/film_recorder.h"
#include "pipeline/production/film/film_shot.h"
#include "pipeline/production/film/film_sound.h"
#include "pipeline/production/film/film_tables.h"
#include "pipeline/production/film/film_waveform.h"
#include "pipeline/production/film/people_warnings.h"
#include "pipeline/tasks/code_identity.h"
#include "render/image/image_io.h"
#include "render/image/luminance.h"
#include "scenes/cameras/figure_place.h"

namespace mien::pipeline {

namespace {

/// The shot with the stops that make the study's films equally light.
scenes::Shot exposed(scenes::Shot shot, float stops) {
  shot.tone.exposure_stops += stops;
  return shot;
}

/// Animated pictures repeat where all motions do.
bool repeats(const FilmSubject& subject, FinishedMotions& motions) {
  return std::all_of(subject.motions.begin(), subject.motions.end(),
                     [&](const auto& name) { return motions.clip(name).loops; });
}

/// Seconds of one core, about those of stick figures before the quickstart's set in 2026. Cycles of
/// 1.1 s are assumed where the length is not known before the motion is made.
double cost_of(const Output& output) {
  const double frames = 1.1 * output.cycles * output.fps;
  const double pixels = static_cast<double>(output.shown_size()[0]) * output.shown_size()[1];
  const render::Quality quality = quality_of({.output = output});
  const double per_sample = quality.reference ? 2.2e-7 : 2.4e-8;
  return frames * pixels * (per_sample * quality.samples_per_pixel + 5e-9);
}

std::string video_path(const std::string& stimulus, render::VideoKind kind) {
  return "videos/" + render::with_ending(stimulus, kind).string();
}

std::vector<std::string> names_of(const std::vector<int>& frames, FrameFormat format) {
  std::vector<std::string> names;
  for (const int frame : frames) names.push_back(frame_name(format, frame));
  return names;
}

/// Films whose estimate is longer are kept frame by frame while they are made, so that an
/// interrupted run loses little; the others are drawn again faster than their frames are written.
constexpr double resumable_from_seconds = 60.0;
/// Estimates are wrong at times: other films are kept from this moment of their making.
constexpr double kept_after_seconds = 30.0;

/// Makes one film or a part of it; lives as long as the task runs.
class FilmMaker {
 public:
  FilmMaker(const FilmSubject& subject, const Equalized& equalized, const FilmSettings& settings,
            TaskRun& run)
      : film_(subject.film),
        id_(subject.film.id),
        output_(subject.film.output),
        settings_(settings),
        run_(run),
        shot_(exposed(subject.make_shot(equalized), equalized.exposure_stops)),
        contact_(shot_.frame_count()),
        recorder_(settings_, shot_.frame_count(),
                  output_.video.empty()
                      ? std::nullopt
                      : film_sound(subject.film, subject.equalize.loudness, shot_.frame_count())) {
    settings_.light_cache = disk_light_cache(run.store, run.stop);
    settings_.kept_after_seconds = kept_after_seconds;
    settings_.on_frame_drawn = [&run, estimated = run.task.cost_seconds /
                                                  shot_.frame_count()](double seconds) {
      run.store.heartbeat().count_frame(seconds, estimated);
    };
    record_.exposure_stops = static_cast<double>(equalized.exposure_stops);
    record_.figure_px = scenes::figure_pixels(shot_.cameras);
    record_.figure_place = scenes::figure_place(shot_.cameras);
    for (const scenes::Actor& actor : shot_.actors) {
      for (const std::string& warning : actor.warnings) record_.warnings.push_back(warning);
    }
    if (!subject.film.people.empty()) {
      std::vector<motion::Clip> clips;
      for (const scenes::Actor& actor : shot_.actors) clips.push_back(actor.clip);
      for (std::string& warning : people_warnings(subject.film, clips))
        record_.warnings.push_back(std::move(warning));
    }
    if (subject.film.look.camera.screen)
      record_.visual_degrees = scenes::visual_degrees(shot_.cameras);
  }

  /// Throws Error when its fades last longer than the film.
  void make() {
    refuse_long_fades();
    std::size_t next = keeps_frames() ? 1 : 0;
    const std::unique_ptr<FrameStore> frames = open_frames();
    if (output_.video.empty()) {
      draw(frames.get(), keeps_frames() ? every_frame() : contact_.frames(), {});
    } else {
      make_videos(0, next, frames.get());
      next += output_.video.size();
    }
    if (keeps_frames()) frames->publish(names_of(every_frame(), output_.frames));
    put_contact_sheet(next++);
    put_record(next++);
    if (recorder_.sound()) put_waveform(next);
    if (!keeps_frames()) frames->drop();
  }

  /// Draws frames that are missing, for `make` to find. If another process has made the film in the
  /// meantime, they are no longer needed.
  void make(const Part& part) {
    refuse_long_fades();
    const auto [first, end] = range_of(part, shot_.frame_count());
    const std::unique_ptr<FrameStore> store = open_frames();
    draw_frames(
        shot_, frames_between(first, end), settings_with_frames(), store.get(),
        [](int, const render::Image8&) {}, run_.stop, run_.progress);
    if (find_products(run_.task, run_.keys, run_.store.folder())) store->drop();
  }

 private:
  void refuse_long_fades() const {
    const std::string wrong = fade_fault(film_, shot_.frame_count());
    if (!wrong.empty()) throw Error(wrong, fade_remedy);
  }

  bool keeps_frames() const { return output_.frames != FrameFormat::none; }

  /// The frames that the output asks for, or those that are kept until the film is made.
  std::unique_ptr<FrameStore> open_frames() {
    const StoredSequence kept = stored_sequence(run_.task, run_.task_key);
    return run_.store.frames(kept.path, kept.key);
  }

  /// Settings by which each frame that is drawn is kept.
  FilmSettings settings_with_frames() const {
    FilmSettings kept = settings_;
    if (!keeps_frames()) kept.output.frames = FrameFormat::png;
    return kept;
  }

  std::vector<int> every_frame() const { return frames_between(0, shot_.frame_count()); }

  /// Draws frames for the sink and the contact sheet.
  void draw(FrameStore* store, const std::vector<int>& frames, const FrameSink& sink) {
    const FrameSink both = [&](int frame, const render::Image8& picture) {
      contact_.add(frame, picture);
      record_.luminance.add(render::luminance_of(picture));
      if (sink) sink(frame, picture);
    };
    const bool is_long = run_.task.cost_seconds > resumable_from_seconds;
    draw_frames(shot_, frames, is_long ? settings_with_frames() : settings_, store, both, run_.stop,
                run_.progress);
  }

  /// Opens this video and the ones after it; then the film is drawn once, for all of them.
  void make_videos(std::size_t video, std::size_t product, FrameStore* store) {
    if (video == output_.video.size()) {
      draw(store, every_frame(),
           [&](int, const render::Image8& picture) { recorder_.take(picture); });
      return recorder_.close();
    }
    const render::VideoKind kind = output_.video[video];
    run_.put(
        product,
        [&](const std::filesystem::path& file) {
          recorder_.open(file, kind);
          make_videos(video + 1, product + 1, store);
        },
        [&](const std::filesystem::path& file) { recorder_.check(file, kind); });
  }

  void put_record(std::size_t product) {
    record_.film_frames = recorder_.frames().film;
    record_.first_film_frame = recorder_.frames().before();
    for (const auto& [kind, check] : recorder_.checks()) {
      record_.videos.push_back(video_record(video_path(id_, kind), kind, output_.fps, check));
      record_.videos.back().frames_hash = recorder_.frames_hash();
      if (const auto sound = recorder_.sound_check(kind))
        record_.videos.back().sound = video_sound_record(*sound);
    }
    if (recorder_.sound()) record_.sound = recorder_.sound()->record;
    run_.put_text(product, film_record_text(record_),
                  [](const std::filesystem::path& file) { parse_film_record(read_file(file)); });
  }

  void put_contact_sheet(std::size_t product) {
    run_.put(
        product,
        [&](const std::filesystem::path& file) { render::write_png(file, contact_.build()); },
        render::read_png8);
  }

  void put_waveform(std::size_t product) {
    run_.put_text(product, waveform_svg(*recorder_.sound(), recorder_.frames(), output_.fps),
                  read_file);
  }

  const Stimulus& film_;
  const std::string& id_;
  const Output& output_;
  FilmSettings settings_;
  TaskRun& run_;
  scenes::Shot shot_;
  ContactSheetBuilder contact_;
  FilmRecorder recorder_;
  FilmRecord record_;
};

}  // namespace

StoredSequence stored_sequence(const Task& film, const Hash& task_key) {
  const std::string path = "frames/" + film.id.substr(film.id.find(':') + 1);
  if (film.products.front().path == path) return {path, product_keys(film, task_key).front()};
  return {path, KeyBuilder().add("kept", path).add("task", task_key).key()};
}

FilmSubject subject_of(const Stimulus& stimulus, const Manifest& manifest,
                       FinishedMotions& motions) {
  std::vector<std::string> shown;
  for (const Stimulus* motion : motions_in(stimulus)) shown.push_back(motion->id);
  return {stimulus,
          std::move(shown),
          {},
          manifest.equalize,
          [&stimulus, &motions, seed = manifest.seed](const Equalized& equalized) {
            return shot_of(stimulus, motions, seed, equalized.framing);
          }};
}

FilmSubject subject_of(const Overlay& overlay, const Manifest& manifest, FinishedMotions& motions,
                       const SharedDeterminants& shared) {
  FilmSubject subject{overlay.film, {}, {}, {}, {}};
  for (const auto& [role, name] : motions_on(overlay)) {
    subject.motions.push_back(name);
    subject.stage.add("motion", name);
    if (motions.stimulus(name) == nullptr) {
      subject.stage.add("from", shared.repertoire).add("made at", manifest.output.fps);
      add_interpolation(subject.stage, manifest.interpolation);
    }
  }
  subject.stage.add("layout", static_cast<std::int64_t>(overlay.layout))
      .add("opacity", overlay.opacity)
      .add("cycles", std::int64_t{overlay.film.output.cycles})
      .add("in place", std::int64_t{overlay.film.output.in_place});
  subject.make_shot = [&overlay, &motions, seed = manifest.seed](const Equalized&) {
    return shot_of(overlay, motions, seed);
  };
  return subject;
}

Task film_task(const FilmSubject& subject, const FilmSettings& settings,
               const SharedDeterminants& shared, FinishedMotions& motions) {
  const Stimulus& stimulus = subject.film;
  const Output& output = stimulus.output;
  Task task;
  task.id = "film:" + stimulus.id;
  task.kind = "film";
  for (const std::string& name : subject.motions) {
    if (motions.stimulus(name) != nullptr) task.inputs.push_back("motion:" + name);
  }
  task.determinants.add("libraries", shared.libraries);
  task.determinants.add("code", film_code()).add("seed", static_cast<std::int64_t>(settings.seed));
  add_film(task.determinants, stimulus, shared.files);
  task.determinants.add("stage", subject.stage.key());
  // A video shows the stored frames, so how they were stored concerns it too.
  KeyBuilder stored;
  stored.add("frames", static_cast<std::int64_t>(output.frames));
  if (output.frames != FrameFormat::none)
    task.products.push_back({"frames/" + stimulus.id, stored});
  KeyBuilder shown = stored;
  add_presentation(shown, output.presentation);
  add_sound(shown, stimulus, subject.equalize, shared.files);
  KeyBuilder shown_kinds = shown;
  for (const render::VideoKind kind : output.video) {
    task.products.push_back({video_path(stimulus.id, kind), shown});
    shown_kinds.add("video", render::traits_of(kind).name);
  }
  task.products.push_back({"sheets/contact/" + stimulus.id + ".png", stored});
  task.products.push_back({film_record_path(stimulus.id), shown_kinds});
  if (stimulus.sound && !output.video.empty())
    task.products.push_back({waveform_path(stimulus.id), shown});
  task.cost_seconds = cost_of(output);
  const Equalize& equalize = subject.equalize;
  task.determinants.add("duration", std::int64_t{equalize.duration});
  for (const std::string& other : equalizing_task_ids(equalize)) task.inputs.push_back(other);
  const auto begin = [subject, &motions, settings](TaskRun& run) {
    FilmSettings own = settings;
    own.loops = repeats(subject, motions);
    own.eyes = subject.film.look.camera.stereo_separation_m ? 2 : 1;
    const EqualizedFilms equalized = equalized_films(subject.equalize, run.store.folder(), motions);
    return FilmMaker(subject, equalized.of(subject.film.id), own, run);
  };
  task.make = [begin](TaskRun& run) { begin(run).make(); };
  task.make_part = [begin](TaskRun& run, const Part& part) { begin(run).make(part); };
  return task;
}

}  // namespace mien::pipeline
