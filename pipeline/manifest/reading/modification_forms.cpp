#include <algorithm>

#include "motion/formats/motion_file.h"
#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/modification.h"
#include "pipeline/manifest/stimulus.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

bool has(const json& list, const char* word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

/// A unit of posture that is there already changes, others are added.
template <class Change>
void lay_over(std::vector<Change>& posture, const Change& change) {
  const auto same = std::ranges::find(posture, change.unit, &Change::unit);
  if (same == posture.end()) {
    posture.push_back(change);
  } else {
    *same = change;
  }
}

/// What an edit names, as a map that can be read again.
OrderedJson named_map(const ModificationEdit& edit, const WritingOptions& how) {
  std::vector<FieldEntry> entries = entries_of(edit.values, how);
  std::erase_if(entries, [&](const FieldEntry& entry) { return !edit.names(entry.path); });
  return nested_map(entries);
}

}  // namespace

void PoseMotionForm::read(const DocumentValue& given, PoseSource& pose) {
  std::string name;
  assign(&given.value, name);
  if (motion::is_motion_file(name)) {
    pose.file = given.context.resolve(name);
  } else {
    pose.example = name;
  }
}

OrderedJson PoseMotionForm::write(const PoseSource& pose, const WritingOptions& how) {
  return pose.file.empty() ? OrderedJson(pose.example) : written(pose.file, how);
}

void LimbsForm::read(const DocumentValue& given, motion::Limbs& limbs) {
  const json& list = given.value;
  if (!list.is_array()) return;
  limbs.head = has(list, "head");
  limbs.left_hand = has(list, "hands") || has(list, "left-hand");
  limbs.right_hand = has(list, "hands") || has(list, "right-hand");
  limbs.left_foot = has(list, "feet") || has(list, "left-foot");
  limbs.right_foot = has(list, "feet") || has(list, "right-foot");
}

OrderedJson LimbsForm::write(const motion::Limbs& limbs, const WritingOptions&) {
  OrderedJson list = OrderedJson::array();
  const auto add = [&](bool is_in, const char* word) {
    if (is_in) list.push_back(word);
  };
  add(limbs.head, "head");
  add(limbs.left_hand && limbs.right_hand, "hands");
  add(limbs.left_hand && !limbs.right_hand, "left-hand");
  add(limbs.right_hand && !limbs.left_hand, "right-hand");
  add(limbs.left_foot && limbs.right_foot, "feet");
  add(limbs.left_foot && !limbs.right_foot, "left-foot");
  add(limbs.right_foot && !limbs.left_foot, "right-foot");
  return list;
}

void PostureForm::read(const DocumentValue& given, std::vector<motion::PostureChange>& posture) {
  if (!given.value.is_object()) return;
  for (const std::string& key : written_order(given.value, given.path, given.context.places)) {
    const auto unit = motion::posture_unit(key);
    if (unit && given.value[key].is_number())
      lay_over(posture, motion::PostureChange{*unit, given.value[key].get<double>()});
  }
}

OrderedJson PostureForm::write(const std::vector<motion::PostureChange>& posture,
                               const WritingOptions&) {
  if (posture.empty()) return {};
  OrderedJson map;
  for (const motion::PostureChange& change : posture)
    map[std::string(motion::name_of(change.unit))] = change.degrees;
  return map;
}

void RangeForm::read(const DocumentValue& given, std::vector<motion::RangeShare>& range) {
  if (!given.value.is_object()) return;
  for (const std::string& key : written_order(given.value, given.path, given.context.places)) {
    const auto unit = motion::posture_unit(key);
    if (unit && given.value[key].is_number())
      lay_over(range, motion::RangeShare{*unit, given.value[key].get<double>()});
  }
}

OrderedJson RangeForm::write(const std::vector<motion::RangeShare>& range, const WritingOptions&) {
  if (range.empty()) return {};
  OrderedJson map;
  for (const motion::RangeShare& each : range)
    map[std::string(motion::name_of(each.unit))] = each.share;
  return map;
}

void GestureForm::read(const DocumentValue& given, motion::GestureChange& gesture) {
  if (!given.value.is_object()) return;
  assign(member(given.value, "height"), gesture.height);
  assign(member(given.value, "width"), gesture.width);
  assign(member(given.value, "speed"), gesture.speed);
  assign(member(given.value, "repetitions"), gesture.repetitions);
}

OrderedJson GestureForm::write(const motion::GestureChange& gesture, const WritingOptions&) {
  OrderedJson map;
  if (gesture.height != 1.0) map["height"] = gesture.height;
  if (gesture.width != 1.0) map["width"] = gesture.width;
  if (gesture.speed != 1.0) map["speed"] = gesture.speed;
  if (gesture.repetitions != 0) map["repetitions"] = gesture.repetitions;
  return map;
}

void EditForm::read(const DocumentValue& given, ModificationEdit& edit) {
  pipeline::read(given, edit.values);
  for (const FieldEntry& entry : entries_of(motion::Modification{}, {})) {
    if (member(given.value, entry.path.c_str())) edit.named.insert(entry.path);
  }
  FieldReader reader(given);
  reader("pose", edit.pose, concerns::motion);
}

OrderedJson EditForm::write(const ModificationEdit& edit, const WritingOptions& how) {
  OrderedJson map = named_map(edit, how);
  if (edit.pose) map["pose"] = written(*edit.pose, how);
  return map;
}

motion::Modification with_edit(motion::Modification modification, const ModificationEdit& edit) {
  if (edit.names("paths")) modification.gains.reset();
  const Places places;
  const ReadingContext context{places, [](const std::string& path) { return path; }};
  json named = named_map(edit, {});
  for (const char* key : {"posture", "range"}) named.erase(key);  // whose order counts
  read({named, "", context}, modification);
  for (const motion::PostureChange& change : edit.values.posture)
    lay_over(modification.posture, change);
  for (const motion::RangeShare& each : edit.values.relative.range)
    lay_over(modification.relative.range, each);
  return modification;
}

void StyleRepairForm::read(const DocumentValue& given, bool& feet) { feet = given.value != "none"; }

OrderedJson StyleRepairForm::write(bool feet, const WritingOptions&) {
  return feet ? "plants" : "none";
}

void StyleForm::read(const DocumentValue& given, std::optional<StyleStep>& style) {
  if (!member(given.value, "method")) return;
  style.emplace();
  pipeline::read(given, *style);
}

OrderedJson StyleForm::write(const std::optional<StyleStep>& style, const WritingOptions& how) {
  return style ? written(*style, how) : OrderedJson::object();
}

void StepsForm::read(const DocumentValue& given, std::vector<ModificationStep>& steps) {
  const auto add = [&](const DocumentValue& one) {
    if (!one.value.is_object()) return;
    steps.push_back({.path = one.path});
    pipeline::read(one, steps.back());
  };
  if (!given.value.is_array()) return add(given);
  for (std::size_t i = 0; i < given.value.size(); ++i)
    add({given.value[i], element_path(given.path, i), given.context});
}

OrderedJson StepsForm::write(const std::vector<ModificationStep>& steps,
                             const WritingOptions& how) {
  return steps.size() == 1 ? written(steps.front(), how) : written(steps, how);
}

}  // namespace mien::pipeline
