#pragma once

#include <string>
#include <vector>

#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/ratings/answers/answer_row.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"

namespace mien::pipeline {

/// A study of five stimuli of one actor: neutral, acted and modified, sad and happy; two scales,
/// answered on a slider so that hardly anything is rounded.
inline Manifest two_emotion_study(int participants = 20, std::uint64_t seed = 1) {
  Manifest manifest;
  manifest.study = "two-emotions";
  manifest.seed = seed;
  const auto add = [&](const std::string& id, const std::string& made, const std::string& emotion) {
    Stimulus stimulus;
    stimulus.id = id;
    stimulus.factors = {{"actor", "woman"}, {"made", made}, {"emotion", emotion}};
    manifest.stimuli.push_back(stimulus);
  };
  add("walk", "as-is", "neutral");
  add("acted-sad", "acted", "sad");
  add("acted-happy", "acted", "happy");
  add("sad", "modified", "sad");
  add("happy", "modified", "happy");
  Questionnaire asked;
  asked.title.text = "How does she walk?";
  asked.participants = participants;
  asked.scales.ids = {"sad-happy", "weak-strong"};
  asked.answer.slider = true;
  manifest.questionnaire = asked;
  return manifest;
}

/// The same stimuli, three pairs of them.
inline Manifest pair_study() {
  Manifest manifest = two_emotion_study(12);
  manifest.questionnaire->trials = &pair_form;
  manifest.questionnaire->pairs = {{"walk", "sad"}, {"walk", "happy"}, {"acted-sad", "happy"}};
  manifest.questionnaire->scales.ids = {"sad-happy"};
  return manifest;
}

/// The same stimuli, each with each other.
inline Manifest all_pairs_study(int participants) {
  Manifest manifest = pair_study();
  manifest.questionnaire->participants = participants;
  manifest.questionnaire->pairs.clear();
  for (std::size_t i = 0; i < manifest.stimuli.size(); ++i)
    for (std::size_t k = i + 1; k < manifest.stimuli.size(); ++k)
      manifest.questionnaire->pairs.push_back({manifest.stimuli[i].id, manifest.stimuli[k].id});
  return manifest;
}

/// Few who lean to an end, and answers that stay away from the ends.
inline const SimulatedParticipants steady_people = {
    .spread = RatingSpread{.participant = 0.2, .stimulus = 0.0, .residual = 0.4},
    .attention_pass_rate = 1.0};

inline std::vector<AnswerRow> answers_to(const Manifest& manifest, const StatedTruth& truth = {},
                                         const SimulatedParticipants& people = steady_people) {
  return simulated_sessions(manifest, plan_sessions(manifest), truth, people);
}

}  // namespace mien::pipeline
