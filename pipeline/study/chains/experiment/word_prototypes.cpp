#include "pipeline/study/chains/experiment/word_prototypes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "motion/live/live_core.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/manifest/questionnaire_content.h"
#include "pipeline/study/chains/experiment/recipe_dimensions.h"

namespace mien::pipeline {

namespace {

using Kind = MotionSpace::Kind;

/// As the schema of manifests permits.
constexpr std::size_t longest_study_name = 64;

/// Positions of the examples, one column each, in units of the ranges.
Eigen::MatrixXd places_of_examples(const ChainStudy& study) {
  Eigen::MatrixXd places = study.dimensions.at_examples;
  const auto dimensions = static_cast<Eigen::Index>(study.design.dimensions.size());
  if (places.size() == 0) {
    const auto& examples = study.bundle.examples.examples;
    places = Eigen::MatrixXd::Zero(dimensions, static_cast<Eigen::Index>(examples.size()));
    for (std::size_t e = 0; e < examples.size(); ++e)
      for (Eigen::Index d = 0; d < dimensions; ++d)
        if (study.design.dimensions[static_cast<std::size_t>(d)] == examples[e].name)
          places(d, static_cast<Eigen::Index>(e)) = 1.0;
  }
  for (Eigen::Index d = 0; d < dimensions; ++d) {
    const DimensionRange& range = study.design.space[static_cast<std::size_t>(d)];
    places.row(d) /= range.high - range.low;
  }
  return places;
}

/// The mean of a chain's samples, in units of the ranges.
Eigen::VectorXd chain_place(const ChainDesign& design, const WordSamples& word, std::size_t chain) {
  Eigen::VectorXd place(static_cast<Eigen::Index>(word.dimensions.size()));
  for (std::size_t d = 0; d < word.dimensions.size(); ++d) {
    const std::vector<double>& values = word.dimensions[d].values[chain];
    double sum = 0.0;
    for (const double value : values) sum += value;
    const DimensionRange& range = design.space[d];
    place[static_cast<Eigen::Index>(d)] =
        sum / static_cast<double>(values.size()) / (range.high - range.low);
  }
  return place;
}

NamedValues named_values(const std::vector<std::string>& names, const std::vector<double>& values) {
  NamedValues named;
  for (std::size_t i = 0; i < names.size(); ++i)
    named.emplace_back(names[i], std::round(1000.0 * values[i]) / 1000.0);
  return named;
}

/// What the live core blends for a point, as weights of examples.
NamedValues blended_weights(const ChainStudy& study, const std::vector<double>& point) {
  motion::LiveCore core(study.bundle);
  const Eigen::VectorXd weights =
      core.make(
              {.kind = study.dimensions.kind, .sliders = study.design.dimensions, .values = point})
          .weights;
  NamedValues named;
  for (Eigen::Index i = 0; i < weights.size(); ++i)
    if (std::abs(weights[i]) >= 0.0005)
      named.emplace_back(study.bundle.examples.examples[static_cast<std::size_t>(i)].name,
                         std::round(1000.0 * weights[i]) / 1000.0);
  return named;
}

Stimulus prototype(const Manifest& manifest, const MotionSpace& space, const ChainStudy& study,
                   const WordSamples& word) {
  Stimulus stimulus = plain_stimulus(manifest);
  stimulus.id = word.word;
  const std::vector<double> point = word.prototype();
  if (space.kind == Kind::recipe) {
    stimulus.weights = {{space.recipe.of, 1.0}};
    stimulus.modify = modification_steps(space.recipe, point);
    return stimulus;
  }
  const NamedValues values = named_values(study.design.dimensions, point);
  if (space.kind == Kind::components)
    stimulus.weights = blended_weights(study, point);
  else if (space.kind == Kind::weights)
    stimulus.weights = values;
  else
    (space.kind == Kind::features ? stimulus.features : stimulus.adjectives) = values;
  return stimulus;
}

/// "not sad" in the languages of the built-in texts; with a minus sign in others.
std::string negated(const std::string& language, const std::string& word) {
  if (language == "ja") return word + "とは言えない";
  if (language == "zh") return "不" + word;
  static const std::map<std::string, std::string> negations = {{"en", "not "}, {"de", "nicht "},
                                                               {"fr", "pas "}, {"es", "no "},
                                                               {"fi", "ei "},  {"ar", "غير "}};
  const auto found = negations.find(language);
  return (found == negations.end() ? "− " : found->second) + word;
}

/// Adds the names of a scale's ends in a language.
void add_ends(Scale& scale, const std::string& language, const std::string& word) {
  const std::string low = negated(language, word);
  if (language == "en") {
    scale.low = low;
    scale.high = word;
  } else if (language == "ja") {
    scale.japanese_low = low;
    scale.japanese_high = word;
  } else {
    scale.words.push_back({language, {low, word}});
  }
}

/// Names of the raters of a word: chains of participants are named after both.
std::vector<std::string> raters_of(const ChainResults& results, const std::string& word,
                                   std::size_t count) {
  std::vector<std::string> names;
  for (const ChainPath& path : results.paths) {
    if (path.name.word != word || (!path.is_complete && !path.name.participant.empty())) continue;
    names.push_back(path.name.participant.empty()
                        ? fmt::format("chain-{}", path.name.chain)
                        : fmt::format("{}-{}", path.name.participant, path.name.chain));
  }
  names.resize(count);
  return names;
}

}  // namespace

ScaleSet word_scales(const Manifest& manifest) {
  ScaleSet set{.name = "words of " + manifest.study};
  for (const auto& [id, shown] : adaptive_of(manifest).words) {
    Scale scale;
    scale.id = id;
    const std::string first = adaptive_of(manifest).language.first();
    scale.low = negated(first, shown.text);
    scale.high = shown.text;
    if (shown.by_language.empty() && first != "en") add_ends(scale, first, shown.text);
    for (const auto& [language, text] : shown.by_language) add_ends(scale, language, text);
    set.scales.push_back(scale);
  }
  return set;
}

std::string word_ratings_csv(const ChainStudy& study, const ChainResults& results,
                             const ScaleSet& scales) {
  const Eigen::MatrixXd places = places_of_examples(study);
  const Eigen::VectorXd centre = places.rowwise().mean();
  CsvWriter csv({"participant", "stimulus", "scale", "value", "simulated"});
  for (std::size_t w = 0; w < results.words.size(); ++w) {
    const WordSamples& word = results.words[w];
    const Scale& scale = scales.scales[w];
    const auto chains = static_cast<std::size_t>(word.chains);
    const std::vector<std::string> raters = raters_of(results, word.word, chains);
    for (std::size_t chain = 0; chain < chains; ++chain) {
      const Eigen::VectorXd towards = chain_place(results.design, word, chain) - centre;
      if (towards.squaredNorm() < 1e-12)
        throw Error(fmt::format("a chain of {} ended in the middle of the examples", word.word),
                    "no direction in the space looks like the word");
      for (Eigen::Index e = 0; e < places.cols(); ++e) {
        const double t = 0.5 + 0.5 * (places.col(e) - centre).dot(towards) / towards.squaredNorm();
        const double value = std::lerp(scale.least, scale.most, std::clamp(t, 0.0, 1.0));
        csv.row({raters[chain], study.bundle.examples.examples[static_cast<std::size_t>(e)].name,
                 scale.id, fmt::format("{:.4f}", value), results.simulated ? "1" : "0"});
      }
    }
  }
  return csv.text();
}

Manifest prototype_manifest(const Manifest& source, const ChainStudy& study,
                            const ChainResults& results, const std::filesystem::path& scales) {
  Manifest manifest = source;
  const std::string ending = results.simulated ? "-simulated-prototypes" : "-prototypes";
  manifest.study = source.study.substr(0, longest_study_name - ending.size()) + ending;
  manifest.stimuli.clear();
  manifest.overlays.clear();
  manifest.sheets.clear();
  manifest.mismatch.reset();
  manifest.adaptive.reset();
  manifest.ratings.expected.clear();
  const Adaptive& adaptive = *source.adaptive;
  for (const WordSamples& word : results.words)
    manifest.stimuli.push_back(prototype(manifest, adaptive.space, study, word));
  if (manifest.stimuli.size() > 1) {
    Sheet& sheet = manifest.sheets.emplace_back();
    for (const Stimulus& stimulus : manifest.stimuli) sheet.gallery.push_back(stimulus.id);
  }
  Questionnaire& asked = manifest.questionnaire.emplace();
  // Consent and instructions were about sliders.
  asked.language = adaptive.language;
  asked.texts = adaptive.texts;
  asked.participants = adaptive.participants;
  asked.demographics = adaptive.demographics;
  asked.scales.all = true;
  asked.scales.file = scales;
  return manifest;
}

}  // namespace mien::pipeline
