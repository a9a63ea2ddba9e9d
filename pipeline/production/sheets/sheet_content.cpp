#include "pipeline/production/sheets/sheet_content.h"

#include <optional>
#include <set>
#include <utility>

#include "pipeline/production/synthesis/modified_motion.h"
#include "pipeline/tasks/code_identity.h"

namespace mien::pipeline {

namespace {

std::string origin_of(const std::string& name, Motions& motions) {
  const Stimulus* stimulus = motions.stimulus(name);
  if (stimulus == nullptr) return "example";
  if (stimulus->clip) return "as captured";
  if (stimulus->walk) return "along a path";
  if (!stimulus->features.empty()) return "from features";
  if (!stimulus->adjectives.empty()) return "from adjectives";
  return stimulus->weights.size() == 1 ? stimulus->weights.front().first : "from weights";
}

SheetMotion sheet_motion(const std::string& name, Motions& motions) {
  const Synthesis& synthesis = motions.of(name);
  SheetMotion result{name, origin_of(name, motions), synthesis.motion, {}};
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

/// What a motion was asked to have or to keep, and what it has.
struct Values {
  NamedValues asked;
  NamedValues held;
  NamedValues reached;  ///< of what was asked for
  NamedValues rated;    ///< every rated parameter, of a blend of rated examples
  bool are_features = false;

  std::optional<double> reached_of(const std::string& id, bool is_feature) const {
    if (is_feature != are_features) return is_feature ? std::nullopt : value_of(rated, id);
    const auto own = value_of(reached, id);
    return own || is_feature ? own : value_of(rated, id);
  }
  SheetValue of(const std::string& id, bool is_feature) const {
    return {is_feature == are_features ? value_of(asked, id) : std::nullopt,
            is_feature ? std::nullopt : value_of(held, id), reached_of(id, is_feature)};
  }
};

/// What is shown as captured has nothing to do with the examples, of which there may be none.
Values values_of(const std::string& name, Motions& motions) {
  const Synthesis& made = motions.of(name);
  const Stimulus* stimulus = motions.stimulus(name);
  const bool is_blend = made.weights.size() > 0;
  return {made.asked, made.held, made.modified.empty() ? made.reached : NamedValues(),
          is_blend ? rated_values(made, motions.repertoire()) : NamedValues(),
          stimulus != nullptr && !stimulus->features.empty()};
}

/// Parameters that either motion was asked for, the target's first, then those held, then all
/// others with a value.
class ParameterList {
 public:
  ParameterList(const Values& target, const Values& created, const ScaleSet& scales)
      : target_(target), created_(created), scales_(scales) {
    add(target.asked, target.are_features);
    add(created.asked, created.are_features);
    add(target.held, false);
    add(created.held, false);
    add(target.rated, false);
    add(created.rated, false);
  }

  std::vector<SheetParameter> take() { return std::move(parameters_); }

 private:
  void add(const NamedValues& values, bool are_features) {
    for (const auto& [id, value] : values) {
      if (!known_.emplace(id, are_features).second) continue;
      parameters_.push_back({are_features ? feature_label(id) : rating_label(id, scales_),
                             target_.of(id, are_features), created_.of(id, are_features)});
    }
  }

  const Values& target_;
  const Values& created_;
  const ScaleSet& scales_;
  std::set<std::pair<std::string, bool>> known_;
  std::vector<SheetParameter> parameters_;
};

/// Whether a number on the sheet comes from ratings.
bool rests_on_ratings(const Values& values) {
  return !values.rated.empty() || (!values.asked.empty() && !values.are_features);
}

/// Examples are what motions are made from: references.
MotionColours colours_of(const Stimulus* stimulus) {
  if (stimulus == nullptr || stimulus->role == Role::reference) return reference_colours;
  return stimulus->role == Role::target ? target_colours : created_colours;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> provenance_of(const Manifest& manifest) {
  return {{"mien", std::string(program_version())},
          {"seed", std::to_string(manifest.seed)},
          {"manifest", manifest.file.filename().string()}};
}

SheetContent sheet_content(const Sheet& sheet, const Manifest& manifest, Motions& motions) {
  SheetContent content;
  content.study = manifest.study;
  content.target = sheet_motion(sheet.target, motions);
  content.created = sheet_motion(sheet.created, motions);
  if (!sheet.reference.empty()) {
    content.reference = sheet_motion(sheet.reference, motions);
  }
  content.distance = motions.distance(sheet.target, sheet.created);
  const Values target = values_of(sheet.target, motions);
  const Values created = values_of(sheet.created, motions);
  if (!target.asked.empty() || !created.asked.empty() || rests_on_ratings(target) ||
      rests_on_ratings(created)) {
    const Repertoire& repertoire = motions.repertoire();
    content.parameters = ParameterList(target, created, repertoire.scales).take();
    content.simulated_ratings =
        repertoire.simulated_ratings && (rests_on_ratings(target) || rests_on_ratings(created));
  }
  content.provenance = provenance_of(manifest);
  return content;
}

GalleryContent gallery_content(const Sheet& sheet, const Manifest& manifest, Motions& motions) {
  GalleryContent content{manifest.study, sheet.id, {}, {}, {}, false, provenance_of(manifest)};
  for (const std::string& name : sheet.gallery) {
    content.motions.push_back(sheet_motion(name, motions));
    content.distances_m.push_back(motions.distance(sheet.gallery.front(), name).mean);
    const Stimulus* stimulus = motions.stimulus(name);
    content.colours.push_back(colours_of(stimulus));
    const bool is_rated = stimulus != nullptr && !stimulus->adjectives.empty();
    content.simulated_ratings |= is_rated && motions.repertoire().simulated_ratings;
  }
  return content;
}

}  // namespace mien::pipeline
