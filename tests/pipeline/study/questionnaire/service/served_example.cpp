#include "pipeline/study/questionnaire/service/served_example.h"

#include <fstream>

#include <fmt/format.h>

#include "pipeline/study/questionnaire/service/record_check.h"

namespace mien::pipeline {

namespace {

std::string token_of_stimulus(const std::string& stimulus) {
  return "m" + std::to_string(std::hash<std::string>()(stimulus) % 1'000'000 + 1'000'000);
}

Trial rating(int number, const std::string& stimulus, std::vector<TrialItem> items) {
  return {.number = number, .block = "main", .stimuli = {stimulus}, .items = std::move(items)};
}

SessionPlan example_plan(int index, int more) {
  SessionPlan plan{.index = index,
                   .participant = participant_name(index),
                   .seed = 10'000'000'000'000'000'000u + static_cast<std::uint64_t>(index),
                   .choices = {"sad", "happy"}};
  plan.trials = {rating(1, "walk-sad", {{"sad-happy", false}}),
                 rating(2, "walk-happy", {{"sad-happy", true}, {"calm-wild", false}}),
                 rating(3, "walk-sad", {{"words", false}}),
                 {.number = 4,
                  .block = "main",
                  .items = {{"sad-happy", false}},
                  .is_check = true,
                  .expected = "5"},
                 {.number = 5,
                  .block = "main",
                  .kind = &emotion_trials,
                  .stimuli = {"walk-happy"},
                  .items = {{"emotion", false}}},
                 {.number = 6,
                  .block = "main",
                  .kind = &pair_trials,
                  .stimuli = {"walk-happy", "walk-sad"},
                  .items = {{"sad-happy", false}}}};
  plan.trials[0].block = "practice";
  plan.trials[0].practice = true;
  plan.trials[1].reference = "walk-normal";
  for (int count = 0; count < more; ++count)
    plan.trials.push_back(rating(7 + count, "walk-sad", {{"sad-happy", (count + index) % 2 == 0}}));
  return plan;
}

nlohmann::ordered_json session_of(const SessionPlan& plan) {
  nlohmann::ordered_json trials = nlohmann::ordered_json::array();
  for (const Trial& trial : plan.trials) {
    nlohmann::ordered_json media = nlohmann::ordered_json::array();
    for (const std::string& stimulus : trial.stimuli) media.push_back(token_of_stimulus(stimulus));
    nlohmann::ordered_json items = nlohmann::ordered_json::array();
    for (const TrialItem& item : trial.items)
      items.push_back({{"item", item.item}, {"flipped", item.flipped}});
    trials.push_back(
        {{"number", trial.number},
         {"block", trial.block},
         {"kind", trial.kind_name()},
         {"media", std::move(media)},
         {"reference", trial.reference.empty() ? "" : token_of_stimulus(trial.reference)},
         {"items", std::move(items)},
         {"practice", trial.practice},
         {"warm_up", trial.warm_up},
         {"check", trial.is_check},
         {"expected", trial.expected}});
  }
  return {{"participant", plan.participant},
          {"seed", std::to_string(plan.seed)},
          {"choices", plan.choices},
          {"trials", std::move(trials)}};
}

nlohmann::ordered_json item(const std::string& low, const std::string& high, double end) {
  return {{"low", low},         {"high", high},   {"points", 5},
          {"slider", false},    {"words", false}, {"anchors", true},
          {"default", nullptr}, {"least", -end},  {"most", end}};
}

nlohmann::ordered_json example_experiment(const std::vector<SessionPlan>& plans) {
  nlohmann::ordered_json experiment = {
      {"format", "mien-questionnaire-1"},
      {"study", "walks"},
      {"title", "How <do> they walk?"},
      {"language", "en"},
      {"design", "0123abcd"},
      {"simulated", false},
      {"texts", {{"consent", {"Yes?"}}, {"instructions", {}}, {"ending", {}}}},
      {"settings", {{"comments", true}}}};
  experiment["items"] = {{"sad-happy", item("sad", "happy", 2)},
                         {"calm-wild", item("calm", "wild", 3)},
                         {"words", item("", "", 1)}};
  experiment["items"]["calm-wild"]["slider"] = true;
  experiment["items"]["words"]["words"] = true;
  experiment["choices"] = {{"sad", "Sad"}, {"happy", "Happy"}};
  experiment["demographics"] = {
      {{"id", "age"}, {"ask", "How old?"}, {"answer", "number"}, {"required", true}},
      {{"id", "hand"}, {"ask", "Which?"}, {"answer", {"left", "right"}}}};
  for (const char* stimulus : {"walk-sad", "walk-happy", "walk-normal"}) {
    const std::string token = token_of_stimulus(stimulus);
    experiment["media"][token] = {{"file", "media/" + token + ".mp4"},
                                  {"type", "video/mp4"},
                                  {"sha256", fmt::format("{:0>64}", token.substr(1))}};
    experiment["stimuli"][token] = stimulus;
  }
  experiment["sessions"] = nlohmann::ordered_json::array();
  for (const SessionPlan& plan : plans) experiment["sessions"].push_back(session_of(plan));
  return experiment;
}

nlohmann::json response_to(const ServedStudy& study, const Trial& trial, const TrialItem& asked) {
  nlohmann::json value = 1 + trial.number % 5;
  const auto scale = study.facts.scales.find(asked.item);
  if (scale != study.facts.scales.end() && scale->second.slider) value = 70;
  if (scale != study.facts.scales.end() && scale->second.words) value = "a bit, \"tired\"";
  if (trial.is_attention_check()) value = 5;
  if (trial.kind == &emotion_trials) value = "happy";
  if (trial.kind == &pair_trials) value = "right";
  return {{"item", asked.item}, {"value_raw", value}, {"rt_ms", 1200.5}};
}

}  // namespace

ServedStudy example_study(const std::filesystem::path& folder, int participants, int more) {
  ServedStudy study;
  for (int index = 0; index < participants; ++index)
    study.plans.push_back(example_plan(index, more));
  study.experiment = example_experiment(study.plans);
  study.facts = questionnaire_facts(study.experiment);
  for (const auto& [token, stimulus] : study.experiment.at("stimuli").items()) {
    const std::filesystem::path file = folder / (stimulus.get<std::string>() + ".mp4");
    std::ofstream(file) << "film of " << token;
    study.media[token] = {file, "video/mp4"};
  }
  study.page["index.html"] = {"<!doctype html><title>page</title>", "text/html; charset=utf-8"};
  study.page["questionnaire.js"] = {"go();", "text/javascript; charset=utf-8"};
  study.lab["index.html"] = {"<title>lab</title>", "text/html; charset=utf-8"};
  return study;
}

nlohmann::json good_record(const ServedStudy& study, int plan, const std::string& name,
                           const std::string& browser) {
  nlohmann::json record = {{"record", name},
                           {"session", browser},
                           {"responses", nlohmann::json::array()},
                           {"comment", ""},
                           {"started_at", "2026-01-31T09:00:00.000Z"}};
  if (name == "consent") record["responses"] = {{{"item", "consent"}, {"value_raw", "agreed"}}};
  if (name == "demographics")
    record["responses"] = {{{"item", "age"}, {"value_raw", 31}},
                           {{"item", "hand"}, {"value_raw", "left"}}};
  if (name == "ending") record["comment"] = "Nice, \"really\"\a";
  const Trial* trial = trial_of(study.plans.at(static_cast<std::size_t>(plan)), name);
  if (trial == nullptr) return record;
  for (const TrialItem& asked : trial->items)
    record["responses"].push_back(response_to(study, *trial, asked));
  record["replays"] = 1;
  record["trial_ms"] = 8123;
  record["play_start_ms"] = 12;
  record["ended_ms"] = nullptr;
  record["stalls"] = 0;
  record["refresh_hz"] = 59.94;
  record["media_sha256"] = nlohmann::json::array();
  for (const std::string& stimulus : trial->stimuli)
    record["media_sha256"].push_back(study.facts.sha256.at(stimulus));
  return record;
}

}  // namespace mien::pipeline
