#include "pipeline/study/matching/experiment/matching_study.h"

#include <algorithm>

#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/study_texts.h"
#include "pipeline/study/questionnaire/experiment/experiment.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;
using Strings = std::vector<std::string>;

Strings all_targets(const Manifest& manifest) {
  Strings ids = matching_targets(manifest);
  for (const std::string& id : matching_of(manifest).practice)
    if (std::ranges::find(ids, id) == ids.end()) ids.push_back(id);
  return ids;
}

/// Sliders that are shown at once and those that may be added: of `all`, those that are named;
/// where none are, those that `info` has as primary, and all others.
ordered_json shown_and_offered(const ordered_json& info, const Strings& shown,
                               const Strings& offered) {
  ordered_json sliders = {{"shown", shown}, {"offered", ordered_json::array()}};
  for (const ordered_json& slider : info) {
    const std::string name = slider.at("name");
    const bool is_shown = shown.empty() ? slider.at("primary").get<bool>()
                                        : std::ranges::find(shown, name) != shown.end();
    const bool is_offered = offered.empty() || std::ranges::find(offered, name) != offered.end();
    if (is_shown && shown.empty()) sliders["shown"].push_back(name);
    if (!is_shown && is_offered) sliders["offered"].push_back(name);
  }
  return sliders;
}

void refuse_unrated(const Manifest& manifest, const Strings& names,
                    const motion::ParameterTable& rated) {
  for (const std::string& name : names)
    if (std::ranges::find(rated.names, name) == rated.names.end())
      throw Error({manifest.file.string()}, "there are no ratings of \"" + name + "\"",
                  "use rated adjectives");
}

ordered_json sliders_json(const Manifest& manifest, const motion::LiveBundle& bundle) {
  const Matching& matching = *manifest.matching;
  const ordered_json info = ordered_json::parse(bundle.info).at("sliders");
  ordered_json sliders = ordered_json::object();
  for (const std::string& interface : matching.interfaces) {
    if (interface == "adjectives") {
      if (bundle.adjectives.names.empty())
        throw Error({manifest.file.string()}, "the examples have no ratings",
                    "add ratings, or use interfaces without adjectives");
      refuse_unrated(manifest, matching.primary, bundle.adjectives);
      refuse_unrated(manifest, matching.offered, bundle.adjectives);
      sliders[interface] =
          shown_and_offered(info.at("adjectives"), matching.primary, matching.offered);
    } else if (interface == "features") {
      sliders[interface] = shown_and_offered(info.at("features"), matching.features, {});
    } else {
      Strings examples;
      for (const motion::Example& example : bundle.examples.examples)
        examples.push_back(example.name);
      sliders[interface] = {{"shown", examples}, {"offered", ordered_json::array()}};
    }
  }
  return sliders;
}

ordered_json sessions_of(const std::vector<SessionPlan>& plans) {
  ordered_json sessions = ordered_json::array();
  for (const SessionPlan& plan : plans) {
    ordered_json trials = ordered_json::array();
    for (const Trial& trial : plan.trials)
      trials.push_back({{"number", trial.number},
                        {"block", trial.block},
                        {"kind", trial.kind_name()},
                        {"media", ordered_json::array()},
                        {"target", trial.stimuli.front()},
                        {"interface", trial.items.front().item},
                        {"practice", trial.practice}});
    sessions.push_back({{"participant", plan.participant},
                        {"seed", std::to_string(plan.seed)},
                        {"trials", trials}});
  }
  return sessions;
}

/// Settings that were added later are written only where they are not the default, so that earlier
/// experiments keep their design hash.
ordered_json settings_of(const Manifest& manifest, const motion::LiveBundle& bundle) {
  const Matching& matching = *manifest.matching;
  ordered_json settings = {{"limit_s", matching.limit_s},
                           {"threshold_m", matching.threshold_m},
                           {"shows_distance", matching.shows_distance},
                           {"target_colour", matching.target_colour},
                           {"created_colour", matching.created_colour},
                           {"sliders", sliders_json(manifest, bundle)}};
  if (matching.order != Matching().order)
    settings["order"] = word_of(matching_order_words, matching.order);
  if (matching.shows_examples) settings["shows_examples"] = true;
  return settings;
}

/// The experiment in the only language that its manifest offers, without its hash.
ordered_json experiment_in_language(const Manifest& manifest, const motion::LiveBundle& bundle,
                                    const std::vector<SessionPlan>& plans) {
  const Matching& matching = *manifest.matching;
  const auto texts_of = [&](const TextSource& source) {
    return paragraphs_of(source.text, matching.language.first());
  };
  return {{"format", "mien-matching-1"},
          {"study", manifest.study},
          {"title", title_of(manifest)},
          {"language", matching.language.first()},
          {"design", ""},
          {"simulated", false},
          {"texts",
           {{"consent", texts_of(matching.consent)},
            {"instructions", texts_of(matching.instructions)},
            {"ending", texts_of(matching.ending)}}},
          {"settings", {{"phones", word_of(phones_words, matching.phones)}}},
          {"matching", settings_of(manifest, bundle)},
          {"items", ordered_json::object()},
          {"demographics", demographics_json(matching.demographics)},
          {"media", ordered_json::object()},
          {"stimuli", ordered_json::object()},
          {"sessions", sessions_of(plans)}};
}

ordered_json experiment_of(const Manifest& manifest, const motion::LiveBundle& bundle,
                           const std::vector<SessionPlan>& plans) {
  const Matching& matching = *manifest.matching;
  const auto in = [&](const std::string& language) {
    return experiment_in_language(in_language(manifest, language), bundle, plans);
  };
  ordered_json experiment = in(matching.language.first());
  add_languages(experiment, matching.language, matching.texts, in);
  experiment["design"] = hash_of(experiment.dump());
  return experiment;
}

}  // namespace

MatchingStudy matching_study(const Manifest& manifest, Motions& motions, int participants) {
  LiveChoice choice = live_choice(manifest);
  choice.targets = all_targets(manifest);
  choice.primary = matching_of(manifest).primary;
  MatchingStudy study{.plans = plan_matching(manifest, participants),
                      .bundle = live_bundle(manifest, motions, choice)};
  study.experiment = experiment_of(manifest, study.bundle, study.plans);
  return study;
}

ServedStudy served_matching(MatchingStudy study, const std::filesystem::path& pages) {
  ServedStudy served{.experiment = std::move(study.experiment),
                     .plans = std::move(study.plans),
                     .page = served_page(pages)};
  served.facts = questionnaire_facts(served.experiment);
  // The motions are part of the study's identity.
  served.facts.sha256["motions"] = hash_of(to_bytes(study.bundle));
  served.live = std::make_unique<LiveMotions>(std::move(study.bundle));
  return served;
}

}  // namespace mien::pipeline
