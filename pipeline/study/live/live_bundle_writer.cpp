#include "pipeline/study/live/live_bundle_writer.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/measures/features/motion_features.h"
#include "pipeline/production/synthesis/slider_interface.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

motion::LiveTarget live_target(const std::string& id, Motions& motions) {
  const Stimulus* stimulus = motions.stimulus(id);
  if (stimulus == nullptr)
    throw Error(fmt::format("there is no stimulus \"{}\" for a target", id),
                "name stimuli of the manifest");
  const Synthesis& made = motions.of(id);
  motion::LiveTarget target;
  target.name = id;
  target.motion = made.motion;
  if (made.modified.empty()) target.weights = made.weights;
  target.playback = {stimulus->output.cycles, stimulus->output.in_place};
  target.shown_frames = motions.shown(*stimulus).frame_count();
  return target;
}

ordered_json metres(const motion::Vec3& v) { return {v.x(), v.y(), v.z()}; }

const ScaleGroup* find_group(const std::string& id, const ScaleSet& scales) {
  for (const ScaleGroup& group : scales.groups)
    if (group.id == id) return &group;
  return nullptr;
}

/// What an adjective is called and what its ends are.
void add_texts(ordered_json& slider, const std::string& name, const ScaleSet& scales) {
  if (const ScaleGroup* group = find_group(name, scales)) {
    if (!group->japanese.empty()) slider["labels"] = {{"en", name}, {"ja", group->japanese}};
    return;
  }
  const Scale* scale = find_scale(scales, name);
  if (scale == nullptr) return;
  slider["low"] = scale->low;
  slider["high"] = scale->high;
  slider["texts"]["en"] = {scale->low, scale->high};
  if (!scale->japanese_low.empty() && !scale->japanese_high.empty())
    slider["texts"]["ja"] = {scale->japanese_low, scale->japanese_high};
  for (const auto& [language, ends] : scale->words) slider["texts"][language] = ends;
}

/// Whether a slider is shown at once.
bool is_primary(const std::string& name, const ScaleSet& scales,
                const std::vector<std::string>& primary) {
  if (!primary.empty()) return std::find(primary.begin(), primary.end(), name) != primary.end();
  return scales.groups.empty() || find_group(name, scales) != nullptr;
}

double mean_of(const motion::ParameterTable& table, std::size_t row) {
  return table.values.row(static_cast<Eigen::Index>(row)).mean();
}

ordered_json adjective_sliders(const motion::ParameterTable& table, const ScaleSet& scales,
                               const std::vector<std::string>& primary) {
  ordered_json sliders = ordered_json::array();
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const std::string& name = table.names[i];
    ordered_json slider = {{"name", name}};
    add_texts(slider, name, scales);
    slider["primary"] = is_primary(name, scales, primary);
    slider["mean"] = mean_of(table, i);
    sliders.push_back(slider);
  }
  return sliders;
}

ordered_json labels_of(std::string_view english, std::string_view japanese) {
  return {{"en", english}, {"ja", japanese}};
}

ordered_json feature_labels(const std::string& id) {
  for (int g = 0; g < motion::feature_group_count; ++g) {
    const auto group = static_cast<motion::FeatureGroup>(g);
    if (motion::id_of(group) == id)
      return labels_of(motion::name_of(group), motion::japanese_name_of(group));
  }
  const auto& features = motion::motion_features();
  const auto index = static_cast<std::size_t>(motion::find_motion_feature(id));
  return labels_of(features[index].name, features[index].japanese);
}

ordered_json feature_sliders(const motion::ParameterTable& table) {
  ordered_json sliders = ordered_json::array();
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const std::string& name = table.names[i];
    const bool is_group = motion::find_motion_feature(name) < 0;
    sliders.push_back({{"name", name},
                       {"labels", feature_labels(name)},
                       {"primary", is_group},
                       {"mean", mean_of(table, i)}});
  }
  return sliders;
}

/// All examples, which must be blendable, or the chosen one.
motion::ExampleSet bundled_examples(const Manifest& manifest, const Repertoire& repertoire,
                                    const LiveChoice& choice) {
  motion::ExampleSet examples = examples_for(choice.interpolation, repertoire);
  if (!choice.only.empty()) {
    std::erase_if(examples.examples,
                  [&](const motion::Example& example) { return example.name != choice.only; });
    examples.blendable = true;
    if (!examples.examples.empty()) return examples;
    throw Error(Place{manifest.file.string()},
                fmt::format("there is no example \"{}\"", choice.only), "name one of the examples");
  }
  if (examples.examples.empty() || !examples.blendable)
    throw Error(Place{manifest.file.string()}, "its examples cannot be blended live",
                "use examples that can be blended, without blendable: false");
  return examples;
}

}  // namespace

LiveChoice live_choice(const Manifest& manifest) {
  return {{}, manifest.interpolation, manifest.output, {}};
}

motion::LiveBundle live_bundle(const Manifest& manifest, Motions& motions,
                               const LiveChoice& choice) {
  const Repertoire& repertoire = motions.repertoire();
  motion::LiveBundle bundle;
  bundle.examples = bundled_examples(manifest, repertoire, choice);
  if (choice.only.empty()) {
    bundle.adjectives = repertoire.parameters;
    bundle.features = repertoire.features.table;
    bundle.feature_scale = repertoire.features.scale;
  }
  bundle.how = choice.interpolation;
  bundle.frames_per_second = choice.output.fps;
  bundle.playback = {choice.output.cycles, choice.output.in_place};
  for (const std::string& id : choice.targets) bundle.targets.push_back(live_target(id, motions));
  bundle.info = live_info(bundle, repertoire.scales, choice.primary).dump();
  return bundle;
}

ordered_json body_info(const motion::Skeleton& body) {
  ordered_json names = ordered_json::array(), parents = names, offsets = names, tips = names;
  for (const motion::Joint& joint : body.joints) {
    names.push_back(joint.name);
    parents.push_back(joint.parent);
    offsets.push_back(metres(joint.offset));
    tips.push_back(joint.tip ? metres(*joint.tip) : ordered_json());
  }
  return {{"names", names}, {"parents", parents}, {"offsets", offsets}, {"tips", tips}};
}

ordered_json live_info(const motion::LiveBundle& bundle, const ScaleSet& scales,
                       const std::vector<std::string>& primary) {
  ordered_json examples = ordered_json::array(), targets = examples;
  for (const motion::Example& example : bundle.examples.examples) examples.push_back(example.name);
  for (const motion::LiveTarget& target : bundle.targets) targets.push_back(target.name);
  const motion::Skeleton& body = bundle.examples.examples.front().clip.body;
  return {{"body", body_info(body)},
          {"examples", examples},
          {"sliders",
           {{"adjectives", adjective_sliders(bundle.adjectives, scales, primary)},
            {"features", feature_sliders(bundle.features)}}},
          {"targets", targets},
          {"foot_lock", bundle.how.foot_lock},
          {"method", motion::name_of(bundle.how.weights.method)},
          {"fps", bundle.frames_per_second}};
}

}  // namespace mien::pipeline
