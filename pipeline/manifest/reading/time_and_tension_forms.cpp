#include <algorithm>

#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/modification.h"

namespace mien::pipeline {

namespace {

void assign_number(const nlohmann::json& map, const char* key, double& target) {
  if (const nlohmann::json* given = member(map, key)) assign(given, target);
}

}  // namespace

void TempoForm::read(const DocumentValue& given, motion::Tempo& tempo) {
  tempo = {};
  if (given.value.is_number()) tempo.factor = given.value.get<double>();
  if (!given.value.is_array()) return;
  for (const nlohmann::json& point : given.value) {
    const bool is_point =
        point.is_array() && point.size() == 2 && point[0].is_number() && point[1].is_number();
    if (is_point) tempo.curve.push_back({point[0].get<double>(), point[1].get<double>()});
  }
}

std::string path_of(const motion::TempoFault& fault, const std::string& path) {
  if (fault.point < 0) return path;
  return element_path(element_path(path, static_cast<std::size_t>(fault.point)),
                      fault.is_of_factor ? 1 : 0);
}

OrderedJson TempoForm::write(const motion::Tempo& tempo, const WritingOptions&) {
  if (tempo.curve.empty()) return tempo.factor;
  OrderedJson points = OrderedJson::array();
  for (const motion::TempoPoint& point : tempo.curve)
    points.push_back(OrderedJson::array({point.share, point.factor}));
  return points;
}

void StiffnessForm::read(const DocumentValue& given, motion::Stiffness& stiffness) {
  stiffness = {};
  if (given.value.is_number()) {
    const double all = given.value.get<double>();
    stiffness = {all, all, all, all, std::min(1.0, all)};
  }
  if (!given.value.is_object()) return;
  assign_number(given.value, "head", stiffness.head);
  assign_number(given.value, "trunk", stiffness.trunk);
  assign_number(given.value, "arms", stiffness.left_arm);
  assign_number(given.value, "arms", stiffness.right_arm);
  assign_number(given.value, "left-arm", stiffness.left_arm);
  assign_number(given.value, "right-arm", stiffness.right_arm);
  assign_number(given.value, "legs", stiffness.legs);
}

OrderedJson StiffnessForm::write(const motion::Stiffness& stiffness, const WritingOptions&) {
  if (motion::is_unit(stiffness)) return 1.0;
  OrderedJson map = OrderedJson::object();
  const auto add = [&](const char* part, double value) {
    if (value != 1.0) map[part] = value;
  };
  add("head", stiffness.head);
  add("trunk", stiffness.trunk);
  if (stiffness.left_arm == stiffness.right_arm) {
    add("arms", stiffness.left_arm);
  } else {
    add("left-arm", stiffness.left_arm);
    add("right-arm", stiffness.right_arm);
  }
  add("legs", stiffness.legs);
  return map;
}

std::string text_of(const motion::Stiffness& stiffness) {
  std::string text;
  if (motion::is_unit(stiffness)) return text;
  const OrderedJson parts = StiffnessForm::write(stiffness, {});
  for (const auto& [part, value] : parts.items())
    text += (text.empty() ? "" : ", ") + part + " " + value.dump();
  return text;
}

}  // namespace mien::pipeline
