#include "pipeline/study/adaptive/film_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mien::pipeline {

namespace {

/// What a film is chosen for: "sad-happy 1.33 ± 0.24", or "removes 13 % of what is unknown".
std::string reason(const FilmChoice& choice, const NextFilm& film) {
  if (choice.aim.scale.empty())
    return fmt::format("removes {:.1f} % of what is unknown", 100.0 * film.gain);
  const auto scale = std::ranges::find(choice.rated.scales, choice.aim.scale, &RatedFilms::scale);
  const auto s = static_cast<std::size_t>(scale - choice.rated.scales.begin());
  return fmt::format("{} {:.2f} ± {:.2f}", choice.aim.scale, film.mean[s], film.deviation[s]);
}

/// "0.33", or "–" if it is not known.
std::string number_text(double value) {
  return std::isnan(value) ? "–" : fmt::format("{:.2f}", value);
}

std::string round_heads(const FilmChoice& choice) {
  std::string heads;
  for (const FilmRound& round : choice.rounds)
    heads += fmt::format(" {:>8}", fmt::format("round {}", round.number));
  return heads;
}

std::string rounds_text(const FilmChoice& choice) {
  std::string text =
      "Rounds, and how well the mean ratings of their films were predicted (from the rounds "
      "before; "
      "in the first, each\nfrom the others): share of their variance explained, and share within "
      "90 % intervals, means over scales\n";
  text += fmt::format("  {:>8} {:>6} {:>8} {:>10} {:>8}\n", "round", "films", "answers",
                      "explained", "within");
  for (const FilmRound& round : choice.rounds)
    text += fmt::format("  {:>8} {:>6} {:>8} {:>10} {:>8}\n", round.number, round.films,
                        round.answers, number_text(round.explained), number_text(round.covered));
  text += "Error of predicted mean ratings (root mean square over the films of the round):\n";
  text += fmt::format("  {:24}{}\n", "", round_heads(choice));
  for (std::size_t s = 0; s < choice.rated.scales.size(); ++s) {
    text += fmt::format("  {:24}", choice.rated.scales[s].scale);
    for (const FilmRound& round : choice.rounds)
      text += fmt::format(" {:>8}", number_text(round.scales[s].error));
    text += '\n';
  }
  return text;
}

std::string known_text(const FilmChoice& choice) {
  std::string text =
      "Standard deviation of expected mean ratings (root mean square over all films):\n";
  const bool has_rounds = choice.rounds.size() > 1;
  text += has_rounds ? fmt::format("  {:24}{}  after the next\n", "", round_heads(choice))
                     : fmt::format("  {:24} {:>6}  after this round\n", "", "now");
  for (std::size_t s = 0; s < choice.rated.scales.size(); ++s) {
    text += fmt::format("  {:24}", choice.rated.scales[s].scale);
    if (has_rounds) {
      for (const FilmRound& round : choice.rounds)
        text += fmt::format(" {:>8}", number_text(round.scales[s].deviation));
      text += fmt::format(" {:8.2f}\n", choice.next.known_then[s]);
    } else {
      text +=
          fmt::format(" {:6.2f} {:6.2f}\n", choice.next.known_now[s], choice.next.known_then[s]);
    }
  }
  return text;
}

}  // namespace

std::string aim_text(const FilmAim& aim) {
  if (aim.scale.empty()) return "to learn the most about all ratings";
  return fmt::format("that may be rated {} on {}", aim.highest ? "highest" : "lowest", aim.scale);
}

std::string film_report(const FilmChoice& choice) {
  std::string text = choice.rated.simulated ? "simulated answers\n" : "";
  text += fmt::format("{} of {} films that the examples allow, {}{}\n", choice.next.films.size(),
                      choice.candidates.size(), aim_text(choice.aim),
                      choice.rated.scales.empty()
                          ? "; nothing is rated yet, so they are chosen by their features alone"
                          : "");
  for (std::size_t f = 0; f < choice.next.films.size(); ++f) {
    const NextFilm& film = choice.next.films[f];
    text += fmt::format("  {}  {:40} {}\n", choice.ids[f], blend_text(choice, film.candidate),
                        reason(choice, film));
  }
  if (choice.rounds.size() > 1) text += rounds_text(choice);
  return choice.rated.scales.empty() ? text : text + known_text(choice);
}

}  // namespace mien::pipeline
