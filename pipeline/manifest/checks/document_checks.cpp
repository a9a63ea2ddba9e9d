#include "pipeline/manifest/checks/document_checks.h"

#include <cassert>
#include <utility>

#include <nlohmann/json.hpp>

#include "motion/text/file_contents.h"
#include "motion/text/json_depth.h"
#include "motion/text/safe_name.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/base/reading/yaml_tree.h"
#include "pipeline/manifest/look/set_file.h"
#include "pipeline/manifest/ratings/scales/scales.h"
#include "pipeline/manifest/reading/recipes.h"
#include "pipeline/manifest/texts/page_texts.h"

namespace mien::pipeline {

namespace {

/// How many of the keys a schema knows; those that it asks for count twice.
int keys_known(const YamlNode& map, const nlohmann::json& schema) {
  int known = 0;
  for (const YamlNode& key : map.keys) {
    known += schema["properties"].contains(key.text);
    for (const nlohmann::json& required : schema["required"]) known += required == key.text;
  }
  return known;
}

DocumentKind kind_by_name(const std::filesystem::path& name) {
  const std::string file = name.filename().string();
  if (file.ends_with(".scales.yaml")) return DocumentKind::scales;
  if (file.ends_with(".set.yaml")) return DocumentKind::set;
  if (file.ends_with(".recipes.yaml")) return DocumentKind::recipes;
  if (file.ends_with(".texts.yaml")) return DocumentKind::texts;
  return DocumentKind::manifest;
}

/// The keys of files of texts, which have no schema: English says which texts there are.
const nlohmann::json& texts_schema() {
  static const nlohmann::json schema = {{"properties",
                                         {{"language", {}},
                                          {"complete_from", {}},
                                          {"direction", {}},
                                          {"questionnaire", {}},
                                          {"matching", {}},
                                          {"in_matching", {}},
                                          {"chains", {}}}},
                                        {"required", {"language"}}};
  return schema;
}

/// What a document that a manifest may name holds, and how it is named there.
struct NamedDocument {
  std::string holds;
  std::string as_named;
};

NamedDocument named_document(DocumentKind kind, const std::string& file) {
  if (kind == DocumentKind::scales) return {"scales", "examples: {scales: " + file + "}"};
  if (kind == DocumentKind::set) return {"a set", "look: {scene: " + file + "}"};
  if (kind == DocumentKind::texts)
    return {"texts of pages", "questionnaire: {texts: " + file + "}"};
  assert(kind == DocumentKind::recipes);
  return {"recipes", "recipes: " + file};
}

}  // namespace

DocumentKind kind_of_document(std::string_view yaml, const std::filesystem::path& name) {
  std::vector<Fault> ignored_faults;
  const YamlNode tree = read_yaml(yaml, name.string(), ignored_faults);
  std::pair best{0, kind_by_name(name)};
  const auto consider = [&](DocumentKind kind, const nlohmann::json& schema) {
    const int known = keys_known(tree, schema);
    if (known > best.first) best = {known, kind};
  };
  consider(DocumentKind::manifest, manifest_schema());
  consider(DocumentKind::scales, scales_schema());
  consider(DocumentKind::set, set_schema());
  consider(DocumentKind::recipes, recipes_schema());
  consider(DocumentKind::texts, texts_schema());
  return best.second;
}

Fault not_a_manifest_fault(DocumentKind kind, const std::filesystem::path& file) {
  const NamedDocument document = named_document(kind, file.filename().string());
  return {{file.string(), 1, 1},
          "",
          "holds " + document.holds + ", and is not a manifest",
          "refer to it in a manifest as " + document.as_named +
              "; only mien check accepts it directly"};
}

std::vector<Fault> check_other_document(DocumentKind kind, const std::filesystem::path& file) {
  try {
    if (kind == DocumentKind::scales) read_scales(file);
    if (kind == DocumentKind::set) read_set(file.string(), file);
    if (kind == DocumentKind::recipes) read_recipes(file.string(), file);
    if (kind == DocumentKind::texts) read_texts(file);
  } catch (const Faults& faults) {
    return faults.list();
  } catch (const Error& error) {
    return {{{}, "", error.what(), ""}};
  }
  return {};
}

namespace {

/// Entries that are not as mien writes them are skipped: they only help with missing files.
std::vector<RecordedInput> recordings_in(const nlohmann::json& record) {
  std::vector<RecordedInput> recordings;
  if (!record.contains("recordings")) return recordings;
  for (const nlohmann::json& entry : record["recordings"]) {
    try {
      recordings.push_back({entry.at("path"), entry.at("hash"), entry.value("licence", ""),
                            entry.value("source", ""), entry.value("share", true)});
    } catch (const nlohmann::json::exception&) {
    }
  }
  return recordings;
}

}  // namespace

std::optional<StudyRecord> study_record_in(const std::filesystem::path& file) {
  if (file.extension() != ".json") return std::nullopt;
  const motion::FileReading reading = motion::bytes_of_file(file, motion::max_table_bytes);
  if (reading.bytes && motion::is_nested_deeper(*reading.bytes, motion::max_json_depth))
    return std::nullopt;
  const auto record = nlohmann::json::parse(reading.bytes.value_or(""), nullptr, false);
  const auto text = [&](const char* place) -> std::string {
    const nlohmann::json::json_pointer pointer(place);
    if (!record.is_object() || !record.contains(pointer)) return "";
    return record[pointer].is_string() ? record[pointer].get<std::string>() : "";
  };
  if (text("/manifest/as_run").empty()) return std::nullopt;
  const std::filesystem::path folder = file.parent_path();
  const auto kept = [&](const char* place) {
    return motion::inside(folder, text(place), {file.string()});
  };
  return StudyRecord{kept("/manifest/as_run"), kept("/manifest/copy"), text("/command"),
                     recordings_in(record)};
}

}  // namespace mien::pipeline
