#include "pipeline/study/questionnaire/simulated_sessions.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/questionnaire/asked_study.h"
#include "pipeline/study/trials/trial_kind.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

using test::asked_study;

TEST(SimulatedSessions, HaveARowForEveryItemOfEveryTrialThatCanBeReadAgain) {
  const Manifest manifest = asked_study(8,
                                        "participants: 6, scales: [sad-happy, slow-fast], "
                                        "attention: {every: 3}, retest: {repeat: 1}, "
                                        "warm_up: 1, practice: [a1], reference: b2");
  const auto plans = plan_sessions(manifest);
  const auto rows = simulated_sessions(manifest, plans, {});
  std::size_t expected = 0;
  for (const SessionPlan& plan : plans) {
    for (const Trial& trial : plan.trials) expected += trial.items.size();
  }
  EXPECT_EQ(rows.size(), expected);
  const auto again = answer_rows(parse_csv(to_csv(rows), "answers.csv"));
  ASSERT_EQ(again.size(), rows.size());
  const auto scales = response_scales_by_item(manifest);
  for (const AnswerRow& row : again) {
    EXPECT_TRUE(row.simulated);
    EXPECT_EQ(row.design, design_hash(manifest, plans));
    EXPECT_EQ(row.against, row.kind == "attention" ? "" : "b2");
    EXPECT_EQ(row.passed.has_value(), row.kind == "attention");
    if (row.passed) {  // as the page writes them: what was pressed
      EXPECT_EQ(row.value, row.value_raw);
      EXPECT_EQ(row.pole_left, "");
      continue;
    }
    EXPECT_EQ(std::stod(row.value),
              value_of_raw(scales.at(row.item), std::stod(row.value_raw), row.pole_left == "high"));
  }
}

// As pages and servers write them: 0.666667 and not 0.66666666666666674.
TEST(SimulatedSessions, HaveValuesOfSixDecimals) {
  const Manifest manifest =
      asked_study(8, "participants: 6, scales: [sad-happy], answer: {points: 7}");
  const auto scales = response_scales_by_item(manifest);
  std::size_t long_ones = 0;
  for (const AnswerRow& row : simulated_sessions(manifest, plan_sessions(manifest), {})) {
    EXPECT_LE(row.value.size(), std::string("-0.666667").size()) << row.value;
    EXPECT_NEAR(
        std::stod(row.value),
        value_of_raw(scales.at(row.item), std::stod(row.value_raw), row.pole_left == "high"), 5e-7);
    long_ones += row.value.size() > 4 ? 1 : 0;
  }
  EXPECT_GT(long_ones, 0u);
}

TEST(SimulatedSessions, FollowTheStatedTruth) {
  const Manifest manifest =
      asked_study(3, "participants: 400, scales: [sad-happy], answer: {slider: true}");
  const StatedTruth truth = {{{"a1", "sad-happy"}, 0.8}, {{"b2", "sad-happy"}, -0.4}};
  std::map<std::string, double> sums;
  for (const AnswerRow& row : simulated_sessions(
           manifest, plan_sessions(manifest), truth,
           {.spread = RatingSpread{.participant = 0.2, .stimulus = 0.0, .residual = 0.4}}))
    sums[row.stimulus] += std::stod(row.value);
  EXPECT_NEAR(sums["a1"] / 400, 0.8, 0.1);  // four standard errors
  EXPECT_NEAR(sums["b2"] / 400, -0.4, 0.1);
  EXPECT_NEAR(sums["c3"] / 400, 0.0, 0.1);
}

TEST(SimulatedSessions, ChooseTheHigherOfTwoAndAnOfferedEmotion) {
  const Manifest pairs = asked_study(3, "participants: 60, scales: [sad-happy], trials: pair");
  int right = 0, all = 0;
  for (const AnswerRow& row :
       simulated_sessions(pairs, plan_sessions(pairs), {{{"a1", "sad-happy"}, 1.5}})) {
    EXPECT_EQ(row.value, row.value_raw == "left" ? row.stimulus : row.against);
    if (row.stimulus != "a1" && row.against != "a1") continue;
    ++all;
    right += row.value == "a1";
  }
  EXPECT_EQ(all, 120);
  EXPECT_GT(right, 100);
  const Manifest emotions = asked_study(8, "participants: 40, trials: emotion");
  int seen = 0, shown = 0;
  for (const AnswerRow& row : simulated_sessions(emotions, plan_sessions(emotions), {})) {
    EXPECT_EQ(row.item, "emotion");
    seen += row.value == level_of(emotions, row.stimulus, "emotion");
    ++shown;
  }
  EXPECT_EQ(shown, 320);
  EXPECT_NEAR(seen / 320.0, 0.6 + 0.4 / 2, 0.1);  // two are to choose from: sad and happy
}

std::optional<std::string> no_variable(const std::string&) { return std::nullopt; }

/// The answers that lie beside a shipped manifest as if they were real.
void expect_shipped_answers(const std::string& study) {
  const auto folder = std::filesystem::path(MIEN_SOURCE_DIR) / "manifests";
  const Manifest manifest = load_manifest(folder / (study + ".yaml"), no_variable);
  const auto rows =
      simulated_sessions(manifest, plan_sessions(manifest), measured_truth(manifest).ratings);
  // Compared first, so that a difference does not print them all.
  const bool are_same = to_csv(rows) == read_file(folder / (study + ".answers.csv"));
  EXPECT_TRUE(are_same) << "mien study simulate " << study << " says something else by now";
}

TEST(SimulatedSessions, OfTheClosedLoopAreThoseThatItsNextRoundIsMadeOf) {
  expect_shipped_answers("closed-loop-1");
  expect_shipped_answers("closed-loop-2");
}

TEST(MeasuredTruth, HasTheBriskWalkFasterAndTheSadOneSadder) {
  const auto file = std::filesystem::path(MIEN_SOURCE_DIR) / "manifests" / "closed-loop-1.yaml";
  const StatedTruth truth = measured_truth(load_manifest(file, no_variable)).ratings;
  const auto of = [&](const char* stimulus, const char* scale) {
    return truth.at({stimulus, scale});
  };
  EXPECT_GT(of("brisk", "slow-fast"), of("normal", "slow-fast"));
  EXPECT_LT(of("slow", "slow-fast"), of("normal", "slow-fast"));
  EXPECT_LT(of("sad", "sad-happy"), of("happy", "sad-happy"));
}

TEST(StatedTruth, IsReadWithThePlacesOfWhatIsWrong) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "truth.csv";
  write_file(file,
             "stimulus,scale,value\na1,sad-happy,1\na2,sad-happy,1\na1,sad-hapy,9\n"
             "a1,sad-happy,much\na1,sad-happy,3\n");
  const Manifest manifest = asked_study(3, "participants: 4, scales: [sad-happy]");
  try {
    read_truth(manifest, file);
    FAIL();
  } catch (const Faults& faults) {
    const std::string told = faults.what();
    for (const char* words :
         {"truth.csv:3:1", "\"a2\"", "truth.csv:4:4", "did you mean \"sad-happy\"",
          "truth.csv:5:14", "truth.csv:6:14", "from -2 to 2"})
      EXPECT_NE(told.find(words), std::string::npos) << words << "\n" << told;
  }
}

TEST(StatedTruth, MayChangeWhileAVideoIsRated) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "truth.csv";
  const Manifest manifest =
      asked_study(3, "participants: 4, scales: [sad-happy], trials: continuous");
  write_file(file,
             "stimulus,scale,value,from_s\na1,sad-happy,80,6.5\na1,sad-happy,20,\n"
             "b2,sad-happy,60,\n");
  const AssumedTruth truth = read_truth(manifest, file);
  EXPECT_EQ(truth.ratings.at({"a1", "sad-happy"}), 20.0);
  EXPECT_EQ(truth.ratings.at({"b2", "sad-happy"}), 60.0);
  ASSERT_EQ(truth.courses.size(), 1u);
  const std::vector<TruthStep>& course = truth.courses.at({"a1", "sad-happy"});
  ASSERT_EQ(course.size(), 1u);
  EXPECT_EQ(course[0].from_s, 6.5);
  EXPECT_EQ(course[0].value, 80.0);
  const auto fault_of = [&](const std::string& rows, const Manifest& asked) {
    write_file(file, "stimulus,scale,value,from_s\n" + rows);
    try {
      read_truth(asked, file);
    } catch (const Faults& faults) {
      return std::string(faults.what());
    }
    return std::string();
  };
  EXPECT_NE(fault_of("a1,sad-happy,20,-1\n", manifest).find("truth.csv:2:17: \"-1\" is no time"),
            std::string::npos)
      << fault_of("a1,sad-happy,20,-1\n", manifest);
  EXPECT_NE(fault_of("a1,sad-happy,20,\na1,sad-happy,30,0\n", manifest)
                .find("truth.csv:3:17: a second rating from 0 s on"),
            std::string::npos);
  EXPECT_NE(fault_of("a1,sad-happy,1,3\n", asked_study(3, "participants: 4, scales: [sad-happy]"))
                .find("in continuous trials only"),
            std::string::npos);
}

TEST(MeasuredTruth, OfAWalkerWhoseMoodChangesChangesWithIt) {
  const auto file = std::filesystem::path(MIEN_SOURCE_DIR) / "manifests" / "continuous-study.yaml";
  const AssumedTruth truth = measured_truth(load_manifest(file, no_variable));
  ASSERT_EQ(truth.courses.size(), 2u);
  const auto change = [&](const char* stimulus) {
    const std::pair<std::string, std::string> named = {stimulus, "sad-happy"};
    const TruthStep& step = truth.courses.at(named).front();
    EXPECT_GT(step.from_s, 7.4) << "after half a second of standing and 7 s of walking";
    EXPECT_LT(step.from_s, 8.5);
    return step.value - truth.ratings.at(named);
  };
  EXPECT_GT(change("brightens"), 15.0);
  EXPECT_LT(change("saddens"), -15.0);
}

/// Standing and changes of mood, of which the walks have different parts, say nothing of a mood.
TEST(MeasuredTruth, OfAMoodIsAboutTheSameFirstAndLast) {
  const auto file = std::filesystem::path(MIEN_SOURCE_DIR) / "manifests" / "continuous-study.yaml";
  Manifest manifest = load_manifest(file, no_variable);
  manifest.questionnaire->scales.ids = {"tired-excited"};
  const AssumedTruth truth = measured_truth(manifest);
  const auto first = [&](const char* id) { return truth.ratings.at({id, "tired-excited"}); };
  const auto last = [&](const char* id) {
    return truth.courses.at({id, "tired-excited"}).front().value;
  };
  EXPECT_NEAR(last("brightens"), first("saddens"), 6.0) << "happy";
  EXPECT_NEAR(last("saddens"), first("brightens"), 6.0) << "sad";
  EXPECT_GT(first("saddens") - first("brightens"), 30.0);
}

TEST(MeasuredTruth, OffersATableForScalesWithoutAModel) {
  const Manifest manifest = asked_study(2, "participants: 2, scales: [sad-happy]");
  EXPECT_NO_THROW(refuse_scales_without_model(manifest));
  Manifest other = manifest;
  other.scales.file = "own.yaml";
  other.scales.set.scales = {{.id = "grace", .low = "clumsy", .high = "graceful"}};
  other.questionnaire->scales.ids = {"grace"};
  try {
    refuse_scales_without_model(other);
    FAIL() << "accepted";
  } catch (const Error& error) {
    const std::string told = error.what();
    for (const char* words :
         {"no model of \"grace\"", "--truth truth.csv",
          "\n  stimulus,scale,value\n  a1,grace,-0.67\n  b2,grace,0.67\n", "`loadings:`"})
      EXPECT_NE(told.find(words), std::string::npos) << words << "\n" << told;
  }
}

TEST(SimulatedSessions, HaveTheSameShareOfEveryRange) {
  EXPECT_EQ(usual_spread(4.0).participant, 0.3);
  EXPECT_EQ(usual_spread(4.0).residual, 0.7);
  EXPECT_EQ(usual_spread(100.0).participant, 7.5);
  EXPECT_EQ(usual_spread(100.0).residual, 17.5);
  Manifest manifest = asked_study(3, "participants: 60, scales: [sad-happy]");
  manifest.scales.file = "own.yaml";
  manifest.scales.set.scales = {
      {.id = "warmth", .low = "cold", .high = "warm", .least = 0.0, .most = 100.0}};
  manifest.questionnaire->scales.ids = {"warmth"};
  manifest.questionnaire->answer.slider = true;
  double squares = 0.0;
  const auto rows = simulated_sessions(manifest, plan_sessions(manifest), {});
  for (const AnswerRow& row : rows) squares += std::pow(std::stod(row.value) - 50.0, 2);
  // 7.5 and 17.5 together are 19.
  EXPECT_NEAR(std::sqrt(squares / static_cast<double>(rows.size())), 19.0, 3.0);
}

TEST(DesignHash, IsOfWhatParticipantsSee) {
  const auto hash = [](const std::string& members) {
    const Manifest manifest = asked_study(6, "participants: 4, scales: [sad-happy]" + members);
    return design_hash(manifest, plan_sessions(manifest));
  };
  EXPECT_EQ(hash(""), hash(", pace: {answer: 9}"));
  EXPECT_EQ(hash(""), hash(", analysis: {alpha: 0.01}"));
  const auto screened = [&](const std::string& more) {
    return hash(", screening: {questions: [{id: eyes, ask: x, answer: [a, b]" + more + "}");
  };
  EXPECT_NE(hash(""), screened("}]"));
  EXPECT_NE(screened("}]"), screened(", accept: a}]"));
  EXPECT_EQ(screened("}]"), screened("}], quotas: [{of: {eyes: a}, at_most: 3}]"));
  EXPECT_NE(hash(""), hash(", debriefing: yes or no"));
  EXPECT_NE(hash(""), hash(", display: {size: native}"));
  EXPECT_NE(hash(""), hash(", comments: true"));
  EXPECT_NE(hash(""), hash(", consent: yes or no"));
  EXPECT_NE(hash(""), hash(", order: latin"));
  EXPECT_NE(hash(""), hash(", retest: {repeat: 1}"));
}

// As programs calculated them that knew only the former names: studies in progress keep them.
TEST(DesignHash, DoesNotChangeWithTheNamesOfKeys) {
  const auto hash = [](const std::string& members) {
    const Manifest manifest = asked_study(6, "participants: 4, scales: [sad-happy]" + members);
    return design_hash(manifest, plan_sessions(manifest));
  };
  EXPECT_EQ(hash(""), "44a3e021f59738cbb516fab9b02ead15");
  for (const std::string key : {"catch", "retest"})
    EXPECT_EQ(hash(", " + key + ": {repeat: 1}"), "c07e6d783da131fe3bec1a55c133935e") << key;
}

}  // namespace
}  // namespace mien::pipeline
