// Records of films that are rated while they play.

#include <algorithm>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/ratings/answers/trace.h"
#include "pipeline/study/questionnaire/service/record_check.h"
#include "pipeline/study/questionnaire/service/served_example.h"
#include "pipeline/study/questionnaire/service/service.h"
#include "pipeline/study/questionnaire/service/withdrawal.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

/// A session with a further trial of a film of 3.05 s.
class TraceRecords : public testing::Test {
 protected:
  TraceRecords() {
    add_film(study_.facts);
    trial_ = {.number = 7,
              .block = "main",
              .kind = &continuous_trials,
              .stimuli = {"walk-sad"},
              .items = {{.item = "calm-tense", .flipped = true}}};
    plan_ = study_.plans.at(0);
    plan_.trials.push_back(trial_);
  }

  static void add_film(QuestionnaireFacts& facts) {
    facts.scales["calm-tense"] = {.slider = true, .least = 0.0, .most = 100.0, .lead_s = 1.0};
    facts.seconds["walk-sad"] = 3.05;
  }

  nlohmann::json record(const nlohmann::json& raw) const {
    return {{"record", "trial-7"},
            {"session", "a1b2"},
            {"comment", ""},
            {"started_at", "2026-01-01T00:00:00Z"},
            {"attempt", 2},
            {"plays_before", 1},
            {"responses", {{{"item", "calm-tense"}, {"value_raw", raw}, {"rt_ms", 700}}}}};
  }

  void check(const nlohmann::json& text) const {
    check_record(study_.facts, plan_, read_record(text));
  }

  static std::string trace(std::size_t samples, double value = 25.0) {
    return to_text(std::vector<double>(samples, value));
  }

  test::TemporaryFolder folder_;
  ServedStudy study_ = example_study(folder_.path(), 1);
  SessionPlan plan_;
  Trial trial_;
};

TEST_F(TraceRecords, AreOfTheWholeFilm) {
  EXPECT_NO_THROW(check(record(trace(32))));
  for (const std::size_t samples : {1u, 31u, 33u, 6001u}) {
    try {
      check(record(trace(samples)));
      ADD_FAILURE() << samples;
    } catch (const RecordFault& fault) {
      EXPECT_EQ(std::string(fault.what()),
                "a trace of " + std::to_string(samples) + " samples, and its film has 32");
    }
  }
}

TEST_F(TraceRecords, HoldNumbersFrom0To100) {
  for (const nlohmann::json& raw :
       {nlohmann::json(50), nlohmann::json("high"), nlohmann::json(""),
        nlohmann::json(trace(31) + " 100.1"), nlohmann::json(trace(31) + " -1"),
        nlohmann::json(trace(31) + "  "), nlohmann::json(std::string(200'000, '5'))})
    EXPECT_THROW(check(record(raw)), RecordFault) << raw.dump().substr(0, 40);
  // Words do not become longer than those of other trials.
  EXPECT_THROW(read_record(record(std::string(20'000, 'w'))), RecordFault);
  EXPECT_NO_THROW(read_record(record(std::string(20'000, '5'))));
}

TEST_F(TraceRecords, BecomeARowWithTheMeanAfterTheLead) {
  std::string raw = to_text(std::vector<double>(10, 90.0));  // the lead
  raw += " " + trace(22, 30.5);
  const std::vector<AnswerRow> rows =
      rows_of(study_.facts, plan_, trial_, read_record(record(raw)));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].kind, "continuous");
  EXPECT_EQ(rows[0].item, "calm-tense");
  EXPECT_EQ(rows[0].value_raw, raw);
  EXPECT_EQ(rows[0].value, "69.5");
  EXPECT_EQ(rows[0].pole_left, "high");
  EXPECT_EQ(rows[0].rt_ms, 700);
  EXPECT_EQ(rows[0].attempt, 2);
  EXPECT_EQ(rows[0].plays_before, 1);
}

TEST_F(TraceRecords, OfFilmsThatCouldNotBePlayedHaveNoTrace) {
  nlohmann::json text = record(trace(32));
  text["play_fault"] = "stalled";
  EXPECT_THROW(check(text), RecordFault) << "what was not seen is not answered";
  text["responses"] = nlohmann::json::array();
  EXPECT_NO_THROW(check(text));
  const std::vector<AnswerRow> rows = rows_of(study_.facts, plan_, trial_, read_record(text));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].value_raw + rows[0].value, "");
  EXPECT_FALSE(rows[0].counts());
}

/// A served study whose sessions end with a film that is rated while it plays.
class ServedTraces : public TraceRecords {
 protected:
  static ServedStudy with_trial(ServedStudy study, const Trial& trial) {
    add_film(study.facts);
    for (SessionPlan& plan : study.plans) plan.trials.push_back(trial);
    return study;
  }

  HttpResponse ask(const std::string& method, const std::string& target, const std::string& body) {
    return service_.answer({.method = method,
                            .path = plain_path(target).value(),
                            .headers = {{"content-type", "application/json"}, {"host", "here"}},
                            .body = body,
                            .address = "127.0.0.1"});
  }

  HttpResponse give(const nlohmann::json& record) {
    return ask("POST",
               "/s/" + service_.sessions().state(0).session.link + "/records/" +
                   record.at("record").get<std::string>(),
               record.dump());
  }

  std::string got(const std::string& name) {
    return ask("GET", "/lab/" + service_.sessions().lab_link() + "/" + name, "").body;
  }

  test::TemporaryFolder media_;
  ServedStudy served_ = with_trial(example_study(media_.path(), 1), trial_);
  SessionStore store_{folder_.path() / "answers.db"};
  QuestionnaireService service_{served_, store_};
};

TEST_F(ServedTraces, AreATableAndGoWhenAParticipantWithdraws) {
  for (const std::string& name : record_names(served_.plans.at(0), served_.facts)) {
    if (name == "trial-7") {
      const HttpResponse refused = give(record(trace(31)));
      EXPECT_EQ(refused.status, 400) << refused.body;
      EXPECT_NE(refused.body.find("its film has 32"), std::string::npos) << refused.body;
    }
    const HttpResponse taken =
        give(name == "trial-7" ? record(trace(32)) : good_record(served_, 0, name));
    ASSERT_EQ(taken.status, 200) << name << taken.body;
  }
  EXPECT_EQ(nlohmann::json::parse(got("status.json")).at("has_traces"), true);
  const std::string table = got("traces.csv");
  EXPECT_EQ(std::ranges::count(table, '\n'), 33);
  EXPECT_NE(table.find("p001,a1b2,7,walk-sad,calm-tense,3.05,75,0\n"), std::string::npos) << table;
  EXPECT_NE(got("answers.csv").find("," + trace(32) + ",75,high,"), std::string::npos);
  // Tables of traces are among those from which participants are deleted.
  const std::filesystem::path saved = folder_.path() / "traces.csv";
  write_file(saved, table);
  const auto without = without_participant(saved, {.name = "p001", .session = {}, .ids = {}});
  ASSERT_TRUE(without.has_value());
  EXPECT_EQ(without->removed, 32);
  ask("POST", "/s/" + service_.sessions().state(0).session.link + "/withdrawal",
      R"({"session": "a1b2"})");
  EXPECT_EQ(std::ranges::count(got("traces.csv"), '\n'), 1);
}

}  // namespace
}  // namespace mien::pipeline
