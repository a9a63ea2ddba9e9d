#include "pipeline/manifest/checks/manifest_reader.h"

#include <utility>

#include "motion/text/file_contents.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/base/reading/yaml_json.h"
#include "pipeline/manifest/checks/document_checks.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/manifest/reading/levelled_document.h"
#include "pipeline/manifest/reading/resolved_manifest.h"

namespace mien::pipeline {

ManifestReading parse_manifest(std::string_view text, const std::filesystem::path& file,
                               const Environment& environment, const PathVisitor& paths) {
  const nlohmann::json& schema = manifest_schema();
  std::vector<Fault> faults;
  JsonReading written = read_json(text, file.string(), schema, environment, faults);
  if (written.document.is_null() && !faults.empty())
    return {{.file = file}, in_reading_order(std::move(faults))};
  std::vector<Fault> against_schema = check_schema(written.document, schema, written.places);
  LevelledDocument levelled = with_all_levels(std::move(written));
  const std::vector<std::size_t> origins = std::move(levelled.origins);
  if (against_schema.empty() && !origins.empty())
    against_schema = with_written_paths(
        check_schema(levelled.reading.document, schema, levelled.reading.places), origins);
  const bool are_levels_made = levelled.faults.empty();
  append(against_schema, std::move(levelled.faults));
  Manifest built = build_manifest(std::move(levelled.reading), file, paths);
  built.origins = origins;
  ResolvedManifest resolved = resolve(std::move(built));
  // Without the stimuli of some levels, others may seem to be at fault.
  std::vector<Fault> meaning;
  if (are_levels_made) meaning = with_written_paths(check_meaning(resolved), origins);
  return {
      std::move(resolved.manifest),
      merged_faults({std::move(faults), std::move(against_schema),
                     with_written_paths(std::move(resolved.faults), origins), std::move(meaning)})};
}

std::vector<NamedFile> named_files(std::string_view text, const std::filesystem::path& file,
                                   const Environment& environment) {
  std::vector<NamedFile> named;
  std::vector<Fault> faults;
  JsonReading written = read_json(text, file.string(), manifest_schema(), environment, faults);
  if (!faults.empty()) throw Faults(std::move(faults));
  build_manifest(with_all_levels(std::move(written)).reading, file,
                 [&](const std::string& name, const std::filesystem::path& resolved) {
                   named.push_back({name, resolved});
                 });
  return named;
}

ManifestReading read_manifest(const std::filesystem::path& file, const Environment& environment,
                              const PathVisitor& paths) {
  const motion::FileReading text = motion::bytes_of_file(file, motion::max_document_bytes);
  ManifestReading other;
  other.manifest.file = file;
  if (!text.bytes) {
    other.faults.push_back({{file.string(), 0, 0}, "", text.error, "name a manifest (YAML)"});
    return other;
  }
  ManifestReading reading = parse_manifest(*text.bytes, file, environment, paths);
  if (reading.faults.empty()) return reading;
  const DocumentKind kind = kind_of_document(*text.bytes, file);
  if (kind == DocumentKind::manifest) return reading;
  other.faults.push_back(not_a_manifest_fault(kind, file));
  return other;
}

}  // namespace mien::pipeline
