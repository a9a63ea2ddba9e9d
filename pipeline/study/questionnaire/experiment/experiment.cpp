#include "pipeline/study/questionnaire/experiment/experiment.h"

#include <array>

#include <nlohmann/json.hpp>

#include "motion/text/words.h"
#include "pipeline/base/documents/sha256.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/study_texts.h"
#include "pipeline/study/questionnaire/simulated_sessions.h"
#include "pipeline/study/thresholds/track_json.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

/// Names of the ends of a scale in a language, or the English ones where there are none.
std::array<std::string, 2> ends_of(const Scale& scale, std::string_view language) {
  return ends_in(scale, language).value_or(std::array{scale.low, scale.high});
}

/// How a scale is rated while a film plays.
void add_continuous(const ContinuousSettings& continuous, ordered_json& item) {
  item["continuous"] = {{"input", word_of(trace_input_words, continuous.input)},
                        {"start", word_of(trace_start_words, continuous.start)},
                        {"lead", continuous.lead},
                        {"speed", continuous.speed}};
}

ordered_json items_json(const Manifest& manifest) {
  const Questionnaire& asked = questionnaire_of(manifest);
  ordered_json items = ordered_json::object();
  for (const Scale& scale : questionnaire_scales(manifest).scales) {
    const ordered_json start =
        asked.answer.starts_at == StartsAt::middle ? ordered_json("middle") : ordered_json(nullptr);
    const auto [low, high] = ends_of(scale, asked.language.first());
    items[scale.id] = {{"low", low},
                       {"high", high},
                       {"points", asked.answer.points},
                       {"slider", has_sliders(asked)},
                       {"words", asked.answer.words},
                       {"anchors", asked.answer.anchors},
                       {"default", start},
                       {"least", scale.least},
                       {"most", scale.most}};
    if (!asked.answer.suggest.words.empty())
      items[scale.id]["suggest"] = asked.answer.suggest.words;
    if (asked.preference.ties) items[scale.id]["ties"] = true;
    if (asked.preference.strength) items[scale.id]["strength"] = true;
    if (asked.trials->is_continuous) add_continuous(asked.continuous, items[scale.id]);
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
  ordered_json replays = asked.trials->is_continuous ? "none" : "counted";
  if (asked.replays.most)
    replays = *asked.replays.most == 0 ? ordered_json("none") : ordered_json(*asked.replays.most);
  ordered_json settings = {{"replays", replays},
                           {"watch", word_of(watching_words, asked.watch)},
                           {"comments", asked.comments},
                           {"phones", word_of(phones_words, asked.phones)},
                           {"view", word_of(shown_as_words, asked.view)},
                           {"question", asked.question.text}};
  if (asked.display.size.kind != DisplaySize::Kind::window)
    settings["display"] = {{"size", DisplaySizeForm::write(asked.display.size, {})},
                           {"distance_cm", asked.display.distance_cm}};
  if (asked.display.blind_spot) settings["display"]["blind_spot"] = true;
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

ordered_json tokens_json(const Manifest& manifest, const std::vector<std::string>& stimuli) {
  ordered_json tokens = ordered_json::array();
  for (const std::string& stimulus : stimuli) tokens.push_back(media_token(manifest, stimulus));
  return tokens;
}

/// What a trial of a track shows at each level, or the level of a trial without the signal.
void add_adaptive(const Manifest& manifest, const Trial& trial, ordered_json& text) {
  if (!trial.level.empty()) text["level"] = trial.level;
  if (!trial.is_adaptive()) return;
  text["track"] = trial.adaptive.track;
  text["positive"] = trial.adaptive.positive;
  for (const std::vector<std::string>& stimuli : trial.adaptive.by_level)
    text["by_level"].push_back(tokens_json(manifest, stimuli));
}

ordered_json trial_json(const Manifest& manifest, const Trial& trial) {
  ordered_json items = ordered_json::array();
  for (const TrialItem& asked : trial.items)
    items.push_back({{"item", asked.item}, {"flipped", asked.flipped}});
  ordered_json text = {
      {"number", trial.number},
      {"block", trial.block},
      {"kind", trial.kind_name()},
      {"media", tokens_json(manifest, trial.stimuli)},
      {"reference",
       trial.reference.empty() ? std::string() : media_token(manifest, trial.reference)},
      {"items", items},
      {"practice", trial.practice},
      {"warm_up", trial.warm_up},
      {"check", trial.is_check},
      {"expected", trial.expected}};
  add_adaptive(manifest, trial, text);
  return text;
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
  std::map<std::string, std::string> figures;  // hashes by token
  for (const auto& [token, shown] : by_token) {
    const MediaFile& file = *shown.second;
    files[token] = {{"file", "media/" + token + file.ending},
                    {"type", file.type},
                    {"sha256", file.sha256},
                    {"seconds", file.seconds},
                    {"width", file.width},
                    {"height", file.height}};
    if (file.has_sound) files[token]["sound"] = true;
    for (const FigureFile& figure : file.figures) {
      files[token]["figures"].push_back(figure.token);
      figures[figure.token] = figure.sha256;
    }
    stimuli[token] = shown.first;
  }
  for (const auto& [token, sha256] : figures)
    files[token] = {{"file", "media/" + token + ".glb"},
                    {"type", glb_type},
                    {"sha256", sha256},
                    {"seconds", 0.0},
                    {"width", 0},
                    {"height", 0}};
  experiment["media"] = std::move(files);
  experiment["stimuli"] = std::move(stimuli);
}

}  // namespace

std::vector<std::string> paragraphs_of(std::string_view text, std::string_view language) {
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
    if (!current.empty() && !is_written_without_spaces(language)) current += ' ';
    current += line;
  }
  put();
  return paragraphs;
}

ordered_json demographics_json(const std::vector<Demographic>& demographics) {
  ordered_json questions = ordered_json::array();
  for (const Demographic& one : demographics) {
    ordered_json answer = one.answer.is_number ? "number" : "text";
    if (!one.answer.choices.empty()) answer = one.answer.choices.words;
    questions.push_back(
        {{"id", one.id}, {"ask", one.ask.text}, {"answer", answer}, {"required", one.required}});
  }
  return questions;
}

ordered_json language_json(const ordered_json& experiment, const ordered_json& first) {
  ordered_json shown = ordered_json::object();
  for (const char* member : {"title", "texts", "consent", "settings", "items", "choices", "chains",
                             "screening", "demographics"})
    if (experiment.contains(member)) shown[member] = experiment[member];
  const auto record_first = [](ordered_json& questions, const ordered_json& recorded) {
    for (std::size_t i = 0; i < questions.size(); ++i)
      if (questions[i]["answer"].is_array()) questions[i]["values"] = recorded[i]["answer"];
  };
  record_first(shown["demographics"], first["demographics"]);
  if (shown.contains("screening") && shown["screening"].contains("questions"))
    record_first(shown["screening"]["questions"], first["screening"]["questions"]);
  return shown;
}

void add_languages(ordered_json& experiment, const PageLanguage& language, const OwnTexts& own,
                   const std::function<ordered_json(const std::string&)>& in_language) {
  if (language.by_browser) {
    ordered_json languages = ordered_json::object();
    for (const std::string& tag : language.offered)
      languages[tag] = tag == language.first() ? ordered_json::object()
                                               : language_json(in_language(tag), experiment);
    experiment["languages"] = std::move(languages);
  }
  for (const PageTexts& texts : own.texts) experiment["page_texts"][texts.language] = texts.texts;
}

namespace {

/// The experiment in the only language that its manifest offers, without media.
ordered_json experiment_in_language(const Manifest& manifest, const ordered_json& sessions,
                                    const std::string& design) {
  const Questionnaire& asked = questionnaire_of(manifest);
  const auto texts_of = [&](const TextSource& source) {
    return paragraphs_of(source.text, asked.language.first());
  };
  ordered_json experiment = {{"format", "mien-questionnaire-1"},
                             {"study", manifest.study},
                             {"title", title_of(manifest)},
                             {"language", asked.language.first()},
                             {"design", design},
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
                             {"sessions", sessions}};
  if (!asked.adaptive.empty()) experiment["adaptive"] = procedure_json(track_procedure(manifest));
  if (ordered_json consent = consent_json(asked); !consent.is_null())
    experiment["consent"] = std::move(consent);
  if (!asked.screening.empty())
    experiment["screening"] = written(asked.screening, WritingOptions{});
  if (ordered_json recruitment = recruitment_json(asked); !recruitment.is_null())
    experiment["recruitment"] = std::move(recruitment);
  return experiment;
}

}  // namespace

ordered_json experiment_json(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                             const MediaFiles& media) {
  const Questionnaire& asked = questionnaire_of(manifest);
  const std::string design = design_hash(manifest, plans);
  ordered_json experiment = experiment_in_language(in_language(manifest, asked.language.first()),
                                                   sessions_json(manifest, plans), design);
  add_languages(experiment, asked.language, asked.texts, [&](const std::string& language) {
    return experiment_in_language(in_language(manifest, language), nullptr, design);
  });
  add_media(experiment, media);
  return experiment;
}

}  // namespace mien::pipeline
