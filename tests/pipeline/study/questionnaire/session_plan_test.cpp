#include "pipeline/study/questionnaire/session_plan.h"

#include <algorithm>
#include <regex>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "motion/math/random_number.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/questionnaire/asked_study.h"
#include "pipeline/study/questionnaire/balance.h"
#include "pipeline/study/questionnaire/session_duration.h"

namespace mien::pipeline {
namespace {

using test::asked_study;

std::vector<SessionPlan> plans_of(int stimuli, const std::string& members) {
  return plan_sessions(asked_study(stimuli, "participants: 12, scales: [sad-happy], " + members));
}

std::vector<std::string> analysed(const SessionPlan& plan) {
  std::vector<std::string> ids;
  for (const Trial& trial : plan.trials) {
    if (trial.is_analysed()) ids.push_back(trial.stimuli.at(0));
  }
  return ids;
}

TEST(SessionPlan, IsTheSameWithMoreParticipants) {
  const Manifest manifest = asked_study(
      20,
      "participants: 7, scales: [sad-happy, slow-fast], per_participant: 9, no_repeats: [actor], "
      "attention: {every: 4}, retest: {repeat: 2}, warm_up: 2");
  const auto few = plan_sessions(manifest);
  const auto many = plan_sessions(manifest, {}, 40);
  ASSERT_EQ(few.size(), 7u);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  EXPECT_EQ(many[39].participant, "p040");
}

/// What holds of any design, whatever it says.
void expect_sound(const Manifest& manifest, const std::vector<SessionPlan>& plans) {
  const Questionnaire& asked = *manifest.questionnaire;
  for (const SessionPlan& plan : plans) {
    const std::vector<std::string> seen = analysed(plan);
    EXPECT_EQ(std::set<std::string>(seen.begin(), seen.end()).size(), seen.size());
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(asked.per_participant));
    int warm_up = 0, repeated = 0;
    const Trial* before = nullptr;
    for (const Trial& trial : plan.trials) {
      EXPECT_EQ(trial.number, &trial - plan.trials.data() + 1);
      warm_up += trial.warm_up;
      repeated += trial.is_check && !trial.is_attention_check();
      if (trial.is_attention_check()) continue;
      if (before != nullptr && !before->practice) {
        EXPECT_NE(before->stimuli, trial.stimuli);
        for (const std::string& factor : asked.no_repeats) {
          EXPECT_NE(level_of(manifest, before->stimuli[0], factor),
                    level_of(manifest, trial.stimuli[0], factor))
              << plan.participant << " " << trial.number;
        }
      }
      before = &trial;
    }
    EXPECT_EQ(warm_up, asked.warm_up);
    EXPECT_EQ(repeated, asked.repeated);
    EXPECT_LT(plan.seed, std::uint64_t{1} << 53U);
  }
  EXPECT_LE(participant_range(balance_of(manifest, plans)).most,
            participant_range(balance_of(manifest, plans)).least + 1);
}

TEST(SessionPlan, KeepsWhatItPromisesOverManyRandomDesigns) {
  const auto drawn = [](int design, const char* what, int most) {
    const double share =
        0.5 + 0.5 * motion::random_number(5, what, static_cast<std::uint64_t>(design));
    return static_cast<int>(share * (most + 1));
  };
  const char* orders[] = {"full", "{blocked: emotion}", "full"};
  for (int design = 0; design < 60; ++design) {
    const int stimuli = 18 + drawn(design, "stimuli", 30);
    const int own = stimuli - drawn(design, "own", 6);
    const std::string members =
        "participants: 9, scales: [sad-happy], per_participant: " + std::to_string(own) +
        ", order: " + orders[design % 3] +
        ", warm_up: " + std::to_string(drawn(design, "warm", 3)) +
        ", retest: {repeat: " + std::to_string(drawn(design, "repeat", 3)) +
        "}, attention: {every: " + std::to_string(drawn(design, "every", 9)) +
        "}, practice: [a1, b2]" + (design % 3 != 1 ? ", no_repeats: [actor]" : "");
    SCOPED_TRACE(std::to_string(stimuli) + ": " + members);
    const Manifest manifest = asked_study(stimuli, members);
    expect_sound(manifest, plan_sessions(manifest));
  }
}

TEST(SessionPlan, SaysWhenNoOrderKeepsApartWhatHasToBe) {
  const Manifest manifest = asked_study(
      6, "participants: 2, scales: [sad-happy], stimuli: [a1, b2, c3, b5], no_repeats: [emotion]");
  try {
    plan_sessions(manifest);
    FAIL() << "three of four are sad";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("3 of 4 stimuli have emotion: sad"), std::string::npos)
        << error.what();
  }
}

TEST(SessionPlan, SaysAtItsKeyThatAStimulusCannotBeSeenTwice) {
  try {
    plan_sessions(asked_study(1, "participants: 2, scales: [sad-happy], retest: {repeat: 1}"));
    FAIL() << "nothing could come in between";
  } catch (const Error& error) {
    const std::string told = error.what();
    EXPECT_NE(
        told.find("questionnaire.retest.repeat: p001 cannot see a stimulus a second time with "
                  "others in between; omit it, or show more stimuli"),
        std::string::npos)
        << told;
    EXPECT_TRUE(std::regex_search(told, std::regex(":[0-9]+:[0-9]+: "))) << told;
  }
}

TEST(SessionPlan, OfALatinSquareIsBalancedWhereItCanBe) {
  const Manifest even = asked_study(6, "participants: 12, scales: [sad-happy], order: latin");
  const Balance balance = balance_of(even, plan_sessions(even));
  EXPECT_TRUE(position_range(balance).is_uniform());
  EXPECT_EQ(position_range(balance).least, 2);
  EXPECT_TRUE(succession_range(balance).is_uniform());
  const Manifest odd = asked_study(5, "participants: 10, scales: [sad-happy], order: latin");
  EXPECT_TRUE(succession_range(balance_of(odd, plan_sessions(odd))).is_uniform());
  const Manifest uneven = asked_study(5, "participants: 7, scales: [sad-happy], order: latin");
  const auto sentences = balance_sentences(uneven, balance_of(uneven, plan_sessions(uneven)), 7);
  EXPECT_NE(sentences.back().find("multiple of 5"), std::string::npos) << sentences.back();
}

TEST(SessionPlan, TurnsEachScaleForHalfOfTheParticipants) {
  const Manifest manifest = asked_study(4, "participants: 12, scales: all");
  const auto plans = plan_sessions(manifest);
  const Balance balance = balance_of(manifest, plans);
  EXPECT_EQ(balance.flipped.size(), 41u);
  EXPECT_EQ(flipped_range(balance).least, 6);
  EXPECT_TRUE(flipped_range(balance).is_uniform());
  EXPECT_EQ(plans[0].trials[0].items, plans[0].trials[3].items);
  std::set<bool> sides;
  for (const TrialItem& item : plans[0].trials[0].items) sides.insert(item.flipped);
  EXPECT_EQ(sides.size(), 2u);
}

TEST(SessionPlan, OfPairsPutsEachStimulusLeftForHalfOfTheParticipants) {
  const Manifest manifest = asked_study(4, "participants: 12, scales: [sad-happy], trials: pair");
  const Balance balance = balance_of(manifest, plan_sessions(manifest));
  EXPECT_EQ(balance.subjects.size(), 6u);
  EXPECT_EQ(left_range(balance).least, 6);
  EXPECT_TRUE(left_range(balance).is_uniform());
}

TEST(SessionPlan, OfPairsSaysWhereOrWhenTheFirstOfThemIsShown) {
  const auto sentences = [](int participants, const std::string& more) {
    const Manifest manifest = asked_study(
        2,
        fmt::format("participants: {}, scales: [sad-happy], trials: pair{}", participants, more));
    const auto said =
        balance_sentences(manifest, balance_of(manifest, plan_sessions(manifest)), participants);
    return fmt::format("{}", fmt::join(said, "\n"));
  };
  const auto expect = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  const std::string together = sentences(2, "");
  expect(together, "Each pair is shown to 2 participants of 2.");
  expect(together, "Each pair appears twice in each position.");
  expect(together, "The first stimulus of each pair is on the left once.");
  const std::string in_turn = sentences(4, ", preference: {shown: in_turn}");
  expect(in_turn, "The first stimulus of each pair is shown first twice.");
  EXPECT_EQ(in_turn.find("on the left"), std::string::npos) << in_turn;
  const std::string one = sentences(1, "");
  expect(one, "Each pair is shown to 1 participant of 1.");
  expect(sentences(6, ""), "The first stimulus of each pair is on the left 3 times.");
}

/// Numbers of trials of two different and of two equal stimuli.
std::pair<int, int> different_and_same(const SessionPlan& plan) {
  std::pair<int, int> counts;
  for (const Trial& trial : plan.trials)
    if (trial.is_analysed())
      ++(trial.stimuli[0] == trial.stimuli[1] ? counts.second : counts.first);
  return counts;
}

TEST(SessionPlan, OfSameAndDifferentHasBothInTheirShare) {
  const Manifest all = asked_study(5, "participants: 8, trials: same_different");
  for (const SessionPlan& plan : plan_sessions(all))
    EXPECT_EQ(different_and_same(plan), std::pair(10, 10));
  const Manifest some =
      asked_study(6,
                  "participants: 12, trials: same_different, same_different: {same: 0.4}, "
                  "per_participant: 10");
  for (const SessionPlan& plan : plan_sessions(some)) {
    const auto [different, same] = different_and_same(plan);
    EXPECT_EQ(different + same, 10);
    EXPECT_GE(same, 3);
    EXPECT_LE(same, 5);
  }
}

TEST(SessionPlan, OfSameAndDifferentIsBalancedOverDifferentPairs) {
  const Manifest manifest = asked_study(4, "participants: 12, trials: same_different");
  const Balance balance = balance_of(manifest, plan_sessions(manifest));
  EXPECT_EQ(balance.subjects.size(), 6u);
  EXPECT_EQ(balance.max_positions, 12);
  EXPECT_TRUE(participant_range(balance).is_uniform());
  EXPECT_EQ(participant_range(balance).least, 12);
  EXPECT_EQ(left_range(balance).least, 6);
  EXPECT_TRUE(left_range(balance).is_uniform());
  EXPECT_EQ(same_range(balance).least, 12);
  EXPECT_EQ(same_range(balance).most, 24);
  const auto sentences = balance_sentences(manifest, balance, 12);
  EXPECT_NE(sentences.back().find("shown twice in 72 trials"), std::string::npos)
      << sentences.back();
}

TEST(SessionPlan, OfYesAndNoGivesEveryParticipantSignalAndNoise) {
  const Manifest manifest =
      asked_study(8,
                  "participants: 12, trials: yes_no, question: Is it, signal: {emotion: [happy]}, "
                  "per_participant: 4");
  for (const SessionPlan& plan : plan_sessions(manifest)) {
    int signals = 0;
    for (const Trial& trial : plan.trials)
      signals += level_of(manifest, trial.stimuli[0], "emotion") == "happy" ? 1 : 0;
    EXPECT_EQ(signals, 2);
  }
}

TEST(SessionPlan, OfTwoIntervalsHasTheSignalFirstForHalfOfTheShowings) {
  const Manifest manifest =
      asked_study(5, "participants: 12, trials: two_interval, question: Is it, signal: [a1, b2]");
  int first = 0, all = 0;
  for (const SessionPlan& plan : plan_sessions(manifest)) {
    for (const Trial& trial : plan.trials) {
      ++all;
      first += trial.stimuli[0] == "a1" || trial.stimuli[0] == "b2" ? 1 : 0;
    }
  }
  EXPECT_EQ(all, 12 * 6);
  EXPECT_EQ(2 * first, all);
}

TEST(SessionPlan, OfSetsHasAllStimuliEquallyOftenInAllPlaces) {
  const Manifest manifest =
      asked_study(7,
                  "participants: 12, scales: [sad-happy, slow-fast], trials: best_worst, "
                  "best_worst: {size: 3}");
  const auto plans = plan_sessions(manifest);
  std::map<std::string, int> shown;
  std::map<std::pair<std::string, std::size_t>, int> places;
  std::map<std::pair<std::string, std::string>, int> together;
  for (const Trial& trial : plans[0].trials) {
    ASSERT_EQ(trial.stimuli.size(), 3u);
    for (const std::string& one : trial.stimuli) {
      ++shown[one];
      for (const std::string& other : trial.stimuli)
        if (one < other) ++together[{one, other}];
    }
  }
  // Seven sets of three of seven stimuli; best would be each with each other once (Fano's plane).
  EXPECT_EQ(shown.size(), 7u);
  for (const auto& [id, count] : shown) EXPECT_EQ(count, 3) << id;
  EXPECT_GE(together.size(), 18u);
  for (const auto& [pair, count] : together) EXPECT_LE(count, 2) << pair.first << pair.second;
  for (const SessionPlan& plan : plans)
    for (const Trial& trial : plan.trials)
      for (std::size_t i = 0; i < 3; ++i) ++places[{trial.stimuli[i], i}];
  for (const auto& [place, count] : places) EXPECT_EQ(count, 12) << place.first;
  std::vector<std::string> items;
  for (const TrialItem& item : plans[0].trials[0].items) items.push_back(item.item);
  EXPECT_EQ(items, (std::vector<std::string>{"sad-happy/best", "sad-happy/worst", "slow-fast/best",
                                             "slow-fast/worst"}));
  const Balance balance = balance_of(manifest, plans);
  EXPECT_EQ(balance.subjects.size(), 7u);
  EXPECT_TRUE(balance.left.empty());
  EXPECT_EQ(place_range(balance).least, 12);
  EXPECT_TRUE(place_range(balance).is_uniform());
}

TEST(SessionPlan, AsksForAnAnswerThatThereIs) {
  std::set<std::string> points, emotions;
  for (const SessionPlan& plan : plans_of(20, "attention: {every: 3}, answer: {points: 7}")) {
    int checks = 0;
    for (const Trial& trial : plan.trials) {
      if (trial.is_attention_check()) points.insert(trial.expected);
      checks += trial.is_attention_check();
    }
    EXPECT_EQ(checks, 6);
    EXPECT_FALSE(plan.trials.back().is_attention_check());
  }
  EXPECT_EQ(points, (std::set<std::string>{"1", "7"}));
  for (const SessionPlan& plan : plans_of(20, "trials: emotion, attention: {every: 3}")) {
    EXPECT_EQ(plan.choices.size(), 4u);
    for (const Trial& trial : plan.trials) {
      if (trial.is_attention_check() && trial.items[0].item == emotion_form.item)
        emotions.insert(trial.expected);
    }
  }
  EXPECT_EQ(emotions, (std::set<std::string>{"angry", "calm", "happy", "sad"}));
  std::set<std::string> others;
  for (const std::string members :
       {"trials: same_different", "trials: yes_no, question: Is it, signal: [a1, b2]",
        "trials: two_interval, question: Is it, signal: [a1, b2]",
        "scales: [sad-happy], trials: best_worst, best_worst: {size: 3, sets: 9}"}) {
    const Manifest manifest = asked_study(5, "participants: 12, attention: {every: 2}, " + members);
    for (const SessionPlan& plan : plan_sessions(manifest))
      for (const Trial& trial : plan.trials)
        if (trial.is_attention_check()) others.insert(trial.expected);
  }
  EXPECT_EQ(others, (std::set<std::string>{"1", "2", "3", "different", "first", "no", "same",
                                           "second", "yes"}));
}

TEST(SessionPlan, OfAGridHasEachSetInAnOrderOfItsOwnBesideItsReference) {
  const Manifest manifest = asked_study(
      12,
      "participants: 40, scales: [sad-happy], trials: grid, grid: {alike: [actor], reference: "
      "[a1, b2, c3]}, attention: {every: 2}, retest: {repeat: 1}");
  std::map<std::pair<std::string, std::size_t>, int> places;
  std::set<std::vector<std::string>> orders;
  for (const SessionPlan& plan : plan_sessions(manifest)) {
    std::set<std::string> seen;
    for (const Trial& trial : plan.trials) {
      if (trial.is_attention_check()) {
        EXPECT_EQ(trial.items, (std::vector<TrialItem>{{"sad-happy"}}));
        EXPECT_TRUE(trial.expected == "0" || trial.expected == "100");
        continue;
      }
      ASSERT_EQ(trial.stimuli.size(), 4u);
      ASSERT_EQ(trial.items.size(), 4u);
      EXPECT_EQ(trial.items[3], (TrialItem{"sad-happy/4"}));
      EXPECT_EQ(std::ranges::count(trial.stimuli, trial.reference), 1);
      const char actor = trial.stimuli[0][0];
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(trial.stimuli[i][0], actor);
        ++places[{trial.stimuli[i], i}];
      }
      orders.insert(trial.stimuli);
      if (trial.is_analysed()) {
        EXPECT_TRUE(seen.insert(trial.reference).second);
      }
    }
    EXPECT_EQ(seen, (std::set<std::string>{"a1", "b2", "c3"}));
  }
  EXPECT_TRUE(balance_of(manifest, plan_sessions(manifest)).flipped.empty());
  // 40 participants, three sets, and one of them a second time: each stimulus about 13 times in
  // each place; the 99.9 % limits of a binomial count.
  EXPECT_GT(orders.size(), 50u);
  EXPECT_EQ(places.size(), 48u);
  for (const auto& [place, count] : places) {
    EXPECT_GE(count, 2) << place.first;
    EXPECT_LE(count, 28) << place.first;
  }
}

TEST(SessionPlan, OfContinuousRatingsHasOneScaleAfterTheOtherWithAllStimuli) {
  const Manifest manifest = asked_study(
      6,
      "participants: 12, scales: [sad-happy, slow-fast], trials: continuous, practice: [a1], "
      "warm_up: 1, attention: {every: 3}, pace: {answer: 2, between: 1}");
  int flipped = 0, in_other_order = 0;
  std::string before;
  std::map<std::string, int> first;
  const std::vector<SessionPlan> plans = plan_sessions(manifest, {{"a1", 5.0}, {"b2", 7.0}});
  for (const SessionPlan& plan : plans) {
    std::vector<std::string> scales;
    std::map<std::string, std::vector<std::string>> orders;
    for (const Trial& trial : plan.trials) {
      ASSERT_EQ(trial.items.size(), 1u);
      const std::string& scale = trial.items[0].item;
      if (scales.empty() || scales.back() != scale) {
        scales.push_back(scale);
        EXPECT_TRUE(trial.practice) << "each scale begins with its practice";
      }
      if (trial.is_analysed()) orders[scale].push_back(trial.stimuli.at(0));
      flipped += trial.is_analysed() && trial.items[0].flipped;
    }
    EXPECT_EQ(scales.size(), 2u);
    ++first[scales[0]];
    // Of participants 1 and 2, 3 and 4 …, each begins with another scale.
    if (plan.index % 2 == 1) {
      EXPECT_EQ(scales[1], before);
    }
    before = scales[0];
    EXPECT_EQ(orders.size(), 2u);
    for (const auto& [scale, order] : orders) {
      EXPECT_EQ(std::set<std::string>(order.begin(), order.end()).size(), 6u);
      EXPECT_EQ(order.size(), 6u);
    }
    in_other_order += orders["sad-happy"] != orders["slow-fast"];
  }
  EXPECT_EQ(first["sad-happy"], 6);
  EXPECT_EQ(flipped, 72);  // half of 12 participants with 12 trials
  EXPECT_GE(in_other_order, 11);
  const Balance balance = balance_of(manifest, plans);
  EXPECT_EQ(participant_range(balance).least, 12);
  EXPECT_EQ(participant_range(balance).most, 12);
  EXPECT_EQ(balance.max_positions, 6);
  EXPECT_EQ(balance.flipped.size(), 2u);
  EXPECT_EQ(balance.flipped.at("slow-fast"), 6);
  // Nothing is answered after a film: its seconds and 1 s between; checks are answered.
  double seconds = 0.0;
  for (const Trial& trial : plans[0].trials) {
    const std::string film = trial.stimuli.empty() ? "" : trial.stimuli[0];
    seconds += 1.0 + (film.empty() ? 2.0 : film == "a1" ? 5.0 : film == "b2" ? 7.0 : 4.0);
  }
  EXPECT_DOUBLE_EQ(plans[0].expected_seconds, seconds);
}

TEST(SessionPlan, OfContinuousRatingsInAFixedOrderIsTheSameForAll) {
  const Manifest manifest = asked_study(
      4,
      "participants: 3, scales: [slow-fast, sad-happy], trials: continuous, order: fixed, answer: "
      "{side: fixed}");
  for (const SessionPlan& plan : plan_sessions(manifest)) {
    ASSERT_EQ(plan.trials.size(), 8u);
    EXPECT_EQ(plan.trials[0].items[0], (TrialItem{"slow-fast"}));
    EXPECT_EQ(plan.trials[4].items[0], (TrialItem{"sad-happy"}));
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(plan.trials[i].stimuli, plan.trials[i + 4].stimuli);
  }
}

TEST(SessionPlan, OfAGridPractisesSetsOfEqualLevelsAndTakesAsLongAsAllVideos) {
  const Manifest manifest = asked_study(
      8,
      "participants: 1, scales: [sad-happy], trials: grid, grid: {alike: [actor], reference: [a1, "
      "b2, c3]}, stimuli: [a1, a4, b2, b5], practice: [b2, b5, a1, a4], pace: {answer: 2, between: "
      "1}");
  const SessionPlan plan =
      plan_sessions(manifest, {{"a1", 5.0}, {"a4", 7.0}, {"b2", 1.0}, {"b5", 2.0}})[0];
  ASSERT_EQ(plan.trials.size(), 4u);
  EXPECT_TRUE(plan.trials[0].practice && plan.trials[1].practice && !plan.trials[2].practice);
  EXPECT_EQ(plan.trials[0].reference, "b2");
  EXPECT_EQ(plan.trials[1].reference, "a1");
  // The reference is shown twice: openly and hidden.
  EXPECT_DOUBLE_EQ(plan.expected_seconds, 2 * (5 + 5 + 7 + 4 + 1) + 2 * (1 + 1 + 2 + 4 + 1));
}

TEST(SessionPlan, OfTwoIntervalsTakesAsLongAsBothVideos) {
  const Manifest manifest =
      asked_study(2,
                  "participants: 1, trials: two_interval, question: Is it, signal: [a1], "
                  "pace: {answer: 2, between: 1}");
  const SessionPlan plan = plan_sessions(manifest, {{"a1", 5.0}, {"b2", 7.0}})[0];
  EXPECT_DOUBLE_EQ(plan.expected_seconds, 5.0 + 0.5 + 7.0 + 2.0 + 1.0);
}

TEST(SessionPlan, IsExpectedToTakeWhatItsPartsTake) {
  const Manifest manifest = asked_study(
      3,
      "participants: 1, scales: [sad-happy, slow-fast], comments: true, consent: one two three, "
      "demographics: [{id: age, ask: How old, answer: number}], pace: {words_per_minute: 60, "
      "answer: 2, comment: 3, between: 1, demographic: 4}");
  const SessionPlan plan = plan_sessions(manifest, {{"a1", 5.0}, {"b2", 7.0}, {"c3", 9.0}})[0];
  EXPECT_DOUBLE_EQ(plan.expected_seconds, 3 + 4 + (5 + 7 + 9) + 3 * (2 * 2.0 + 3 + 1));
  EXPECT_DOUBLE_EQ(word_count("この歩き方"), 2.5);
  const auto seconds = [](const std::string& display) {
    return plan_sessions(asked_study(3, "participants: 1, scales: [sad-happy]" + display))[0]
        .expected_seconds;
  };
  const double plain = seconds("");
  EXPECT_EQ(seconds(", display: {size: native}"), plain);
  EXPECT_GT(seconds(", display: {size: {cm: 9}}"), plain + 10.0);
  EXPECT_GT(seconds(", display: {size: {degrees: 9}, blind_spot: true}"),
            seconds(", display: {size: {degrees: 9}}") + 30.0);
}

TEST(LeastFilled, IsWhatWasGivenLeastAndSeenLeast) {
  const auto plans = plans_of(12, "per_participant: 4");
  std::vector<int> given(plans.size()), finished(plans.size());
  for (std::size_t i = 0; i < 3; ++i) given[i] = finished[i] = 1;
  EXPECT_EQ(given[next_plan(plans, given, finished)], 0);
  std::ranges::fill(given, 1);
  std::ranges::fill(finished, 1);
  finished[5] = 0;  // somebody left
  EXPECT_EQ(next_plan(plans, given, finished), 5u);
}

TEST(SessionDuration, IsStatedInOneWay) {
  std::vector<SessionPlan> plans(3);
  for (SessionPlan& plan : plans) plan.expected_seconds = 312.0;
  EXPECT_EQ(duration_text(plans), "5.2 min");
  plans[1].expected_seconds = 366.0;
  EXPECT_EQ(duration_text(plans), "5.2 to 6.1 min");
}

}  // namespace
}  // namespace mien::pipeline
