#pragma once

#include <string>
#include <vector>

#include "pipeline/base/documents/table.h"
#include "pipeline/study/adaptive/film_rounds.h"
#include "pipeline/study/adaptive/film_space.h"
#include "pipeline/study/adaptive/next_films.h"

namespace mien::pipeline {

/// A choice of films, with what it was made from.
struct FilmChoice {
  FilmSpace space;
  RatedStudy rated;
  std::vector<FilmCandidate> candidates;
  FilmAim aim;
  NextFilms next;
  std::vector<std::string> ids;  ///< of the chosen films
  std::vector<FilmRound> rounds;
};

/// "sad 0.62, happy 0.38".
std::string blend_text(const FilmChoice& choice, std::size_t candidate);

/// The chosen films, and everything that could be made, each with what is expected of its ratings,
/// and what each round has brought.
std::vector<WrittenTable> film_tables(const FilmChoice& choice);

}  // namespace mien::pipeline
