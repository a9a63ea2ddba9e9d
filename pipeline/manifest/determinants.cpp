#include "pipeline/manifest/determinants.h"

#include <algorithm>
#include <cstdint>

#include "pipeline/look/set_file.h"
#include "pipeline/manifest/example_files.h"
#include "pipeline/tasks/code_identity.h"
#include "scenes/character/character.h"
#include "scenes/figures/figure.h"

namespace mien::pipeline {

namespace {

template <class Enum>
void add_choice(KeyBuilder& key, std::string_view name, Enum value) {
  key.add(name, static_cast<std::int64_t>(value));
}

void add_values(KeyBuilder& key, std::string_view name, const NamedValues& values) {
  for (const auto& [parameter, value] : values) key.add(name, parameter).add("value", value);
}

void add_weights(KeyBuilder& key, const motion::InterpolationOptions& weights) {
  add_choice(key, "method", weights.method);
  key.add("neighbours", std::int64_t{weights.nearest.neighbours})
      .add("blends", std::int64_t{weights.nearest.trials})
      .add("blends seed", static_cast<std::int64_t>(weights.nearest.seed))
      .add("power", weights.power)
      .add("cells", std::int64_t{weights.grid_cells});
  add_choice(key, "nodes", weights.grid_source);
  add_choice(key, "drift", weights.kriging.linear_drift);
  add_choice(key, "estimate", weights.pca.estimate);
  key.add("nugget", weights.kriging.nugget)
      .add("variance", weights.pca.variance_share)
      .add("noise", weights.pca.noise)
      .add("step", weights.click_step);
}

void add_pose(KeyBuilder& key, const PoseSource& pose) {
  key.add("pose", pose.example).add("frame", std::int64_t{pose.frame});
  if (!pose.file.empty()) add_file(key, pose.file);
}

void add_gains(KeyBuilder& key, const motion::PathGains& gains) {
  key.add("low", gains.low).add("middle", gains.middle).add("high", gains.high);
  for (const double band : gains.bands) key.add("band", band);
}

void add_modification(KeyBuilder& key, const motion::Modification& m) {
  key.add("paths", m.paths).add("acceleration", m.acceleration);
  if (m.gains) add_gains(key, *m.gains);
  add_choice(key, "signal", m.signal);
  add_choice(key, "acceleration_at", m.acceleration_place);
  const std::int64_t limbs = m.limbs.head + 2 * m.limbs.left_hand + 4 * m.limbs.right_hand +
                             8 * m.limbs.left_foot + 16 * m.limbs.right_foot;
  key.add("limbs", limbs);
  for (const motion::PostureChange& change : m.posture) {
    key.add("posture", motion::name_of(change.unit)).add("degrees", change.degrees);
  }
  key.add("tempo", m.tempo)
      .add("variation", m.variation)
      .add("seed", static_cast<std::int64_t>(m.seed));
  add_choice(key, "repair", m.repair);
  add_choice(key, "soft_limits", m.soft_joint_limits);
}

void add_style(KeyBuilder& key, const StyleStep& style) {
  key.add("style", name_of(style.method))
      .add("neutral", style.neutral)
      .add("styled", style.styled)
      .add("harmonics", std::int64_t{style.harmonics})
      .add("order", std::int64_t{style.order})
      .add("inputs", std::int64_t{style.inputs})
      .add("components", std::int64_t{style.components})
      .add("seed", static_cast<std::int64_t>(style.seed));
  for (const int component : style.swap) key.add("swap", std::int64_t{component});
  add_choice(key, "feet", style.feet);
}

void add_steps(KeyBuilder& key, const Stimulus& stimulus) {
  for (const ModificationStep& step : stimulus.modify) {
    key.add("modify", step.emotion).add("strength", step.strength);
    add_modification(key, step.modification);
    if (step.style) add_style(key, *step.style);
    if (!step.pose) continue;
    add_pose(key, step.pose->neutral);
    add_pose(key, step.pose->posed);
  }
  if (!stimulus.modify.empty()) add_choice(key, "on_fault", stimulus.on_fault);
}

/// Files that a motion file of its kind may refer to: skeletons beside AMC, buffers beside glTF.
std::vector<std::filesystem::path> parts_of(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  const std::string wanted = ending == ".amc" ? ".asf" : ending == ".gltf" ? ".bin" : "";
  std::vector<std::filesystem::path> parts;
  if (wanted.empty()) return parts;
  for (const auto& entry : std::filesystem::directory_iterator(absolute(file).parent_path())) {
    if (entry.path().extension() == wanted) parts.push_back(entry.path());
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

/// With the buffers and pictures that its file refers to.
void add_character(KeyBuilder& key, const std::filesystem::path& file) {
  add_file(key, file);
  for (const std::filesystem::path& part : scenes::parts_of_character(file)) add_file(key, part);
}

void add_look(KeyBuilder& key, const Look& look) {
  key.add("look", look.written).add("set", hash_of(builtin_set_text(scene_of(look))));
  if (!look.scene_file.empty()) add_file(key, look.scene_file);
  if (const auto* character = scenes::character_in(look.figure))
    add_character(key, character->file);
}

Hash libraries_key() {
  KeyBuilder key;
  for (const auto& [name, version] : library_versions()) key.add(name, version);
  return key.key();
}

Hash repertoire_key(const Manifest& manifest) {
  KeyBuilder key;
  const Examples& examples = manifest.examples;
  key.add("builtin", examples.builtin).add("seed", static_cast<std::int64_t>(manifest.seed));
  add_choice(key, "cycle", examples.cycle);
  add_choice(key, "blend", examples.blendable);
  add_choice(key, "labels", examples.labels);
  for (const auto& [stem, label] : examples.given_labels) key.add(stem, label);
  for (const auto& [stem, times] : examples.keytimes) {
    for (const double time : times) key.add(stem, time);
  }
  add_choice(key, "ratings", manifest.ratings.source);
  key.add("raters", std::int64_t{manifest.ratings.raters});
  for (const std::filesystem::path& file : repertoire_files(manifest)) add_file(key, file);
  return key.key();
}

}  // namespace

SharedDeterminants shared_determinants(const Manifest& manifest) {
  return {libraries_key(), repertoire_key(manifest)};
}

void add_file(KeyBuilder& key, const std::filesystem::path& file) {
  key.add("file", file.filename().string()).add("content", hash_of_file(file));
  for (const std::filesystem::path& part : parts_of(file)) {
    key.add("part", part.filename().string()).add("content", hash_of_file(part));
  }
}

void add_motion(KeyBuilder& key, const Stimulus& stimulus) {
  key.add("id", stimulus.id);
  add_values(key, "adjective", stimulus.adjectives);
  add_values(key, "feature", stimulus.features);
  add_values(key, "weight", stimulus.weights);
  if (stimulus.clip) {
    add_file(key, stimulus.clip->file);
    if (const auto& frames = stimulus.clip->frames) {
      key.add("first", std::int64_t{(*frames)[0]}).add("last", std::int64_t{(*frames)[1]});
    }
  }
  add_interpolation(key, stimulus.interpolation);
  add_steps(key, stimulus);
  key.add("fps", stimulus.output.fps).add("cycles", std::int64_t{stimulus.output.cycles});
  add_choice(key, "in_place", stimulus.output.in_place);
}

void add_interpolation(KeyBuilder& key, const Interpolation& how) {
  add_weights(key, how.weights);
  add_choice(key, "rotations", how.rotations);
  add_choice(key, "time_warp", how.time_warp);
  add_choice(key, "foot_lock", how.foot_lock);
}

void add_film(KeyBuilder& key, const Stimulus& stimulus) {
  add_look(key, stimulus.look);
  add_choice(key, "role", stimulus.role);
  key.add("width", std::int64_t{stimulus.output.size[0]})
      .add("height", std::int64_t{stimulus.output.size[1]})
      .add("fps", stimulus.output.fps);
  if (stimulus.output.scale != 1.0) key.add("scale", stimulus.output.scale);
  if (const auto& crop = stimulus.output.crop) {
    for (const int edge : *crop) key.add("crop", std::int64_t{edge});
  }
  add_choice(key, "quality", stimulus.output.quality);
  if (stimulus.output.shutter > 0.0) key.add("shutter", stimulus.output.shutter);
}

void add_presentation(KeyBuilder& key, const Presentation& presentation) {
  if (!presentation.card.empty()) {
    key.add("card", presentation.card).add("seconds", presentation.card_seconds);
  }
  key.add("fixation", presentation.fixation_seconds)
      .add("size", std::int64_t{presentation.fixation_size})
      .add("before", presentation.blank_before)
      .add("after", presentation.blank_after)
      .add("in", presentation.fade_in)
      .add("out", presentation.fade_out)
      .add("background", presentation.background);
}

}  // namespace mien::pipeline
