// What the methods section says of participants, procedure and analysis.

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/reading/schema.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/schema_paths.h"
#include "pipeline/production/methods/methods.h"
#include "pipeline/production/methods/prose.h"
#include "pipeline/production/run/option_variants.h"
#include "pipeline/study/thresholds/dose_study.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

class MethodsQuestionnaire : public testing::Test {
 protected:
  static void SetUpTestSuite() { test::write_variant_files(folder()); }

  static const fs::path& folder() {
    static const test::TemporaryFolder files;
    return files.path();
  }

  static std::string methods_for(const std::string& text) {
    const fs::path file = folder() / "m.yaml";
    std::ofstream(file) << text;
    const ManifestReading reading =
        check_manifest(file, [](const std::string&) { return std::nullopt; });
    if (!reading.faults.empty()) ADD_FAILURE() << Faults(reading.faults).what();
    Motions motions(reading.manifest);
    return methods_of(reading.manifest, motions).markdown;
  }

  /// A study of four stimuli with these members of its questionnaire.
  static std::string methods_of_asked(const std::string& members) {
    return methods_for(
        "mien: 1\nstudy: s\nseed: 7\nexamples: {set: builtin:walks-10}\n"
        "output: {video: [mp4]}\nquestionnaire: {" +
        members +
        "}\nstimuli:\n"
        "  - {id: a, weights: {normal: 1}, factors: {actor: k, mood: x}}\n"
        "  - {id: b, weights: {sad: 1}, factors: {actor: k, mood: y}}\n"
        "  - {id: c, weights: {proud: 1}, factors: {actor: m, mood: x}}\n"
        "  - {id: d, weights: {tired: 1}, factors: {actor: m, mood: y}}\n");
  }

  static void expect_said(const std::string& text, const std::string& words) {
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  }
};

/// What a reader of the methods need not know: the wording of texts that participants read, codes
/// and addresses of recruitment, the assumed pace, and which stimuli are for practice or form the
/// listed pairs (their numbers are told). The last two say nothing without checks or rules.
bool is_left_out(const std::string& path) {
  constexpr std::array<std::string_view, 17> paths = {"questionnaire.title",
                                                      "questionnaire.texts",
                                                      "questionnaire.consent",
                                                      "questionnaire.instructions",
                                                      "questionnaire.debriefing",
                                                      "questionnaire.ending",
                                                      "questionnaire.pace",
                                                      "questionnaire.answer.suggest",
                                                      "questionnaire.recruitment.prolific",
                                                      "questionnaire.recruitment.redirect",
                                                      "questionnaire.screening.questions[].ask",
                                                      "questionnaire.screening.questions[].answer",
                                                      "questionnaire.demographics[].",
                                                      "questionnaire.practice",
                                                      "questionnaire.pairs",
                                                      "questionnaire.analysis.max_failed_checks",
                                                      "questionnaire.analysis.quality.flagged"};
  return std::ranges::any_of(paths, [&](std::string_view start) {
    return path == start || path.starts_with(std::string(start) + ".") ||
           (start.ends_with('.') && path.starts_with(start));
  });
}

// An option that is new in the schema is tried as soon as it is there.
TEST_F(MethodsQuestionnaire, TellsEveryOptionThatTheSchemaKnows) {
  std::map<std::string, std::string> known;
  const auto told = [&](const nlohmann::json& document) -> const std::string& {
    const std::string text = document.dump();
    const auto [entry, is_new] = known.try_emplace(text);
    if (is_new) entry->second = methods_for(text);
    return entry->second;
  };
  int options = 0;
  for (const auto& [path, node] : test::properties_of(manifest_schema())) {
    if (path != "questionnaire" && !path.starts_with("questionnaire.")) continue;
    if (test::has_one_value(path) || is_left_out(path)) continue;
    SCOPED_TRACE(path);
    const test::OptionVariants variants = test::variants_of(path, node);
    EXPECT_NE(told(variants.first), told(variants.second));
    ++options;
  }
  EXPECT_GT(options, 50);
}

TEST_F(MethodsQuestionnaire, SaysWhoTookPart) {
  const std::string text = methods_of_asked(
      "participants: 40, scales: [slow-fast], consent: Yes., "
      "consent_version: '2', demographics: [{id: age, ask: 'How old?', answer: number}, {id: hand, "
      "ask: 'Which?', answer: [l, r]}], recruitment: {prolific: {completed: DONE}, pseudonymise: "
      "true}, screening: {questions: [{id: years, ask: 'How many?', answer: number, accept: {from: "
      "18, to: 65}}], quotas: [{of: {years: {to: 30}}, at_most: 20}], window: [800, 600], sound: "
      "true}");
  for (const char* words :
       {"# Participants\n\n",
        "The planned number of participants was 40; they were recruited on "
        "Prolific.",
        "Conditions for taking part were years (from 18 to 65), a window of at least 800 × 600 "
        "pixels and audible sound, shown by counting tones. Phones were not admitted.",
        "The numbers of participants were limited to 20 (years: 30 or less).",
        "gave consent (version 2).", "They were asked for age and hand.",
        "The questionnaire was in English.", "kept as keyed hashes only"})
    expect_said(text, words);
}

TEST_F(MethodsQuestionnaire, SaysWhatWasAskedOfARating) {
  const std::string text = methods_of_asked(
      "participants: 4, scales: [slow-fast, sad-happy], answer: {points: 7, anchors: false}, "
      "per_participant: 3, no_repeats: [mood], practice: [a], attention: {every: 2}, replays: 1, "
      "display: {size: {degrees: 12}, distance_cm: 57}, analysis: {alpha: 0.01, "
      "max_failed_checks: 1, correction: bh}");
  for (const char* words :
       {"# Procedure\n\n",
        "In each trial, participants saw one film and rated it on 2 scales (slow–fast, "
        "sad–happy).",
        "Scales had 7 points, with labels at both ends, without an initial answer; the side of the "
        "high end varied between participants and scales.",
        "films could be replayed once.",
        "Films were 12° of visual angle wide, on a screen that participants calibrated with a bank "
        "card; the viewing distance was 57 cm, which participants were asked to keep.",
        "Each participant saw 3 of the 4 stimuli",
        "Trials were in random order for each participant; successive trials differed in mood.",
        "In addition there was 1 practice trial, which was not analysed with the others.",
        "# Analysis\n\nTests were two-sided with α = .01; p values were corrected within each "
        "family "
        "of tests by the method of Benjamini and Hochberg.",
        "Participants who failed more than 1 attention check were left out."})
    expect_said(text, words);
}

TEST_F(MethodsQuestionnaire, DescribesWalksAlongPathsAndWhereTheirMoodChanges) {
  const std::string text = methods_for(
      "mien: 1\nstudy: s\nseed: 7\noutput: {video: [mp4], cycles: 2, frames: none}\nstimuli:\n"
      "  - {id: a, path: [{stand: 0.5, mood: {sad: 1}}, {walk: 3, curve: -20}, {turn: 90}, {walk: "
      "2, "
      "pace: 0.8, mood: {happy: 1}}]}\n"
      "  - {id: b, path: {points: [[0, 0], [0, 4]], pace: 0.9, mood: {quickness: 0.8}}}\n");
  for (const char* words :
       {"Two stimuli were synthesized along a path by a parametric walker",
        "Its moods were mixtures of the parametric walks of builtin:walks-10 and blends of these "
        "with given adjectives;",
        "In a, the walker stood for 0.5 s, walked for 3 s in a curve of 20°/s to the right, turned "
        "by 90° to the left and walked for 2 s at 0.8 times the speed of its mood (",
        " m/s on average); its mood was sad until ", " s, then happy.",
        "In b, the walker followed a path through 2 points on the floor, at 0.9 times the speed of "
        "its mood (",
        "its mood was 0.8 quickness.", "no files of single frames kept"})
    expect_said(text, words);
  EXPECT_EQ(text.find("repeated 2 times"), std::string::npos) << "a walk is not repeated\n" << text;
}

TEST_F(MethodsQuestionnaire, QuotesThePlanOfTheAnalysis) {
  const std::string text = methods_of_asked(
      "participants: 4, scales: [slow-fast], analysis: {plan: \"Walks a and b are "
      "compared.\\n\\nThen "
      "c and d.\"}");
  expect_said(
      text,
      "The plan of the analysis, stated before the study, was as follows.\n\n> Walks a and b are "
      "compared.\n> \n> Then c and d.\n");
  expect_said(methods_html(text), "<blockquote><p>Walks a and b are compared.");
}

TEST_F(MethodsQuestionnaire, CountsInTheSingularAndOfTwo) {
  const std::string asked = "participants: 4, scales: [slow-fast], attention: {every: 1}, ";
  expect_said(methods_of_asked(asked + "stimuli: [a, b]"), "Each participant saw both stimuli.");
  expect_said(methods_of_asked(asked + "stimuli: [a]"), "Each participant saw the one stimulus.");
  const std::string all = methods_of_asked(asked + "comments: false");
  expect_said(all, "Each participant saw all 4 stimuli.");
  expect_said(all, "About every trial, an attention check");
}

TEST_F(MethodsQuestionnaire, SaysThatTheViewingDistanceWasMeasured) {
  const std::string text = methods_of_asked(
      "participants: 4, scales: [slow-fast], display: {size: {degrees: 12}, distance_cm: 57, "
      "blind_spot: true}");
  expect_said(text,
              "measured with the blind spot of the eye [@li2020] or, where this was not "
              "possible, taken as 57 cm");
}

TEST_F(MethodsQuestionnaire, SaysHowSetsOfGridsAreMadeUp) {
  const std::string text = methods_of_asked(
      "participants: 4, scales: [slow-fast], trials: grid, grid: {alike: [actor], reference: "
      "{mood: [x]}}");
  expect_said(text, "participants saw a set of 2 films, which they played one at a time");
  expect_said(text,
              "there were 2 sets, formed by stimuli with the same level of actor; the "
              "reference was shown openly and hidden among the others (mood: x).");
  EXPECT_EQ(text.find("Scales had"), std::string::npos) << text;
}

TEST_F(MethodsQuestionnaire, SaysHowFilmsWereRatedWhileTheyPlayed) {
  const std::string text = methods_of_asked(
      "participants: 4, scales: [slow-fast, sad-happy], trials: continuous, continuous: {start: "
      "low, lead: 2}, analysis: {lag: 1.5}");
  for (const char* words :
       {"participants saw one film, once, and while it played moved a marker from 0 to 100 with a "
        "mouse, a finger or the arrow keys, for 2 scales (slow–fast, sad–happy), one scale after "
        "the other, each with all films.",
        "The marker began at the low end when the film began, and a held arrow key moved it by 50 "
        "per second; the side of the high end varied between participants and scales.",
        "interpolated to 10 samples per second of the film’s own time, in which stops of the film "
        "have no part; the mean of a trial leaves out the first 2 seconds.",
        "delays of 1 to 6 seconds have been reported [@mariooryad2015]; in the analysis, ratings "
        "were moved back by 1.5 "
        "seconds."})
    expect_said(text, words);
  for (const char* words : {"Scales were", "replayed", "before a film had ended"})
    EXPECT_EQ(text.find(words), std::string::npos) << words;
  expect_said(methods_of_asked("participants: 4, scales: [slow-fast], trials: continuous"),
              "the analysis did not correct for this lag.");
  expect_said(methods_of_asked("participants: 4, scales: [slow-fast], trials: continuous, "
                               "continuous: {lead: 1}"),
              "the mean of a trial leaves out the first second.");
  expect_said(methods_of_asked("participants: 4, scales: [slow-fast], trials: continuous, "
                               "continuous: {lead: 0}"),
              "the mean of a trial is of all samples.");
}

TEST_F(MethodsQuestionnaire, SaysHowLevelsWereChosen) {
  const auto methods_of_doses = [](const std::string& form, const std::string& more) {
    return methods_for(test::dose_study_text(test::adaptive_members(form, more)));
  };
  const std::string quest = methods_of_doses("two_interval", "factor: dose, tracks: 2");
  for (const char* words :
       {"participants saw two films one after the other, one of them with the signal, and said "
        "which one had it.",
        "There were 6 levels of dose (0.5, 1, 1.5, 2, 2.5, 3), of which each trial showed one that "
        "depended on the participant’s answers so far.",
        "Levels were chosen by QUEST+ [@watson2017], for a logistic psychometric function with "
        "unknown location, width and lapse rate.",
        "There were 2 interleaved tracks with levels of their own; each ended after 40 trials.",
        "[@wichmann2001a; @wichmann2001b]",
        "The threshold was the level of dose at which the function gives 75 % right answers.",
        "the mean of the posterior distribution of the threshold was given"})
    expect_said(quest, words);
  for (const char* words : {"d′", "random order for each participant", "without the signal"})
    EXPECT_EQ(quest.find(words), std::string::npos) << words;
  const std::string staircase = methods_of_doses(
      "yes_no",
      "factor: dots, easier: falling, method: staircase, down: 1, step: {up: 3, down: 1}");
  for (const char* words :
       {"participants saw one film and said whether the signal was present.",
        "Levels were chosen by a staircase (1 up, 1 down; steps of 3 up and 1 down in places of "
        "the "
        "list of levels) that began with the easiest level and converges to 75 % answers “yes” "
        "[@levitt1971; @kaernbach1991].",
        "There was one track with levels of its own; it ended after 40 trials.",
        "Among them, at random places, were 10 trials without the signal.",
        "For each track, the mean level of the reversals after the first two was given."})
    expect_said(staircase, words);
  expect_said(methods_of_doses("same_different", "factor: dose, method: staircase, reversals: 8"),
              "it ended after 8 reversals, or 40 trials.");
  expect_said(methods_of_doses("yes_no", "factor: dose, until: {sd: 0.2, at_most: 60}"),
              "it ended after the first trial with a posterior standard deviation of the threshold "
              "of at most 0.2, or 60 trials.");
}

TEST_F(MethodsQuestionnaire, SaysWhichModificationsChainsLedThrough) {
  const std::string text = methods_for(
      "mien: 1\nstudy: s\nseed: 7\nexamples: {set: builtin:walks-10}\nadaptive: {participants: 4, "
      "method: gibbs, words: [sad], space: {recipe: {of: normal, emotions: {sad: [0, 1.5]}, "
      "posture: {head-flexion: [-10, 30]}, paths: [0.5, 1.5]}}}\n");
  for (const char* words :
       {"modifications of the example normal (strength of sad from 0 to 1.5, head-flexion from "
        "-10° to 30° and paths from 0.5 to 1.5)",
        "Chains started at random points of the ranges."})
    expect_said(text, words);
  EXPECT_EQ(text.find("random blends"), std::string::npos);
}

TEST_F(MethodsQuestionnaire, CountsTrialsThatAreNotAnalysedOnEachScaleInTurn) {
  const std::string members =
      "participants: 4, scales: [slow-fast, sad-happy], trials: continuous, attention: {every: 2}, "
      "practice: [a]";
  const std::string text = methods_of_asked(members + ", warm_up: 2");
  for (const char* words :
       {"Trials were in random order for each participant and scale.",
        "The order of the scales rotated between participants: over as many participants as there "
        "are scales, each scale was once in each place.",
        "With each of the 2 scales there were in addition 1 practice trial and 2 warm-up trials, "
        "which were not analysed with the others.",
        // Of the 6 trials of a scale, the second and the fourth are followed by one.
        "an attention check asked for a certain answer (about 4 in a session)."})
    expect_said(text, words);
  const std::string one = methods_of_asked(members);
  expect_said(one,
              "With each of the 2 scales there was in addition 1 practice trial, which was not "
              "analysed with the others.");
  const std::string fixed = methods_of_asked(members + ", order: fixed");
  expect_said(fixed, "Scales and trials had the same order for all participants.");
  EXPECT_EQ(fixed.find("rotated"), std::string::npos) << fixed;
  EXPECT_EQ(
      methods_of_asked("participants: 4, scales: [slow-fast], trials: continuous").find("rotated"),
      std::string::npos);
}

TEST_F(MethodsQuestionnaire, CountsPractisedPairsAndSetsOnce) {
  expect_said(methods_of_asked("participants: 4, scales: [slow-fast], trials: pair, practice: [a, "
                               "b]"),
              "In addition there was 1 practice trial, which was not analysed");
  expect_said(methods_of_asked("participants: 4, scales: [slow-fast], trials: best_worst, "
                               "best_worst: {size: 3, sets: 4}, practice: [a, b, c, b, c, d]"),
              "In addition there were 2 practice trials, which were not analysed");
}

TEST_F(MethodsQuestionnaire, SaysWhatBecomesOfIncompleteAnswers) {
  const std::string text = methods_of_asked("participants: 4, scales: [slow-fast]");
  for (const char* words :
       {"The answers of participants who did not finish were included.",
        "Participants without an analysed rating in each cell of the design were left out of the "
        "analysis of variance of that scale."})
    expect_said(text, words);
  const std::string planned =
      methods_of_asked("participants: 4, scales: [slow-fast], analysis: {factors: [mood]}");
  expect_said(planned, "were left out of the analysis of variance of that scale.");
  const std::string choices =
      methods_of_asked("participants: 4, scales: [slow-fast], trials: pair");
  expect_said(choices, "The answers of participants who did not finish were included.");
  EXPECT_EQ(choices.find("analysis of variance"), std::string::npos) << choices;
}

TEST_F(MethodsQuestionnaire, SaysWhatWasAskedInOtherTrials) {
  expect_said(
      methods_of_asked("participants: 4, scales: [slow-fast], trials: pair, preference: {ties: "
                       "true, shown: in_turn, alike: [actor]}"),
      "participants saw two films one after the other and chose, for the scale slow–fast, the one "
      "closer to the high end; they could also answer that there was no difference.");
  expect_said(methods_of_asked("participants: 4, trials: emotion, choices: [sad, happy, calm]"),
              "participants saw one film and answered by one of 3 choices (sad, happy, calm).");
  expect_said(methods_of_asked("participants: 4, trials: same_different, same_different: {same: "
                               "0.25}"),
              "in 25 % of the trials, they were the same.");
  expect_said(methods_of_asked("participants: 4, scales: [slow-fast], trials: best_worst, "
                               "best_worst: {size: 3, sets: 4}"),
              "participants saw a set of 3 films and chose, for the scale slow–fast, those closest "
              "to the high and to the low end; there were 4 sets");
  expect_said(methods_of_asked("participants: 4, trials: yes_no, question: 'Sad?', signal: {mood: "
                               "[y]}"),
              "said whether the signal was present; 2 of 4 stimuli had the signal (mood: y). The "
              "question was "
              "“Sad?”.");
}

TEST_F(MethodsQuestionnaire, SaysWhichLanguagesThereWere) {
  expect_said(
      methods_of_asked("participants: 4, scales: [sad-happy], language: {browser: [en, ja]}"),
      "The questionnaire was in English and Japanese, whichever the participant's browser "
      "preferred.");
}

TEST_F(MethodsQuestionnaire, BeginsNoSentenceWithANumeral) {
  const std::string text = methods_of_asked("participants: 4, scales: [sad-happy]");
  expect_said(text, "Four stimuli were single examples.");
  EXPECT_EQ(text.find("Corresponding moments"), std::string::npos) << text;
  EXPECT_FALSE(std::regex_search(text, std::regex("(\\. |\n)[0-9]"))) << text;
  EXPECT_EQ(sentence_start("1 stimulus was"), "One stimulus was");
  EXPECT_EQ(sentence_start("21 stimuli were"), "Twenty-one stimuli were");
  EXPECT_EQ(sentence_start("99 stimuli"), "Ninety-nine stimuli");
  EXPECT_EQ(sentence_start("100 stimuli were"), "A total of 100 stimuli were");
  EXPECT_EQ(sentence_start("Of 3 stimuli"), "Of 3 stimuli");
}

TEST_F(MethodsQuestionnaire, StandsInPreregistrationsWithoutTheStimuli) {
  const std::string text = methods_of_asked("participants: 4, scales: [sad-happy]");
  const ManifestReading reading =
      check_manifest(folder() / "m.yaml", [](const std::string&) { return std::nullopt; });
  EXPECT_EQ(procedure_of(reading.manifest).markdown, text.substr(text.find("# Participants")));
}

TEST_F(MethodsQuestionnaire, HasNoSectionsWithoutOne) {
  const std::string text = methods_for(
      "{mien: 1, study: s, seed: 7, examples: {set: builtin:walks-10}, stimuli: [{id: a, weights: "
      "{sad: 1}}]}");
  for (const char* heading : {"# Participants", "# Procedure", "# Analysis"})
    EXPECT_EQ(text.find(heading), std::string::npos);
}

TEST_F(MethodsQuestionnaire, NamesTheFactorsOfTheDesignOnly) {
  const std::string text = methods_of_asked("participants: 4, scales: [slow-fast]");
  expect_said(text, "The factors were actor (k, m) and mood (x, y).");
  EXPECT_EQ(text.find("example ("), std::string::npos);
  expect_said(text,
              "The examples were 10 synthetic motions (mien's built-in example set walks-10). Of "
              "these, 4 were used.");
}

TEST_F(MethodsQuestionnaire, AsksOnceToCompleteWhatCannotBeCited) {
  const std::string text = methods_for(
      "{mien: 1, study: s, seed: 7, examples: {set: builtin:walks-10}, interpolation: {method: "
      "cardinal}, stimuli: [{id: a, adjectives: {quickness: 0.6}}, {id: b, weights: {sad: 1}, "
      "modify: {emotion: tired}}]}");
  EXPECT_TRUE(
      text.starts_with("> To be completed by the author of the study: the following works "
                       "are not known well enough to be cited."))
      << text;
  expect_said(text,
              "Source 1: a paper on motion interpolation with parameters based on adjectives");
  expect_said(text, "(source 1 above)");
  EXPECT_EQ(text.find("@adjectives"), std::string::npos);
  EXPECT_EQ(text.find("@emotionthesis2010"), std::string::npos);
  EXPECT_EQ(text.find("Source 3"), std::string::npos);
  std::size_t notes = 0;
  for (std::size_t at = text.find("To be completed"); at != std::string::npos;
       at = text.find("To be completed", at + 1))
    ++notes;
  EXPECT_EQ(notes, 1u);
}

}  // namespace
}  // namespace mien::pipeline
