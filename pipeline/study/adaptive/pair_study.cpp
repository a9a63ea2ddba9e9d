#include "pipeline/study/adaptive/pair_study.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "motion/error.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/results/answer_set.h"

namespace mien::pipeline {

namespace {

/// The manifest with a questionnaire about all stimuli, so that the answers of all rounds belong to
/// it.
Manifest about_all_stimuli(const Manifest& manifest) {
  Manifest all = manifest;
  all.questionnaire->pairs.clear();
  all.questionnaire->stimuli = {};
  for (const Stimulus& stimulus : all.stimuli)
    all.questionnaire->stimuli.ids.push_back(stimulus.id);
  return all;
}

std::set<std::string> named_stimuli(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  std::set<std::string> named;
  if (asked.pairs.empty() || !asked.stimuli.ids.empty() || !asked.stimuli.levels.empty()) {
    const std::vector<std::string> ids = questionnaire_stimuli(manifest);
    named.insert(ids.begin(), ids.end());
  }
  for (const std::vector<std::string>& pair : asked.pairs) named.insert(pair.begin(), pair.end());
  return named;
}

/// Whether two stimuli have equal levels of the factors in which pairs must not differ.
bool are_alike(const Manifest& manifest, const std::string& one, const std::string& other) {
  return std::ranges::all_of(
      questionnaire_of(manifest).preference.alike, [&](const std::string& factor) {
        return level_of(manifest, one, factor) == level_of(manifest, other, factor);
      });
}

std::vector<StimulusPair> pairs_to_ask(const Manifest& manifest,
                                       const std::vector<std::string>& stimuli) {
  std::vector<StimulusPair> pairs;
  for (std::size_t i = 0; i < stimuli.size(); ++i)
    for (std::size_t j = i + 1; j < stimuli.size(); ++j)
      if (are_alike(manifest, stimuli[i], stimuli[j])) pairs.push_back({i, j});
  return pairs;
}

/// Choices and ties, by item and by the ids of the stimuli from left to right.
using Comparisons = std::map<std::string, std::map<std::pair<std::string, std::string>, PairCount>>;

void add_comparisons(const AnswerSet& answers, Comparisons& comparisons) {
  for (const AnalysedPreference& answer : answers.preferences) {
    const std::string& chosen = answers.stimuli[answer.chosen].id;
    const std::string& other = answers.stimuli[answer.other].id;
    PairCount& count = comparisons[answer.item][answer.is_left_chosen ? std::pair(chosen, other)
                                                                      : std::pair(other, chosen)];
    (answer.is_tie           ? count.ties
     : answer.is_left_chosen ? count.first_wins
                             : count.second_wins) += 1.0;
  }
}

ComparedItem compared_item(const std::string& id, const Comparisons& comparisons,
                           const std::vector<std::string>& stimuli) {
  const auto number_of = [&](const std::string& stimulus) {
    return static_cast<std::size_t>(std::ranges::find(stimuli, stimulus) - stimuli.begin());
  };
  ComparedItem item{.id = id, .counts = {}};
  for (const auto& [pair, outcomes] : comparisons.at(id)) {
    PairCount& count = item.counts.emplace_back(outcomes);
    count.first = number_of(pair.first);
    count.second = number_of(pair.second);
  }
  return item;
}

}  // namespace

PairStudy pair_study(const Manifest& manifest, const std::vector<std::vector<AnswerRow>>& rounds,
                     const std::vector<std::string>& asked) {
  if (questionnaire_of(manifest).trials != &pair_form)
    throw Error(fmt::format("the questionnaire has {} trials, no pairs",
                            questionnaire_of(manifest).trials->name),
                "omit --pairs");
  const Manifest about_all = about_all_stimuli(manifest);
  PairStudy study;
  Comparisons comparisons;
  for (const std::vector<AnswerRow>& rows : rounds) {
    const AnswerSet answers = collect_answers(about_all, rows);
    study.simulated = study.simulated || answers.simulated;
    for (const std::string& note : answers.notes)
      if (std::ranges::find(study.notes, note) == study.notes.end()) study.notes.push_back(note);
    add_comparisons(answers, comparisons);
  }
  std::set<std::string> ids = named_stimuli(manifest);
  for (const auto& [item, counts] : comparisons)
    for (const auto& [pair, count] : counts) ids.insert({pair.first, pair.second});
  for (const Stimulus& stimulus : manifest.stimuli)
    if (ids.contains(stimulus.id)) study.stimuli.push_back(stimulus.id);
  for (const std::string& item : asked)
    if (comparisons.contains(item))
      study.items.push_back(compared_item(item, comparisons, study.stimuli));
  study.pairs = pairs_to_ask(manifest, study.stimuli);
  if (study.items.empty())
    throw Error("none of the answers are choices between two stimuli on scales that are asked",
                "give the answers to this manifest's questionnaire");
  return study;
}

double planned_answers(const Manifest& manifest, std::size_t count) {
  const Questionnaire& asked = questionnaire_of(manifest);
  const double shown = asked.per_participant == 0
                           ? 1.0
                           : std::min(1.0, asked.per_participant / static_cast<double>(count));
  return std::max(1.0, asked.participants * shown);
}

Manifest next_pair_round(const Manifest& manifest, const PairStudy& study, const NextPairs& next,
                         const std::string& name) {
  Manifest round = manifest;
  round.study = name;
  Questionnaire& asked = *round.questionnaire;
  asked.stimuli = {};
  asked.stimuli.ids = study.stimuli;
  asked.pairs.clear();
  for (const NextPair& pair : next.pairs)
    asked.pairs.push_back({study.stimuli[study.pairs[pair.pair].first],
                           study.stimuli[study.pairs[pair.pair].second]});
  if (asked.per_participant >= static_cast<int>(asked.pairs.size())) asked.per_participant = 0;
  return round;
}

}  // namespace mien::pipeline
