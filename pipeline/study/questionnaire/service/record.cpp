#include "pipeline/study/questionnaire/service/record.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pipeline/manifest/continuous.h"
#include "pipeline/manifest/ratings/answers/trace.h"
#include "pipeline/study/questionnaire/adaptive_part.h"
#include "pipeline/study/questionnaire/service/record_reader.h"
#include "pipeline/study/questionnaire/service/screening_record.h"
#include "pipeline/study/thresholds/track_json.h"

namespace mien::pipeline {

std::string table_text(std::string text) {
  for (char& character : text) {
    const auto code = static_cast<unsigned char>(character);
    if ((code < 0x20 && character != '\n' && character != '\t') || code == 0x7f) character = ' ';
  }
  return text;
}

namespace {

ItemResponse read_response(const nlohmann::json& text) {
  RecordReader reader(text, "a response");
  ItemResponse response;
  response.item = reader.text("item", max_name_characters * 4);
  const nlohmann::json& raw = reader.required("value_raw");
  if (raw.is_string()) {
    response.value_raw = reader.text("value_raw", longest_trace_text());
    const bool is_trace = response.value_raw.find_first_not_of("0123456789. ") == std::string::npos;
    if (!is_trace) reader.text("value_raw", max_comment_characters);
  } else if (raw.is_number() && std::isfinite(raw.get<double>())) {
    response.is_number = true;
    response.value_raw = shortest(raw.get<double>());
  } else {
    throw RecordFault("\"value_raw\" is neither a number nor a text");
  }
  response.rt_ms = reader.amount("rt_ms", max_ms);
  reader.finish();
  return response;
}

/// More stimuli than any trial shows.
constexpr std::size_t most_media = 16;

std::vector<std::string> read_hashes(const nlohmann::json* list) {
  std::vector<std::string> hashes;
  if (list == nullptr) return hashes;
  if (!list->is_array() || list->size() > most_media)
    throw RecordFault(fmt::format("\"media_sha256\" is not a list of at most {}", most_media));
  for (const nlohmann::json& one : *list) {
    if (!one.is_string() || one.get_ref<const std::string&>().size() > 64)
      throw RecordFault("\"media_sha256\" contains an invalid hash");
    hashes.push_back(one.get<std::string>());
  }
  return hashes;
}

/// Values in one line each; those that are empty are left out.
std::map<std::string, std::string> read_url_parameters(const nlohmann::json* values) {
  std::map<std::string, std::string> read;
  if (values == nullptr) return read;
  RecordReader reader(*values, "\"url_parameters\"");
  for (const auto& [name, unused] : values->items()) {
    std::string value = table_text(reader.text(name.c_str(), max_parameter_characters));
    std::ranges::replace_if(
        value, [](char one) { return one == '\n' || one == '\t'; }, ' ');
    if (!value.empty()) read[name] = std::move(value);
  }
  return read;
}

std::optional<ConsentText> read_consent(const nlohmann::json* text) {
  if (text == nullptr) return std::nullopt;
  RecordReader reader(*text, "\"consent\"");
  ConsentText consent{.version = reader.text("version", max_name_characters * 2),
                      .sha256 = reader.text("sha256", max_name_characters)};
  reader.finish();
  return consent;
}

/// The consent text of an experiment, or of what it shows in another language.
ConsentText consent_of(const nlohmann::ordered_json& shown) {
  const auto consent = shown.find("consent");
  if (consent == shown.end()) return {};
  return {consent->at("version"), consent->at("sha256")};
}

const std::string& hash_at(const std::map<std::string, std::string>& hashes,
                           const std::string& stimulus) {
  static const std::string none;
  const auto found = hashes.find(stimulus);
  return found == hashes.end() ? none : found->second;
}

AnswerRow row_of_trial(const QuestionnaireFacts& facts, const SessionPlan& plan, const Trial& trial,
                       const PageRecord& record) {
  AnswerRow row = record.measured;
  row.participant = plan.participant;
  row.session = record.session;
  set_trial_columns(trial, row);
  row.stimulus_sha256 = hash_at(facts.sha256, row.stimulus);
  row.seed = plan.seed;
  row.design = facts.design;
  row.simulated = facts.simulated;
  return row;
}

/// Rows without answers, of a trial whose stimuli could not be played.
std::vector<AnswerRow> rows_left_out(const QuestionnaireFacts& facts, const SessionPlan& plan,
                                     const Trial& trial, const PageRecord& record) {
  std::vector<AnswerRow> rows;
  for (const TrialItem& asked : trial.items) {
    AnswerRow row = row_of_trial(facts, plan, trial, record);
    row.item = asked.item;
    if (trial.kind == &grid_trials)
      trial.kind->complete(question_of(facts, plan, trial, asked), row);
    row.pole_left.clear();
    row.stimulus_sha256 = hash_at(facts.sha256, row.stimulus);
    if (rows.empty()) row.comment = table_text(record.comment);
    rows.push_back(std::move(row));
  }
  return rows;
}

void add_response(const QuestionnaireFacts& facts, const SessionPlan& plan, const Trial& trial,
                  const ItemResponse& response, AnswerRow& row) {
  row.item = response.item;
  row.value_raw = table_text(response.value_raw);
  row.value = row.value_raw;
  row.rt_ms = response.rt_ms;
  if (trial.is_attention_check()) {
    row.passed = response.value_raw == trial.expected;
    return;
  }
  const auto asked = std::ranges::find(trial.items, response.item, &TrialItem::item);
  trial.kind->complete(question_of(facts, plan, trial, *asked), row);
  row.stimulus_sha256 = hash_at(facts.sha256, row.stimulus);
}

}  // namespace

Question question_of(const QuestionnaireFacts& facts, const SessionPlan& plan, const Trial& trial,
                     const TrialItem& item) {
  return {trial, item, find_scale(facts.scales, item.item),
          plan.choices.empty() ? facts.choices : plan.choices};
}

QuestionnaireFacts questionnaire_facts(const nlohmann::ordered_json& experiment) {
  QuestionnaireFacts facts;
  facts.design = experiment.at("design");
  facts.simulated = experiment.value("simulated", false);
  for (const auto& [id, item] : experiment.at("items").items()) {
    facts.scales[id] = {.points = item.at("points"),
                        .slider = item.value("slider", false),
                        .words = item.value("words", false),
                        .least = item.at("least"),
                        .most = item.at("most"),
                        .low = item.value("low", ""),
                        .high = item.value("high", ""),
                        .ties = item.value("ties", false),
                        .strength = item.value("strength", false)};
    if (const auto continuous = item.find("continuous"); continuous != item.end()) {
      facts.scales[id].lead_s = continuous->at("lead");
      facts.scales[id].starts_low =
          continuous->at("start") == word_of(trace_start_words, TraceStart::low);
    }
  }
  if (const auto choices = experiment.find("choices"); choices != experiment.end())
    for (const auto& [id, shown] : choices->items()) facts.choices.push_back(id);
  if (const auto matching = experiment.find("matching"); matching != experiment.end())
    facts.matching = matching_facts(*matching);
  if (experiment.contains("chains")) facts.chains = chain_facts(experiment);
  for (const auto& question : experiment.at("demographics")) {
    DemographicQuestion asked{.id = question.at("id"),
                              .required = question.value("required", false)};
    const auto& answer = question.at("answer");
    if (answer.is_array()) asked.choices = answer.get<std::vector<std::string>>();
    asked.is_number = answer == "number";
    facts.questions.push_back(asked);
  }
  facts.consents[experiment.value("language", "en")] = consent_of(experiment);
  if (const auto languages = experiment.find("languages"); languages != experiment.end())
    for (const auto& [language, shown] : languages->items())
      if (!shown.empty()) facts.consents[language] = consent_of(shown);
  if (const auto adaptive = experiment.find("adaptive"); adaptive != experiment.end())
    facts.tracks = procedure_of(*adaptive);
  facts.screening = screening_of(experiment);
  if (const auto found = experiment.find("recruitment"); found != experiment.end()) {
    facts.recruitment.url_parameters = found->at("url_parameters");
    facts.recruitment.pseudonymise = found->at("pseudonymise");
    facts.recruitment.most_failed_checks = found->at("most_failed_checks");
  }
  const auto& media = experiment.at("media");
  for (const auto& [token, stimulus] : experiment.at("stimuli").items()) {
    facts.sha256[stimulus.get<std::string>()] = media.at(token).at("sha256");
    facts.seconds[stimulus.get<std::string>()] = media.at(token).value("seconds", 0.0);
  }
  return facts;
}

PageRecord read_record(const nlohmann::json& text) {
  RecordReader reader(text, "the record");
  PageRecord record;
  record.name = reader.name("record");
  record.session = reader.name("session");
  const nlohmann::json& responses = reader.required("responses");
  if (!responses.is_array()) throw RecordFault("\"responses\" is not a list");
  for (const nlohmann::json& response : responses)
    record.responses.push_back(read_response(response));
  record.comment = reader.text("comment", max_comment_characters);
  record.started_at = reader.text("started_at", max_name_characters);
  record.measured.replays = reader.count("replays");
  record.measured.attempt = reader.count("attempt");
  record.measured.plays_before = reader.count("plays_before");
  record.measured.watched_before_ms = reader.amount("watched_before_ms", max_ms);
  record.measured.play_fault = reader.text("play_fault", max_name_characters);
  record.measured.trial_ms = reader.amount("trial_ms", max_ms);
  record.measured.play_start_ms = reader.amount("play_start_ms", max_ms);
  record.measured.ended_ms = reader.amount("ended_ms", max_ms);
  record.measured.stalls = reader.count("stalls");
  record.measured.stall_ms = reader.amount("stall_ms", max_ms);
  record.measured.dropped_frames = reader.count("dropped_frames");
  record.measured.volume_events = table_text(reader.text("volume_events", max_comment_characters));
  record.measured.blurs = reader.count("blurs");
  record.measured.blur_ms = reader.amount("blur_ms", max_ms);
  record.measured.viewport_width = reader.count("viewport_width");
  record.measured.viewport_height = reader.count("viewport_height");
  record.measured.refresh_hz = reader.amount("refresh_hz", 10'000);
  record.measured.shown_width = reader.amount("shown_width", max_count);
  record.measured.shown_height = reader.amount("shown_height", max_count);
  record.measured.pixel_ratio = reader.amount("pixel_ratio", max_count);
  record.measured.shown_cm = reader.amount("shown_cm", max_count);
  record.measured.shown_degrees = reader.amount("shown_degrees", 180.0);
  record.measured.viewing_cm = reader.amount("viewing_cm", max_count);
  record.url_parameters = read_url_parameters(reader.find("url_parameters"));
  record.consent = read_consent(reader.find("consent"));
  if (reader.find("language") != nullptr) record.language = reader.name("language");
  record.media_sha256 = read_hashes(reader.find("media_sha256"));
  record.level = reader.count("level");
  if (reader.find("track_ended") != nullptr) record.is_track_ended = reader.boolean("track_ended");
  if (const nlohmann::json* matching = reader.find("matching"))
    record.matching = read_matching_record(*matching);
  if (const nlohmann::json* chain = reader.find("chain")) record.chain = read_chain_record(*chain);
  reader.finish();
  return record;
}

std::vector<std::string> record_names(const SessionPlan& plan, const QuestionnaireFacts& facts) {
  std::vector<std::string> names = {"consent"};
  if (!facts.screening.empty()) names.push_back("screening");
  if (!facts.questions.empty()) names.push_back("demographics");
  for (const Trial& trial : plan.trials) names.push_back(fmt::format("trial-{}", trial.number));
  names.push_back("ending");
  return names;
}

Trial shown_trial(const QuestionnaireFacts& facts, const Trial& trial, const PageRecord& record) {
  if (!trial.is_adaptive() || !record.level || !facts.tracks) return trial;
  return shown_at(trial, static_cast<std::size_t>(*record.level), facts.tracks->levels);
}

std::vector<AnswerRow> rows_of(const QuestionnaireFacts& facts, const SessionPlan& plan,
                               const Trial& planned, const PageRecord& record) {
  if (record.is_track_ended) return {};
  const Trial trial = shown_trial(facts, planned, record);
  std::vector<AnswerRow> rows;
  if (!record.measured.play_fault.empty()) return rows_left_out(facts, plan, trial, record);
  for (const ItemResponse& response : record.responses) {
    AnswerRow row = row_of_trial(facts, plan, trial, record);
    add_response(facts, plan, trial, response, row);
    if (rows.empty()) row.comment = table_text(record.comment);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace mien::pipeline
