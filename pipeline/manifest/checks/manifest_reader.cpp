#include "pipeline/manifest/checks/manifest_reader.h"

#include <utility>

#include "motion/text/file_contents.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/base/reading/yaml_json.h"
#include "pipeline/manifest/checks/document_checks.h"
#include "pipeline/manifest/checks/part_checks.h"
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
  ResolvedManifest resolved = resolve(build_manifest(std::move(written), file, paths));
  std::vector<Fault> meaning = check_meaning(resolved);
  return {std::move(resolved.manifest),
          merged_faults({std::move(faults), std::move(against_schema), std::move(resolved.faults),
                         std::move(meaning)})};
}

std::vector<NamedFile> named_files(std::string_view text, const std::filesystem::path& file,
                                   const Environment& environment) {
  std::vector<NamedFile> named;
  std::vector<Fault> faults;
  JsonReading written = read_json(text, file.string(), manifest_schema(), environment, faults);
  if (!faults.empty()) throw Faults(std::move(faults));
  build_manifest(std::move(written), file,
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
