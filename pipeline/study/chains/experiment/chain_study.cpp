#include "pipeline/study/chains/experiment/chain_study.h"

#include <algorithm>

#include <Eigen/SVD>
#include <fmt/format.h>

#include "motion/live/live_core.h"
#include "pipeline/manifest/adaptive_plan.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/manifest/study_texts.h"
#include "pipeline/study/chains/experiment/recipe_dimensions.h"
#include "pipeline/study/live/live_bundle_writer.h"
#include "pipeline/study/questionnaire/experiment/experiment.h"
#include "pipeline/study/questionnaire/service/chain_record.h"
#include "pipeline/tasks/hash.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;
using Kind = MotionSpace::Kind;

Eigen::MatrixXd rows_of_table(const Manifest& manifest, const motion::ParameterTable& table,
                              const std::vector<std::string>& names, const char* lacking) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(names.size()), table.values.cols());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const int row = table.find(names[i]);
    if (row < 0)
      throw Error({manifest.file.string()}, fmt::format("{} \"{}\"", lacking, names[i]),
                  "use other dimensions in adaptive.space");
    rows.row(static_cast<Eigen::Index>(i)) = table.values.row(row);
  }
  return rows;
}

/// Components are given to the live core as if they were adjectives.
ChainDimensions add_components(const Manifest& manifest, motion::LiveBundle& bundle) {
  ChainDimensions dimensions{.names = dimension_names(manifest)};
  std::vector<std::string> features;
  for (const std::string& name : bundle.features.names)
    if (motion::find_motion_feature(name) >= 0) features.push_back(name);
  dimensions.at_examples =
      component_scores(rows_of_table(manifest, bundle.features, features, "no feature"),
                       manifest.adaptive->space.components);
  bundle.adjectives = {dimensions.names, dimensions.at_examples, false};
  return dimensions;
}

ChainDimensions dimensions_of(const Manifest& manifest, motion::LiveBundle& bundle) {
  const Kind kind = adaptive_of(manifest).space.kind;
  if (kind == Kind::components) return add_components(manifest, bundle);
  if (kind == Kind::recipe) {
    bundle.modification = live_modification(manifest);
    return {.kind = motion::InterfaceKind::modifications, .names = dimension_names(manifest)};
  }
  ChainDimensions dimensions{.names = dimension_names(manifest)};
  if (kind == Kind::weights) {
    dimensions.kind = motion::InterfaceKind::weights;
    return dimensions;
  }
  const bool is_feature = kind == Kind::features;
  if (is_feature) dimensions.kind = motion::InterfaceKind::features;
  if (!is_feature && bundle.adjectives.names.empty())
    throw Error({manifest.file.string()}, "the examples have no ratings",
                "add ratings, or use features or weights in adaptive.space");
  dimensions.at_examples =
      rows_of_table(manifest, is_feature ? bundle.features : bundle.adjectives, dimensions.names,
                    is_feature ? "not all examples have the feature" : "there are no ratings of");
  return dimensions;
}

ordered_json step_json(const ChainDesign& design, const PlannedStep& step) {
  ordered_json json = {{"word", step.name.word}, {"chain", step.name.chain}, {"step", step.step}};
  if (design.method == ChainMethod::gibbs) {
    json["dimension"] = step.view.dimension;
    json["slider"] = {{"start", step.view.slider.start},
                      {"reversed", step.view.slider.is_reversed}};
  } else {
    json["normals"] = step.view.normals;
    json["proposal_first"] = step.view.is_proposal_first;
  }
  return json;
}

ordered_json session_json(const ChainDesign& design, const ChainSession& session) {
  ordered_json trials = ordered_json::array();
  for (std::size_t i = 0; i < session.plan.trials.size(); ++i) {
    const Trial& trial = session.plan.trials[i];
    ordered_json json = {{"number", trial.number},
                         {"block", trial.block},
                         {"kind", chain_trials.name},
                         {"media", ordered_json::array()},
                         {"practice", trial.practice}};
    if (trial.is_attention_check()) json["expected"] = trial.expected;
    if (!session.steps[i].name.word.empty()) json.update(step_json(design, session.steps[i]));
    trials.push_back(std::move(json));
  }
  ordered_json starts = ordered_json::object();
  for (const auto& [key, point] : session.starts) starts[key] = point;
  return {{"participant", session.plan.participant},
          {"seed", std::to_string(session.plan.seed)},
          {"starts", std::move(starts)},
          {"trials", std::move(trials)}};
}

ordered_json chains_json(const Manifest& manifest, const ChainStudy& study) {
  const Adaptive& adaptive = *manifest.adaptive;
  ordered_json dimensions = ordered_json::array();
  for (std::size_t i = 0; i < study.design.dimensions.size(); ++i)
    dimensions.push_back({{"name", study.design.dimensions[i]},
                          {"low", study.design.space[i].low},
                          {"high", study.design.space[i].high}});
  ordered_json words = ordered_json::object();
  for (const auto& [id, shown] : adaptive.words) words[id] = shown.text;
  ordered_json json = {{"method", word_of(chain_method_words, adaptive.method)},
                       {"across_participants", adaptive.across_participants},
                       {"kind", motion::name_of(study.dimensions.kind)},
                       {"dimensions", std::move(dimensions)},
                       {"words", std::move(words)},
                       {"chains", adaptive.chains},
                       {"steps", study.design.steps},
                       {"people_per_step", adaptive.people_per_step},
                       {"aggregate", word_of(step_aggregate_words, adaptive.aggregate)},
                       {"colour", adaptive.colour},
                       {"deviation", adaptive.deviation},
                       // As a text: numbers of JavaScript have fewer digits.
                       {"seed", std::to_string(study.design.seed)}};
  if (adaptive.attention_every > 0) json["max_failed_checks"] = adaptive.max_failed_checks;
  if (adaptive.until)
    json["until"] = {{"r_hat", adaptive.until->r_hat},
                     {"at_least", adaptive.until->at_least},
                     {"at_most", adaptive.until->at_most}};
  if (adaptive.across_participants) {
    json["answer_within_s"] = adaptive.answer_within_s;
    ordered_json starts = ordered_json::object();
    for (const std::string& word : study.design.words)
      for (int chain = 1; chain <= study.design.chains; ++chain) {
        const ChainName name{word, chain, ""};
        starts[name.key()] = chain_start(study.design, study.dimensions.at_examples, name);
      }
    json["starts"] = std::move(starts);
  }
  return json;
}

/// The experiment in the only language that its manifest offers, without its hash.
ordered_json experiment_in_language(const Manifest& manifest, const ChainStudy& study) {
  const Adaptive& adaptive = *manifest.adaptive;
  const auto texts_of = [&](const TextSource& source) {
    return paragraphs_of(source.text, adaptive.language.first());
  };
  ordered_json sessions = ordered_json::array();
  for (const ChainSession& session : study.sessions)
    sessions.push_back(session_json(study.design, session));
  return {{"format", "mien-chains-1"},
          {"study", manifest.study},
          {"title", title_of(manifest)},
          {"language", adaptive.language.first()},
          {"design", ""},
          {"simulated", false},
          {"texts",
           {{"consent", texts_of(adaptive.consent)},
            {"instructions", texts_of(adaptive.instructions)},
            {"ending", texts_of(adaptive.ending)}}},
          {"settings", {{"phones", word_of(phones_words, adaptive.phones)}}},
          {"chains", chains_json(manifest, study)},
          {"items", ordered_json::object()},
          {"demographics", demographics_json(adaptive.demographics)},
          {"media", ordered_json::object()},
          {"stimuli", ordered_json::object()},
          {"sessions", std::move(sessions)}};
}

ordered_json experiment_of(const Manifest& manifest, const ChainStudy& study) {
  const Adaptive& adaptive = *manifest.adaptive;
  const auto in = [&](const std::string& language) {
    return experiment_in_language(in_language(manifest, language), study);
  };
  ordered_json experiment = in(adaptive.language.first());
  add_languages(experiment, adaptive.language, adaptive.texts, in);
  // Further participants do not change the design.
  const ordered_json sessions = std::move(experiment["sessions"]);
  experiment.erase("sessions");
  experiment["design"] = hash_of(experiment.dump());
  experiment["sessions"] = sessions;
  return experiment;
}

/// Throws what the browser would have to report.
void try_first_motion(const ChainStudy& study) {
  motion::LiveCore core(study.bundle);
  const ChainName name{study.design.words.front(), 1, ""};
  core.make({.kind = study.dimensions.kind,
             .sliders = study.design.dimensions,
             .values = chain_start(study.design, study.dimensions.at_examples, name)});
}

}  // namespace

Eigen::MatrixXd component_scores(const Eigen::MatrixXd& features, int count) {
  Eigen::MatrixXd standardised = features.colwise() - features.rowwise().mean();
  for (Eigen::Index row = 0; row < standardised.rows(); ++row) {
    const double norm = standardised.row(row).norm();
    if (norm > 0.0) standardised.row(row) /= norm;
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(standardised, Eigen::ComputeThinU);
  if (count > motion::spread_rank(standardised.transpose()))
    throw Error(fmt::format("the examples' features vary in fewer than {} directions", count),
                "use fewer components in adaptive.space, or more examples");
  Eigen::MatrixXd scores(count, features.cols());
  for (Eigen::Index i = 0; i < count; ++i) {
    Eigen::VectorXd loadings = svd.matrixU().col(i);
    Eigen::Index largest = 0;
    loadings.cwiseAbs().maxCoeff(&largest);
    if (loadings[largest] < 0.0) loadings = -loadings;
    const Eigen::RowVectorXd score = loadings.transpose() * standardised;
    scores.row(i) = (score.array() - score.minCoeff()) / (score.maxCoeff() - score.minCoeff());
  }
  return scores;
}

std::vector<SessionPlan> ChainStudy::plans() const {
  std::vector<SessionPlan> plans;
  for (const ChainSession& session : sessions) plans.push_back(session.plan);
  return plans;
}

ChainStudy chain_study(const Manifest& manifest, Motions& motions, int participants) {
  LiveChoice choice = live_choice(manifest);
  const MotionSpace& space = adaptive_of(manifest).space;
  if (space.kind == Kind::recipe) choice.only = space.recipe.of;
  ChainStudy study{.bundle = live_bundle(manifest, motions, choice)};
  study.dimensions = dimensions_of(manifest, study.bundle);
  if (space.kind == Kind::components)
    study.bundle.info = live_info(study.bundle, {}, study.dimensions.names).dump();
  study.design = chain_design(manifest, study.dimensions.at_examples);
  try_first_motion(study);
  study.sessions = plan_chains(manifest, study.design, study.dimensions.at_examples, participants);
  study.experiment = experiment_of(manifest, study);
  return study;
}

ServedStudy served_chains(ChainStudy study, const std::filesystem::path& pages) {
  ServedStudy served{.experiment = std::move(study.experiment),
                     .plans = study.plans(),
                     .page = served_page(pages)};
  served.facts = questionnaire_facts(served.experiment);
  // The motions are part of the study's identity, and so is the number of participants.
  served.facts.sha256["motions"] =
      hash_of(to_bytes(study.bundle) + std::to_string(study.sessions.size()));
  served.live = std::make_unique<LiveMotions>(std::move(study.bundle));
  return served;
}

}  // namespace mien::pipeline
