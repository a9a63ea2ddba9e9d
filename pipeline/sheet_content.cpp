#include "pipeline/sheet_content.h"

#include <algorithm>
#include <utility>

#include "pipeline/code_identity.h"

namespace mien::pipeline {

namespace {

std::string origin_of(const std::string& name, const Manifest& manifest) {
  const Stimulus* stimulus = find_stimulus(manifest, name);
  if (stimulus == nullptr) return "example";
  if (stimulus->clip) return "as captured";
  return stimulus->adjectives.empty() ? "from weights" : "from adjectives";
}

SheetMotion sheet_motion(const std::string& name, const Manifest& manifest, Motions& motions) {
  const Synthesis& synthesis = motions.of(name);
  SheetMotion result{name, origin_of(name, manifest), synthesis.motion, {}};
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

SheetParameter sheet_parameter(const std::string& name, const ScaleSet& scales) {
  SheetParameter parameter;
  if (const Scale* scale = find_scale(scales, name)) {
    parameter.low = scale->low;
    parameter.high = scale->high;
    parameter.japanese_low = scale->japanese_low;
    parameter.japanese_high = scale->japanese_high;
    return parameter;
  }
  parameter.name = name;
  for (const ScaleGroup& group : scales.groups) {
    if (group.id == name) parameter.japanese = group.japanese;
  }
  return parameter;
}

/// Parameters that either motion was asked for: the target's first.
std::vector<SheetParameter> parameters_of(const Synthesis& target, const Synthesis& created,
                                          const ScaleSet& scales) {
  std::vector<std::string> names;
  for (const NamedValues* asked : {&target.asked, &created.asked}) {
    for (const auto& [name, value] : *asked) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  std::vector<SheetParameter> parameters;
  for (const std::string& name : names) {
    SheetParameter parameter = sheet_parameter(name, scales);
    parameter.target = value_of(target.asked, name);
    parameter.created = value_of(created.asked, name);
    parameters.push_back(std::move(parameter));
  }
  return parameters;
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
  const Synthesis& target = motions.of(sheet.target);
  const Synthesis& created = motions.of(sheet.created);
  if (!target.asked.empty() || !created.asked.empty()) {
    const Repertoire& repertoire = motions.repertoire();
    content.parameters = parameters_of(target, created, repertoire.scales);
    content.simulated_ratings = repertoire.simulated_ratings;
  }
  content.provenance = {{"mien", std::string(program_version())},
                        {"seed", std::to_string(manifest.seed)},
                        {"manifest", manifest.file.filename().string()}};
  return content;
}

}  // namespace mien::pipeline
