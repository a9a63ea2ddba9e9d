#include "pipeline/production/film/film_tables.h"

#include <fmt/format.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/production/film/film_table_forms.h"
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

using Films = std::vector<MadeFilm>;

constexpr double cost_seconds = 0.01;

/// Six digits: more than a display can show.
std::string rounded(double value) { return fmt::format("{:.6f}", value); }

std::string luminance_csv(const Films& films) {
  CsvWriter table = table_of(luminance_form);
  for (const auto& [stimulus, film, hashes] : films) {
    const render::ClipLuminance& found = film.luminance;
    table.row({stimulus, std::to_string(found.frames), rounded(found.mean),
               rounded(found.deviation), rounded(found.rms_contrast), rounded(found.darkest),
               rounded(found.lightest), shortest(film.exposure_stops)});
  }
  return table.text();
}

std::string videos_csv(const Films& films) {
  CsvWriter table = table_of(videos_form);
  for (const auto& [stimulus, film, hashes] : films) {
    for (std::size_t i = 0; i < film.videos.size(); ++i) {
      const VideoRecord& video = film.videos[i];
      const auto unless_identical = [&](const std::string& text) {
        return video.identical ? std::string() : text;
      };
      table.row({stimulus, video.file, video.format, std::to_string(video.frames),
                 std::to_string(film.first_film_frame), std::to_string(film.film_frames),
                 shortest(video.fps), rounded(video.duration_s), video.identical ? "1" : "0",
                 unless_identical(fmt::format("{:.2f}", video.worst_psnr_db)),
                 unless_identical(std::to_string(video.worst_psnr_frame)),
                 unless_identical(fmt::format("{:.4f}", video.worst_ssim)),
                 unless_identical(std::to_string(video.worst_ssim_frame)), hashes[i]});
    }
  }
  return table.text();
}

std::string views_csv(const Films& films) {
  CsvWriter table = table_of(views_form);
  for (const auto& [stimulus, film, hashes] : films) {
    const auto place = [&film](std::size_t axis) {
      return film.figure_place ? fmt::format("{:.2f}", (*film.figure_place)[axis]) : "";
    };
    table.row({stimulus, fmt::format("{:.2f}", film.figure_px),
               film.visual_degrees ? fmt::format("{:.3f}", *film.visual_degrees) : "", place(0),
               place(1)});
  }
  return table.text();
}

MadeFilm made_film(const std::string& id, const fs::path& folder) {
  MadeFilm film{id, parse_film_record(read_file(folder / film_record_path(id))), {}};
  for (const VideoRecord& video : film.record.videos) {
    const auto receipt = read_receipt(folder, video.file);
    film.hashes.push_back(receipt ? receipt->hash : "");
  }
  return film;
}

struct Table {
  const TableForm& form;
  std::string (*make)(const Films&);
};

constexpr Table tables[] = {
    {luminance_form, luminance_csv}, {videos_form, videos_csv}, {views_form, views_csv}};

}  // namespace

std::string film_record_path(const std::string& stimulus) {
  return "metrics/films/" + stimulus + ".json";
}

std::vector<TableForm> film_table_forms() {
  std::vector<TableForm> forms;
  for (const Table& table : tables) forms.push_back(table.form);
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
  for (const Table& table : tables) task.products.push_back({std::string(table.form.path), {}});
  task.cost_seconds = cost_seconds;
  task.make = [&manifest](TaskRun& run) {
    Films films;
    for (const Stimulus* film : films_of(manifest))
      films.push_back(made_film(film->id, run.store.folder()));
    for (std::size_t i = 0; i < run.keys.size(); ++i) {
      run.put_text(i, tables[i].make(films), read_csv);
    }
  };
  return task;
}

}  // namespace mien::pipeline
