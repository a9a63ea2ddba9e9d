#include "pipeline/production/film/film_tables.h"

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/tasks/code_identity.h"
#include "pipeline/tasks/receipt.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

struct MadeFilm {
  std::string stimulus;
  FilmRecord record;
  std::vector<std::string> hashes;  // of its videos
};

struct MadeVideo {
  const MadeFilm& of;
  const VideoRecord& video;
  std::string hash;

  template <class Value>
  std::string of_sound(Value VideoSoundRecord::*member) const {
    return video.sound ? fmt::format("{}", (*video.sound).*member) : "";
  }

  std::string unless_identical(std::string text) const { return video.identical ? "" : text; }
};

using Films = std::vector<MadeFilm>;

constexpr double cost_seconds = 0.01;

/// Six digits: more than a display can show.
std::string rounded(double value) { return fmt::format("{:.6f}", value); }

std::string place_of_figure(const FilmRecord& film, std::size_t axis) {
  return film.figure_place ? fmt::format("{:.2f}", (*film.figure_place)[axis]) : "";
}

constexpr SharedColumn film_column{"stimulus", "", "id of the stimulus or overlay",
                                   [](auto& r) { return r.stimulus; }};

constexpr auto luminance_columns = table_of<MadeFilm>(
    "metrics/luminance.csv", "film",
    {film_column,
     {"frames", "",
      "number of frames measured: all, or those of the contact sheet if neither frames nor videos "
      "are written",
      [](auto& r) { return r.record.luminance.frames; }},
     {"mean_luminance", "0–1", "mean relative luminance (linear) over all pixels and frames",
      [](auto& r) { return rounded(r.record.luminance.mean); }},
     {"sd_luminance", "0–1", "standard deviation over pixels, averaged over frames",
      [](auto& r) { return rounded(r.record.luminance.deviation); }},
     {"rms_contrast", "", "RMS contrast: standard deviation divided by mean, averaged over frames",
      [](auto& r) { return rounded(r.record.luminance.rms_contrast); }},
     {"min_frame_luminance", "0–1", "mean luminance of the darkest frame",
      [](auto& r) { return rounded(r.record.luminance.darkest); }},
     {"max_frame_luminance", "0–1", "mean luminance of the brightest frame",
      [](auto& r) { return rounded(r.record.luminance.lightest); }},
     {"exposure_stops", "stops", "exposure compensation: 1 doubles the light, −1 halves it",
      [](auto& r) { return r.record.exposure_stops; }}});

constexpr auto videos_columns = table_of<MadeVideo>(
    "metrics/videos.csv", "video",
    {{"stimulus", "", "id of the stimulus or overlay", [](auto& r) { return r.of.stimulus; }},
     {"file", "", "path of the video, relative to the study folder",
      [](auto& r) { return r.video.file; }},
     {"format", "", "video format, as in output.video", [](auto& r) { return r.video.format; }},
     {"frames", "", "number of frames of the whole video", [](auto& r) { return r.video.frames; }},
     {"first_film_frame", "",
      "first frame of the film within the video, after card, cross and blank; counted from 0",
      [](auto& r) { return r.of.record.first_film_frame; }},
     {"film_frames", "", "number of frames of the film",
      [](auto& r) { return r.of.record.film_frames; }},
     {"fps", "1/s", "frames per second", [](auto& r) { return r.video.fps; }},
     {"duration_s", "s", "duration of the whole video",
      [](auto& r) { return rounded(r.video.duration_s); }},
     {"identical", "0/1", "1: every decoded frame is identical to the rendered frame",
      [](auto& r) { return r.video.identical; }},
     {"worst_psnr_db", "dB", "lowest peak signal-to-noise ratio of a frame; empty where identical",
      [](auto& r) { return r.unless_identical(fmt::format("{:.2f}", r.video.worst_psnr_db)); }},
     {"worst_psnr_frame", "",
      "number of that frame in the video, counted from 0; empty where identical",
      [](auto& r) { return r.unless_identical(std::to_string(r.video.worst_psnr_frame)); }},
     {"worst_ssim", "0–1",
      "lowest structural similarity (SSIM) between a frame and its decoded version; empty where "
      "identical",
      [](auto& r) { return r.unless_identical(fmt::format("{:.4f}", r.video.worst_ssim)); }},
     {"worst_ssim_frame", "",
      "number of that frame in the video, counted from 0; empty where identical",
      [](auto& r) { return r.unless_identical(std::to_string(r.video.worst_ssim_frame)); }},
     {"sound_codec", "", "codec of the sound: aac or opus; empty without a sound",
      [](auto& r) { return r.of_sound(&VideoSoundRecord::codec); }},
     {"sound_channels", "", "number of channels of the sound, at 48 kHz; empty without a sound",
      [](auto& r) { return r.of_sound(&VideoSoundRecord::channels); }},
     {"sound_frames", "", "number of sample frames of the sound, at 48 kHz; empty without a sound",
      [](auto& r) { return r.of_sound(&VideoSoundRecord::frames); }},
     {"sound_offset_frames", "",
      "by how many sample frames the decoded sound is later than the encoded one, measured by "
      "cross-correlation; empty for silence and without a sound",
      [](auto& r) {
        const bool is_measured = r.video.sound && r.video.sound->offset_frames;
        return is_measured ? std::to_string(*r.video.sound->offset_frames) : "";
      }},
     {"sound_correlation", "",
      "correlation of the decoded sound with the encoded one; empty without a sound",
      [](auto& r) {
        return r.video.sound ? fmt::format("{:.3f}", r.video.sound->correlation) : "";
      }},
     {"sound_hash", "", "XXH3-64 of the sound before encoding; empty without a sound",
      [](auto& r) { return r.of_sound(&VideoSoundRecord::hash); }},
     {"video_hash", "", "XXH3-128 of the file", [](auto& r) { return r.hash; }}});

constexpr auto views_columns = table_of<MadeFilm>(
    "metrics/views.csv", "film",
    {film_column,
     {"figure_px", "pixels", "height of the standing figure in the image",
      [](auto& r) { return fmt::format("{:.2f}", r.record.figure_px); }},
     {"visual_degrees", "°",
      "visual angle of that height on the screen described by the camera; empty if it describes "
      "none",
      [](auto& r) {
        return r.record.visual_degrees ? fmt::format("{:.3f}", *r.record.visual_degrees) : "";
      }},
     {"figure_x_px", "pixels",
      "horizontal position of the figure, to the right of the image centre: the midpoint of its "
      "path on the floor, or, for a camera that follows it, its own position; empty if the figure "
      "is behind the camera",
      [](auto& r) { return place_of_figure(r.record, 0); }},
     {"figure_y_px", "pixels", "the same vertically, below the image centre",
      [](auto& r) { return place_of_figure(r.record, 1); }}});

std::vector<MadeVideo> videos_of(const Films& films) {
  std::vector<MadeVideo> rows;
  for (const MadeFilm& film : films)
    for (std::size_t i = 0; i < film.record.videos.size(); ++i)
      rows.push_back({film, film.record.videos[i], film.hashes[i]});
  return rows;
}

MadeFilm made_film(const std::string& id, const fs::path& folder) {
  MadeFilm film{id, parse_film_record(read_file(folder / film_record_path(id))), {}};
  for (const VideoRecord& video : film.record.videos) {
    const auto receipt = read_receipt(folder, video.file);
    film.hashes.push_back(receipt ? receipt->hash : "");
  }
  return film;
}

struct FilmTable {
  TableForm form;
  std::string (*csv)(const Films&);
};

constexpr FilmTable tables[] = {
    {luminance_columns.form(), [](const Films& films) { return luminance_columns.of(films).csv; }},
    {videos_columns.form(),
     [](const Films& films) { return videos_columns.of(videos_of(films)).csv; }},
    {views_columns.form(), [](const Films& films) { return views_columns.of(films).csv; }}};

}  // namespace

std::string film_record_path(const std::string& stimulus) {
  return "metrics/films/" + stimulus + ".json";
}

std::vector<TableForm> film_table_forms() {
  std::vector<TableForm> forms;
  for (const FilmTable& table : tables) forms.push_back(table.form);
  return forms;
}

Task films_task(const Manifest& manifest, const SharedDeterminants& shared) {
  Task task;
  task.id = "films";
  task.kind = "tables";
  task.determinants.add("libraries", shared.libraries).add("code", film_code());
  for (const Stimulus* film : films_of(manifest)) {
    task.inputs.push_back("film:" + film->id);
    task.determinants.add("stimulus", film->id);
  }
  for (const FilmTable& table : tables) task.products.push_back({std::string(table.form.path), {}});
  task.cost_seconds = cost_seconds;
  task.make = [&manifest](TaskRun& run) {
    Films films;
    for (const Stimulus* film : films_of(manifest))
      films.push_back(made_film(film->id, run.store.folder()));
    for (std::size_t i = 0; i < run.keys.size(); ++i) {
      run.put_text(i, tables[i].csv(films), read_csv);
    }
  };
  return task;
}

}  // namespace mien::pipeline
