#include "pipeline/sheets/sheet_content.h"

#include <utility>

#include "pipeline/synthesis/modified_motion.h"
#include "pipeline/synthesis/parameter_label.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

std::string origin_of(const std::string& name, const Manifest& manifest) {
  const Stimulus* stimulus = find_stimulus(manifest, name);
  if (stimulus == nullptr) return "example";
  if (stimulus->clip) return "as captured";
  if (!stimulus->features.empty()) return "from features";
  if (!stimulus->adjectives.empty()) return "from adjectives";
  return stimulus->weights.size() == 1 ? stimulus->weights.front().first : "from weights";
}

SheetMotion sheet_motion(const std::string& name, const Manifest& manifest, Motions& motions) {
  const Synthesis& synthesis = motions.of(name);
  SheetMotion result{name, origin_of(name, manifest), synthesis.motion, {}};
  if (!synthesis.modified.empty()) {
    result.origin =
        synthesis.modified + share_text(synthesis.modified_share) + ", of " + result.origin;
  }
  for (Eigen::Index i = 0; i < synthesis.weights.size(); ++i) {
    const std::string& example = motions.repertoire().names[static_cast<std::size_t>(i)].name;
    if (synthesis.weights[i] > 0.0) result.weights.emplace_back(example, synthesis.weights[i]);
  }
  return result;
}

std::optional<double> value_of(const NamedValues& values, const std::string& name) {
  for (const auto& [parameter, value] : values) {
    if (parameter == name) return value;
  }
  return std::nullopt;
}

/// The parameters that a stimulus was asked for, and whether they are features.
struct Asked {
  NamedValues values;
  bool are_features = false;
};

Asked asked_of(const std::string& name, const Manifest& manifest, Motions& motions) {
  const Stimulus* stimulus = find_stimulus(manifest, name);
  return {motions.of(name).asked, stimulus != nullptr && !stimulus->features.empty()};
}

SheetParameter sheet_parameter(const std::string& id, bool is_feature, const ScaleSet& scales) {
  ParameterLabel label = is_feature ? feature_label(id) : rating_label(id, scales);
  return {std::move(label.name),
          std::move(label.japanese),
          std::move(label.low),
          std::move(label.high),
          std::move(label.japanese_low),
          std::move(label.japanese_high),
          std::nullopt,
          std::nullopt};
}

/// Parameters that either motion was asked for: the target's first.
std::vector<SheetParameter> parameters_of(const Asked& target, const Asked& created,
                                          const ScaleSet& scales) {
  const bool same_kind = target.are_features == created.are_features;
  std::vector<SheetParameter> parameters;
  for (const auto& [id, value] : target.values) {
    SheetParameter parameter = sheet_parameter(id, target.are_features, scales);
    parameter.target = value;
    if (same_kind) parameter.created = value_of(created.values, id);
    parameters.push_back(std::move(parameter));
  }
  for (const auto& [id, value] : created.values) {
    if (same_kind && value_of(target.values, id)) continue;
    SheetParameter parameter = sheet_parameter(id, created.are_features, scales);
    parameter.created = value;
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

/// Examples are what motions are made from: references.
MotionColours colours_of(const Stimulus* stimulus) {
  if (stimulus == nullptr || stimulus->role == Role::reference) return reference_colours;
  return stimulus->role == Role::target ? target_colours : created_colours;
}

std::vector<std::pair<std::string, std::string>> provenance_of(const Manifest& manifest) {
  return {{"mien", std::string(program_version())},
          {"seed", std::to_string(manifest.seed)},
          {"manifest", manifest.file.filename().string()}};
}

}  // namespace

SheetContent sheet_content(const Sheet& sheet, const Manifest& manifest, Motions& motions) {
  SheetContent content;
  content.study = manifest.study;
  content.target = sheet_motion(sheet.target, manifest, motions);
  content.created = sheet_motion(sheet.created, manifest, motions);
  if (!sheet.reference.empty()) {
    content.reference = sheet_motion(sheet.reference, manifest, motions);
  }
  content.distance = motion::distance(content.target.motion, content.created.motion);
  const Asked target = asked_of(sheet.target, manifest, motions);
  const Asked created = asked_of(sheet.created, manifest, motions);
  if (!target.values.empty() || !created.values.empty()) {
    const Repertoire& repertoire = motions.repertoire();
    content.parameters = parameters_of(target, created, repertoire.scales);
    const bool rests_on_ratings = (!target.values.empty() && !target.are_features) ||
                                  (!created.values.empty() && !created.are_features);
    content.simulated_ratings = rests_on_ratings && repertoire.simulated_ratings;
  }
  content.provenance = provenance_of(manifest);
  return content;
}

GalleryContent gallery_content(const Sheet& sheet, const Manifest& manifest, Motions& motions) {
  GalleryContent content{manifest.study, sheet.id, {}, {}, false, provenance_of(manifest)};
  for (const std::string& name : sheet.gallery) {
    content.motions.push_back(sheet_motion(name, manifest, motions));
    const Stimulus* stimulus = find_stimulus(manifest, name);
    content.colours.push_back(colours_of(stimulus));
    const bool is_rated = stimulus != nullptr && !stimulus->adjectives.empty();
    content.simulated_ratings |= is_rated && motions.repertoire().simulated_ratings;
  }
  return content;
}

}  // namespace mien::pipeline
