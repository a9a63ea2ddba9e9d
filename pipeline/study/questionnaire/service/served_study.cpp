#include "pipeline/study/questionnaire/service/served_study.h"

#include <set>

#include "pipeline/study/questionnaire/experiment/experiment.h"
#include "pipeline/study/questionnaire/service/recruited_participants.h"
#include "pipeline/study/questionnaire/service/screening_record.h"

namespace mien::pipeline {

namespace {

namespace fs = std::filesystem;

std::set<std::string> tokens_of(const nlohmann::ordered_json& session) {
  std::set<std::string> tokens;
  for (const auto& trial : session.at("trials")) {
    for (const auto& token : trial.at("media")) tokens.insert(token.get<std::string>());
    if (const auto levels = trial.find("by_level"); levels != trial.end())
      for (const auto& shown : *levels)
        for (const auto& token : shown) tokens.insert(token.get<std::string>());
    tokens.insert(trial.value("reference", ""));
  }
  return tokens;
}

/// With those of the figures that the media show.
std::set<std::string> with_figures(std::set<std::string> tokens,
                                   const nlohmann::ordered_json& media) {
  std::set<std::string> all = tokens;
  for (const std::string& token : tokens) {
    const auto file = media.find(token);
    if (file == media.end() || !file->contains("figures")) continue;
    for (const auto& figure : file->at("figures")) all.insert(figure.get<std::string>());
  }
  return all;
}

/// The parts of experiment.json that all sessions share, without media.
nlohmann::ordered_json shared_part(const ServedStudy& study) {
  nlohmann::ordered_json own;
  for (const auto& [name, value] : study.experiment.items())
    if (name != "sessions" && name != "media" && name != "stimuli") own[name] = value;
  own["media"] = nlohmann::ordered_json::object();
  if (const auto found = own.find("recruitment"); found != own.end())
    *found = public_recruitment(*found);
  const auto hide_accepted = [](nlohmann::ordered_json& shown) {
    if (const auto found = shown.find("screening"); found != shown.end())
      *found = public_screening(*found);
  };
  hide_accepted(own);
  if (const auto languages = own.find("languages"); languages != own.end())
    for (auto& shown : *languages) hide_accepted(shown);
  return own;
}

}  // namespace

ServedStudy served_study(const Manifest& manifest, const std::vector<SessionPlan>& plans,
                         const MediaFiles& media, const fs::path& pages) {
  ServedStudy study{.experiment = experiment_json(manifest, plans, media),
                    .plans = plans,
                    .page = served_page(pages)};
  for (const auto& [stimulus, file] : media) {
    study.media[file.token] = {file.file, file.type};
    for (const FigureFile& figure : file.figures)
      study.media[figure.token] = {figure.file, glb_type};
  }
  study.facts = questionnaire_facts(study.experiment);
  return study;
}

Hash media_hash(const ServedStudy& study) {
  std::string all;
  for (const auto& [stimulus, sha256] : study.facts.sha256) all += stimulus + " " + sha256 + "\n";
  return hash_of(all);
}

std::string session_json(const ServedStudy& study, int plan, const std::string& participant,
                         const SessionProgress& progress) {
  nlohmann::ordered_json own = shared_part(study);
  nlohmann::ordered_json session =
      study.experiment.at("sessions").at(static_cast<std::size_t>(plan));
  session["participant"] = participant;
  const std::set<std::string> tokens =
      with_figures(tokens_of(session), study.experiment.at("media"));
  for (const auto& [token, media] : study.experiment.at("media").items()) {
    if (!tokens.contains(token)) continue;
    own["media"][token] = media;
    own["media"][token]["file"] = "../../media/" + token;
  }
  own["sessions"] = nlohmann::ordered_json::array({std::move(session)});
  own["kept"] = progress.stored;
  own["browser"] = progress.browser;
  if (!progress.answered.is_null()) own["answered"] = progress.answered;
  if (progress.ended) own["ended"] = word_of(session_end_words, *progress.ended);
  if (!progress.destination.is_null()) own["destination"] = progress.destination;
  return own.dump();
}

std::string joining_json(const ServedStudy& study, bool has_enough) {
  nlohmann::ordered_json own = shared_part(study);
  own["sessions"] = nlohmann::ordered_json::array(
      {{{"participant", ""}, {"seed", "0"}, {"trials", nlohmann::ordered_json::array()}}});
  own["kept"] = nlohmann::ordered_json::array();
  own["joining"] = true;
  if (has_enough) own["enough"] = true;
  return own.dump();
}

}  // namespace mien::pipeline
