#include "pipeline/manifest/questionnaire_pairs.h"

#include <map>

#include <gtest/gtest.h>

#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/questionnaire/asked_study.h"

namespace mien::pipeline {
namespace {

using test::asked_study;
using Pairs = std::vector<std::vector<std::string>>;

// The stimuli are a1, b2, c3, a4 (sad), b5, c6, a7, b8 (happy): actor and emotion.
Manifest study_of(const std::string& members, int stimuli = 8) {
  return asked_study(stimuli, "participants: 4, " + members);
}

std::map<std::string, int> counts_of(const Pairs& pairs) {
  std::map<std::string, int> counts;
  for (const auto& pair : pairs) {
    EXPECT_EQ(pair[0], pair[1]);
    ++counts[pair[0]];
  }
  return counts;
}

TEST(DifferentPairs, AreAllOfTheStimuli) {
  const Pairs pairs = different_pairs(study_of("trials: same_different, stimuli: [a1, b2, c3]"));
  EXPECT_EQ(pairs, (Pairs{{"a1", "b2"}, {"a1", "c3"}, {"b2", "c3"}}));
}

TEST(DifferentPairs, DifferInTheStatedFactorOnly) {
  const Pairs pairs =
      different_pairs(study_of("trials: same_different, same_different: {differ_in: emotion}"));
  EXPECT_EQ(pairs, (Pairs{{"a1", "a7"}, {"b2", "b5"}, {"b2", "b8"}, {"c3", "c6"}, {"a4", "a7"}}));
}

TEST(DifferentPairs, OfTwoIntervalsHaveOneSignal) {
  const std::string question = ", question: Is it sad";
  const Pairs pairs = different_pairs(
      study_of("trials: two_interval, stimuli: [a1, b2, b5], signal: {emotion: [sad]}" + question));
  EXPECT_EQ(pairs, (Pairs{{"a1", "b5"}, {"b2", "b5"}}));
  EXPECT_EQ(
      different_pairs(study_of("trials: two_interval, signal: [b5], pairs: [[b5, a1]]" + question)),
      (Pairs{{"b5", "a1"}}));
}

TEST(SignalStimuli, HaveTheNamesOrLevelsThatAreStated) {
  using Ids = std::vector<std::string>;
  const std::string asked = "trials: yes_no, question: Is it sad, signal: ";
  EXPECT_EQ(signal_stimuli(study_of(asked + "[b2, a1]")), (Ids{"a1", "b2"}));
  EXPECT_EQ(signal_stimuli(study_of(asked + "{emotion: [happy], actor: [b, c]}")),
            (Ids{"b5", "c6", "b8"}));
  EXPECT_EQ(signal_stimuli(study_of(asked + "{emotion: [happy]}, stimuli: [a1, c6]")), (Ids{"c6"}));
}

TEST(SamePairs, AreTheStatedShare) {
  const auto same_and_all = [](const std::string& members) {
    const Manifest manifest = study_of("trials: same_different, " + members);
    const Pairs all = questionnaire_subjects(manifest);
    const std::size_t different = different_pairs(manifest).size();
    return std::pair(all.size() - different, all.size());
  };
  // 28 pairs of eight stimuli.
  EXPECT_EQ(same_and_all("comments: true"), (std::pair<std::size_t, std::size_t>(28, 56)));
  EXPECT_EQ(same_and_all("same_different: {same: 0.3}"),
            (std::pair<std::size_t, std::size_t>(12, 40)));
  EXPECT_EQ(same_and_all("same_different: {same: 0.1}, pairs: [[a1, b2]]"),
            (std::pair<std::size_t, std::size_t>(1, 2)));
}

TEST(SamePairs, HaveTheStimuliInProportionToTheDifferentPairs) {
  const Manifest manifest =
      study_of("trials: same_different, pairs: [[a1, b2], [a1, c3], [a1, a4], [a1, b5]]");
  EXPECT_EQ(counts_of(same_pairs(manifest, different_pairs(manifest))),
            (std::map<std::string, int>{{"a1", 2}, {"b2", 1}, {"c3", 1}}));
  const Manifest even = study_of("trials: same_different, same_different: {same: 0.6}", 4);
  for (const auto& [id, count] : counts_of(same_pairs(even, different_pairs(even)))) {
    EXPECT_GE(count, 2) << id;
    EXPECT_LE(count, 3) << id;
  }
}

}  // namespace
}  // namespace mien::pipeline
