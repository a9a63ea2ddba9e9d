#include "pipeline/study/trials/trial_kind.h"

#include <set>

#include <gtest/gtest.h>

#include "pipeline/manifest/ratings/answers/grid_item.h"

namespace mien::pipeline {
namespace {

const std::vector<std::string> choices = {"sad", "happy", "calm"};

/// A trial of a kind that asks its own item and a scale, or of a set.
Trial trial_of(const TrialKind& kind) {
  Trial trial{.kind = &kind, .stimuli = {"walk", "run"}, .items = {{"sad-happy", true}}};
  if (kind.form->is_set)
    trial = {.kind = &kind,
             .stimuli = {"walk", "run", "jump"},
             .items = {{"sad-happy/best"}, {"sad-happy/worst"}}};
  if (kind.form->is_grid) trial.items = {{"sad-happy/1"}, {"sad-happy/2"}};
  trial.stimuli.resize(kind.form->stimuli);
  if (!kind.form->item.empty()) trial.items.push_back({std::string(kind.form->item)});
  return trial;
}

/// Calls `ask` with every item of every kind that a manifest may ask for, on every form of scale.
void for_each_question(auto&& ask) {
  const ResponseScale scales[] = {{.points = 5},
                                  {.points = 2, .least = -1, .most = 1},
                                  {.slider = true, .least = 0, .most = 3},
                                  {.words = true, .low = "sad", .high = "happy"},
                                  {.ties = true},
                                  {.strength = true},
                                  {.ties = true, .strength = true}};
  for (const auto& [name, form] : trial_form_words) {
    const TrialKind& kind = trial_kind_of(*form);
    const Trial trial = trial_of(kind);
    for (const ResponseScale& scale : scales) {
      if (scale.words && (!form->is_on_scale || form->is_on_slider)) continue;
      for (const TrialItem& item : trial.items)
        ask(kind, Question{trial, item, item.item == form->item ? nullptr : &scale, choices});
    }
  }
}

AnswerRow completed(const Question& question, const std::string& raw) {
  AnswerRow row;
  row.stimulus = question.trial.stimuli[0];
  row.against = question.trial.against();
  row.value_raw = raw;
  question.trial.kind->complete(question, row);
  return row;
}

ItemResponse response_of(const Question& question, const std::string& raw) {
  // Places in a set are choices, and traces are texts.
  const TrialForm& form = *question.trial.kind->form;
  const bool is_text = form.is_set || (form.is_continuous && !question.trial.is_attention_check());
  const bool is_number = !is_text && raw.find_first_not_of("0123456789") == std::string::npos;
  return {.item = question.item.item, .value_raw = raw, .is_number = is_number};
}

TEST(TrialKinds, AreAllThatAManifestMayAskForByTheSameNames) {
  std::set<std::string_view> names;
  for (const TrialKind* kind : trial_kinds) EXPECT_TRUE(names.insert(kind->name).second);
  for (const auto& [name, form] : trial_form_words) {
    EXPECT_EQ(trial_kind_of(*form).name, name);
    EXPECT_EQ(find_trial_form(name), form);
  }
  EXPECT_EQ(find_trial_form(attention_kind), nullptr);
}

TEST(TrialKinds, TakeEveryAnswerThatACheckMayAskFor) {
  for_each_question([](const TrialKind& kind, const Question& question) {
    const std::vector<std::string> answers = kind.attention_answers(question);
    ASSERT_FALSE(answers.empty());
    EXPECT_EQ(std::set<std::string>(answers.begin(), answers.end()).size(), answers.size());
    for (const std::string& answer : answers) {
      Trial check = question.trial;
      check.expected = answer;
      const Question asked{check, question.item, question.scale, question.choices};
      EXPECT_EQ(kind.fault(asked, response_of(asked, answer)), "") << kind.name << answer;
    }
  });
}

TEST(TrialKinds, TakeWhatSimulatedPeopleAnswer) {
  for_each_question([](const TrialKind& kind, const Question& question) {
    for (int i = 0; i < 100; ++i) {
      const double share = 0.01 * i;
      const SimulatedView view{.opinion = [&](std::size_t which) { return share - 0.5 * which; },
                               .shown = i % 3 == 0 ? "calm" : "angry",
                               .is_recognised = i % 2 == 0,
                               .chance = share};
      const std::string raw = kind.simulated(question, view);
      EXPECT_EQ(kind.fault(question, response_of(question, raw)), "") << kind.name << " " << raw;
      EXPECT_FALSE(completed(question, raw).value.empty());
    }
  });
}

TEST(TrialKinds, RefuseWhatNoPageOffers) {
  for_each_question([](const TrialKind& kind, const Question& question) {
    const bool takes_any_text = question.scale != nullptr && question.scale->words;
    EXPECT_EQ(kind.fault(question, response_of(question, "both")).empty(), takes_any_text);
    EXPECT_NE(kind.fault(question, response_of(question, "101")), "");
  });
}

TEST(Trials, ThatAskAnEmotionAskScalesAsRatingsDo) {
  const ResponseScale scale{.points = 5, .least = -2, .most = 2};
  const Trial emotion = trial_of(emotion_trials), rating = trial_of(rating_trials);
  const Question one{emotion, emotion.items[0], &scale, choices};
  const Question other{rating, rating.items[0], &scale, choices};
  for (const char* raw : {"1", "2", "5"}) {
    EXPECT_EQ(completed(one, raw).value, completed(other, raw).value);
    EXPECT_EQ(completed(one, raw).pole_left, "high");
  }
  EXPECT_EQ(completed(one, "1").value, "2");
  const Question choice{emotion, emotion.items[1], nullptr, choices};
  EXPECT_EQ(completed(choice, "happy").value, "happy");
  EXPECT_EQ(completed(choice, "happy").pole_left, "");
}

TEST(Trials, OfTwoStimuliAreAnsweredWithOneOfThem) {
  const Trial trial = trial_of(pair_trials);
  const ResponseScale scale;
  const Question question{trial, trial.items[0], &scale, choices};
  EXPECT_EQ(completed(question, "left").value, "walk");
  EXPECT_EQ(completed(question, "right").value, "run");
  EXPECT_EQ(completed(question, "right").pole_left, "");
}

/// Raw answers of simulated participants to a pair, from a much smaller first to a much greater
/// one.
std::vector<std::string> answers_on(const ResponseScale& scale) {
  const Trial trial = trial_of(pair_trials);
  const Question question{trial, trial.items[0], &scale, choices};
  std::vector<std::string> answers;
  for (const double first : {-2.0, -0.5, 0.1, 0.5, 2.0}) {
    const SimulatedView view{
        .opinion = [&](std::size_t which) { return which == 0 ? first : 0.0; }};
    answers.push_back(pair_trials.simulated(question, view));
  }
  return answers;
}

TEST(Trials, OfTwoStimuliMayEndInATieAndHaveAStrength) {
  using Answers = std::vector<std::string>;
  EXPECT_EQ(answers_on({}), (Answers{"right", "right", "left", "left", "left"}));
  EXPECT_EQ(answers_on({.ties = true}), (Answers{"right", "right", "tie", "left", "left"}));
  EXPECT_EQ(
      answers_on({.strength = true}),
      (Answers{"right_much", "right_slightly", "left_slightly", "left_slightly", "left_much"}));
  EXPECT_EQ(answers_on({.ties = true, .strength = true}),
            (Answers{"right_much", "right_slightly", "tie", "left_slightly", "left_much"}));
  const Trial trial = trial_of(pair_trials);
  const ResponseScale plain, scale{.ties = true, .strength = true};
  const Question question{trial, trial.items[0], &scale, choices};
  EXPECT_EQ(completed(question, "tie").value, "tie");
  EXPECT_EQ(completed(question, "left_slightly").value, "walk");
  EXPECT_EQ(completed(question, "right_much").value, "run");
  for (const char* raw : {"left", "right"})
    EXPECT_NE(pair_trials.fault(question, response_of(question, raw)), "") << raw;
  const Question without{trial, trial.items[0], &plain, choices};
  for (const char* raw : {"tie", "left_much"})
    EXPECT_NE(pair_trials.fault(without, response_of(without, raw)), "") << raw;
}

TEST(Trials, OfSetsAreAnsweredWithPlaces) {
  Trial trial{.kind = &best_worst_trials,
              .stimuli = {"walk", "run", "jump", "sit"},
              .items = {{"sad-happy/best"}, {"sad-happy/worst"}}};
  EXPECT_EQ(trial.against(), "run jump sit");
  const Question best{trial, trial.items[0], nullptr, choices};
  const Question worst{trial, trial.items[1], nullptr, choices};
  EXPECT_EQ(completed(best, "3").value, "jump");
  const SimulatedView view{.opinion = [](std::size_t which) {
    return which == 2 ? 1.0 : which == 1 ? -1.0 : 0.0;
  }};
  EXPECT_EQ(best_worst_trials.simulated(best, view), "3");
  EXPECT_EQ(best_worst_trials.simulated(worst, view), "2");
  const SimulatedView indifferent{.opinion = [](std::size_t) { return 0.0; }};
  EXPECT_NE(best_worst_trials.simulated(best, indifferent),
            best_worst_trials.simulated(worst, indifferent));
  const auto contradiction = [&](const char* one, const char* other) {
    return best_worst_trials.contradiction({{.item = "sad-happy/best", .value_raw = one},
                                            {.item = "weak-strong/worst", .value_raw = "1"},
                                            {.item = "sad-happy/worst", .value_raw = other}});
  };
  EXPECT_EQ(contradiction("1", "2"), "");
  EXPECT_NE(contradiction("2", "2"), "");
  for (const char* raw : {"0", "5", "1.5", ""})
    EXPECT_NE(best_worst_trials.fault(best, {.item = "sad-happy/best", .value_raw = raw}), "");
}

TEST(Trials, OfAGridAreAboutTheStimulusInEachPlace) {
  const Trial trial{.kind = &grid_trials,
                    .stimuli = {"walk", "run", "jump"},
                    .reference = "run",
                    .items = {{"sad-happy/1"}, {"sad-happy/2"}, {"sad-happy/3"}}};
  const Question hidden{trial, trial.items[1], nullptr, choices};
  const Question other{trial, trial.items[2], nullptr, choices};
  AnswerRow row = completed(other, "37");
  EXPECT_EQ(row.stimulus, "jump");
  EXPECT_EQ(row.against, "run");
  EXPECT_EQ(row.item, "sad-happy");
  EXPECT_EQ(row.value, "37");
  EXPECT_EQ(row.pole_left, "low");
  EXPECT_EQ(completed(hidden, "100").stimulus, "run");
  const auto simulated = [](const Question& question, bool is_recognised) {
    const SimulatedView view{
        .opinion = [](std::size_t which) { return which == 2 ? 140.0 : 30.4 + which; },
        .is_recognised = is_recognised};
    return grid_trials.simulated(question, view);
  };
  EXPECT_EQ(simulated(hidden, true), "100");
  EXPECT_EQ(simulated(hidden, false), "31");
  EXPECT_EQ(simulated(other, false), "100");
  for (const char* raw : {"-1", "101", "3.5"})
    EXPECT_NE(
        grid_trials.fault(other, {.item = "sad-happy/3", .value_raw = raw, .is_number = true}), "")
        << raw;
  EXPECT_NE(grid_trials.fault(other, {.item = "sad-happy/3", .value_raw = "50"}), "");
}

TEST(GridItems, HaveAScaleAndAPlace) {
  const auto item = grid_item("slow/quick/12");
  ASSERT_TRUE(item.has_value());
  EXPECT_EQ(item->scale, "slow/quick");
  EXPECT_EQ(item->place, 12u);
  EXPECT_EQ(to_item(*item), "slow/quick/12");
  for (const char* name : {"sad-happy", "sad-happy/", "/3", "sad-happy/0", "sad-happy/03",
                           "sad-happy/3x", "sad-happy/-1", "sad-happy/best"})
    EXPECT_FALSE(grid_item(name).has_value()) << name;
}

TEST(Trials, OfDetectionAreSimulatedByObservations) {
  const auto answer = [](const TrialKind& kind, double one, double other) {
    const Trial trial = trial_of(kind);
    const Question question{trial, trial.items.back(), nullptr, choices};
    const SimulatedView view{
        .opinion = [=](std::size_t which) { return which == 0 ? one : other; }};
    return kind.simulated(question, view);
  };
  EXPECT_EQ(answer(yes_no_trials, 0.6, 0.0), "yes");
  EXPECT_EQ(answer(yes_no_trials, 0.4, 0.0), "no");
  EXPECT_EQ(answer(two_interval_trials, 0.6, 0.4), "first");
  EXPECT_EQ(answer(two_interval_trials, 0.4, 0.6), "second");
  EXPECT_EQ(answer(same_different_trials, -0.7, 0.7), "same");
  EXPECT_EQ(answer(same_different_trials, 0.8, -0.8), "different");
  const Trial trial = trial_of(two_interval_trials);
  const Question question{trial, trial.items.back(), nullptr, choices};
  EXPECT_EQ(completed(question, "second").value, "run");
}

TEST(Trials, AreCalledAttentionChecksWhereAnAnswerIsExpected) {
  Trial trial = trial_of(pair_trials);
  EXPECT_EQ(trial.kind_name(), "pair");
  trial.expected = "left";
  EXPECT_EQ(trial.kind_name(), "attention");
}

TEST(RawAnswer, GoesThereAndBackWhicheverEndIsLeft) {
  ResponseScale scale{.points = 7, .least = -3, .most = 3};
  EXPECT_EQ(value_of_raw(scale, 1, false), -3.0);
  EXPECT_EQ(value_of_raw(scale, 1, true), 3.0);
  EXPECT_EQ(value_of_raw(scale, 5, false), 1.0);
  for (int raw = 1; raw <= 7; ++raw) {
    for (const bool flipped : {false, true}) {
      const double value = value_of_raw(scale, raw, flipped);
      EXPECT_EQ(raw_of_value(scale, value, flipped), raw);
      EXPECT_NEAR(written_value_of_raw(scale, raw, flipped), value, 5e-7);
    }
  }
  scale.slider = true;
  EXPECT_EQ(value_of_raw(scale, 25, true), 1.5);
  EXPECT_EQ(raw_of_value(scale, 99, false), 100.0);
}

}  // namespace
}  // namespace mien::pipeline
