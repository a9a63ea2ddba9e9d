#include "pipeline/production/run/stimuli_table.h"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/people.h"
#include "pipeline/manifest/repetitions.h"
#include "pipeline/production/design/design_findings.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/production/film/film_tables.h"
#include "pipeline/production/methods/study_facts.h"
#include "pipeline/production/run/shown_moods.h"
#include "pipeline/tasks/receipt.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

double rounded_seconds(double seconds) { return std::round(1e6 * seconds) / 1e6; }

std::string listed(const NamedValues& values) {
  std::string text;
  for (const auto& [name, value] : values) {
    text += (text.empty() ? "" : " ") + name + "=" + shortest(value);
  }
  return text;
}

std::string requested_of(const Stimulus& stimulus);

/// "a: sad=1; b: walk.bvh"
std::string requested_of_people(const Stimulus& stimulus) {
  std::string text;
  for (const Person& person : stimulus.people)
    text += (text.empty() ? "" : "; ") + person.name + ": " + requested_of(person.motion);
  return text;
}

std::string requested_of(const Stimulus& stimulus) {
  if (!stimulus.people.empty()) return requested_of_people(stimulus);
  if (stimulus.walk) return described(*stimulus.walk);
  if (!stimulus.clip)
    return listed(stimulus.adjectives) + listed(stimulus.features) + listed(stimulus.weights);
  std::string text = stimulus.clip->file.filename().string();
  for (const auto* choice : {&stimulus.clip->how.take, &stimulus.clip->how.subject})
    if (!choice->empty()) text += " " + *choice;
  if (const auto& frames = stimulus.clip->frames) {
    text += " " + std::to_string((*frames)[0]) + "-" + std::to_string((*frames)[1]);
  }
  return text;
}

std::string times_of(const std::vector<ShownMood>& moods) {
  std::string text;
  for (std::size_t i = 1; i < moods.size(); ++i)
    text += (text.empty() ? "" : " ") + shortest(rounded_seconds(moods[i].from_s));
  return text;
}

std::string words_of(const std::vector<ShownMood>& moods) {
  std::string text;
  for (const ShownMood& mood : moods) text += (text.empty() ? "" : "; ") + mood.mood;
  return text;
}

std::string motions_of(const Overlay& overlay) {
  std::string names;
  for (const auto& [role, name] : motions_on(overlay)) names += (names.empty() ? "" : " ") + name;
  return names;
}

FilmRecord film_record(const fs::path& folder, const std::string& film) {
  return parse_film_record(read_file(folder / film_record_path(film)));
}

/// A film as it was made; its motion is described for stimuli only.
struct MadeStimulus {
  const Stimulus& film;
  const fs::path& folder;
  FilmRecord record;
  std::vector<std::string> levels;
  std::string requested;
  bool is_stimulus = false;         ///< not an overlay
  const Synthesis* made = nullptr;  ///< null of an overlay, and of several people
  std::string ratings = {};
  std::string method = {};
  std::vector<ShownMood> moods = {};

  const Output& output() const { return film.output; }
  bool loops() const { return made != nullptr && made->motion.clip.loops; }
  const VideoRecord* video() const {
    return record.videos.empty() ? nullptr : &record.videos.front();
  }
  /// From the study's folder; empty where it was not made.
  std::string clip() const {
    const std::vector<std::string>& clips = film.output.clips;
    return clips.empty() || !film.people.empty() ? "" : "clips/" + film.id + "." + clips.front();
  }
  std::string frames() const {
    return film.output.frames == FrameFormat::none ? "" : "frames/" + film.id;
  }
  /// The artifact's hash; empty where it was not made.
  std::string hash_of(const std::string& path) const {
    const auto receipt = path.empty() ? std::nullopt : read_receipt(folder, path);
    return receipt ? receipt->hash : "";
  }
};

constexpr auto stimuli_columns = table_of<MadeStimulus>(
    "metrics/stimuli.csv", "stimulus, followed by one per overlay",
    {{"stimulus", "", "id of the stimulus or overlay, as used in all other tables",
      [](auto& r) { return r.film.id; }},
     {"kind", "", "stimulus or overlay",
      [](auto& r) { return r.is_stimulus ? "stimulus" : "overlay"; }},
     {"role", "", "target, created or reference; empty for an overlay",
      [](auto& r) { return r.is_stimulus ? name_of(r.film.role) : ""; }},
     {"factor_*", "",
      "level of a design factor; emotion, strength, example and clip are filled in where they "
      "follow from the stimulus; otherwise empty",
      [](auto& r) { return r.levels; }},
     {"source", "",
      "source of the motion: adjectives, features, weights, clip or path; people, if there are "
      "several; motions for an overlay",
      [](auto& r) { return r.is_stimulus ? source_of(r.film) : "motions"; }},
     {"requested", "",
      "requested values (name=value), file, path, those of each person, or motions of an overlay",
      [](auto& r) { return r.requested; }},
     {"ratings", "",
      "ratings on which the motion is based: given (by people), simulated or none (features, "
      "weights, files, paths)",
      [](auto& r) { return r.ratings; }},
     {"method", "",
      "method by which blend weights were found, or direct for given weights; empty for a file, a "
      "path or an overlay",
      [](auto& r) { return r.method; }},
     {"modified", "", "modifications applied to the motion; empty for none",
      [](auto& r) { return r.made ? r.made->modified : ""; }},
     {"modified_share", "0–1",
      "proportion of the requested modification strength that was applied; below 1 where on_fault "
      "reduced it, 0 where it left the motion unmodified; empty if no modification was requested",
      [](auto& r) { return r.made && !r.made->modified.empty() ? r.made->modified_share : NAN; }},
     {"scene", "", "the set", [](auto& r) { return scene_name(r.film.look); }},
     {"figure", "", "figure type",
      [](auto& r) { return scenes::kind_of(r.film.look.figure).name; }},
     {"figure_options", "", "figure options that differ from the defaults, as JSON",
      [](auto& r) { return figure_options(r.film); }},
     {"camera", "", "camera view", [](auto& r) { return r.film.look.camera.view; }},
     {"camera_options", "", "camera options that differ from the defaults, as JSON",
      [](auto& r) { return camera_options(r.film.look); }},
     {"width_px", "pixels", "width of the frames",
      [](auto& r) { return r.output().shown_size()[0]; }},
     {"height_px", "pixels", "height of the frames",
      [](auto& r) { return r.output().shown_size()[1]; }},
     {"fps", "1/s", "frames per second", [](auto& r) { return r.output().fps; }},
     {"cycles", "",
      "repetitions of a looping motion; films end earlier where durations are equalized",
      [](auto& r) { return r.output().cycles; }},
     {"in_place", "0/1", "1: walking in place, as on a treadmill",
      [](auto& r) { return r.output().in_place; }},
     {"quality", "", "draft, standard, final or reference",
      [](auto& r) { return name_of(r.output().quality); }},
     {"samples_per_pixel", "", "samples per pixel at that quality",
      [](auto& r) { return quality_of(FilmSettings{.output = r.output()}).samples_per_pixel; }},
     {"shutter_deg", "°", "shutter angle; 360° is the whole frame interval",
      [](auto& r) { return r.output().shutter; }},
     {"cycle_s", "s", "duration of one cycle; empty for motions that do not loop",
      [](auto& r) { return r.loops() ? r.made->motion.clip.duration_seconds() : NAN; }},
     {"film_frames", "", "number of frames of the film",
      [](auto& r) { return r.record.film_frames; }},
     {"film_s", "s", "duration of the film",
      [](auto& r) { return r.record.film_frames / r.output().fps; }},
     {"video", "", "path of the first video, relative to the study folder; all are in videos.csv",
      [](auto& r) { return r.video() ? r.video()->file : ""; }},
     {"video_s", "s", "duration of the video, including card, cross and blanks",
      [](auto& r) { return r.video() ? r.video()->frames / r.video()->fps : NAN; }},
     {"mood_changes_s", "s",
      "times of the video at which the mood of a walk along a path begins to change, separated by "
      "spaces; empty if it does not",
      [](auto& r) { return times_of(r.moods); }},
     {"moods", "",
      "its moods in order, separated by semicolons: one more than changes; empty if it does not "
      "change",
      [](auto& r) { return words_of(r.moods); }},
     {"video_hash", "", "its XXH3-128",
      [](auto& r) { return r.video() ? r.hash_of(r.video()->file) : ""; }},
     {"sound", "", "file name of the sound in the videos; empty without a sound",
      [](auto& r) { return r.record.sound ? r.record.sound->file : ""; }},
     {"sound_of", "", "id of the stimulus to which that sound belongs; empty without a sound",
      [](auto& r) { return r.record.sound ? r.record.sound->of : ""; }},
     {"sound_offset_s", "s", "time of the sound file at which the film begins",
      [](auto& r) { return r.record.sound ? r.record.sound->offset_s : NAN; }},
     {"sound_gain_db", "dB", "gain of the sound, including that which equalizes loudness",
      [](auto& r) { return r.record.sound ? r.record.sound->gain_db : NAN; }},
     {"held_frames", "", "number of frames for which the film's last picture is held for the sound",
      [](auto& r) { return r.record.sound ? std::to_string(r.record.sound->held_frames) : ""; }},
     {"loudness_lufs", "LUFS",
      "integrated loudness of the sound by EBU R 128, before encoding; empty without a sound, or "
      "if "
      "it is too short or quiet to be measured",
      [](auto& r) { return r.record.sound ? r.record.sound->loudness_lufs.value_or(NAN) : NAN; }},
     {"true_peak_dbtp", "dBTP", "true peak of the sound, before encoding; empty for silence",
      [](auto& r) { return r.record.sound ? r.record.sound->true_peak_dbtp.value_or(NAN) : NAN; }},
     {"clip", "",
      "path of the motion file, relative to the study folder; empty with several people, whose "
      "files are clips/<stimulus>.<person>",
      [](auto& r) { return r.clip(); }},
     {"clip_hash", "", "its XXH3-128", [](auto& r) { return r.hash_of(r.clip()); }},
     {"frames", "", "path of the folder of frames, relative to the study folder",
      [](auto& r) { return r.frames(); }},
     {"frames_hash", "", "XXH3-128 of the names and hashes of all frames",
      [](auto& r) { return r.hash_of(r.frames()); }}});

struct WarningRow {
  std::string stimulus;
  const char* about;
  std::string sentence;
};

constexpr auto warnings_columns = table_of<WarningRow>(
    "metrics/warnings.csv", "warning",
    {{"stimulus", "",
      "id of the stimulus or overlay; empty for warnings about examples and factors",
      [](auto& r) { return r.stimulus; }},
     {"about", "", "examples, design (factors, and relations among stimuli), motion or film",
      [](auto& r) { return r.about; }},
     {"warning", "", "a sentence", [](auto& r) { return r.sentence; }}});

}  // namespace

const TableForm stimuli_form = stimuli_columns.form();
const TableForm warnings_form = warnings_columns.form();

std::string stimuli_csv(const Manifest& manifest, Motions& motions, const fs::path& folder) {
  const std::vector<std::string> factors = factors_of(manifest);
  std::vector<MadeStimulus> rows;
  for (const Stimulus& stimulus : manifest.stimuli) {
    std::vector<std::string> levels;
    for (const std::string& factor : factors) levels.push_back(level_of(stimulus, factor));
    rows.push_back(
        {stimulus, folder, film_record(folder, stimulus.id), std::move(levels),
         requested_of(stimulus), true, stimulus.people.empty() ? &motions.of(stimulus.id) : nullptr,
         ratings_of(&stimulus, motions), method_of(stimulus), shown_moods(motions, stimulus)});
  }
  for (const Overlay& overlay : manifest.overlays)
    rows.push_back({overlay.film, folder, film_record(folder, overlay.film.id),
                    std::vector<std::string>(factors.size()), motions_of(overlay)});
  return stimuli_columns.of(rows, factors).csv;
}

std::string warnings_csv(const Manifest& manifest, Motions& motions, const fs::path& folder,
                         const DesignFindings& design) {
  std::vector<WarningRow> rows;
  if (uses_examples(manifest)) {
    for (const std::string& warning : motions.repertoire().warnings)
      rows.push_back({"", "examples", warning});
  }
  for (const DesignWarning& warning : design_warnings(manifest, design))
    rows.push_back({"", "design", to_sentence(warning)});
  for (const Repetition& repetition : repetitions_in(manifest))
    rows.push_back({repetition.id, "design", to_sentence(repetition)});
  for (const Stimulus* motion : motion_sources(manifest)) {
    for (const std::string& warning : motions.of(motion->id).warnings)
      rows.push_back({motion->id, "motion", warning});
  }
  for (const Stimulus* film : films_of(manifest)) {
    for (const std::string& warning : film_record(folder, film->id).warnings)
      rows.push_back({film->id, "film", warning});
  }
  return warnings_columns.of(rows).csv;
}

}  // namespace mien::pipeline
