#include "pipeline/study/studio/manifest_edit.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "motion/error.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/base/reading/yaml_json.h"
#include "pipeline/study/studio/source_change.h"
#include "pipeline/study/studio/source_tree.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

ordered_json in_written_order(const json& value, const std::string& path, const Places& places) {
  if (value.is_object()) {
    ordered_json map = ordered_json::object();
    for (const std::string& key : written_order(value, path, places))
      map[key] = in_written_order(value[key], member_path(path, key), places);
    return map;
  }
  if (!value.is_array()) return ordered_json(value);
  ordered_json array = ordered_json::array();
  for (std::size_t i = 0; i < value.size(); ++i)
    array.push_back(in_written_order(value[i], element_path(path, i), places));
  return array;
}

/// The text after one change, or nothing where it says something else then.
bool says(const std::string& text, const std::string& file, const ordered_json& wanted,
          const Environment& environment) {
  try {
    return say_the_same(document_of(text, file, environment), wanted);
  } catch (const Faults&) {
    return false;
  }
}

}  // namespace

ordered_json document_of(std::string_view text, const std::string& file,
                         const Environment& environment) {
  std::vector<Fault> faults;
  const YamlNode tree = read_yaml(text, file, faults);
  const json& schema = manifest_schema();
  if (!faults.empty()) throw Faults(in_reading_order(std::move(faults)));
  const JsonReading reading = to_json(tree, root_of(schema), environment, faults);
  if (!faults.empty()) throw Faults(in_reading_order(std::move(faults)));
  return in_written_order(reading.document, "", reading.places);
}

std::string edited(std::string text, const std::string& file,
                   const std::vector<DocumentChange>& changes, const Environment& environment) {
  if (changes.empty()) return text;
  ordered_json document = document_of(text, file, environment);
  for (const DocumentChange& change : changes) {
    const SourceNode root = read_source(text, file);
    const TextChange replaced = text_change(text, root, change);
    apply(change, document);
    std::string next = text;
    next.replace(replaced.begin, replaced.end - replaced.begin, replaced.text);
    if (!says(next, file, document, environment))
      throw Error(replaced.place,
                  path_text(change.path) + " cannot be changed in this form of YAML",
                  "change it in the file by hand, or write the value plainly there");
    text = std::move(next);
  }
  return text;
}

}  // namespace mien::pipeline
