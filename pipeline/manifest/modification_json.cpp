#include "pipeline/manifest/modification_json.h"

#include <algorithm>

#include "motion/formats/motion_file.h"
#include "pipeline/documents/json_assign.h"
#include "pipeline/documents/yaml_json.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

template <class Value>
void assign_optional(const json* value, std::optional<Value>& target) {
  if (value == nullptr) return;
  Value given{};
  assign(value, given);
  target = given;
}

template <class Enum>
void assign_optional(const json* value, std::optional<Enum>& target,
                     std::initializer_list<std::pair<const char*, Enum>> words) {
  if (value == nullptr) return;
  Enum given{};
  assign(value, given, words);
  target = given;
}

motion::PathGains path_gains(const json& map) {
  motion::PathGains gains;
  assign(member(map, "low"), gains.low);
  assign(member(map, "middle"), gains.middle);
  assign(member(map, "high"), gains.high);
  if (const json* bands = member(map, "bands"); bands && bands->is_array()) {
    for (const json& band : *bands) {
      if (band.is_number()) gains.bands.push_back(band.get<double>());
    }
  }
  return gains;
}

motion::Limbs limbs_of(const json& list) {
  motion::Limbs limbs{false, false, false, false, false};
  const auto has = [&](const char* word) {
    return std::find(list.begin(), list.end(), word) != list.end();
  };
  limbs.head = has("head");
  limbs.left_hand = has("hands") || has("left-hand");
  limbs.right_hand = has("hands") || has("right-hand");
  limbs.left_foot = has("feet") || has("left-foot");
  limbs.right_foot = has("feet") || has("right-foot");
  return limbs;
}

std::vector<motion::PostureChange> posture_of(const json& map, const std::string& path,
                                              const Places& places) {
  std::vector<motion::PostureChange> posture;
  for (const std::string& key : written_order(map, path, places)) {
    const auto unit = motion::posture_unit(key);
    if (unit && map[key].is_number()) posture.push_back({*unit, map[key].get<double>()});
  }
  return posture;
}

/// A text is a file when it ends like one, else an example.
PoseSource pose_of(const json* given,
                   const std::function<std::filesystem::path(std::string)>& resolve) {
  PoseSource pose;
  if (given == nullptr) return pose;
  std::string name;
  assign(given, name);
  assign(member(*given, "motion"), name);
  assign(member(*given, "frame"), pose.frame);
  if (motion::is_motion_file(name)) {
    pose.file = resolve(name);
  } else {
    pose.example = name;
  }
  return pose;
}

}  // namespace

ModificationEdit modification_edit(
    const json& map, const std::string& path, const Places& places,
    const std::function<std::filesystem::path(std::string)>& resolve) {
  ModificationEdit edit;
  assign_optional(member(map, "paths"), edit.paths);
  if (const json* gains = member(map, "gains")) edit.gains = path_gains(*gains);
  assign_optional(member(map, "signal"), edit.signal,
                  {{"direction-vectors", motion::RotationSignal::direction_vectors},
                   {"quaternions", motion::RotationSignal::quaternions}});
  assign_optional(member(map, "acceleration"), edit.acceleration);
  assign_optional(member(map, "acceleration_at"), edit.acceleration_place,
                  {{"pauses", motion::AccelerationPlace::pauses},
                   {"contacts", motion::AccelerationPlace::contacts}});
  if (const json* limbs = member(map, "limbs"); limbs && limbs->is_array()) {
    edit.limbs = limbs_of(*limbs);
  }
  if (const json* posture = member(map, "posture"); posture && posture->is_object()) {
    edit.posture = posture_of(*posture, member_path(path, "posture"), places);
  }
  if (const json* pose = member(map, "pose"); pose && pose->is_object()) {
    edit.pose = {pose_of(member(*pose, "neutral"), resolve),
                 pose_of(member(*pose, "posed"), resolve)};
  }
  assign_optional(member(map, "tempo"), edit.tempo);
  assign_optional(member(map, "variation"), edit.variation);
  assign_optional(member(map, "seed"), edit.seed);
  assign_optional(member(map, "repair"), edit.repair,
                  {{"plants", motion::FootRepair::plants},
                   {"hip-shift", motion::FootRepair::hip_shift},
                   {"none", motion::FootRepair::none}});
  assign_optional(member(map, "soft_limits"), edit.soft_limits);
  return edit;
}

std::optional<StyleStep> style_step(const json& map) {
  const json* method = member(map, "method");
  if (method == nullptr) return std::nullopt;
  StyleStep step;
  for (const auto& [word, meaning] : style_methods) {
    if (*method == word) step.method = meaning;
  }
  assign(member(map, "neutral"), step.neutral);
  assign(member(map, "styled"), step.styled);
  assign(member(map, "harmonics"), step.harmonics);
  assign(member(map, "order"), step.order);
  assign(member(map, "inputs"), step.inputs);
  assign(member(map, "components"), step.components);
  assign(member(map, "seed"), step.seed);
  if (const json* swap = member(map, "swap"); swap && swap->is_array()) {
    for (const json& component : *swap) {
      int number = 0;
      assign(&component, number);
      step.swap.push_back(number);
    }
  }
  const json* repair = member(map, "repair");
  step.feet = repair == nullptr || *repair != "none";
  return step;
}

}  // namespace mien::pipeline
