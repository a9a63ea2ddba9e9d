#include "pipeline/manifest/look/set_file.h"

#include "motion/text/file_contents.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/field_writer.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/base/reading/yaml_json.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/manifest/look/set_fields.h"

#include "embedded/corridor_set.h"
#include "embedded/lab_grid_set.h"
#include "embedded/studio_set.h"
#include "embedded/treadmill_set.h"
#include "embedded/void_set.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// A set before its file says anything: without light and ground.
scenes::SetPlan plain_set() {
  scenes::SetPlan plan;
  plan.sky.zenith = plan.sky.horizon = plan.sky.below = render::Color::Zero();
  return plan;
}

/// What the schema cannot say.
std::vector<Fault> faults_of(const scenes::SetPlan& plan, const Places& places) {
  std::vector<Fault> faults;
  if (plan.ground && plan.ground->fade_end <= plan.ground->fade_start) {
    faults.push_back({place_of(places, "ground.fade"), "ground.fade",
                      "fading of the floor ends before it begins",
                      "write the smaller value first"});
  }
  if (plan.ground && plan.ground->line_spacing > 0.0f &&
      plan.ground->line_width > plan.ground->line_spacing) {
    faults.push_back({place_of(places, "ground.lines.width"), "ground.lines.width",
                      "lines are wider than their spacing", "write width less than every"});
  }
  if (plan.belt && !plan.in_place) {
    faults.push_back({key_place_of(places, "belt"), "belt",
                      "a belt requires a figure walking in place", "add in_place: true"});
  }
  return faults;
}

}  // namespace

void BackgroundForm::read(const DocumentValue& given, render::Sky& sky) {
  assign(&given.value, sky.backdrop_horizon);
  assign(&given.value, sky.backdrop_zenith);
  assign(member(given.value, "horizon"), sky.backdrop_horizon);
  assign(member(given.value, "zenith"), sky.backdrop_zenith);
}

OrderedJson BackgroundForm::write(const render::Sky& sky, const WritingOptions& how) {
  return {{"horizon", written(sky.backdrop_horizon, how)},
          {"zenith", written(sky.backdrop_zenith, how)}};
}

void GroundForm::read(const DocumentValue& given, std::optional<render::Ground>& ground) {
  ground.emplace();
  ground->line_spacing = 0.0f;
  pipeline::read(given, *ground);
}

OrderedJson GroundForm::write(const std::optional<render::Ground>& ground,
                              const WritingOptions& how) {
  return ground ? nested_map(entries_of(*ground, how)) : OrderedJson();
}

void FadeForm::read(const DocumentValue& given, render::Ground& ground) {
  assign(&given.value[0], ground.fade_start);
  assign(&given.value[1], ground.fade_end);
}

OrderedJson FadeForm::write(const render::Ground& ground, const WritingOptions&) {
  return {ground.fade_start, ground.fade_end};
}

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
  const motion::FileReading reading = motion::bytes_of_file(file, motion::max_document_bytes);
  if (reading.bytes) return parse_set(*reading.bytes, file);
  throw Error(Place{file.string(), 0, 0}, reading.error,
              motion::did_you_mean(name, set_names()) + " or name a file (my.set.yaml)");
}

scenes::SetPlan parse_set(std::string_view yaml, const fs::path& file) {
  const JsonReading reading = read_valid_json(yaml, file.string(), set_schema());
  const ReadingContext context{reading.places, [](const std::string& path) { return path; }};
  scenes::SetPlan plan = plain_set();
  read({reading.document, "", context}, plan);
  std::vector<Fault> faults = faults_of(plan, reading.places);
  if (!faults.empty()) throw Faults(faults);
  return plan;
}

}  // namespace mien::pipeline
