#pragma once

#include <string>

#include "pipeline/study/adaptive/film_tables.h"

namespace mien::pipeline {

/// "to learn the most about all ratings", or "that may be rated highest on sad-happy".
std::string aim_text(const FilmAim& aim);

/// What a choice of films is printed as: the films with reasons, what is known now and after them
/// and, if there have been several rounds, what each has brought.
std::string film_report(const FilmChoice& choice);

}  // namespace mien::pipeline
