#include "pipeline/look.h"

#include <algorithm>

#include "pipeline/json_assign.h"
#include "scenes/sets.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;
using Resolve = std::function<std::filesystem::path(const std::string&)>;

scenes::Figure mannequin_from(const json& given) {
  scenes::MannequinOptions options;
  assign(member(given, "build"), options.build);
  assign(member(given, "sex"), options.sex);
  return options;
}

scenes::Figure figure_named(const std::string& name) {
  if (name == "mannequin") return scenes::MannequinOptions{};
  return scenes::StickOptions{};
}

/// A name, or a name with options.
scenes::Figure figure_from(const json& given, const Resolve& resolve) {
  if (given.is_string()) return figure_named(given.get<std::string>());
  if (const json* mannequin = member(given, "mannequin")) return mannequin_from(*mannequin);
  if (const json* character = member(given, "character")) {
    std::string file;
    assign(character, file);
    return scenes::CharacterOptions{resolve(file)};
  }
  return scenes::StickOptions{};
}

scenes::CameraSettings camera_from(const json& given) {
  scenes::CameraSettings camera;
  assign(&given, camera.view);
  assign(member(given, "view"), camera.view);
  return camera;
}

void assign_scene(const json& given, Look& look, const Resolve& resolve) {
  assign(&given, look.scene);
  const std::vector<std::string> names = scenes::set_names();
  const bool is_shipped = std::find(names.begin(), names.end(), look.scene) != names.end();
  look.scene_file = is_shipped ? std::filesystem::path() : resolve(look.scene);
}

}  // namespace

void overlay(const json& given, Look& look, const Resolve& resolve) {
  if (!given.is_object()) return;
  if (const json* scene = member(given, "scene")) assign_scene(*scene, look, resolve);
  if (const json* figure = member(given, "figure")) look.figure = figure_from(*figure, resolve);
  if (const json* camera = member(given, "camera")) look.camera = camera_from(*camera);
  json written = json::parse(look.written);
  for (const char* key : {"scene", "figure", "camera"}) {
    if (const json* value = member(given, key)) written[key] = *value;
  }
  look.written = written.dump();
}

}  // namespace mien::pipeline
