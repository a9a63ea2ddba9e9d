#include "pipeline/production/archive/rerender.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "motion/math/random_number.h"
#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/production/archive/frame_comparison.h"
#include "pipeline/production/archive/scratch_folder.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_equalized.h"
#include "pipeline/production/film/film_exposure.h"
#include "pipeline/production/film/film_frames.h"
#include "pipeline/production/film/film_framing.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/production/film/film_tables.h"
#include "pipeline/production/film/film_task.h"
#include "pipeline/production/synthesis/durations_task.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/tasks/store.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

/// A damaged one is as good as none.
std::optional<FilmRecord> record_of(const std::string& film, const StudyContents& contents) {
  const motion::FileReading text =
      motion::bytes_of_file(contents.folder / film_record_path(film), motion::max_document_bytes);
  if (!text.bytes) return std::nullopt;
  try {
    return parse_film_record(*text.bytes);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

const VideoRecord* best_stored_video(const FilmRecord& record, const StudyContents& contents) {
  const VideoRecord* best = nullptr;
  std::error_code unknown;
  for (const VideoRecord& video : record.videos) {
    if (!fs::is_regular_file(contents.folder / video.file, unknown)) continue;
    if (best == nullptr || (video.identical && !best->identical)) best = &video;
  }
  return best;
}

/// The subject of a stimulus or of an overlay.
FilmSubject subject_named(const std::string& id, const Manifest& manifest, Motions& motions,
                          const SharedDeterminants& shared) {
  for (const Overlay& overlay : manifest.overlays) {
    if (overlay.film.id == id) return subject_of(overlay, manifest, motions, shared);
  }
  return subject_of(*find_stimulus(manifest, id), manifest, motions);
}

/// Draws frames of one film.
class Rerendering {
 public:
  Rerendering(const FilmSubject& subject, const FramesToRerender& wanted, const Manifest& manifest,
              const Equalized& equalized, const StudyContents& contents, int threads)
      : wanted_(wanted),
        contents_(contents),
        output_(subject.film.output),
        settings_{.output = output_,
                  .seed = manifest.seed,
                  .threads = threads,
                  .eyes = subject.film.look.camera.stereo_separation_m ? 2 : 1},
        shot_(subject.make_shot(equalized)) {
    shot_.tone.exposure_stops += equalized.exposure_stops;
  }

  std::vector<RerenderedFrame> draw(const std::stop_token& stop,
                                    const std::function<void(double)>& progress) const {
    if (shot_.frame_count() != wanted_.film.frames) return of_another_length();
    return wanted_.film.has_frames() ? against_frames(stop, progress)
                                     : against_video(stop, progress);
  }

 private:
  std::vector<RerenderedFrame> of_another_length() const {
    return {{wanted_.film.id, wanted_.frames.front(), wanted_.film.kept, false,
             "the film has " + std::to_string(shot_.frame_count()) + " frames now, but had " +
                 std::to_string(wanted_.film.frames)}};
  }

  std::vector<RerenderedFrame> against_frames(const std::stop_token& stop,
                                              const std::function<void(double)>& progress) const {
    const ScratchFolder scratch;
    Store store(scratch.path());
    const std::unique_ptr<FrameStore> drawn = store.frames("frames", "rendered again");
    draw_frames(
        shot_, wanted_.frames, settings_, drawn.get(), [](int, const render::Image8&) {}, stop,
        progress);
    std::vector<RerenderedFrame> result;
    for (const int frame : wanted_.frames) {
      const std::string name = frame_name(output_.frames, frame);
      const std::string against = wanted_.film.kept + "/" + name;
      const Comparison comparison =
          compare_files(drawn->find(name).value(), contents_.folder / against);
      result.push_back({wanted_.film.id, frame, against, comparison.agrees, comparison.how});
    }
    return result;
  }

  std::vector<RerenderedFrame> against_video(const std::stop_token& stop,
                                             const std::function<void(double)>& progress) const {
    const FilmRecord record = record_of(wanted_.film.id, contents_).value();
    const VideoRecord& video = *best_stored_video(record, contents_);
    VideoFrames shown(output_, wanted_.film.frames, settings_.eyes, record.first_film_frame);
    draw_frames(
        shot_, wanted_.frames, settings_, nullptr,
        [&](int frame, const render::Image8& picture) { shown.take(frame, picture); }, stop,
        progress);
    std::vector<RerenderedFrame> result;
    for (const auto& [frame, comparison] : shown.compare_with(contents_.folder, video))
      result.push_back({wanted_.film.id, frame, video.file, comparison.agrees, comparison.how});
    return result;
  }

  const FramesToRerender& wanted_;
  const StudyContents& contents_;
  const Output& output_;
  FilmSettings settings_;
  scenes::Shot shot_;
};

/// What films have in common, from the tables of it: archives have no records of tasks. The
/// shortest duration is passed to `motions`. Throws Error.
EqualizedFilms equalized_in_tables(const Manifest& manifest, const fs::path& folder,
                                   Motions& motions) {
  const auto column = [&](const TableForm& form, std::string_view name) {
    const fs::path table = folder / form.path;
    const auto refuse = [&](const std::string& wrong) {
      throw Error({table.string()}, wrong,
                  "this study's films are equalized with it; keep metrics to render frames again");
    };
    const std::string problem = motion::read_error(table, motion::max_table_bytes);
    if (!problem.empty()) refuse(problem);
    std::map<std::string, double> numbers = stimulus_numbers(table, name);
    for (const Stimulus& stimulus : manifest.stimuli) {
      if (!numbers.contains(stimulus.id)) refuse("no row of " + motion::in_quotes(stimulus.id));
    }
    return numbers;
  };
  EqualizedFilms films;
  const Equalize& equalize = manifest.equalize;
  if (equalize.duration)
    motions.know_shortest(column(durations_form, "duration_s").begin()->second);
  if (equalize.luminance) films.exposure_stops = column(exposure_form, "exposure_stops");
  if (equalize.size) films.figure_px = column(sizes_form, "figure_px");
  if (equalize.place) {
    const auto below = column(places_form, "y_px");
    for (const auto& [stimulus, right] : column(places_form, "x_px"))
      films.figure_place[stimulus] = {right, below.at(stimulus)};
  }
  return films;
}

}  // namespace

std::vector<ComparableFilm> comparable_films(const Manifest& manifest,
                                             const StudyContents& contents) {
  std::vector<ComparableFilm> films;
  std::error_code unknown;
  for (const Stimulus* film : films_of(manifest)) {
    const std::string frames = "frames/" + film->id;
    const ArtifactRecord* sequence = contents.find(frames);
    if (sequence != nullptr && fs::is_directory(contents.folder / frames, unknown)) {
      films.push_back({film->id, sequence->frames, frames});
    } else if (const std::optional<FilmRecord> record = record_of(film->id, contents)) {
      const VideoRecord* video = best_stored_video(*record, contents);
      if (video != nullptr) films.push_back({film->id, record->film_frames, video->file});
    }
  }
  return films;
}

std::vector<FramesToRerender> sampled_frames(const std::vector<ComparableFilm>& films, int count,
                                             std::uint64_t seed) {
  std::vector<std::pair<std::size_t, int>> candidates;  // film, frame
  for (std::size_t f = 0; f < films.size(); ++f) {
    for (int frame = 0; frame < films[f].frames; ++frame) candidates.emplace_back(f, frame);
  }
  const std::size_t drawn = std::min(candidates.size(), static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < drawn; ++k)
    std::swap(candidates[k],
              candidates[k + motion::random_bits(seed, k) % (candidates.size() - k)]);
  candidates.resize(drawn);
  std::ranges::sort(candidates);
  std::vector<FramesToRerender> wanted;
  for (const auto& [film, frame] : candidates) {
    if (wanted.empty() || wanted.back().film.id != films[film].id)
      wanted.push_back({films[film], {}});
    wanted.back().frames.push_back(frame);
  }
  return wanted;
}

std::vector<RerenderedFrame> rerender(const Manifest& manifest, const StudyContents& contents,
                                      const std::vector<FramesToRerender>& wanted, int threads,
                                      const std::stop_token& stop, const ShareDone& done) {
  FileKeys files;
  const SharedDeterminants shared = shared_determinants(manifest, files);
  Motions motions(manifest);
  const EqualizedFilms equalized = equalized_in_tables(manifest, contents.folder, motions);
  std::vector<RerenderedFrame> result;
  for (std::size_t w = 0; w < wanted.size(); ++w) {
    const FilmSubject subject = subject_named(wanted[w].film.id, manifest, motions, shared);
    const auto progress = [&](double share) {
      if (done)
        done((static_cast<double>(w) + share) / static_cast<double>(wanted.size()),
             wanted[w].film.id);
    };
    const Rerendering rerendering(subject, wanted[w], manifest, equalized.of(wanted[w].film.id),
                                  contents, threads);
    for (RerenderedFrame& frame : rerendering.draw(stop, progress))
      result.push_back(std::move(frame));
  }
  return result;
}

}  // namespace mien::pipeline
