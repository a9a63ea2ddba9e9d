// Records of adaptive trials: the level that they show must follow from the earlier answers.

#include "pipeline/study/questionnaire/service/track_check.h"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/questionnaire/adaptive_part.h"
#include "pipeline/study/questionnaire/experiment/experiment.h"
#include "pipeline/study/questionnaire/service/record_check.h"
#include "pipeline/study/questionnaire/service/service.h"
#include "pipeline/study/thresholds/dose_study.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

MediaFiles media_for(const Manifest& manifest) {
  MediaFiles media;
  for (const std::string& id : questionnaire_stimuli(manifest))
    media[id] = {.token = media_token(manifest, id),
                 .ending = ".mp4",
                 .type = "video/mp4",
                 .sha256 = fmt::format("{:0>64}", id),
                 .seconds = 2.0};
  return media;
}

ServedStudy adaptive_study(const std::string& form, const std::string& more) {
  const Manifest manifest = mien::test::dose_study(mien::test::adaptive_members(form, more));
  ServedStudy study{.plans = plan_sessions(manifest)};
  study.experiment = experiment_json(manifest, study.plans, media_for(manifest));
  study.facts = questionnaire_facts(study.experiment);
  return study;
}

/// A served study that is answered trial after trial by a page that chooses the levels itself.
class TrackRecords {
 public:
  TrackRecords(const std::string& form, const std::string& more)
      : study_(adaptive_study(form, more)), levels_(*study_.facts.tracks) {}

  const SessionPlan& plan() const { return study_.plans.at(0); }

  nlohmann::json empty_record(const std::string& name) const {
    return {{"record", name},
            {"session", "a1b2"},
            {"comment", ""},
            {"responses", nlohmann::json::array()},
            {"started_at", "2026-01-01T00:00:00Z"}};
  }

  /// The record of a trial that was shown at a level and answered.
  nlohmann::json shown_record(const Trial& trial, std::size_t place, const std::string& raw) const {
    nlohmann::json record = empty_record(fmt::format("trial-{}", trial.number));
    record["responses"] = {{{"item", trial.items.at(0).item}, {"value_raw", raw}, {"rt_ms", 700}}};
    Trial shown = trial;
    if (trial.is_adaptive()) {
      shown = shown_at(trial, place, study_.facts.tracks->levels);
      record["level"] = place;
    }
    for (const std::string& id : shown.stimuli)
      record["media_sha256"].push_back(study_.facts.sha256.at(id));
    return record;
  }

  /// What a page that behaves well gives, with positive answers to levels from `seen` on.
  nlohmann::json record_of(const Trial& trial, std::size_t seen) const {
    if (!trial.is_adaptive()) return shown_record(trial, 0, "no");
    const auto place = place_of(trial);
    if (!place) {
      nlohmann::json ended = empty_record(fmt::format("trial-{}", trial.number));
      ended["track_ended"] = true;
      return ended;
    }
    return shown_record(trial, *place, *place >= seen ? trial.adaptive.positive : "no");
  }

  std::optional<std::size_t> place_of(const Trial& trial) const {
    return levels_.next(track_answers(plan(), trial, kept_));
  }

  void keep(const nlohmann::json& record) { kept_.push_back(read_record(record)); }

  /// Why the server refuses a record; empty if it does not.
  std::string refusal(const nlohmann::json& text) const {
    try {
      const PageRecord record = read_record(text);
      check_record(study_.facts, plan(), record);
      check_level_shown(study_.facts, plan(), record, kept_);
    } catch (const RecordFault& fault) {
      return fault.what();
    }
    return "";
  }

  const ServedStudy& study() const { return study_; }
  const std::vector<PageRecord>& kept() const { return kept_; }

 private:
  ServedStudy study_;
  TrackLevels levels_;
  std::vector<PageRecord> kept_;
};

TEST(TracksOfRecords, AreTakenOnlyAtTheLevelThatFollows) {
  for (const char* more : {"factor: dose, trials: 12, tracks: 2",
                           "factor: dose, trials: 12, tracks: 2, method: staircase, down: 1"}) {
    TrackRecords page("yes_no", more);
    int refused = 0;
    for (const Trial& trial : page.plan().trials) {
      const nlohmann::json good = page.record_of(trial, 3);
      ASSERT_EQ(page.refusal(good), "") << more << trial.number;
      for (std::size_t place = 0; trial.is_adaptive() && place < 6; ++place) {
        if (place == page.place_of(trial)) continue;
        EXPECT_EQ(page.refusal(page.shown_record(trial, place, "no")),
                  "the level shown does not follow from the answers so far")
            << more << trial.number << "/" << place;
        ++refused;
      }
      page.keep(good);
    }
    EXPECT_EQ(refused, 2 * 12 * 5);
  }
}

TEST(TracksOfRecords, StateALevelAndShowItsFilms) {
  TrackRecords page("yes_no", "factor: dose, trials: 12");
  const auto trial = std::ranges::find_if(page.plan().trials, &Trial::is_adaptive);
  const std::size_t place = page.place_of(*trial).value();
  const nlohmann::json good = page.shown_record(*trial, place, "yes");
  ASSERT_EQ(page.refusal(good), "");
  nlohmann::json text = good;
  text.erase("level");
  EXPECT_NE(page.refusal(text).find("level"), std::string::npos);
  text = good;
  text["level"] = 6;
  EXPECT_EQ(page.refusal(text), "there is no level 6");
  text["level"] = 1.5;
  EXPECT_NE(page.refusal(text), "");
  text = good;
  text["media_sha256"] = page.shown_record(*trial, (place + 1) % 6, "yes")["media_sha256"];
  EXPECT_EQ(page.refusal(text), "the media shown were not those of this trial");
  text = good;
  text["responses"][0]["value_raw"] = "perhaps";
  EXPECT_NE(page.refusal(text), "");
  text = good;
  text["track_ended"] = true;
  EXPECT_NE(page.refusal(text), "");
  // Trials without the signal, and pages without trials, have no levels.
  const auto noise = std::ranges::find_if_not(page.plan().trials, &Trial::is_adaptive);
  text = page.shown_record(*noise, 0, "no");
  EXPECT_EQ(page.refusal(text), "");
  text["level"] = 0;
  EXPECT_EQ(page.refusal(text), "this trial has no levels");
  text = page.empty_record("ending");
  text["level"] = 0;
  EXPECT_EQ(page.refusal(text), "this page has no trial");
}

void expect_skipped_only_where_the_track_has_ended(const char* more) {
  TrackRecords page("yes_no", more);
  int skipped = 0;
  for (const Trial& trial : page.plan().trials) {
    nlohmann::json ended = page.empty_record(fmt::format("trial-{}", trial.number));
    ended["track_ended"] = true;
    const bool has_ended = trial.is_adaptive() && !page.place_of(trial);
    EXPECT_EQ(page.refusal(ended).empty(), has_ended) << trial.number;
    if (has_ended) {
      EXPECT_EQ(page.refusal(page.shown_record(trial, 2, "no")),
                "the track of this trial has ended");
    }
    const nlohmann::json good = page.record_of(trial, 3);
    ASSERT_EQ(page.refusal(good), "");
    page.keep(good);
    skipped += has_ended ? 1 : 0;
    EXPECT_EQ(rows_of(page.study().facts, page.plan(), trial, page.kept().back()).size(),
              has_ended ? 0u : 1u);
  }
  EXPECT_GT(skipped, 15) << more;
}

TEST(TracksOfRecords, AreSkippedWhereTheTrackHasEndedAndOnlyThere) {
  expect_skipped_only_where_the_track_has_ended(
      "factor: dose, trials: 30, method: staircase, down: 1, reversals: 3");
  expect_skipped_only_where_the_track_has_ended("factor: dose, until: {sd: 0.6, at_most: 40}");
}

TEST(TracksOfRecords, WhoseFilmsCouldNotBePlayedDoNotMoveTheTrack) {
  TrackRecords page("yes_no", "factor: dose, trials: 12, method: staircase, down: 1");
  std::vector<Trial> track;
  std::ranges::copy_if(page.plan().trials, std::back_inserter(track), &Trial::is_adaptive);
  EXPECT_EQ(page.place_of(track[0]), 5u);
  nlohmann::json left_out = page.shown_record(track[0], 5, "yes");
  left_out["responses"] = nlohmann::json::array();
  left_out["play_fault"] = "stalled";
  ASSERT_EQ(page.refusal(left_out), "");
  page.keep(left_out);
  EXPECT_EQ(page.place_of(track[1]), 5u);
  const auto rows = rows_of(page.study().facts, page.plan(), track[0], page.kept().back());
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].value, "");
  EXPECT_EQ(rows[0].level, "3");
}

TEST(TracksOfRecords, BecomeRowsWithLevelAndTrack) {
  TrackRecords page("two_interval", "factor: dose, trials: 12, tracks: 2");
  const Trial& trial = page.plan().trials.at(1);
  const std::size_t place = page.place_of(trial).value();
  const auto rows = rows_of(page.study().facts, page.plan(), trial,
                            read_record(page.shown_record(trial, place, trial.adaptive.positive)));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].level, page.study().facts.tracks->levels[place]);
  EXPECT_EQ(rows[0].track, trial.adaptive.track);
  EXPECT_EQ(rows[0].stimulus, trial.adaptive.by_level[place][0]);
  EXPECT_EQ(rows[0].against, trial.adaptive.by_level[place][1]);
  // The right answer names the stimulus with the signal, the one that is not neutral.
  EXPECT_EQ(rows[0].value.substr(1), std::to_string(place + 1));
  EXPECT_EQ(rows[0].stimulus_sha256, page.study().facts.sha256.at(rows[0].stimulus));
}

TEST(ServedTracks, RefuseOtherLevelsAndTellTheAnswersAfterAReload) {
  const TrackRecords page("yes_no", "factor: dose, trials: 5, noise: 0.3");
  mien::test::TemporaryFolder folder;
  SessionStore store(folder.path() / "answers.db");
  QuestionnaireService service(page.study(), store);
  const std::string base = "/s/" + service.sessions().state(0).session.link + "/";
  const auto ask = [&](const std::string& method, const std::string& target,
                       const std::string& body) {
    return service.answer({.method = method,
                           .path = plain_path(target).value(),
                           .headers = {{"content-type", "application/json"}, {"host", "here"}},
                           .body = body,
                           .address = "127.0.0.1"});
  };
  const auto give = [&](const nlohmann::json& record) {
    return ask("POST", base + "records/" + record.at("record").get<std::string>(), record.dump());
  };
  nlohmann::json consent = page.empty_record("consent");
  consent["responses"] = {{{"item", "consent"}, {"value_raw", "agreed"}}};
  ASSERT_EQ(give(consent).status, 200);
  TrackRecords answering("yes_no", "factor: dose, trials: 5, noise: 0.3");
  const auto later = std::ranges::find(answering.plan().trials, 2, &Trial::number);
  EXPECT_EQ(give(answering.shown_record(*later, 0, "no")).status, 409) << "out of order";
  nlohmann::json answered = nlohmann::json::object();
  for (const Trial& trial : answering.plan().trials) {
    const auto place = answering.place_of(trial);
    if (trial.is_adaptive()) {
      const HttpResponse refused = give(answering.shown_record(trial, (*place + 1) % 6, "no"));
      EXPECT_EQ(refused.status, 400);
      EXPECT_NE(refused.body.find("does not follow"), std::string::npos) << refused.body;
    }
    const nlohmann::json good = answering.record_of(trial, 3);
    ASSERT_EQ(give(good).status, 200) << trial.number;
    EXPECT_EQ(give(good).status, 200) << "given again";
    answering.keep(good);
    if (trial.is_adaptive())
      answered[fmt::format("trial-{}", trial.number)] = {{"place", *place},
                                                         {"positive", *place >= 3}};
    const auto told = nlohmann::json::parse(ask("GET", base + "session.json", "").body);
    EXPECT_EQ(told.at("answered"), answered);
    EXPECT_EQ(told.at("adaptive").at("levels").size(), 6u);
    EXPECT_EQ(told.at("media").size(), 14u) << "films of all levels";
  }
}

}  // namespace
}  // namespace mien::pipeline
