#include <variant>

#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/manifest/look/look_fields.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/manifest/look/set_file.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

constexpr double eyes_apart_m = 0.063;

/// A figure that is named, or a map of one.
bool is_figure(const Given& given, const char* name) {
  return given.value == name || member(given.value, name) != nullptr;
}

/// The options under a figure's name, if there are any, over those that it has anyway.
template <class Options>
Options options_of(const Given& given, const char* name, Options options = {}) {
  if (const json* map = member(given.value, name))
    read({*map, member_path(given.path, name), given.context}, options);
  return options;
}

scenes::CharacterOptions character_of(const Given& given) {
  scenes::CharacterOptions character;
  read({*member(given.value, "character"), member_path(given.path, "character"), given.context},
       character.file);
  return character;
}

/// Onion skin and traces are there instead of poses left behind, unless these are asked for too.
scenes::TrailOptions trail_before(const Given& given) {
  scenes::TrailOptions trail;
  const json* map = member(given.value, "trail");
  if (map == nullptr) return trail;
  if (map->contains("before") || map->contains("after") || map->contains("traces")) trail.poses = 0;
  return trail;
}

/// A map of one figure.
OrderedJson figure_map(const char* name, const auto& options, const Writing& how) {
  OrderedJson map;
  map[name] = written(options, how);
  return map;
}

OrderedJson figure_map(const scenes::StickOptions&, const Writing&) { return "stick"; }

OrderedJson figure_map(const scenes::MannequinOptions& mannequin, const Writing& how) {
  return figure_map("mannequin", mannequin, how);
}

OrderedJson figure_map(const scenes::CharacterOptions& character, const Writing& how) {
  return figure_map("character", character.file, how);
}

OrderedJson figure_map(const scenes::PointLightOptions& dots, const Writing& how) {
  return figure_map("point-light", dots, how);
}

OrderedJson figure_map(const scenes::TrailOptions& trail, const Writing& how) {
  OrderedJson map = figure_map("trail", trail, how);
  map["trail"]["poses"] = trail.poses;  // what it is unless told hangs on the others
  return map;
}

}  // namespace

void JointsForm::read(const Given& given, scenes::PointLightOptions& dots) {
  assign(&given.value, dots.joint_set);
  pipeline::read(given, dots.joints);
  if (!dots.joints.empty()) dots.joint_set.clear();
}

OrderedJson JointsForm::write(const scenes::PointLightOptions& dots, const Writing& how) {
  return dots.joints.empty() ? OrderedJson(dots.joint_set) : written(dots.joints, how);
}

void BodyFigureForm::read(const Given& given, scenes::BodyFigure& figure) {
  if (member(given.value, "character") != nullptr) {
    figure = character_of(given);
  } else if (is_figure(given, "mannequin")) {
    figure = options_of<scenes::MannequinOptions>(given, "mannequin");
  } else {
    figure = scenes::StickOptions{};
  }
}

OrderedJson BodyFigureForm::write(const scenes::BodyFigure& figure, const Writing& how) {
  return std::visit([&](const auto& body) { return figure_map(body, how); }, figure);
}

void FigureForm::read(const Given& given, scenes::Figure& figure) {
  if (is_figure(given, "point-light")) {
    figure = options_of<scenes::PointLightOptions>(given, "point-light");
  } else if (is_figure(given, "trail")) {
    figure = options_of(given, "trail", trail_before(given));
  } else {
    scenes::BodyFigure body;
    BodyFigureForm::read(given, body);
    std::visit([&](const auto& options) { figure = options; }, body);
  }
}

OrderedJson FigureForm::write(const scenes::Figure& figure, const Writing& how) {
  return std::visit([&](const auto& body) { return figure_map(body, how); }, figure);
}

void StereoForm::read(const Given& given, std::optional<double>& separation_m) {
  separation_m = eyes_apart_m;
  assign(member(given.value, "separation"), *separation_m);
}

OrderedJson StereoForm::write(const std::optional<double>& separation_m, const Writing&) {
  if (!separation_m) return {};
  return {{"separation", *separation_m}};
}

void SceneForm::read(const Given& given, Look& look) {
  look.background.clear();
  assign(&given.value, look.scene);
  assign(member(given.value, "set"), look.scene);
  assign(member(given.value, "background"), look.background);
  const bool is_shipped = !builtin_set_text(look.scene).empty();
  look.scene_file = is_shipped ? std::filesystem::path() : given.context.resolve(look.scene);
}

/// What a set holds counts by itself in keys.
OrderedJson SceneForm::write(const Look& look, const Writing& how) {
  if (look.scene.empty()) return {};
  // Without the file itself, which `written` would add to the key.
  const std::string name =
      look.scene_file.empty() ? look.scene : look.scene_file.filename().generic_string();
  const bool is_name = look.scene_file.empty() || how.for_key;
  const OrderedJson set = is_name ? OrderedJson(name) : written(look.scene_file, how);
  if (look.background.empty()) return set;
  return {{"set", set}, {"background", look.background}};
}

}  // namespace mien::pipeline
