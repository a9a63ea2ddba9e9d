#include "motion/formats/fbx/fbx_scene.h"

#include <array>
#include <utility>

#include "motion/error.h"

namespace mien::motion {

namespace {

/// An axis of the settings: its index and sign.
struct SignedAxis {
  std::int64_t axis = 0;
  std::int64_t sign = 1;

  Vec3 vector() const { return (sign < 0 ? -1.0 : 1.0) * Vec3::Unit(static_cast<int>(axis)); }
};

/// The node whose properties are the global settings: a section of its own, in old files one of
/// the objects.
std::uint32_t settings_node(const FbxDocument& document) {
  if (const std::uint32_t own = find_child(document, 0, "GlobalSettings")) return own;
  const std::uint32_t objects = find_child(document, 0, "Objects");
  return objects == 0 ? 0 : find_child(document, objects, "GlobalSettings");
}

}  // namespace

FbxSettings parse_fbx_settings(const FbxDocument& document) {
  FbxSettings settings;
  const std::uint32_t node = settings_node(document);
  if (node == 0) return settings;
  SignedAxis up{1, 1};
  SignedAxis front{2, 1};
  SignedAxis coordinate{0, 1};
  std::int64_t time_mode = 0;
  double custom_rate = 0.0;
  const std::pair<std::string_view, std::int64_t*> integers[] = {
      {"UpAxis", &up.axis},
      {"UpAxisSign", &up.sign},
      {"FrontAxis", &front.axis},
      {"FrontAxisSign", &front.sign},
      {"CoordAxis", &coordinate.axis},
      {"CoordAxisSign", &coordinate.sign},
      {"TimeMode", &time_mode}};
  for (const FbxProperty& property : properties_of(document, node)) {
    if (property.count == 0) continue;
    for (const auto& [name, integer] : integers) {
      if (property.name == name) *integer = property.integer;
    }
    if (property.name == "UnitScaleFactor")
      settings.stated_metres_per_unit = property.numbers[0] / 100.0;
    if (property.name == "CustomFrameRate") custom_rate = property.numbers[0];
  }
  bool seen[3] = {false, false, false};
  for (const SignedAxis& one : {up, front, coordinate}) {
    const bool is_new = one.axis >= 0 && one.axis < 3 && !seen[one.axis];
    if (!is_new) refuse_fbx(document, node, "the axes of the global settings are not three");
    seen[one.axis] = true;
  }
  settings.metres_per_unit = settings.stated_metres_per_unit.value_or(settings.metres_per_unit);
  if (!(settings.metres_per_unit > 1e-9 && settings.metres_per_unit < 1e9)) {
    refuse_fbx(document, node, "the unit of length (UnitScaleFactor) is not positive or too large");
  }
  settings.to_y_up.row(0) = coordinate.vector().transpose();
  settings.to_y_up.row(1) = up.vector().transpose();
  settings.to_y_up.row(2) = front.vector().transpose();
  settings.frames_per_second = frame_rate_of_time_mode(time_mode, custom_rate);
  return settings;
}

FbxScene parse_fbx_scene(std::string_view bytes, const std::string& file_name) {
  FbxScene scene;
  scene.document = parse_fbx_document(bytes, file_name);
  scene.objects = parse_fbx_objects(scene.document);
  scene.settings = parse_fbx_settings(scene.document);
  scene.models = parse_fbx_models(scene.document, scene.objects);
  scene.parents_first = parents_first(scene.models);
  scene.takes = fbx_takes(scene.document, scene.objects);
  return scene;
}

std::vector<FbxPlace> places_of(const FbxScene& scene, const std::vector<FbxMoving>& moving) {
  std::vector<FbxPlace> places(scene.models.size());
  for (const int m : scene.parents_first) {
    const FbxModel& model = scene.models[static_cast<size_t>(m)];
    const FbxPlace parent =
        model.parent < 0 ? FbxPlace{} : places[static_cast<size_t>(model.parent)];
    places[static_cast<size_t>(m)] = place_below(parent, model, moving[static_cast<size_t>(m)]);
  }
  return places;
}

std::vector<FbxMoving> at_rest(const FbxScene& scene) {
  std::vector<FbxMoving> moving;
  moving.reserve(scene.models.size());
  for (const FbxModel& model : scene.models) moving.push_back(at_rest(model));
  return moving;
}

double frame_rate_of_time_mode(std::int64_t mode, double custom) {
  constexpr std::array<double, 19> rates = {0.0,
                                            120.0,
                                            100.0,
                                            60.0,
                                            50.0,
                                            48.0,
                                            30.0,
                                            30.0,
                                            30000.0 / 1001.0,
                                            30000.0 / 1001.0,
                                            25.0,
                                            24.0,
                                            1000.0,
                                            24000.0 / 1001.0,
                                            0.0,
                                            96.0,
                                            72.0,
                                            60000.0 / 1001.0,
                                            120000.0 / 1001.0};
  if (mode == 14) return custom >= 1.0 && custom <= 1000.0 ? custom : 0.0;
  return mode >= 0 && mode < static_cast<std::int64_t>(rates.size())
             ? rates[static_cast<size_t>(mode)]
             : 0.0;
}

}  // namespace mien::motion
