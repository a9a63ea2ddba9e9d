#include "pipeline/production/run/stimuli_table.h"

#include <vector>

#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/look/look_fields.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/manifest/repetitions.h"
#include "pipeline/production/film/film.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/production/film/film_tables.h"
#include "pipeline/production/methods/study_facts.h"
#include "pipeline/tasks/receipt.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

using Row = std::vector<std::string>;

void add(Row& row, const Row& more) { row.insert(row.end(), more.begin(), more.end()); }

std::string listed(const NamedValues& values) {
  std::string text;
  for (const auto& [name, value] : values) {
    text += (text.empty() ? "" : " ") + name + "=" + shortest(value);
  }
  return text;
}

std::string asked_of(const Stimulus& stimulus) {
  if (stimulus.walk) return described(*stimulus.walk);
  if (!stimulus.clip)
    return listed(stimulus.adjectives) + listed(stimulus.features) + listed(stimulus.weights);
  std::string text = stimulus.clip->file.filename().string();
  if (!stimulus.clip->take.empty()) text += " " + stimulus.clip->take;
  if (const auto& frames = stimulus.clip->frames) {
    text += " " + std::to_string((*frames)[0]) + "-" + std::to_string((*frames)[1]);
  }
  return text;
}

/// From `source` to `modified_share`.
Row making_of(const Stimulus& stimulus, Motions& motions) {
  const Synthesis& made = motions.of(stimulus.id);
  return {std::string(source_of(stimulus)),
          asked_of(stimulus),
          ratings_of(&stimulus, motions),
          method_of(stimulus),
          made.modified,
          made.modified.empty() ? "" : shortest(made.modified_share)};
}

Row making_of(const Overlay& overlay) {
  std::string names;
  for (const auto& [role, name] : motions_on(overlay)) names += (names.empty() ? "" : " ") + name;
  return {"motions", names, "", "", "", ""};
}

std::string figure_options(const Look& look) {
  const OrderedJson figure = FigureForm::write(look.figure, Writing{.for_key = true});
  if (figure.is_string()) return "";
  const OrderedJson options = *figure.begin();
  return options.is_null() || options.empty() ? "" : options.dump();
}

/// A name and its options.
Row camera_of(const Look& look) {
  OrderedJson camera = written(look.camera, Writing{.for_key = true});
  if (camera.is_object()) camera.erase("view");
  return {look.camera.view, !camera.is_object() || camera.empty() ? "" : camera.dump()};
}

/// From `scene` to `shutter_deg`.
Row settings_of(const Stimulus& film) {
  const Output& output = film.output;
  const auto [width, height] = output.shown_size();
  Row row = {scene_name(film.look), figure_name(film.look), figure_options(film.look)};
  add(row, camera_of(film.look));
  add(row, {std::to_string(width), std::to_string(height), shortest(output.fps),
            std::to_string(output.cycles), output.in_place ? "1" : "0",
            std::string(name_of(output.quality)),
            std::to_string(quality_of(FilmSettings{.output = output}).samples_per_pixel),
            shortest(output.shutter)});
  return row;
}

FilmRecord film_record(const fs::path& folder, const std::string& film) {
  return parse_film_record(read_file(folder / film_record_path(film)));
}

/// An artifact and its hash; both empty where it was not made.
Row file_of(const fs::path& folder, const std::string& path, bool is_made) {
  if (!is_made) return {"", ""};
  const auto receipt = read_receipt(folder, path);
  return {path, receipt ? receipt->hash : ""};
}

/// From `film_frames` to the end.
Row files_of(const Stimulus& film, const fs::path& folder) {
  const Output& output = film.output;
  const FilmRecord record = film_record(folder, film.id);
  Row row = {std::to_string(record.film_frames), shortest(record.film_frames / output.fps)};
  if (record.videos.empty()) {
    add(row, {"", "", ""});
  } else {
    const VideoRecord& video = record.videos.front();
    const Row file = file_of(folder, video.file, true);
    add(row, {file[0], shortest(video.frames / video.fps), file[1]});
  }
  const ClipFiles& clips = output.clips;
  add(row,
      file_of(folder, "clips/" + film.id + (clips.bvh ? ".bvh" : ".glb"), clips.bvh || clips.glb));
  add(row, file_of(folder, "frames/" + film.id, output.frames != FrameFormat::none));
  return row;
}

std::string cycle_seconds(const motion::Clip& clip) {
  return clip.loops ? shortest(clip.duration_seconds()) : "";
}

}  // namespace

std::string stimuli_csv(const Manifest& manifest, Motions& motions, const fs::path& folder) {
  const std::vector<std::string> factors = factors_of(manifest);
  CsvWriter table(header_of(stimuli_form, factors));
  for (const Stimulus& stimulus : manifest.stimuli) {
    Row row = {stimulus.id, "stimulus", std::string(name_of(stimulus.role))};
    for (const std::string& factor : factors) row.push_back(level_of(stimulus, factor));
    add(row, making_of(stimulus, motions));
    add(row, settings_of(stimulus));
    row.push_back(cycle_seconds(motions.of(stimulus.id).motion.clip));
    add(row, files_of(stimulus, folder));
    table.row(row);
  }
  for (const Overlay& overlay : manifest.overlays) {
    Row row = {overlay.film.id, "overlay", ""};
    row.resize(row.size() + factors.size());
    add(row, making_of(overlay));
    add(row, settings_of(overlay.film));
    row.emplace_back();
    add(row, files_of(overlay.film, folder));
    table.row(row);
  }
  return table.text();
}

std::string warnings_csv(const Manifest& manifest, Motions& motions, const fs::path& folder) {
  CsvWriter table = table_of(warnings_form);
  if (uses_examples(manifest)) {
    for (const std::string& warning : motions.repertoire().warnings)
      table.row({"", "examples", warning});
  }
  for (const Repetition& repetition : repetitions_in(manifest))
    table.row({repetition.id, "design", to_sentence(repetition)});
  for (const Stimulus& stimulus : manifest.stimuli) {
    for (const std::string& warning : motions.of(stimulus.id).warnings)
      table.row({stimulus.id, "motion", warning});
  }
  for (const Stimulus* film : films_of(manifest)) {
    for (const std::string& warning : film_record(folder, film->id).warnings)
      table.row({film->id, "film", warning});
  }
  return table.text();
}

}  // namespace mien::pipeline
