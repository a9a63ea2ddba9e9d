#include "pipeline/study/questionnaire/service/record.h"

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/study/questionnaire/service/record_check.h"
#include "pipeline/study/questionnaire/service/served_example.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

class Records : public testing::Test {
 protected:
  const SessionPlan& plan() const { return study_.plans.at(0); }

  void check(const nlohmann::json& text) const {
    check_record(study_.facts, plan(), read_record(text));
  }

  std::vector<AnswerRow> rows(const std::string& name, const nlohmann::json& text) const {
    return rows_of(study_.facts, plan(), *trial_of(plan(), name), read_record(text));
  }

  std::vector<AnswerRow> rows(const std::string& name) const {
    return rows(name, good_record(study_, 0, name));
  }

  test::TemporaryFolder folder_;
  ServedStudy study_ = example_study(folder_.path(), 1);
};

TEST_F(Records, OfAWellBehavedPageAreTaken) {
  for (const std::string& name : record_names(plan(), study_.facts))
    EXPECT_NO_THROW(check(good_record(study_, 0, name))) << name;
}

TEST_F(Records, AreInTheOrderOfTheSession) {
  EXPECT_EQ(record_names(plan(), study_.facts),
            (std::vector<std::string>{"consent", "demographics", "trial-1", "trial-2", "trial-3",
                                      "trial-4", "trial-5", "trial-6", "ending"}));
}

TEST_F(Records, TellWhatWasMeasured) {
  const AnswerRow row = rows("trial-1").at(0);
  EXPECT_EQ(row.participant, "p001");
  EXPECT_EQ(row.session, "a1b2");
  EXPECT_EQ(row.trial, 1);
  EXPECT_EQ(row.block, "practice");
  EXPECT_EQ(row.stimulus, "walk-sad");
  EXPECT_EQ(row.stimulus_sha256, study_.facts.sha256.at("walk-sad"));
  EXPECT_EQ(row.rt_ms, 1200.5);
  EXPECT_TRUE(row.is_practice);
  EXPECT_FALSE(row.counts());
  EXPECT_EQ(row.replays, 1);
  EXPECT_EQ(row.trial_ms, 8123);
  EXPECT_EQ(row.ended_ms, std::nullopt);
  EXPECT_EQ(row.refresh_hz, 59.94);
  EXPECT_EQ(row.seed, 10'000'000'000'000'000'000u);
  EXPECT_EQ(row.design, "0123abcd");
}

TEST_F(Records, KeepRawAnswersAndTurnThemIntoTheScalesOwnRange) {
  nlohmann::json text = good_record(study_, 0, "trial-2");
  text["responses"][0]["value_raw"] = 5;  // rightmost, which is the low end here
  text["comment"] = "=cmd()\r\n\"<script>\"";
  const std::vector<AnswerRow> both = rows("trial-2", text);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].value_raw, "5");
  EXPECT_EQ(both[0].value, "-2");
  EXPECT_EQ(both[0].pole_left, "high");
  EXPECT_EQ(both[0].against, "walk-normal");
  EXPECT_EQ(both[0].comment, "=cmd() \n\"<script>\"");
  EXPECT_EQ(both[1].value_raw, "70");
  EXPECT_EQ(both[1].value, "1.2");
  EXPECT_EQ(both[1].pole_left, "low");
  EXPECT_EQ(both[1].comment, "");
}

TEST_F(Records, OfTrialsThatCouldNotBePlayedHaveARowForEachItemWithoutAnAnswer) {
  nlohmann::json text = good_record(study_, 0, "trial-2");
  text["responses"] = nlohmann::json::array();
  text["play_fault"] = "not_decoded";
  EXPECT_NO_THROW(check(text));
  const std::vector<AnswerRow> both = rows("trial-2", text);
  ASSERT_EQ(both.size(), 2u);
  for (const AnswerRow& row : both) {
    EXPECT_EQ(row.play_fault, "not_decoded");
    EXPECT_EQ(row.value_raw + row.value, "");
    EXPECT_EQ(row.rt_ms, std::nullopt);
    EXPECT_FALSE(row.counts());
  }
  text["play_fault"] = "dull";
  EXPECT_THROW(check(text), RecordFault);
  text["play_fault"] = "";
  EXPECT_THROW(check(text), RecordFault) << "nothing is left out without a fault";
  nlohmann::json answered = good_record(study_, 0, "trial-2");
  answered["play_fault"] = "stalled";
  EXPECT_THROW(check(answered), RecordFault) << "what was not seen is not answered";
  nlohmann::json unseen = good_record(study_, 0, "trial-4");
  unseen["responses"] = nlohmann::json::array();
  unseen["play_fault"] = "stalled";
  EXPECT_THROW(check(unseen), RecordFault) << "an attention check without a stimulus";
}

TEST_F(Records, TellWhatHadBeenWatchedBeforeAReload) {
  nlohmann::json text = good_record(study_, 0, "trial-1");
  text["attempt"] = 2;
  text["plays_before"] = 1;
  text["watched_before_ms"] = 640.5;
  EXPECT_NO_THROW(check(text));
  const AnswerRow row = rows("trial-1", text).at(0);
  EXPECT_EQ(row.attempt, 2);
  EXPECT_EQ(row.plays_before, 1);
  EXPECT_EQ(row.watched_before_ms, 640.5);
}

TEST_F(Records, OfOtherKindsHaveTheirOwnValues) {
  EXPECT_EQ(rows("trial-3").at(0).value, "a bit, \"tired\"");
  EXPECT_EQ(rows("trial-3").at(0).pole_left, "");
  const AnswerRow attention = rows("trial-4").at(0);
  EXPECT_EQ(attention.passed, true);
  EXPECT_TRUE(attention.is_check);
  EXPECT_EQ(attention.value, "5");
  const AnswerRow emotion = rows("trial-5").at(0);
  EXPECT_EQ(emotion.item, "emotion");
  EXPECT_EQ(emotion.value, "happy");
  const AnswerRow pair = rows("trial-6").at(0);
  EXPECT_EQ(pair.stimulus, "walk-happy");
  EXPECT_EQ(pair.against, "walk-sad");
  EXPECT_EQ(pair.value_raw, "right");
  EXPECT_EQ(pair.value, "walk-sad");
}

TEST_F(Records, AreReadBackFromATable) {
  std::vector<AnswerRow> all;
  for (const Trial& trial : plan().trials) {
    for (const AnswerRow& row : rows("trial-" + std::to_string(trial.number))) all.push_back(row);
  }
  const std::vector<AnswerRow> read = answer_rows(parse_csv(to_csv(all), "answers.csv"));
  ASSERT_EQ(read.size(), all.size());
  EXPECT_EQ(to_csv(read), to_csv(all));
}

TEST_F(Records, OfChecksAreAnsweredAsTheOtherTrialsAre) {
  Trial check{.number = 1, .kind = &emotion_trials, .items = {{"emotion"}}, .expected = "sad"};
  SessionPlan plan{.trials = {check}, .choices = {"sad", "happy"}};
  nlohmann::json text = good_record(study_, 0, "consent");
  text["record"] = "trial-1";
  const auto give = [&](const std::string& item, const nlohmann::json& value) {
    text["responses"] = {{{"item", item}, {"value_raw", value}}};
    check_record(study_.facts, plan, read_record(text));
  };
  EXPECT_NO_THROW(give("emotion", "happy"));
  EXPECT_THROW(give("emotion", 1), RecordFault);
  plan.trials[0].kind = &pair_trials;
  plan.trials[0].items = {{"sad-happy"}};
  plan.trials[0].expected = "left";
  EXPECT_NO_THROW(give("sad-happy", "right"));
  EXPECT_THROW(give("sad-happy", 1), RecordFault);
  plan.trials[0].kind = &rating_trials;
  plan.trials[0].expected = "5";
  EXPECT_NO_THROW(give("sad-happy", 1));
  EXPECT_THROW(give("sad-happy", "left"), RecordFault);
}

TEST_F(Records, OfASetWhoseBestIsItsWorstAreRefused) {
  SessionPlan plan{.trials = {{.number = 1,
                               .kind = &best_worst_trials,
                               .stimuli = {"walk-sad", "walk-happy", "walk-normal"},
                               .items = {{"sad-happy/best"}, {"sad-happy/worst"}}}}};
  nlohmann::json text = good_record(study_, 0, "consent");
  text["record"] = "trial-1";
  const auto give = [&](const nlohmann::json& best, const nlohmann::json& worst) {
    text["responses"] = {{{"item", "sad-happy/best"}, {"value_raw", best}},
                         {{"item", "sad-happy/worst"}, {"value_raw", worst}}};
    check_record(study_.facts, plan, read_record(text));
  };
  EXPECT_NO_THROW(give("3", "1"));
  EXPECT_THROW(give("3", "3"), RecordFault);
  EXPECT_THROW(give("4", "1"), RecordFault);
  EXPECT_THROW(give(3, "1"), RecordFault);
  text["media_sha256"] = nlohmann::json(std::vector<std::string>(6, ""));
  EXPECT_THROW(give("3", "1"), RecordFault) << "more media than stimuli";
  text["media_sha256"] = nlohmann::json(std::vector<std::string>(17, ""));
  EXPECT_THROW(read_record(text), RecordFault);
}

/// A session as experiment.json tells it.
SessionPlan plan_in(const nlohmann::json& session, const nlohmann::json& stimuli) {
  SessionPlan plan{.participant = session.at("participant"),
                   .seed = std::stoull(session.at("seed").get<std::string>())};
  for (const nlohmann::json& told : session.at("trials")) {
    Trial trial{.number = told.at("number"),
                .block = told.at("block"),
                .practice = told.at("practice"),
                .warm_up = told.at("warm_up"),
                .is_check = told.at("check"),
                .expected = told.at("expected")};
    for (const TrialKind* kind : trial_kinds)
      if (told.at("kind") == kind->name) trial.kind = kind;
    for (const nlohmann::json& token : told.at("media"))
      trial.stimuli.push_back(stimuli.at(token.get<std::string>()));
    const std::string reference = told.at("reference");
    if (!reference.empty()) trial.reference = stimuli.at(reference);
    for (const nlohmann::json& item : told.at("items"))
      trial.items.push_back({item.at("item"), item.at("flipped")});
    trial.level = told.value("level", "");
    trial.adaptive.track = told.value("track", 0);
    for (const nlohmann::json& tokens : told.value("by_level", nlohmann::json::array())) {
      trial.adaptive.by_level.emplace_back();
      for (const nlohmann::json& token : tokens)
        trial.adaptive.by_level.back().push_back(stimuli.at(token.get<std::string>()));
    }
    plan.trials.push_back(std::move(trial));
  }
  return plan;
}

TEST(RowsOfAPage, AreThoseThatThePageItselfMakes) {
  const std::filesystem::path folder =
      std::filesystem::path(MIEN_SOURCE_DIR) / "tests/pipeline/study/questionnaire";
  const auto told = nlohmann::ordered_json::parse(read_file(folder / "page_session.json"));
  const QuestionnaireFacts facts = questionnaire_facts(told.at("experiment"));
  const SessionPlan plan = plan_in(nlohmann::json(told.at("experiment").at("sessions").at(0)),
                                   nlohmann::json(told.at("experiment").at("stimuli")));
  std::vector<AnswerRow> rows;
  for (const Trial& trial : plan.trials) {
    const auto text = told.at("records").find("trial-" + std::to_string(trial.number));
    if (text == told.at("records").end()) continue;
    const PageRecord record = read_record(nlohmann::json(*text));
    for (AnswerRow& row : rows_of(facts, plan, trial, record)) rows.push_back(std::move(row));
  }
  EXPECT_EQ(to_csv(rows), read_file(folder / "page_answers.csv"));
}

/// A record with one thing changed: a JSON pointer and what stands there then.
struct Tampering {
  std::string record;
  std::string where;
  nlohmann::json value;
};

TEST_F(Records, ThatNoPageGivesAreRefused) {
  const std::vector<Tampering> tamperings = {
      {"trial-1", "/responses/0/value_raw", 6},
      {"trial-1", "/responses/0/value_raw", 0},
      {"trial-1", "/responses/0/value_raw", 2.5},
      {"trial-1", "/responses/0/value_raw", "3"},
      {"trial-1", "/responses/0/value_raw", nullptr},
      {"trial-1", "/responses/0/value_raw", nlohmann::json::array()},
      {"trial-1", "/responses/0/item", "calm-wild"},
      {"trial-1", "/responses/0/item", "none"},
      {"trial-1", "/responses/0/rt_ms", -1},
      {"trial-1", "/responses/0/rt_ms", "1"},
      {"trial-1", "/responses/0/more", 1},
      {"trial-1", "/responses", nlohmann::json::array()},
      {"trial-1", "/responses", 1},
      {"trial-1", "/responses/1", {{"item", "sad-happy"}, {"value_raw", 1}}},
      {"trial-1", "/record", "trial-99"},
      {"trial-1", "/record", 7},
      {"trial-1", "/session", ""},
      {"trial-1", "/session", "a b"},
      {"trial-1", "/session", std::string(65, 'a')},
      {"trial-1", "/participant", "p002"},
      {"trial-1", "/comment", std::string(10'001, 'a')},
      {"trial-1", "/comment", {{"a", 1}}},
      {"trial-1", "/replays", 1.5},
      {"trial-1", "/replays", 1e300},
      {"trial-1", "/attempt", "2"},
      {"trial-1", "/watched_before_ms", -1},
      {"trial-1", "/play_fault", 1},
      {"trial-1", "/media_sha256/0", std::string(64, '0')},
      {"trial-1", "/media_sha256/3", "a"},
      {"trial-2", "/responses/1/value_raw", 101},
      {"trial-3", "/responses/0/value_raw", 3},
      {"trial-5", "/responses/0/value_raw", "angry"},
      {"trial-6", "/responses/0/value_raw", "both"},
      {"consent", "/responses/0/value_raw", "perhaps"},
      {"consent", "/responses", nlohmann::json::array()},
      {"demographics", "/responses/0/value_raw", "old"},
      {"demographics", "/responses/1/value_raw", "none"},
      {"demographics", "/responses/0/item", "hand"},
      {"demographics", "/responses", nlohmann::json::array()},
      {"ending", "/responses/0", {{"item", "sad-happy"}, {"value_raw", 1}}}};
  for (const Tampering& one : tamperings) {
    nlohmann::json text = good_record(study_, 0, one.record);
    text[nlohmann::json::json_pointer(one.where)] = one.value;
    EXPECT_THROW(check(text), RecordFault) << one.record << one.where << " " << one.value;
  }
  EXPECT_THROW(check(nlohmann::json::array()), RecordFault);
  EXPECT_THROW(check(nlohmann::json("trial-1")), RecordFault);
}

}  // namespace
}  // namespace mien::pipeline
