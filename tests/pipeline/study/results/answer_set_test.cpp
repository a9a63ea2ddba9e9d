#include "pipeline/study/results/answer_set.h"

#include <gtest/gtest.h>

#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/study/results/participants.h"
#include "pipeline/study/results/two_emotions.h"

namespace mien::pipeline {
namespace {

std::vector<AnswerRow> read_back(const std::vector<AnswerRow>& rows) {
  return answer_rows(parse_csv(to_csv(rows), "a.csv"));
}

std::string gather_refusal(const Manifest& manifest, const std::vector<AnswerRow>& rows) {
  try {
    collect_answers(manifest, read_back(rows));
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

bool tells(const std::string& refusal, const std::string& words) {
  return refusal.find(words) != std::string::npos;
}

TEST(AnswerSet, KnowsWhatStimuliAre) {
  const Manifest manifest = two_emotion_study(4);
  const AnswerSet answer_set = collect_answers(manifest, answers_to(manifest));
  ASSERT_EQ(answer_set.stimuli.size(), 5u);
  EXPECT_TRUE(answer_set.stimuli[0].is_neutral());
  EXPECT_EQ(answer_set.stimuli[3].made, "modified");
  EXPECT_EQ(answer_set.stimuli[3].emotion, "sad");
  EXPECT_EQ(answer_set.stimuli[3].setting, "woman");
  EXPECT_EQ(answer_set.people.size(), 4u);
  EXPECT_EQ(answer_set.ratings.size(), 4u * 5u * 2u);
  EXPECT_TRUE(answer_set.simulated);
  EXPECT_EQ(answer_set.points, 11);
}

TEST(AnswerSet, NamesMatchedSoundsInSettingsOnlyWhereSoundsDiffer) {
  Manifest manifest = two_emotion_study(4);
  for (Stimulus& stimulus : manifest.stimuli)
    stimulus.sound = StimulusSound{.file = "a.wav", .of = stimulus.id};
  EXPECT_EQ(collect_answers(manifest, answers_to(manifest)).stimuli[3].setting, "woman");
  manifest.stimuli[2].sound->of = "sad";
  const AnswerSet answer_set = collect_answers(manifest, answers_to(manifest));
  EXPECT_EQ(answer_set.stimuli[2].setting, "woman, mismatched");
  EXPECT_EQ(answer_set.stimuli[3].setting, "woman, matched");
}

TEST(AnswerSet, LeavesOutTrialsThatCouldNotBePlayedAndSaysSo) {
  const Manifest manifest = two_emotion_study(4);
  std::vector<AnswerRow> rows = answers_to(manifest);
  const std::size_t all = collect_answers(manifest, rows).ratings.size();
  const int trial = rows.front().trial;
  const std::string participant = rows.front().participant;
  std::size_t left_out = 0;
  for (AnswerRow& row : rows) {
    if (row.participant != participant || row.trial != trial) continue;
    row.value_raw = row.value = row.pole_left = "";
    row.rt_ms.reset();
    row.play_fault = "stalled";
    ++left_out;
  }
  const AnswerSet answer_set = collect_answers(manifest, read_back(rows));
  EXPECT_EQ(answer_set.ratings.size(), all - left_out);
  EXPECT_EQ(answer_set.people.size(), 4u);
  EXPECT_EQ(answer_set.notes,
            (std::vector<std::string>{"1 trial of 1 participant has no answers, since the stimuli "
                                      "could not be played"}));
}

TEST(AnswerSet, TellsMeasuredViewingDistances) {
  const Manifest manifest = two_emotion_study(3);
  std::vector<AnswerRow> rows = answers_to(manifest);
  for (AnswerRow& row : rows)
    if (row.participant != "p002") row.viewing_cm = row.participant == "p001" ? 50.0 : 60.0;
  EXPECT_EQ(collect_answers(manifest, read_back(rows)).notes,
            (std::vector<std::string>{"Viewing distance, measured with the blind spot: mean 55.0 "
                                      "cm, standard deviation 7.1 cm (50.0 to 60.0 cm; 2 "
                                      "participants)."}));
}

TEST(AnswerSet, TellsViewingDistancesOfIncludedParticipantsOnly) {
  const Manifest manifest = two_emotion_study(3);
  std::vector<AnswerRow> rows = answers_to(manifest);
  ReportChoices choices{.without_unfinished = true};
  const int trial = rows.front().trial;
  for (AnswerRow& row : rows) {
    row.viewing_cm = row.participant == "p001" ? 90.0 : 60.0;
    if (row.participant == "p001") choices.planned[row.seed] = 5;
  }
  std::erase_if(
      rows, [&](const AnswerRow& row) { return row.participant == "p001" && row.trial == trial; });
  const AnswerSet answer_set = collect_answers(manifest, read_back(rows), choices);
  EXPECT_EQ(answer_set.people.size(), 2u);
  ASSERT_EQ(answer_set.notes.size(), 2u);  // and that the unfinished are left out
  EXPECT_NE(answer_set.notes[0].find("mean 60.0 cm"), std::string::npos) << answer_set.notes[0];
}

TEST(AnswerSet, BelievesThatParticipantsFinishedIfTheirOwnSessionDid) {
  const Manifest manifest = two_emotion_study(3);
  std::vector<AnswerRow> rows = answers_to(manifest);
  ReportChoices choices;
  for (const AnswerRow& row : rows) choices.planned[row.seed] = 5;
  const int trial = rows.front().trial;
  std::erase_if(
      rows, [&](const AnswerRow& row) { return row.participant == "p001" && row.trial == trial; });
  const auto unfinished = [&](const std::string& finished) {
    choices.finished = {finished};
    return collect_answers(manifest, rows, choices).unfinished.size();
  };
  EXPECT_EQ(unfinished("p001/gone"), 1u);
  EXPECT_EQ(unfinished("p001/simulated"), 0u);
  EXPECT_EQ(unfinished("p001"), 0u);
  const ParticipantTable people{
      parse_csv("participant,session,finished\np001,gone,1\np002,,1\np003,a,0\n", "people.csv")};
  EXPECT_EQ(people.finished(), (std::set<std::string>{"p001/gone", "p002"}));
}

TEST(AnswerSet, TellsEveryFaultWithItsPlace) {
  const Manifest manifest = two_emotion_study(2);
  std::vector<AnswerRow> rows = answers_to(manifest);
  rows[0].stimulus = "wlak";
  rows[1].item = "sad-hapy";
  rows[2].value = "9";
  rows[3].value = "soon";
  const std::string refusal = gather_refusal(manifest, rows);
  EXPECT_TRUE(tells(refusal, "a.csv:2:")) << refusal;
  EXPECT_TRUE(tells(refusal, "the study has no stimulus \"wlak\"; did you mean \"walk\"?"))
      << refusal;
  EXPECT_TRUE(tells(refusal, "does not ask \"sad-hapy\"; did you mean \"sad-happy\"?")) << refusal;
  EXPECT_TRUE(tells(refusal, "a.csv:4:")) << refusal;
  EXPECT_TRUE(tells(refusal, "\"9\" is not a valid answer on")) << refusal;
  EXPECT_TRUE(tells(refusal, "\"soon\" is not a valid answer on")) << refusal;
}

TEST(AnswerSet, RefusesValuesThatContradictTheRawAnswer) {
  const Manifest manifest = two_emotion_study(2);
  std::vector<AnswerRow> rows = answers_to(manifest);
  rows[0].pole_left = rows[0].pole_left == "low" ? "high" : "low";
  rows[0].value_raw = "100";
  rows[0].value = rows[0].pole_left == "low" ? "-2" : "2";
  EXPECT_TRUE(tells(gather_refusal(manifest, rows), "the raw answer 100 with the"));
}

TEST(AnswerSet, RefusesAnswersOfAnotherDesignAndOfAnotherKind) {
  const Manifest manifest = two_emotion_study(2);
  std::vector<AnswerRow> rows = answers_to(manifest);
  rows.back().design = "ffff";
  EXPECT_TRUE(tells(gather_refusal(manifest, rows), "an answer of design \"ffff\" among"));
  rows = answers_to(manifest);
  rows[0].kind = "emotion";
  EXPECT_TRUE(tells(gather_refusal(manifest, rows), "an answer of kind emotion, but"));
}

TEST(AnswerSet, RefusesWhatHoldsNothingThatCounts) {
  const Manifest manifest = two_emotion_study(2);
  std::vector<AnswerRow> rows = answers_to(manifest);
  for (AnswerRow& row : rows) row.is_practice = true;
  EXPECT_TRUE(tells(gather_refusal(manifest, rows), "a.csv:1:1: holds no answers to analyse"));
}

TEST(AnswerSet, SaysHowManyAnswersAreLeftOutForWhichReasonAndTheWayOut) {
  Manifest manifest = two_emotion_study(3);
  manifest.questionnaire->attention_every = 2;
  std::vector<AnswerRow> rows = answers_to(manifest);
  for (AnswerRow& row : rows)
    if (row.kind == "attention") row.passed = false;
  const std::string failed = gather_refusal(manifest, rows);
  for (const char* words :
       {"to practice, warm-up and check trials", "30 of 3 participants who are excluded",
        "max_failed_checks: 3 participants", "admit more failed checks with --max-failed-checks"})
    EXPECT_TRUE(tells(failed, words)) << words << "\n" << failed;
  manifest.questionnaire->attention_every = 0;
  manifest.questionnaire->analysis.quality.min_rt_ms = 50000.0;
  const std::string fast = gather_refusal(manifest, answers_to(manifest));
  EXPECT_TRUE(tells(fast, "of 30 answers, 30 that quality rules exclude (min_rt_ms: 3 part"))
      << fast;
  EXPECT_TRUE(tells(fast, "quality: {flagged: kept}")) << fast;
  manifest.questionnaire->analysis.quality = {};
  rows = answers_to(manifest);
  for (AnswerRow& row : rows) row.value.clear();
  EXPECT_TRUE(tells(gather_refusal(manifest, rows), "30 that are empty"))
      << gather_refusal(manifest, rows);
  ReportChoices choices{.without_unfinished = true};
  rows = answers_to(manifest);
  for (const AnswerRow& row : rows) choices.planned[row.seed] = 40;
  try {
    collect_answers(manifest, rows, choices);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_TRUE(tells(error.what(), "30 of 3 participants who did not finish")) << error.what();
    EXPECT_TRUE(tells(error.what(), "omit --unfinished leave-out")) << error.what();
  }
}

TEST(AnswerSet, NotesWhereTheCommandLineDepartsFromTheStatedAnalysis) {
  const Manifest manifest = two_emotion_study(3);
  const auto notes = [&](const ReportChoices& choices) {
    std::string all;
    for (const std::string& note : collect_answers(manifest, answers_to(manifest), choices).notes)
      all += note + "\n";
    return all;
  };
  EXPECT_EQ(notes({.correction = TestCorrection::holm, .max_failed_checks = 1}), "");
  EXPECT_EQ(notes({.correction = TestCorrection::none, .max_failed_checks = 3}),
            "Deviation from the analysis that the manifest states: --correction none instead of "
            "holm.\nDeviation from the analysis that the manifest states: --max-failed-checks 3 "
            "instead of 1.\n");
  EXPECT_TRUE(tells(notes({.without_unfinished = true}), "--unfinished leave-out instead of keep"));
}

TEST(AnswerSet, NotesThatAllAnswersAreInTheMiddle) {
  const Manifest manifest = two_emotion_study(3);
  const auto has_note = [&](const SimulatedParticipants& people) {
    const AnswerSet answers = collect_answers(manifest, answers_to(manifest, {}, people));
    return std::ranges::any_of(answers.notes, [](const std::string& note) {
      return note.starts_with("All 30 answers on scales are exactly in the middle");
    });
  };
  EXPECT_TRUE(
      has_note({.spread = RatingSpread{.participant = 0.0, .stimulus = 0.0, .residual = 0.0}}));
  EXPECT_FALSE(has_note({}));
}

TEST(AnswerSet, LeavesOutWhoFailsChecksAndSaysSo) {
  Manifest manifest = two_emotion_study(6);
  manifest.questionnaire->attention_every = 2;
  SimulatedParticipants people = steady_people;
  std::vector<AnswerRow> rows = answers_to(manifest, {}, people);
  int failed = 0;
  for (AnswerRow& row : rows)
    if (row.participant == "p003" && row.kind == "attention") {
      row.passed = false;
      ++failed;
    }
  ASSERT_GE(failed, 2);
  EXPECT_EQ(collect_answers(manifest, rows).people.size(), 5u);
  EXPECT_EQ(collect_answers(manifest, rows, {.max_failed_checks = failed}).people.size(), 6u);
  const AnswerSet answer_set = collect_answers(manifest, rows);
  EXPECT_TRUE(answer_set.attention[2].is_excluded);
  EXPECT_EQ(std::count(answer_set.people.begin(), answer_set.people.end(), "p003"), 0);
}

TEST(AnswerSet, TakesChoicesAndPairs) {
  Manifest manifest = two_emotion_study(6);
  manifest.questionnaire->trials = &emotion_form;
  const AnswerSet chosen = collect_answers(manifest, answers_to(manifest));
  EXPECT_EQ(chosen.chosen.size(), 6u * 5u);
  EXPECT_EQ(chosen.choices.size(), 3u);
  manifest.questionnaire->trials = &pair_form;
  manifest.questionnaire->pairs = {{"walk", "sad"}, {"walk", "happy"}};
  manifest.questionnaire->scales.ids = {"sad-happy"};
  const AnswerSet pairs =
      collect_answers(manifest, answers_to(manifest, {{{"happy", "sad-happy"}, 2.0}}));
  EXPECT_EQ(pairs.preferences.size(), 6u * 2u);
}

}  // namespace
}  // namespace mien::pipeline
