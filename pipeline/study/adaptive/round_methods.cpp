#include "pipeline/study/adaptive/round_methods.h"

#include <algorithm>

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

/// "a, b and c"
std::string listed(const std::vector<std::string>& names) {
  if (names.size() < 2) return names.empty() ? "" : names.front();
  const std::vector<std::string> first(names.begin(), names.end() - 1);
  return fmt::format("{} and {}", fmt::join(first, ", "), names.back());
}

/// "1 film was", "8 films were"
std::string chosen_text(std::size_t count, const char* one, const char* several) {
  return count == 1 ? fmt::format("One {} was", one) : fmt::format("{} {} were", count, several);
}

std::string candidates_text(const FilmChoice& choice) {
  const bool has_blends = std::ranges::any_of(
      choice.candidates, [](const FilmCandidate& one) { return one.weights.maxCoeff() < 1.0; });
  return has_blends
             ? fmt::format("{} films, the examples and random blends of two or three of them",
                           choice.candidates.size())
             : fmt::format("the {} examples", choice.candidates.size());
}

constexpr const char* apart_text =
    "Films differed in their features by at least 0.3 standard deviations (root mean square) from "
    "each other";

RoundMethods first_films(const FilmChoice& choice) {
  return {
      fmt::format(
          "{} chosen among {}, before anything was rated, by their motion features ({}) alone: one "
          "after the other, each the film whose ratings would lower the variance of the expected "
          "ratings most, summed over all films [@cohn1996]. Ratings were taken to be a Gaussian "
          "process of the features [@rasmussen2006], with the parameters that are most probable "
          "before there are ratings. {}.",
          chosen_text(choice.next.films.size(), "film", "films"), candidates_text(choice),
          listed(choice.space.parameters), apart_text),
      {"cohn1996", "rasmussen2006"}};
}

std::string criterion_text(const FilmChoice& choice) {
  if (choice.aim.scale.empty())
    return "whose ratings would lower the variance of the expected ratings most, summed over all "
           "films and, as a share, averaged over the scales [@cohn1996]";
  return fmt::format(
      "with the greatest expected improvement [@jones1998] over the {} rating on {} so far",
      choice.aim.highest ? "highest" : "lowest", choice.aim.scale);
}

}  // namespace

RoundMethods film_methods(const FilmChoice& choice) {
  if (choice.rated.scales.empty()) return first_films(choice);
  std::vector<std::string> scales;
  for (const RatedFilms& scale : choice.rated.scales) scales.push_back(scale.scale);
  std::string text = fmt::format(
      "{} chosen among {}, from the {} so far on {}. On each scale, mean ratings were taken to be "
      "a "
      "Gaussian process of the motion features ({}), whose amplitude, reach and deviation were the "
      "most probable given the ratings [@rasmussen2006]. Films were chosen one after the other, "
      "each the film {}; after each choice, its ratings were taken to be as expected "
      "[@ginsbourger2010]. {} and from rated films.",
      chosen_text(choice.next.films.size(), "film", "films"), candidates_text(choice),
      choice.rated.simulated ? "simulated ratings" : "ratings", listed(scales),
      listed(choice.space.parameters), criterion_text(choice), apart_text);
  return {
      std::move(text),
      {choice.aim.scale.empty() ? "cohn1996" : "jones1998", "rasmussen2006", "ginsbourger2010"}};
}

RoundMethods pair_methods(const PairChoice& choice) {
  std::vector<std::string> scales;
  for (const ComparedItem& item : choice.study.items) scales.push_back(item.id);
  return {
      fmt::format(
          "{} chosen among {} of {} stimuli, from the {} so far on {}. On each scale, the "
          "stimuli's log-worths in the model of Bradley and Terry [@bradley1952] had a normal "
          "prior, whose standard deviation was fitted to the answers, and a normal posterior by "
          "Laplace's approximation. Pairs were chosen one after the other, each the pair whose "
          "answers would lower the variance of the log-worths most, summed over the stimuli "
          "and, as a share, averaged over the scales; after each choice, its answers were taken "
          "to be as expected.",
          chosen_text(choice.next.pairs.size(), "pair", "pairs"), choice.study.pairs.size(),
          choice.study.stimuli.size(), choice.study.simulated ? "simulated answers" : "answers",
          listed(scales)),
      {"bradley1952"}};
}

}  // namespace mien::pipeline
