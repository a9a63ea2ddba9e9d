#include <algorithm>

#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/matching/experiment/matching_study.h"
#include "pipeline/study/questionnaire/orders.h"
#include "pipeline/study/questionnaire/session_duration.h"
#include "pipeline/study/trials/trial_kind.h"

namespace mien::pipeline {

namespace {

constexpr double guess_seconds = 30.0;
constexpr double share_of_limit = 0.5;
constexpr double pause_seconds = 15.0;
constexpr double question_seconds = 8.0;
constexpr double words_per_second = 200.0 / 60.0;

using Strings = std::vector<std::string>;

Strings in_row(const Strings& names, std::size_t row) {
  Strings ordered;
  for (const std::size_t i : williams_row(names.size(), row)) ordered.push_back(names[i]);
  return ordered;
}

void add_trial(SessionPlan& plan, const std::string& block, const std::string& target,
               const std::string& interface) {
  plan.trials.push_back({.number = static_cast<int>(plan.trials.size()) + 1,
                         .block = block,
                         .kind = &matching_trials,
                         .stimuli = {target},
                         .items = {{interface, false}},
                         .practice = block == "practice"});
}

/// One block an interface.
void add_interface_blocks(SessionPlan& plan, const Matching& matching, const Strings& targets,
                          std::size_t participant) {
  const std::size_t rows = williams_rows(matching.interfaces.size());
  const Strings interfaces = in_row(matching.interfaces, participant % rows);
  if (const Strings& practice = matching.practice; !practice.empty()) {
    const std::size_t trials = std::max(practice.size(), interfaces.size());
    for (std::size_t i = 0; i < trials; ++i)
      add_trial(plan, "practice", practice[i % practice.size()], interfaces[i % interfaces.size()]);
  }
  for (std::size_t block = 0; block < interfaces.size(); ++block) {
    const std::size_t row = participant / rows + participant % rows + block;
    for (const std::string& target : in_row(targets, row))
      add_trial(plan, interfaces[block], target, interfaces[block]);
  }
}

/// One block a target.
void add_target_blocks(SessionPlan& plan, const Matching& matching, const Strings& targets,
                       std::size_t participant) {
  const std::size_t rows = williams_rows(matching.interfaces.size());
  const auto add_block = [&](const std::string& block, const std::string& target, std::size_t at) {
    for (const std::string& interface : in_row(matching.interfaces, (participant + at) % rows))
      add_trial(plan, block, target, interface);
  };
  for (std::size_t i = 0; i < matching.practice.size(); ++i)
    add_block("practice", matching.practice[i], i);
  const Strings ordered = in_row(targets, participant / rows + participant % rows);
  for (std::size_t i = 0; i < ordered.size(); ++i) add_block(ordered[i], ordered[i], i);
}

/// Expected duration of a session, seconds: reading texts, and for each trial a guess (30 s), half
/// of the time limit and a pause (15 s).
double matching_seconds(const Manifest& manifest, const SessionPlan& plan) {
  const Matching& matching = matching_of(manifest);
  double seconds = question_seconds * static_cast<double>(matching.demographics.size());
  for (const TextSource* text : {&matching.consent, &matching.instructions, &matching.ending})
    seconds += word_count(text->text) / words_per_second;
  const double trial = guess_seconds + share_of_limit * matching.limit_s + pause_seconds;
  return seconds + trial * static_cast<double>(plan.trials.size());
}

SessionPlan plan_of(const Manifest& manifest, int index) {
  const Matching& matching = *manifest.matching;
  const Strings targets = matching_targets(manifest);
  SessionPlan plan{.index = index, .participant = participant_name(index)};
  // So that a number of JavaScript represents it exactly.
  plan.seed = hashed_seed(manifest.seed, plan.participant) >> 11U;
  const auto participant = static_cast<std::size_t>(index);
  if (matching.order == MatchingOrder::guesses_first)
    add_target_blocks(plan, matching, targets, participant);
  else
    add_interface_blocks(plan, matching, targets, participant);
  plan.expected_seconds = matching_seconds(manifest, plan);
  return plan;
}

}  // namespace

std::vector<SessionPlan> plan_matching(const Manifest& manifest, int count) {
  const int participants = count != 0 ? count : matching_of(manifest).participants;
  std::vector<SessionPlan> plans;
  for (int index = 0; index < participants; ++index) plans.push_back(plan_of(manifest, index));
  return plans;
}

}  // namespace mien::pipeline
