#include "pipeline/manifest/look/look_options.h"

#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "motion/text/excerpt.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/environment.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/base/reading/field_reader.h"
#include "pipeline/base/reading/option_document.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/manifest/look/look_checks.h"
#include "pipeline/manifest/look/look_fields.h"
#include "pipeline/manifest/look/point_form.h"
#include "scenes/character/character.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;

bool is_character(const std::string& figure) {
  return !figure.starts_with('{') && !figure.starts_with("character:") &&
         scenes::is_character_file(figure);
}

bool is_map(const std::string& text) {
  return text.starts_with('{') || text.find(": ") != std::string::npos;
}

/// A word without an ending, or a map, is not the name of a file.
bool is_face_file(const std::string& face) {
  return !is_map(face) && std::filesystem::path(face).has_extension();
}

/// Of a word that is none of the known ones, and of weights whose colon YAML does not see.
void check_face_word(const std::string& face) {
  if (face.empty() || face == "neutral" || face == "hidden" || is_map(face)) return;
  std::error_code unknown;
  const bool has_colon = face.find(':') != std::string::npos;
  if (std::filesystem::exists(face, unknown) || (is_face_file(face) && !has_colon)) return;
  const std::vector<std::string> words{"neutral", "hidden"};
  if (motion::nearest_word(face, words))
    throw Faults({{{},
                   "--face",
                   motion::in_quotes(face) + " is neither neutral nor hidden",
                   motion::did_you_mean(face, words)}});
  const std::string name = face.substr(0, face.find(':'));
  throw Faults({{{},
                 "--face",
                 motion::in_quotes(face) + " is neither neutral, hidden, weights nor a file",
                 "write weights as \"" + motion::excerpt(name) +
                     ": 0.5\", or give a file of weights with its ending (.csv, .npz, .glb)"}});
}

/// Faults of files that were given alone, without the key that a manifest needs, are those of the
/// option.
void shorten_paths(const LookOptions& options, std::vector<Fault>& faults) {
  for (Fault& fault : faults) {
    if (fault.path == "figure.character" && is_character(options.figure)) fault.path = "figure";
    if (fault.path == "face.file" && is_face_file(options.face)) fault.path = "face";
  }
}

/// Options without their braces get them.
std::string in_braces(const std::string& text) {
  return is_map(text) && !text.starts_with('{') ? "{" + text + "}" : text;
}

/// File names are passed as variables, so that special characters in them are not interpreted by
/// YAML.
std::string yaml_of(const LookOptions& options) {
  const std::string scene = is_map(options.scene) ? in_braces(options.scene) : "'${MIEN_SCENE}'";
  const std::string figure =
      is_character(options.figure) ? "{character: '${MIEN_FIGURE}'}" : in_braces(options.figure);
  const std::string given_scene = options.scene.empty() ? "" : "scene: " + scene + "\n";
  const std::string face =
      is_face_file(options.face) ? "{file: '${MIEN_FACE}'}" : in_braces(options.face);
  const std::string given_face = options.face.empty() ? "" : "face: " + face + "\n";
  return given_scene + "figure: " + figure + "\n" + given_face + "hands: " + options.hands +
         "\ncamera: " + in_braces(options.camera) + "\n";
}

json look_schema() {
  const json& manifest = manifest_schema();
  json schema = manifest["definitions"]["look"];
  schema["definitions"] = manifest["definitions"];
  return schema;
}

}  // namespace

Look look_of(const LookOptions& options, std::vector<Fault>& warnings) {
  check_face_word(options.face);
  const Environment environment = [&](const std::string& name) -> std::optional<std::string> {
    if (name == "MIEN_SCENE") return options.scene;
    if (name == "MIEN_FIGURE") return options.figure;
    if (name == "MIEN_FACE") return options.face;
    return process_environment()(name);
  };
  const JsonReading reading = read_options(yaml_of(options), look_schema(), environment);
  const ReadingContext context{reading.places, [](const std::string& path) { return path; }};
  Look look;
  read({reading.document, "", context}, look);
  ReadSets sets;
  CheckedFiles characters;
  std::vector<Fault> faults = resolve_set(look, "", reading.places, sets);
  append(faults, check_look(look, "", reading.places, {}, characters));
  shorten_paths(options, faults);
  if (!faults.empty()) throw as_option_faults(std::move(faults));
  if (!reading.renamed.empty()) append(warnings, as_option_faults(reading.renamed).list());
  return look;
}

}  // namespace mien::pipeline
