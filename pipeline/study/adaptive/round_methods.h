#pragma once

#include <string>
#include <vector>

#include "pipeline/study/adaptive/film_tables.h"
#include "pipeline/study/adaptive/pair_tables.h"

namespace mien::pipeline {

/// A paragraph of a methods section, in Markdown with citations in pandoc's syntax.
struct RoundMethods {
  std::string text;
  std::vector<std::string> cited;  ///< keys of the works
};

/// How the films of a round were chosen.
RoundMethods film_methods(const FilmChoice& choice);

/// How the pairs of a round were chosen.
RoundMethods pair_methods(const PairChoice& choice);

}  // namespace mien::pipeline
