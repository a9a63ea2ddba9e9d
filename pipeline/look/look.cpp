#include "pipeline/look/look.h"

#include <variant>

#include "pipeline/documents/json_assign.h"
#include "pipeline/look/look_json.h"
#include "pipeline/look/set_file.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;
using Resolve = std::function<std::filesystem::path(const std::string&)>;

void assign_scene(const json& given, Look& look, const Resolve& resolve) {
  look.background.clear();
  assign(&given, look.scene);
  assign(member(given, "set"), look.scene);
  assign(member(given, "background"), look.background);
  const bool is_shipped = !builtin_set_text(look.scene).empty();
  look.scene_file = is_shipped ? std::filesystem::path() : resolve(look.scene);
}

}  // namespace

std::string scene_of(const Look& look) {
  if (!look.scene.empty()) return look.scene;
  return std::holds_alternative<scenes::PointLightOptions>(look.figure) ? "void" : "studio";
}

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
