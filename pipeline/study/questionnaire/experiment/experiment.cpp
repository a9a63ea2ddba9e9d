#include "pipeline/study/questionnaire/experiment/experiment.h"

#include <nlohmann/json.hpp>

#include "motion/text/words.h"
#include "pipeline/base/documents/sha256.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

/// The label of an end in the language of the questionnaire, or in English where there is none.
const std::string& end_label(const std::string& english, const std::string& japanese,
                             InterfaceLanguage language) {
  return language == InterfaceLanguage::japanese && !japanese.empty() ? japanese : english;
}

ordered_json items_json(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  ordered_json items = ordered_json::object();
  for (const Scale& scale : questionnaire_scales(manifest).scales) {
    const ordered_json start =
        asked.answer.starts_at == StartsAt::middle ? ordered_json("middle") : ordered_json(nullptr);
    items[scale.id] = {{"low", end_label(scale.low, scale.japanese_low, asked.language)},
                       {"high", end_label(scale.high, scale.japanese_high, asked.language)},
                       {"points", asked.answer.points},
                       {"slider", asked.answer.slider},
                       {"words", asked.answer.words},
                       {"anchors", asked.answer.anchors},
                       {"default", start},
                       {"least", scale.least},
                       {"most", scale.most}};
    if (!asked.answer.suggest.empty()) items[scale.id]["suggest"] = asked.answer.suggest;
    if (asked.preference.ties) items[scale.id]["ties"] = true;
    if (asked.preference.strength) items[scale.id]["strength"] = true;
  }
  return items;
}

ordered_json choices_json(const Manifest& manifest) {
  ordered_json choices = ordered_json::object();
  if (!questionnaire_of(manifest).trials->offers_choices) return choices;
  for (const auto& [id, text] : questionnaire_choices(manifest)) choices[id] = text;
  return choices;
}

ordered_json settings_json(const Questionnaire& asked) {
  ordered_json replays = "counted";
  if (asked.replays.most)
    replays = *asked.replays.most == 0 ? ordered_json("none") : ordered_json(*asked.replays.most);
  ordered_json settings = {{"replays", replays},
                           {"watch", word_of(watching_words, asked.watch)},
                           {"comments", asked.comments},
                           {"phones", word_of(phones_words, asked.phones)},
                           {"view", word_of(shown_as_words, asked.view)},
                           {"question", asked.question}};
  if (asked.display.size.kind != DisplaySize::Kind::window)
    settings["display"] = {{"size", DisplaySizeForm::write(asked.display.size, {})},
                           {"distance_cm", asked.display.distance_cm}};
  if (const PairPresentation shown = pair_presentation(asked); shown != PairPresentation::together)
    settings["pairs"] = word_of(pair_presentation_words, shown);
  return settings;
}

/// What the page needs to know of the recruitment; null if there is none.
ordered_json recruitment_json(const Questionnaire& asked) {
  const Recruitment& recruitment = asked.recruitment;
  if (recruitment == Recruitment()) return nullptr;
  ordered_json ends = ordered_json::object();
  for (const auto& [word, end] : session_end_words)
    if (const std::string address = address_after(recruitment, end); !address.empty())
      ends[word] = {{"address", address}, {"code", recruitment.prolific.of(end)}};
  return {{"url_parameters", kept_parameters(recruitment)},
          {"pseudonymise", recruitment.pseudonymise},
          {"most_failed_checks", asked.analysis.max_failed_checks},
          {"ends", std::move(ends)}};
}

/// The version and hash of the consent; null if there is none.
ordered_json consent_json(const Questionnaire& asked) {
  if (asked.consent.empty()) return nullptr;
  return {{"version", asked.consent_version}, {"sha256", sha256_of(asked.consent.text)}};
}

ordered_json trial_json(const Manifest& manifest, const Trial& trial) {
  ordered_json media = ordered_json::array();
  for (const std::string& stimulus : trial.stimuli)
    media.push_back(media_token(manifest, stimulus));
  ordered_json items = ordered_json::array();
  for (const TrialItem& asked : trial.items)
    items.push_back({{"item", asked.item}, {"flipped", asked.flipped}});
  return {{"number", trial.number},
          {"block", trial.block},
          {"kind", trial.kind_name()},
          {"media", media},
          {"reference",
           trial.reference.empty() ? std::string() : media_token(manifest, trial.reference)},
          {"items", items},
          {"practice", trial.practice},
          {"warm_up", trial.warm_up},
          {"check", trial.is_check},
          {"expected", trial.expected}};
}

/// Seeds are written as strings: 64 bits do not fit JavaScript's numbers.
ordered_json sessions_json(const Manifest& manifest, const std::vector<SessionPlan>& plans) {
  ordered_json sessions = ordered_json::array();
  for (const SessionPlan& plan : plans) {
    ordered_json trials = ordered_json::array();
    for (const Trial& trial : plan.trials) trials.push_back(trial_json(manifest, trial));
    sessions.push_back({{"participant", plan.participant},
                        {"seed", std::to_string(plan.seed)},
                        {"choices", plan.choices},
                        {"trials", trials}});
  }
  return sessions;
}

/// Sorted by token, so that their order does not reveal the stimuli.
void add_media(ordered_json& experiment, const MediaFiles& media) {
  std::map<std::string, std::pair<std::string, const MediaFile*>> by_token;
  for (const auto& [stimulus, file] : media) by_token[file.token] = {stimulus, &file};
  ordered_json files = ordered_json::object();
  ordered_json stimuli = ordered_json::object();
  for (const auto& [token, shown] : by_token) {
    const MediaFile& file = *shown.second;
    files[token] = {{"file", "media/" + token + file.ending},
                    {"type", file.type},
                    {"sha256", file.sha256},
                    {"seconds", file.seconds},
                    {"width", file.width},
                    {"height", file.height}};
    if (file.has_sound) files[token]["sound"] = true;
    stimuli[token] = shown.first;
  }
  experiment["media"] = std::move(files);
  experiment["stimuli"] = std::move(stimuli);
}

}  // namespace

std::vector<std::string> paragraphs_of(std::string_view text, InterfaceLanguage language) {
  std::vector<std::string> paragraphs;
  std::string current;
  const auto put = [&] {
    if (!current.empty()) paragraphs.push_back(std::move(current));
    current.clear();
  };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.remove_suffix(1);
    while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
    if (line.empty()) {
      put();
      continue;
    }
    // Japanese is written without spaces.
    if (!current.empty() && language != InterfaceLanguage::japanese) current += ' ';
    current += line;
  }
  put();
  return paragraphs;
}

ordered_json demographics_json(const std::vector<Demographic>& demographics) {
  ordered_json questions = ordered_json::array();
  for (const Demographic& one : demographics) {
    ordered_json answer = one.answer.is_number ? "number" : "text";
    if (!one.answer.choices.empty()) answer = one.answer.choices;
    questions.push_back(
        {{"id", one.id}, {"ask", one.ask}, {"answer", answer}, {"required", one.required}});
  }
  return questions;
}

ordered_json experiment_json(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                             const MediaFiles& media) {
  const Questionnaire& asked = questionnaire_of(manifest);
  const auto texts_of = [&](const TextSource& source) {
    return paragraphs_of(source.text, asked.language);
  };
  ordered_json experiment = {{"format", "mien-questionnaire-1"},
                             {"study", manifest.study},
                             {"title", title_of(manifest)},
                             {"language", word_of(language_words, asked.language)},
                             {"design", design_hash(manifest, plans)},
                             {"simulated", false},
                             {"texts",
                              {{"consent", texts_of(asked.consent)},
                               {"instructions", texts_of(asked.instructions)},
                               {"debriefing", texts_of(asked.debriefing)},
                               {"ending", texts_of(asked.ending)}}},
                             {"settings", settings_json(asked)},
                             {"items", items_json(manifest)},
                             {"choices", choices_json(manifest)},
                             {"demographics", demographics_json(asked.demographics)},
                             {"sessions", sessions_json(manifest, plans)}};
  if (ordered_json consent = consent_json(asked); !consent.is_null())
    experiment["consent"] = std::move(consent);
  if (!asked.screening.empty())
    experiment["screening"] = written(asked.screening, WritingOptions{});
  if (ordered_json recruitment = recruitment_json(asked); !recruitment.is_null())
    experiment["recruitment"] = std::move(recruitment);
  add_media(experiment, media);
  return experiment;
}

}  // namespace mien::pipeline
