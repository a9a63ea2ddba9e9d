#include "pipeline/look/look_json.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "pipeline/documents/json_assign.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;
using Resolve = std::function<std::filesystem::path(const std::string&)>;

void assign(const json* value, std::vector<std::string>& target) {
  if (value == nullptr || !value->is_array()) return;
  for (const json& word : *value) {
    if (word.is_string()) target.push_back(word.get<std::string>());
  }
}

std::optional<motion::Vec3> point_from(const json* value) {
  const auto is_number = [](const json& number) { return number.is_number(); };
  if (value == nullptr || !value->is_array() || value->size() != 3) return std::nullopt;
  if (!std::ranges::all_of(*value, is_number)) return std::nullopt;
  return motion::Vec3((*value)[0].get<double>(), (*value)[1].get<double>(),
                      (*value)[2].get<double>());
}

using pipeline::assign;

scenes::MannequinOptions mannequin_from(const json& given) {
  scenes::MannequinOptions options;
  assign(member(given, "build"), options.build);
  assign(member(given, "sex"), options.sex);
  return options;
}

scenes::BodyFigure body_from(const json& given, const Resolve& resolve) {
  if (given == "mannequin") return scenes::MannequinOptions{};
  if (const json* mannequin = member(given, "mannequin")) return mannequin_from(*mannequin);
  if (const json* character = member(given, "character")) {
    std::string file;
    assign(character, file);
    return scenes::CharacterOptions{resolve(file)};
  }
  return scenes::StickOptions{};
}

void assign_joints(const json* joints, scenes::PointLightOptions& options) {
  if (joints == nullptr) return;
  assign(joints, options.joint_set);
  assign(joints, options.joints);
  if (!options.joints.empty()) options.joint_set.clear();
}

scenes::PointLightOptions point_light_from(const json& given) {
  scenes::PointLightOptions options;
  assign_joints(member(given, "joints"), options);
  assign(member(given, "size"), options.size_px);
  assign(member(given, "size_m"), options.size_m);
  assign(member(given, "polarity"), options.dark_on_light,
         {{"light-on-dark", false}, {"dark-on-light", true}});
  assign(member(given, "contrast"), options.contrast);
  assign(member(given, "colour"), options.colour);
  assign(member(given, "background"), options.background);
  assign(member(given, "lifetime"), options.lifetime);
  assign(member(given, "inverted"), options.inverted);
  assign(member(given, "mirrored"), options.mirrored);
  assign(member(given, "rotated"), options.rotated_degrees);
  assign(member(given, "scrambled"), options.scrambled);
  assign(member(given, "reversed"), options.reversed);
  assign(member(given, "constant_speed"), options.constant_speed);
  assign(member(given, "phase_scrambled"), options.phase_scrambled);
  assign(member(given, "noise"), options.noise);
  assign(member(given, "mask"), options.mask);
  assign(member(given, "seed"), options.seed);
  return options;
}

scenes::TrailOptions trail_from(const json& given, const Resolve& resolve) {
  scenes::TrailOptions options;
  if (const json* figure = member(given, "figure")) options.figure = body_from(*figure, resolve);
  // Onion skin and traces are there instead of poses left behind, unless these are asked for too.
  if (given.contains("before") || given.contains("after") || given.contains("traces")) {
    options.poses = 0;
  }
  assign(member(given, "poses"), options.poses);
  assign(member(given, "before"), options.before);
  assign(member(given, "after"), options.after);
  assign(member(given, "every"), options.every_s);
  assign(member(given, "faintest"), options.faintest);
  assign(member(given, "traces"), options.traces);
  assign(member(given, "trace_width"), options.trace_width_m);
  return options;
}

std::vector<scenes::CameraKey> path_from(const json& given) {
  std::vector<scenes::CameraKey> path;
  for (const json& one : given) {
    scenes::CameraKey key;
    assign(member(one, "at"), key.seconds);
    key.position = point_from(member(one, "position")).value_or(key.position);
    key.target = point_from(member(one, "target")).value_or(key.target);
    path.push_back(key);
  }
  return path;
}

scenes::ScreenSettings screen_from(const json& given) {
  scenes::ScreenSettings screen;
  assign(member(given, "distance_cm"), screen.distance_cm);
  assign(member(given, "width_cm"), screen.width_cm);
  assign(member(given, "degrees"), screen.degrees);
  return screen;
}

}  // namespace

scenes::Figure figure_from(const json& given, const Resolve& resolve) {
  if (given == "point-light") return scenes::PointLightOptions{};
  if (given == "trail") return scenes::TrailOptions{};
  if (const json* dots = member(given, "point-light")) return point_light_from(*dots);
  if (const json* trail = member(given, "trail")) return trail_from(*trail, resolve);
  return std::visit([](auto&& body) { return scenes::Figure(body); }, body_from(given, resolve));
}

scenes::CameraSettings camera_from(const json& given) {
  scenes::CameraSettings camera;
  assign(&given, camera.view);
  assign(member(given, "view"), camera.view);
  assign(member(given, "orthographic"), camera.orthographic);
  assign(member(given, "fov"), camera.fov_degrees);
  camera.position = point_from(member(given, "position"));
  camera.target = point_from(member(given, "target"));
  if (const json* path = member(given, "path")) camera.path = path_from(*path);
  if (const json* stereo = member(given, "stereo")) {
    double separation = 0.063;
    assign(member(*stereo, "separation"), separation);
    camera.stereo_separation_m = separation;
  }
  if (const json* screen = member(given, "screen")) camera.screen = screen_from(*screen);
  assign(member(given, "figure_px"), camera.figure_px);
  if (const json* lens = member(given, "depth_of_field")) {
    camera.depth_of_field.emplace();
    assign(member(*lens, "aperture"), camera.depth_of_field->aperture_m);
    assign(member(*lens, "focus"), camera.depth_of_field->focus_m);
  }
  return camera;
}

}  // namespace mien::pipeline
