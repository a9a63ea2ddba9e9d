#include "pipeline/study/adaptive/film_space.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/production/synthesis/synthesis.h"
#include "pipeline/study/adaptive/round_numbers.h"

namespace mien::pipeline {

namespace {

using Eigen::Index;

/// Why a stimulus has no place among the blends of the examples; empty if it has one.
std::string_view fault_of(const Stimulus& stimulus) {
  if (stimulus.clip) return "shows a motion file";
  if (stimulus.walk) return "walks along a path";
  if (!stimulus.people.empty()) return "shows several people";
  return stimulus.modify.empty() ? "" : "is modified";
}

/// Answers about one film on one scale.
struct FilmAnswers {
  int count = 0;
  double sum = 0.0, sum_of_squares = 0.0;

  double mean() const { return sum / count; }
  double squares_within() const { return std::max(0.0, sum_of_squares - count * mean() * mean()); }
};

/// By scale and stimulus.
using AnswersByFilm = std::map<std::string, std::map<std::string, FilmAnswers>>;

class AnswerSorter {
 public:
  AnswerSorter(const Manifest& manifest, const std::vector<std::string>& asked)
      : asked_(asked.begin(), asked.end()) {
    for (const Stimulus& stimulus : manifest.stimuli) stimuli_.emplace(stimulus.id, &stimulus);
  }

  void add(const Answer& answer) {
    if (!asked_.contains(answer.scale)) return;
    const auto found = stimuli_.find(answer.stimulus);
    if (found == stimuli_.end()) {
      ++left_out_[answer.stimulus + ", which is no stimulus of the manifest"];
      return;
    }
    if (const std::string_view fault = fault_of(*found->second); !fault.empty()) {
      ++left_out_[fmt::format("{}, which {}", answer.stimulus, fault)];
      return;
    }
    FilmAnswers& film = films_[answer.scale][answer.stimulus];
    ++film.count;
    film.sum += answer.value;
    film.sum_of_squares += answer.value * answer.value;
  }

  const AnswersByFilm& films() const { return films_; }

  std::vector<std::string> left_out() const {
    std::vector<std::string> sentences;
    for (const auto& [what, count] : left_out_)
      sentences.push_back(
          fmt::format("{} {} left out: {}", count, count == 1 ? "answer is" : "answers are", what));
    return sentences;
  }

 private:
  std::set<std::string> asked_;
  std::map<std::string, const Stimulus*> stimuli_;
  AnswersByFilm films_;
  std::map<std::string, int> left_out_;
};

double answer_variance(const std::map<std::string, FilmAnswers>& films) {
  double squares = 0.0;
  int freedom = 0;
  for (const auto& [stimulus, film] : films) {
    squares += film.squares_within();
    freedom += film.count - 1;
  }
  return freedom > 0 ? squares / freedom : 0.0;
}

RatedFilms rated_films(const std::string& scale, const std::map<std::string, FilmAnswers>& answered,
                       const std::map<std::string, Eigen::RowVectorXd>& places,
                       const std::map<std::string, int>& rounds) {
  const auto count = static_cast<Index>(answered.size());
  RatedFilms films{.scale = scale,
                   .places = Eigen::MatrixXd(count, places.begin()->second.size()),
                   .mean = Eigen::VectorXd(count),
                   .answers = Eigen::VectorXi(count),
                   .answer_variance = answer_variance(answered),
                   .ids = {},
                   .rounds = {}};
  Index i = 0;
  for (const auto& [stimulus, answers] : answered) {
    films.places.row(i) = places.at(stimulus);
    films.mean[i] = answers.mean();
    films.answers[i++] = answers.count;
    films.ids.push_back(stimulus);
    films.rounds.push_back(rounds.at(stimulus));
  }
  return films;
}

std::string round_id(int round, std::size_t film) {
  return fmt::format("round{}-{:02}", round, film + 1);
}

int first_free_round(const Manifest& manifest, int from) {
  int round = from;
  const auto is_taken = [&](const Stimulus& stimulus) {
    return stimulus.id.starts_with(fmt::format("round{}-", round));
  };
  while (std::ranges::any_of(manifest.stimuli, is_taken)) ++round;
  return round;
}

/// Whether a study's name ends with a number of at most four digits after a dash.
bool is_numbered(const std::string& study) {
  const std::size_t dash = study.rfind('-');
  return dash != std::string::npos && dash + 1 < study.size() && study.size() - dash <= 5 &&
         study[dash + 1] != '0' &&
         std::all_of(study.begin() + static_cast<std::ptrdiff_t>(dash) + 1, study.end(),
                     [](unsigned char c) { return std::isdigit(c); });
}

}  // namespace

FilmSpace film_space(const Repertoire& repertoire, std::vector<std::string> features) {
  if (features.empty()) {
    features = feature_parameter_names();
    features.resize(motion::feature_group_count);
  }
  FilmSpace space{.parameters = std::move(features), .examples = {}, .places = {}};
  for (const RatedExample& example : repertoire.names) space.examples.push_back(example.name);
  space.places = places_of_examples(space.parameters, repertoire.features.table);
  return space;
}

RatedStudy rated_study(const Manifest& manifest, const Repertoire& repertoire,
                       const FilmSpace& space, const std::vector<Answers>& rounds,
                       const std::vector<std::string>& asked) {
  AnswerSorter sorter(manifest, asked);
  RatedStudy study;
  for (const Answers& round : rounds) {
    study.simulated = study.simulated || round.simulated;
    for (const Answer& answer : round.answers) sorter.add(answer);
  }
  std::map<std::string, Eigen::RowVectorXd> places;
  for (const Stimulus& stimulus : manifest.stimuli)
    if (fault_of(stimulus).empty())
      places[stimulus.id] = weights_of(stimulus, repertoire).transpose() * space.places;
  const std::map<std::string, int> numbers = round_numbers(rounds);
  std::vector<int> counts;
  for (const std::string& scale : asked) {
    const auto found = sorter.films().find(scale);
    if (found == sorter.films().end()) continue;
    study.scales.push_back(rated_films(scale, found->second, places, numbers));
    for (const int count : study.scales.back().answers) counts.push_back(count);
  }
  study.left_out = sorter.left_out();
  if (study.scales.empty())
    throw Error(
        "none of the answers are ratings, on scales that are asked, of blends of the "
        "examples",
        study.left_out.empty() ? "give the answers to this manifest's questionnaire"
                               : study.left_out.front());
  std::ranges::nth_element(counts, counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2));
  study.answers_per_film = counts[counts.size() / 2];
  return study;
}

Eigen::MatrixXd unanswered_rounds(const Manifest& manifest, const Repertoire& repertoire,
                                  const FilmSpace& space, const std::vector<Answers>& rounds) {
  std::set<std::string> answered;
  for (const Answers& round : rounds)
    for (const Answer& answer : round.answers) answered.insert(answer.stimulus);
  std::vector<Eigen::RowVectorXd> places;
  for (const Stimulus& stimulus : manifest.stimuli)
    if (round_in_name(stimulus.id) && !answered.contains(stimulus.id) && fault_of(stimulus).empty())
      places.emplace_back(weights_of(stimulus, repertoire).transpose() * space.places);
  Eigen::MatrixXd rows(static_cast<Index>(places.size()), space.places.cols());
  for (std::size_t f = 0; f < places.size(); ++f) rows.row(static_cast<Index>(f)) = places[f];
  return rows;
}

Manifest next_round(const Manifest& manifest, const FilmSpace& space,
                    const std::vector<FilmCandidate>& candidates, const NextFilms& next,
                    const std::string& name, int from) {
  Manifest round = manifest;
  round.study = name;
  const int number = first_free_round(manifest, from);
  round.questionnaire->stimuli = {};
  for (std::size_t f = 0; f < next.films.size(); ++f) {
    Stimulus stimulus = plain_stimulus(manifest);
    stimulus.id = round_id(number, f);
    const Eigen::VectorXd& weights = candidates[next.films[f].candidate].weights;
    for (Index i = 0; i < weights.size(); ++i)
      if (weights[i] > 0.0)
        stimulus.weights.emplace_back(space.examples[static_cast<std::size_t>(i)], weights[i]);
    round.questionnaire->stimuli.ids.push_back(stimulus.id);
    round.stimuli.push_back(std::move(stimulus));
  }
  return round;
}

std::string name_of_first_round(const std::string& study) {
  return is_numbered(study) ? name_of_next_round(study) : study + "-1";
}

std::string name_of_next_round(const std::string& study) {
  if (!is_numbered(study)) return study + "-2";
  const std::size_t dash = study.rfind('-');
  return fmt::format("{}-{}", study.substr(0, dash), std::stoi(study.substr(dash + 1)) + 1);
}

}  // namespace mien::pipeline
