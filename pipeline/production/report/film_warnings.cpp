#include "pipeline/production/report/film_warnings.h"

#include <utility>

#include "pipeline/base/documents/files.h"
#include "pipeline/production/film/film_record.h"
#include "pipeline/production/film/film_tables.h"

namespace mien::pipeline {

FilmWarnings film_warnings(const Manifest& manifest, const std::filesystem::path& folder) {
  FilmWarnings warnings;
  for (const Stimulus* film : films_of(manifest)) {
    FilmRecord record = parse_film_record(read_file(folder / film_record_path(film->id)));
    if (!record.warnings.empty()) warnings[film->id] = std::move(record.warnings);
  }
  return warnings;
}

}  // namespace mien::pipeline
