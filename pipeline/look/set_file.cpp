#include "pipeline/look/set_file.h"

#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "motion/text/nearest_word.h"
#include "pipeline/documents/fault.h"
#include "pipeline/documents/json_assign.h"
#include "pipeline/documents/schema.h"
#include "pipeline/documents/yaml_json.h"
#include "pipeline/documents/yaml_tree.h"
#include "pipeline/look/colour_json.h"

#include "embedded/corridor_set.h"
#include "embedded/lab_grid_set.h"
#include "embedded/studio_set.h"
#include "embedded/treadmill_set.h"
#include "embedded/void_set.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

void assign(const json* value, float& target) {
  if (value != nullptr && value->is_number()) target = value->get<float>();
}

void assign(const json* value, motion::Vec3& target) {
  if (value == nullptr) return;
  for (int axis = 0; axis < 3; ++axis) {
    pipeline::assign(&(*value)[static_cast<std::size_t>(axis)], target[axis]);
  }
}

using pipeline::assign;

render::Sky sky_from(const json& document) {
  render::Sky sky;
  sky.zenith = sky.horizon = sky.below = render::Color::Zero();
  if (const json* given = member(document, "sky")) {
    assign(member(*given, "zenith"), sky.zenith);
    assign(member(*given, "horizon"), sky.horizon);
    assign(member(*given, "below"), sky.below);
  }
  const json& background = document["background"];
  assign(&background, sky.backdrop_horizon);
  assign(&background, sky.backdrop_zenith);
  assign(member(background, "horizon"), sky.backdrop_horizon);
  assign(member(background, "zenith"), sky.backdrop_zenith);
  return sky;
}

render::Ground ground_from(const json& given) {
  render::Ground ground;
  ground.line_spacing = 0.0f;
  assign(member(given, "colour"), ground.albedo);
  if (const json* lines = member(given, "lines")) {
    assign(member(*lines, "colour"), ground.line_albedo);
    assign(member(*lines, "every"), ground.line_spacing);
    assign(member(*lines, "width"), ground.line_width);
    assign(member(*lines, "major_every"), ground.major_every);
    assign(member(*lines, "major_colour"), ground.major_albedo);
  }
  if (const json* fade = member(given, "fade")) {
    assign(&(*fade)[0], ground.fade_start);
    assign(&(*fade)[1], ground.fade_end);
  }
  return ground;
}

scenes::KeyLight light_from(const json& given) {
  scenes::KeyLight light;
  assign(member(given, "azimuth"), light.azimuth_degrees);
  assign(member(given, "elevation"), light.elevation_degrees);
  assign(member(given, "distance"), light.distance_m);
  assign(member(given, "size"), light.side_m);
  assign(member(given, "strength"), light.strength);
  assign(member(given, "colour"), light.colour);
  return light;
}

scenes::Wall wall_from(const json& given) {
  scenes::Wall wall;
  assign(member(given, "at"), wall.side,
         {{"left", scenes::Side::left},
          {"right", scenes::Side::right},
          {"front", scenes::Side::front},
          {"back", scenes::Side::back}});
  assign(member(given, "distance"), wall.distance_m);
  assign(member(given, "height"), wall.height_m);
  assign(member(given, "length"), wall.length_m);
  assign(member(given, "colour"), wall.albedo);
  return wall;
}

scenes::Box box_from(const json& given) {
  scenes::Box box;
  assign(member(given, "centre"), box.centre);
  assign(member(given, "size"), box.size);
  assign(member(given, "colour"), box.albedo);
  return box;
}

scenes::Belt belt_from(const json& given) {
  scenes::Belt belt;
  assign(member(given, "width"), belt.width_m);
  assign(member(given, "length"), belt.length_m);
  assign(member(given, "colour"), belt.albedo);
  if (const json* stripes = member(given, "stripes")) {
    assign(member(*stripes, "colour"), belt.stripe_albedo);
    assign(member(*stripes, "every"), belt.stripe_every_m);
    assign(member(*stripes, "width"), belt.stripe_width_m);
  }
  return belt;
}

scenes::SetPlan plan_from(const json& document) {
  scenes::SetPlan plan;
  assign(member(document, "name"), plan.name);
  assign(member(document, "in_place"), plan.in_place);
  plan.sky = sky_from(document);
  if (const json* ground = member(document, "ground")) plan.ground = ground_from(*ground);
  for (const json& light : document.value("lights", json::array())) {
    plan.lights.push_back(light_from(light));
  }
  for (const json& wall : document.value("walls", json::array())) {
    plan.walls.push_back(wall_from(wall));
  }
  for (const json& box : document.value("boxes", json::array())) {
    plan.boxes.push_back(box_from(box));
  }
  if (const json* belt = member(document, "belt")) plan.belt = belt_from(*belt);
  return plan;
}

/// What the schema cannot say.
std::vector<Fault> faults_of(const scenes::SetPlan& plan, const Places& places) {
  std::vector<Fault> faults;
  if (plan.ground && plan.ground->fade_end <= plan.ground->fade_start) {
    faults.push_back({place_of(places, "ground.fade"), "ground.fade",
                      "the floor is gone before it begins to fade", "write the smaller first"});
  }
  if (plan.ground && plan.ground->line_spacing > 0.0f &&
      plan.ground->line_width > plan.ground->line_spacing) {
    faults.push_back({place_of(places, "ground.lines.width"), "ground.lines.width",
                      "lines are wider than their distance", "write width less than every"});
  }
  if (plan.belt && !plan.in_place) {
    faults.push_back({key_place_of(places, "belt"), "belt", "a belt needs a figure in place",
                      "add in_place: true"});
  }
  return faults;
}

}  // namespace

std::vector<std::string> set_names() {
  return {"studio", "void", "treadmill", "corridor", "lab-grid"};
}

std::string_view builtin_set_text(std::string_view name) {
  if (name == "studio") return embedded_studio_set;
  if (name == "void") return embedded_void_set;
  if (name == "treadmill") return embedded_treadmill_set;
  if (name == "corridor") return embedded_corridor_set;
  if (name == "lab-grid") return embedded_lab_grid_set;
  return {};
}

scenes::SetPlan read_set(const std::string& name, const fs::path& file) {
  if (const std::string_view text = builtin_set_text(name); !text.empty()) {
    return parse_set(text, name + ".set.yaml");
  }
  std::ifstream stream(file, std::ios::binary);
  std::error_code error;
  if (!stream || fs::is_directory(file, error)) {
    throw Error(Place{file.string(), 0, 0}, "cannot be read",
                motion::did_you_mean(name, set_names()) + " or name a file (my.set.yaml)");
  }
  return parse_set(std::string((std::istreambuf_iterator<char>(stream)), {}), file);
}

scenes::SetPlan parse_set(std::string_view yaml, const fs::path& file) {
  std::vector<Fault> faults;
  const YamlNode tree = read_yaml(yaml, file.string(), faults);
  if (!faults.empty()) throw Faults(faults);
  const json schema = set_schema();
  const JsonReading reading = to_json(tree, root_of(schema), process_environment(), faults);
  for (Fault& fault : check_schema(reading.document, schema, reading.places)) {
    faults.push_back(std::move(fault));
  }
  if (!faults.empty()) throw Faults(in_reading_order(std::move(faults)));
  scenes::SetPlan plan = plan_from(reading.document);
  faults = faults_of(plan, reading.places);
  if (!faults.empty()) throw Faults(faults);
  return plan;
}

}  // namespace mien::pipeline
