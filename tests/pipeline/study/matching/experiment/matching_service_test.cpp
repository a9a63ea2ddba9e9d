#include <optional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/study/matching/experiment/matching_study.h"
#include "pipeline/study/questionnaire/service/collected_answers.h"
#include "pipeline/study/questionnaire/service/service.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

using nlohmann::json;

Manifest served_manifest() {
  return std::move(
      parse_manifest("mien: 1\nstudy: m\nexamples: {set: builtin:walks-10, ratings: builtin}\n"
                     "output: {fps: 30}\nstimuli:\n"
                     "  - {id: t1, role: target, weights: {normal: 0.5, sad: 0.5}}\n"
                     "  - {id: t2, role: target, adjectives: {quickness: 0.6, largeness: 0.4}}\n"
                     "matching: {participants: 2, interfaces: [features, weights], limit_s: 60}\n",
                     "/nowhere/m.yaml", [](const std::string&) { return std::nullopt; })
          .manifest);
}

json as_json(const SliderSetting& setting) {
  return {{"sliders", setting.sliders}, {"values", setting.values}};
}

/// What a page gives of a trial.
json page_record_of(const MatchedTrial& one, const std::string& browser) {
  const MatchingRecord& match = one.match;
  json changes = json::array();
  for (const MatchingChange& change : match.changes) {
    json text = {{"s", change.seconds}, {"step", change.step}, {"action", change.action}};
    if (!change.slider.empty()) text["slider"] = change.slider;
    if (change.value) text["value"] = *change.value;
    if (change.d) text["d"] = *change.d;
    changes.push_back(text);
  }
  return {{"record", "trial-" + std::to_string(one.trial.number)},
          {"session", browser},
          {"responses", json::array()},
          {"comment", ""},
          {"started_at", "2026-01-31T09:00:00.000Z"},
          {"trial_ms", 90000},
          {"matching",
           {{"first", as_json(match.first)},
            {"last", as_json(match.last)},
            {"first_guess_d", match.first_guess_d},
            {"guess_s", match.guess_s},
            {"d", match.d},
            {"time_s", match.time_s},
            {"success", match.success},
            {"attempt", match.attempt},
            {"changes", changes}}}};
}

json consent_of(const std::string& browser) {
  return {{"record", "consent"},
          {"session", browser},
          {"responses", {{{"item", "consent"}, {"value_raw", "agreed"}}}},
          {"comment", ""},
          {"started_at", "2026-01-31T09:00:00.000Z"}};
}

/// A served experiment of two participants, asked without a network.
class MatchingService : public testing::Test {
 protected:
  MatchingService()
      : manifest_(served_manifest()),
        motions_(manifest_),
        made_(matching_study(manifest_, motions_)),
        trials_(simulated_matching(manifest_, motions_, made_)) {
    make_folder(folder_.path() / "pages");
    write_file(folder_.path() / "pages/index.html",
               "<meta name=\"mien-mode\" content=\"static\"><p>a page</p>");
    study_ = served_matching(std::move(made_), folder_.path() / "pages");
    store_.emplace(folder_.path() / "answers.db");
    service_.emplace(study_, *store_, ServiceRates{}, [] { return 1'800'000'000; });
  }

  HttpResponse ask(const std::string& method, const std::string& target, const json& body = {}) {
    return service_->answer({.method = method,
                             .path = plain_path(target).value(),
                             .headers = {{"content-type", "application/json"}, {"host", "here:80"}},
                             .body = body.is_null() ? "" : body.dump(),
                             .address = "127.0.0.1"});
  }
  std::string of(int session) {
    return "/s/" + service_->sessions().state(session).session.link + "/";
  }
  HttpResponse give(int session, const json& record) {
    return ask("POST", of(session) + "records/" + record.at("record").get<std::string>(), record);
  }
  std::vector<MatchedTrial> trials_of(const std::string& participant) const {
    std::vector<MatchedTrial> own;
    for (const MatchedTrial& one : trials_)
      if (one.participant == participant) own.push_back(one);
    return own;
  }

  const Manifest manifest_;
  Motions motions_;
  MatchingStudy made_;
  const std::vector<MatchedTrial> trials_;
  test::TemporaryFolder folder_;
  ServedStudy study_;
  std::optional<SessionStore> store_;
  std::optional<QuestionnaireService> service_;
};

TEST_F(MatchingService, KeepsTrialsOfEachParticipantByThemselves) {
  ASSERT_EQ(give(0, consent_of("a1b2")).status, 200);
  for (const MatchedTrial& one : trials_of("p001"))
    ASSERT_EQ(give(0, page_record_of(one, "a1b2")).status, 200) << one.trial.number;
  const json other = json::parse(ask("GET", of(1) + "session.json").body);
  EXPECT_EQ(other.at("kept"), json::array());
  EXPECT_EQ(other.at("sessions").size(), 1u);
  EXPECT_EQ(other.dump().find("p001"), std::string::npos);
  EXPECT_TRUE(store_->records_of(1).empty());
  EXPECT_EQ(store_->records_of(0).size(), 1u + trials_of("p001").size());
}

TEST_F(MatchingService, ChangesNothingThatWasGiven) {
  give(0, consent_of("a1b2"));
  const MatchedTrial first = trials_of("p001").front();
  ASSERT_EQ(give(0, page_record_of(first, "a1b2")).status, 200);
  const std::string before = trials_csv(study_, service_->sessions());
  json slower = page_record_of(first, "a1b2");
  slower["matching"]["guess_s"] = 25.0;
  EXPECT_EQ(give(0, slower).status, 409);
  EXPECT_EQ(give(0, page_record_of(first, "other")).status, 409);
  EXPECT_EQ(ask("DELETE", of(0) + "records/trial-1").status, 405);
  EXPECT_EQ(trials_csv(study_, service_->sessions()), before);
}

TEST_F(MatchingService, TakesNoTrialOfAnotherPlan) {
  give(1, consent_of("a1b2"));
  // The first trial of the other participant has another interface or target.
  const MatchedTrial foreign = trials_of("p001").front(), own = trials_of("p002").front();
  ASSERT_NE(foreign.trial.stimuli.front() + foreign.trial.items.front().item,
            own.trial.stimuli.front() + own.trial.items.front().item);
  EXPECT_EQ(give(1, page_record_of(foreign, "a1b2")).status, 400);
  EXPECT_EQ(store_->records_of(1).size(), 1u);
}

TEST_F(MatchingService, AnswersMotionsByALinkAlone) {
  EXPECT_EQ(ask("GET", of(0) + "live/info").status, 200);
  EXPECT_EQ(ask("GET", "/s/" + std::string(32, 'a') + "/live/info").status, 404);
  EXPECT_EQ(ask("GET", "/live/info").status, 404);
}

}  // namespace
}  // namespace mien::pipeline
