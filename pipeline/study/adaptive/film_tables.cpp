#include "pipeline/study/adaptive/film_tables.h"

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

/// A film and a scale.
struct ExpectedRating {
  const FilmChoice& choice;
  std::size_t film;  ///< of the chosen films, or of the candidates
  std::size_t candidate;
  std::size_t scale;
  double mean, deviation;
  bool simulated;
};

constexpr auto next_films_columns = table_of<ExpectedRating>(
    "next_films.csv", "chosen film and scale, in the order of choice",
    {{"stimulus", "", "id of the film in the next manifest",
      [](auto& r) { return r.choice.ids[r.film]; }},
     {"blend", "", "examples with their weights",
      [](auto& r) { return blend_text(r.choice, r.candidate); }},
     {"scale", "", "id of the scale", [](auto& r) { return r.choice.rated.scales[r.scale].scale; }},
     {"expected", "scale units", "expected mean rating before the film is rated",
      [](auto& r) { return r.mean; }},
     {"deviation", "scale units",
      "standard deviation of that expectation once the films before it are rated",
      [](auto& r) { return r.deviation; }},
     {"gain", "",
      "share of what is unknown that the film's ratings would remove (mean over scales) or, if the "
      "highest or lowest ratings are sought, the expected improvement in scale units",
      [](auto& r) { return r.choice.next.films[r.film].gain; }},
     {"answers", "", "given (by people) or simulated",
      [](auto& r) { return origin_text(r.simulated); }}});

constexpr auto known_films_columns = table_of<ExpectedRating>(
    "known_films.csv", "blend that the examples allow, and scale",
    {{"blend", "", "examples with their weights",
      [](auto& r) { return blend_text(r.choice, r.candidate); }},
     {"scale", "", "id of the scale", [](auto& r) { return r.choice.rated.scales[r.scale].scale; }},
     {"expected", "scale units", "expected mean rating", [](auto& r) { return r.mean; }},
     {"deviation", "scale units", "standard deviation of that expectation, before the next round",
      [](auto& r) { return r.deviation; }},
     {"answers", "", "given (by people) or simulated",
      [](auto& r) { return origin_text(r.simulated); }}});

}  // namespace

std::string blend_text(const FilmChoice& choice, std::size_t candidate) {
  const Eigen::VectorXd& weights = choice.candidates[candidate].weights;
  std::string text;
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    if (weights[i] <= 0.0) continue;
    text += fmt::format("{}{} {:g}", text.empty() ? "" : ", ",
                        choice.space.examples[static_cast<std::size_t>(i)], weights[i]);
  }
  return text;
}

std::vector<WrittenTable> film_tables(const FilmChoice& choice) {
  std::vector<ExpectedRating> next, known;
  for (std::size_t f = 0; f < choice.next.films.size(); ++f) {
    const NextFilm& film = choice.next.films[f];
    for (std::size_t s = 0; s < choice.rated.scales.size(); ++s)
      next.push_back(
          {choice, f, film.candidate, s, film.mean[s], film.deviation[s], choice.rated.simulated});
  }
  for (std::size_t c = 0; c < choice.candidates.size(); ++c)
    for (std::size_t s = 0; s < choice.rated.scales.size(); ++s) {
      const ScaleKnowledge& scale = choice.next.known[s];
      const auto at = static_cast<Eigen::Index>(c);
      known.push_back(
          {choice, c, c, s, scale.mean[at], scale.deviation[at], choice.rated.simulated});
    }
  return {next_films_columns.of(next), known_films_columns.of(known)};
}

}  // namespace mien::pipeline
