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

/// A round and a scale.
struct RoundOnScale {
  const FilmChoice& choice;
  const FilmRound& round;
  std::size_t scale;
  bool simulated;

  const ScaleRound& on_scale() const { return round.scales[scale]; }
};

constexpr auto rounds_columns = table_of<RoundOnScale>(
    "rounds.csv", "round of films, and scale",
    {{"round", "", "number of the round: that in the names of its films (round2-01)",
      [](auto& r) { return r.round.number; }},
     {"scale", "", "id of the scale", [](auto& r) { return r.choice.rated.scales[r.scale].scale; }},
     {"films", "", "number of films of the round that were rated on the scale",
      [](auto& r) { return r.on_scale().films; }},
     {"ratings", "", "number of answers about them on the scale",
      [](auto& r) { return r.on_scale().answers; }},
     {"deviation", "scale units",
      "standard deviation of expected mean ratings after the round, root mean square over all "
      "films "
      "that can be made",
      [](auto& r) { return r.on_scale().deviation; }},
     {"predicted_from", "",
      "before: the mean ratings of the round's films are predicted from the rounds before; others: "
      "each from the other films of the round, as there is no earlier one",
      [](auto& r) { return &r.round == &r.choice.rounds.front() ? "others" : "before"; }},
     {"error", "scale units",
      "error of the predicted mean ratings, root mean square over the round's films",
      [](auto& r) { return r.on_scale().error; }},
     {"explained", "",
      "1 less the sum of squared errors of the predictions by that of the mean of the films from "
      "which is predicted: 1 if exact, 0 or less if no better than that mean",
      [](auto& r) { return r.on_scale().explained; }},
     {"covered", "0–1",
      "share of the round's films whose mean rating is in its predicted 90 % interval",
      [](auto& r) { return r.on_scale().covered; }},
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
  std::vector<RoundOnScale> rounds;
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
  for (const FilmRound& round : choice.rounds)
    for (std::size_t s = 0; s < choice.rated.scales.size(); ++s)
      rounds.push_back({choice, round, s, choice.rated.simulated});
  return {next_films_columns.of(next), known_films_columns.of(known), rounds_columns.of(rounds)};
}

}  // namespace mien::pipeline
