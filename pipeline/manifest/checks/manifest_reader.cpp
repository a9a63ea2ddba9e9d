#include "pipeline/manifest/checks/manifest_reader.h"

#include <set>
#include <string>
#include <utility>

#include "motion/skeleton/body.h"
#include "motion/text/file_contents.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/base/reading/yaml_json.h"
#include "pipeline/base/reading/yaml_tree.h"
#include "pipeline/manifest/checks/document_checks.h"
#include "pipeline/manifest/checks/manifest_checks.h"
#include "pipeline/manifest/checks/matching_checks.h"
#include "pipeline/manifest/checks/questionnaire_checks.h"
#include "pipeline/manifest/look/look_checks.h"
#include "pipeline/manifest/manifest_builder.h"
#include "pipeline/manifest/recipes.h"
#include "scenes/point_light/dot_joints.h"

namespace mien::pipeline {

namespace {

/// Adds faults at paths that have none yet, so that one mistake is told once.
void add_at_new_paths(std::vector<Fault>& faults, std::vector<Fault> more) {
  std::set<std::string> taken;
  for (const Fault& fault : faults) taken.insert(fault.path);
  for (Fault& fault : more) {
    if (fault.path.empty() || !taken.contains(fault.path)) faults.push_back(std::move(fault));
  }
}

/// Completes the manifest's look, and those of stimuli and overlays that say something of their
/// own. The others have the manifest's.
std::vector<Fault> complete_looks(Manifest& manifest) {
  const std::vector<std::string> joints = scenes::dot_joint_names(motion::standard_body());
  LookFiles files;
  std::vector<Fault> faults = complete_look(manifest.look, "look", manifest.places, joints, files);
  const auto complete = [&](Stimulus& film) {
    const std::string path = member_path(film.path, "look");
    if (!manifest.places.values.contains(path)) {
      film.look.set = manifest.look.set;
      return;
    }
    for (Fault& fault : complete_look(film.look, path, manifest.places, joints, files))
      faults.push_back(std::move(fault));
  };
  for (Stimulus& stimulus : manifest.stimuli) complete(stimulus);
  for (Overlay& overlay : manifest.overlays) complete(overlay.film);
  return faults;
}

/// A file that cannot be read was told by the checks.
std::vector<Fault> complete_scales(ScalesSource& scales) {
  if (!motion::hindrance_of(scales.file, motion::most_of_document).empty()) return {};
  try {
    scales = scales_in(scales.file);
  } catch (const Faults& wrong) {
    return wrong.list();
  } catch (const Error& wrong) {
    return {{{}, "examples.scales", wrong.what(), ""}};
  }
  return {};
}

}  // namespace

ManifestReading parse_manifest(std::string_view text, const std::filesystem::path& file,
                               const Environment& environment) {
  ManifestReading reading;
  const YamlNode tree = read_yaml(text, file.string(), reading.faults);
  const bool unreadable = tree.kind == YamlNode::Kind::null && !reading.faults.empty();
  reading.manifest.file = file;
  if (unreadable) return reading;

  const nlohmann::json& schema = manifest_schema();
  JsonReading json = to_json(tree, root_of(schema), environment, reading.faults);
  add_at_new_paths(reading.faults, check_schema(json.document, schema, json.places));
  reading.manifest = build_manifest(json.document, std::move(json.places), file);
  add_at_new_paths(reading.faults, resolve_modifications(reading.manifest));
  add_at_new_paths(reading.faults, resolve_foils(reading.manifest));
  resolve_holds(reading.manifest);
  add_at_new_paths(reading.faults, check_meaning(reading.manifest));
  add_at_new_paths(reading.faults, complete_looks(reading.manifest));
  std::vector<Fault> in_scales = complete_scales(reading.manifest.scales);
  const bool has_scales = in_scales.empty();
  reading.faults.insert(reading.faults.end(), in_scales.begin(), in_scales.end());
  std::vector<Fault> in_texts = complete_questionnaire(reading.manifest);
  append(in_texts, complete_matching(reading.manifest));
  const bool has_all = has_scales && in_texts.empty();
  add_at_new_paths(reading.faults, std::move(in_texts));
  if (has_all) add_at_new_paths(reading.faults, check_questionnaire(reading.manifest));
  if (has_all) add_at_new_paths(reading.faults, check_matching(reading.manifest));
  reading.faults = in_reading_order(std::move(reading.faults));
  return reading;
}

std::vector<NamedFile> files_named(std::string_view text, const std::filesystem::path& file,
                                   const Environment& environment) {
  std::vector<NamedFile> named;
  std::vector<Fault> faults;
  const YamlNode tree = read_yaml(text, file.string(), faults);
  JsonReading json = to_json(tree, root_of(manifest_schema()), environment, faults);
  if (!faults.empty()) throw Faults(in_reading_order(std::move(faults)));
  build_manifest(json.document, std::move(json.places), file,
                 [&](const std::string& name, const std::filesystem::path& resolved) {
                   named.push_back({name, resolved});
                 });
  return named;
}

ManifestReading read_manifest(const std::filesystem::path& file, const Environment& environment) {
  const motion::FileReading text = motion::bytes_of_file(file, motion::most_of_document);
  ManifestReading other;
  other.manifest.file = file;
  if (!text.bytes) {
    other.faults.push_back({{file.string(), 0, 0}, "", text.hindrance, "name a manifest (YAML)"});
    return other;
  }
  ManifestReading reading = parse_manifest(*text.bytes, file, environment);
  if (reading.faults.empty()) return reading;
  const DocumentKind kind = kind_of_document(*text.bytes, file);
  if (kind == DocumentKind::manifest) return reading;
  other.faults.push_back(told_as_no_manifest(kind, file));
  return other;
}

}  // namespace mien::pipeline
