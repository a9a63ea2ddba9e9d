#include "pipeline/study/adaptive/pair_study.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/reading/manifest_yaml.h"
#include "pipeline/study/adaptive/pair_tables.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

using Ids = std::vector<std::string>;

Manifest pair_walks(const std::string& questionnaire) {
  const ManifestReading reading = check_manifest_text(
      "mien: 1\nstudy: walks\nseed: 3\nexamples: {set: builtin:walks-10, ratings: builtin}\n"
      "stimuli:\n"
      "  - {id: sad, weights: {sad: 1}, factors: {pace: slow}}\n"
      "  - {id: tired, weights: {tired: 1}, factors: {pace: slow}}\n"
      "  - {id: happy, weights: {happy: 1}, factors: {pace: quick}}\n"
      "  - {id: angry, weights: {angry: 1}, factors: {pace: quick}}\n"
      "questionnaire: {participants: 6, trials: pair, scales: [sad-happy, slow-fast]" +
          questionnaire + "}\n",
      "walks.yaml", {});
  EXPECT_TRUE(reading.faults.empty()) << to_string(reading.faults.front());
  return reading.manifest;
}

/// An answer by a participant about a pair, the first on the left.
AnswerRow answer(int trial, const std::string& left, const std::string& right,
                 const std::string& chosen, const std::string& scale = "sad-happy") {
  AnswerRow row;
  row.participant = "p001";
  row.session = "s";
  row.trial = trial;
  row.block = "main";
  row.kind = "pair";
  row.stimulus = left;
  row.against = right;
  row.item = scale;
  row.value = chosen;
  row.value_raw = chosen == left ? "left" : chosen == right ? "right" : chosen;
  row.design = "d";
  return row;
}

TEST(PairStudy, CountsTheAnswersOfAllRounds) {
  const Manifest manifest = pair_walks(", preference: {ties: true}");
  AnswerRow practice = answer(9, "sad", "happy", "sad");
  practice.is_practice = true;
  std::vector<AnswerRow> second = {answer(1, "happy", "sad", "happy"),
                                   answer(2, "happy", "tired", "tie"),
                                   answer(3, "sad", "happy", "happy", "slow-fast")};
  for (AnswerRow& row : second) row.design = "another";
  second[0].simulated = true;
  const PairStudy study = pair_study(
      manifest,
      {{answer(1, "sad", "happy", "happy"), answer(2, "sad", "happy", "sad"), practice}, second},
      {"slow-fast", "sad-happy"});
  EXPECT_EQ(study.stimuli, (Ids{"sad", "tired", "happy", "angry"}));
  EXPECT_EQ(study.pairs.size(), 6u);
  EXPECT_TRUE(study.simulated);
  ASSERT_EQ(study.items.size(), 2u);
  EXPECT_EQ(study.items[0].id, "slow-fast");
  double total = 0.0, happy_over_sad = 0.0, ties = 0.0;
  for (const PairCount& count : study.items[1].counts) {
    total += count.total();
    ties += count.ties;
    if (count.first == 2 && count.second == 0) happy_over_sad += count.first_wins;
    if (count.first == 0 && count.second == 2) happy_over_sad += count.second_wins;
  }
  EXPECT_EQ(total, 4.0);
  EXPECT_EQ(ties, 1.0);
  EXPECT_EQ(happy_over_sad, 2.0);
}

TEST(PairStudy, KnowsWhichPairsCanBeAsked) {
  const std::vector<std::vector<AnswerRow>> rounds = {{answer(1, "sad", "tired", "sad")}};
  const auto pairs = [&](const std::string& more) {
    const PairStudy study = pair_study(pair_walks(more), rounds, {"sad-happy"});
    std::vector<Ids> named;
    for (const StimulusPair& pair : study.pairs)
      named.push_back({study.stimuli[pair.first], study.stimuli[pair.second]});
    return named;
  };
  EXPECT_EQ(pairs("").size(), 6u);
  EXPECT_EQ(pairs(", preference: {alike: [pace]}"),
            (std::vector<Ids>{{"sad", "tired"}, {"happy", "angry"}}));
  // Listed pairs name the stimuli, as answers do.
  EXPECT_EQ(pairs(", pairs: [[tired, happy]]"),
            (std::vector<Ids>{{"sad", "tired"}, {"sad", "happy"}, {"tired", "happy"}}));
  EXPECT_EQ(pairs(", stimuli: [sad, tired]"), (std::vector<Ids>{{"sad", "tired"}}));
}

TEST(PairStudy, RefusesWhatHasNoPairs) {
  const auto refusal = [](const Manifest& manifest, std::vector<AnswerRow> rows) {
    try {
      pair_study(manifest, {std::move(rows)}, {"sad-happy"});
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  Manifest ratings = pair_walks("");
  ratings.questionnaire->trials = &rating_form;
  EXPECT_NE(refusal(ratings, {answer(1, "sad", "tired", "sad")}).find("rating trials, no pairs"),
            std::string::npos);
  EXPECT_NE(refusal(pair_walks(""), {answer(1, "sad", "gone", "sad")}).find("no stimulus \"gone\""),
            std::string::npos);
  EXPECT_NE(refusal(pair_walks(""), {answer(1, "sad", "tired", "sad", "slow-fast")})
                .find("none of the answers are choices"),
            std::string::npos);
}

TEST(PlannedAnswers, AreThoseOfParticipantsWhoSeeThePair) {
  Manifest manifest = pair_walks("");
  EXPECT_EQ(planned_answers(manifest, 4), 6.0);
  manifest.questionnaire->per_participant = 2;
  EXPECT_EQ(planned_answers(manifest, 4), 3.0);
  EXPECT_EQ(planned_answers(manifest, 1), 6.0);
  manifest.questionnaire->participants = 1;
  EXPECT_EQ(planned_answers(manifest, 4), 1.0);
}

TEST(NextPairRound, AsksTheChosenPairsAndKeepsAllStimuli) {
  const Manifest manifest = pair_walks(", per_participant: 1, preference: {alike: [pace]}");
  const PairStudy study =
      pair_study(manifest, {{answer(1, "sad", "tired", "sad")}}, {"sad-happy", "slow-fast"});
  NextPairs next;
  next.pairs = {{.pair = 1, .gain = 0.0, .first_chosen = {}}};
  const Manifest round = next_pair_round(manifest, study, next, "walks-2");
  const ManifestReading read = check_manifest_text(manifest_yaml(round, "."), "next.yaml", {});
  ASSERT_TRUE(read.faults.empty()) << to_string(read.faults.front());
  const Questionnaire& asked = *read.manifest.questionnaire;
  EXPECT_EQ(read.manifest.study, "walks-2");
  EXPECT_EQ(asked.pairs, (std::vector<Ids>{{"happy", "angry"}}));
  EXPECT_EQ(asked.stimuli.ids, (Ids{"sad", "tired", "happy", "angry"}));
  EXPECT_EQ(asked.per_participant, 0);  // one pair: all
  EXPECT_EQ(asked.preference.alike, (Ids{"pace"}));
  // The round after it can ask the same pairs.
  EXPECT_EQ(
      pair_study(read.manifest, {{answer(1, "sad", "tired", "sad")}}, {"sad-happy"}).pairs.size(),
      2u);
}

TEST(PairTables, HaveThePairsAndTheWorthsOfAllStimuli) {
  const Manifest manifest = all_pairs_study(12);
  const StatedTruth truth = {{{"acted-sad", "sad-happy"}, -0.8},
                             {{"sad", "sad-happy"}, -0.7},
                             {{"walk", "sad-happy"}, 0.0},
                             {{"happy", "sad-happy"}, 0.7},
                             {{"acted-happy", "sad-happy"}, 0.8}};
  PairChoice choice{.study = pair_study(manifest, {answers_to(manifest, truth)}, {"sad-happy"}),
                    .next = {}};
  ASSERT_EQ(choice.study.pairs.size(), 10u);
  choice.next = next_pairs(choice.study.pairs, choice.study.items, choice.study.stimuli.size(),
                           {.pairs = 2, .answers = 12.0});
  // That a happy walk is happier than a sad one is known.
  for (const NextPair& pair : choice.next.pairs) {
    const std::string& one = choice.first_of(pair.pair);
    const std::string& other = choice.second_of(pair.pair);
    EXPECT_FALSE(one.ends_with("sad") && other.ends_with("happy")) << one << other;
    EXPECT_FALSE(one.ends_with("happy") && other.ends_with("sad")) << one << other;
    EXPECT_GT(pair.first_chosen[0], 0.01);
    EXPECT_LT(pair.first_chosen[0], 0.99);
  }
  const auto tables = pair_tables(choice);
  ASSERT_EQ(tables.size(), 2u);
  EXPECT_EQ(std::ranges::count(tables[0].csv, '\n'), 1 + 2);
  EXPECT_EQ(std::ranges::count(tables[1].csv, '\n'), 1 + 5);
  EXPECT_NE(tables[1].csv.find("walk,sad-happy,48,"), std::string::npos) << tables[1].csv;
  const std::string text = pair_report(choice);
  EXPECT_EQ(text.find("simulated answers\n2 of 10 pairs of 5 stimuli, "), 0u) << text;
  EXPECT_NE(text.find("% of what is unknown"), std::string::npos);
}

}  // namespace
}  // namespace mien::pipeline
