#include "pipeline/studio/studio_draft.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "motion/error.h"
#include "pipeline/checks/modification_checks.h"
#include "pipeline/checks/name_checks.h"
#include "pipeline/documents/fault_list.h"
#include "pipeline/studio/document_change.h"
#include "pipeline/studio/studio_places.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t most_vocabularies = 8;

/// A document's texts, and where they stand.
template <class Visit>
void each_text(const ordered_json& value, const DocumentPath& path, const Visit& visit) {
  if (value.is_string()) visit(value.get_ref<const std::string&>(), path);
  if (!value.is_structured()) return;
  std::size_t index = 0;
  for (const auto& [key, one] : value.items()) {
    DocumentPath below = path;
    if (value.is_object()) {
      below.emplace_back(key);
    } else {
      below.emplace_back(index++);
    }
    each_text(one, below, visit);
  }
}

/// "walk.bvh", "../x", "captures/": with a folder, or an ending of letters.
bool looks_like_path(const std::string& text) {
  if (text.find_first_of("/\\") != std::string::npos) return true;
  const std::size_t dot = text.rfind('.');
  if (dot == std::string::npos || dot + 1 == text.size()) return false;
  return std::all_of(text.begin() + static_cast<std::ptrdiff_t>(dot) + 1, text.end(),
                     [](unsigned char letter) { return std::isalnum(letter) != 0; }) &&
         std::isdigit(static_cast<unsigned char>(text[dot + 1])) == 0;
}

/// Patterns of names in a folder, which never lead out of it.
bool is_pattern(const std::string& text, const DocumentPath& path) {
  if (path.empty() || text.find_first_of("/\\") != std::string::npos) return false;
  return path.back() == DocumentStep("include") || path.back() == DocumentStep("exclude");
}

/// Whether a text stands where a folder or file may be named without looking like one.
bool names_a_source(const std::string& text, const DocumentPath& path) {
  static const std::set<std::string> keys = {"set",    "folder",  "file",
                                             "scales", "ratings", "recipes"};
  static const std::set<std::string> words = {"builtin", "none", "simulated", "fig29"};
  if (text.starts_with("builtin:") || words.contains(text)) return false;
  const bool is_look = std::find(path.begin(), path.end(), DocumentStep("look")) != path.end();
  if (is_look) return false;  // sets by their names
  return std::any_of(path.begin(), path.end(), [](const DocumentStep& step) {
    const auto* key = std::get_if<std::string>(&step);
    return key != nullptr && keys.contains(*key);
  });
}

std::vector<Fault> new_files(const ordered_json& document, const ordered_json& known,
                             const std::filesystem::path& manifest) {
  const StudioPlaces places(manifest, known);
  std::set<std::string> names;
  each_text(known, {}, [&](const std::string& text, const DocumentPath&) { names.insert(text); });
  std::vector<Fault> faults;
  each_text(document, {}, [&](const std::string& text, const DocumentPath& path) {
    if (names.contains(text)) return;
    if (is_pattern(text, path)) return;
    if (!looks_like_path(text) && !names_a_source(text, path)) return;
    if (places.hold(text)) return;
    faults.push_back({{},
                      path_text(path),
                      "\"" + text +
                          "\" is neither named by the manifest nor a motion, a folder or a "
                          "character below its folder",
                      "choose what is there, or write it into the manifest by hand and load it "
                      "again"});
  });
  return faults;
}

/// What was expanded is not expanded again.
void keep_dollars(ordered_json& value) {
  if (value.is_string()) {
    std::string& text = value.get_ref<std::string&>();
    for (std::size_t at = text.find("${"); at != std::string::npos; at = text.find("${", at + 3))
      text.insert(at, "$");
  }
  if (!value.is_structured()) return;
  for (auto& one : value) keep_dollars(one);
}

}  // namespace

ordered_json faults_json(const std::vector<Fault>& faults) {
  ordered_json list = ordered_json::array();
  for (const Fault& fault : faults)
    list.push_back({{"path", fault.path}, {"wrong", fault.wrong}, {"remedy", fault.remedy}});
  return list;
}

ManifestReading DraftReader::reading_of(ordered_json document, const ordered_json& known) {
  std::vector<Fault> faults = new_files(document, known, file_);
  if (!faults.empty()) throw DraftFaults(std::move(faults));
  keep_dollars(document);
  const std::string text = document.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  return parse_manifest(text, file_, environment_);
}

Manifest DraftReader::read(ordered_json document, const ordered_json& known) {
  const std::string key = examples_key(document);
  ManifestReading reading = reading_of(std::move(document), known);
  if (reading.faults.empty()) {
    try {
      const Vocabulary words = vocabulary(key, reading.manifest);
      append(reading.faults, check_names(reading.manifest, words));
      append(reading.faults, check_modification_names(reading.manifest, words));
    } catch (const Error& error) {
      reading.faults.push_back({{}, "examples", error.what(), ""});
    }
  }
  if (!reading.faults.empty()) throw DraftFaults(std::move(reading.faults));
  return std::move(reading.manifest);
}

Manifest DraftReader::read_examples(ordered_json document, const ordered_json& known) {
  document = document_about(document, {});
  document["stimuli"] = {{{"id", "none"}, {"weights", {{"none", 1}}}}};
  ManifestReading reading = reading_of(std::move(document), known);
  if (!reading.faults.empty()) throw DraftFaults(std::move(reading.faults));
  return std::move(reading.manifest);
}

Vocabulary DraftReader::vocabulary(const std::string& key, const Manifest& manifest) {
  const std::lock_guard lock(mutex_);
  const auto found = vocabularies_.find(key);
  if (found != vocabularies_.end()) return found->second;
  if (vocabularies_.size() >= most_vocabularies) vocabularies_.clear();
  return vocabularies_.emplace(key, vocabulary_of(manifest)).first->second;
}

std::string examples_key(const ordered_json& document) {
  ordered_json parts = ordered_json::object();
  for (const char* name : {"examples", "seed"}) {
    if (document.contains(name)) parts[name] = document[name];
  }
  return parts.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

ordered_json document_about(const ordered_json& document, const std::vector<std::string>& ids) {
  ordered_json about = document;
  for (const char* name : {"sheets", "overlays", "questionnaire", "matching", "equalize"})
    about.erase(name);
  if (!document.contains("stimuli") || !document["stimuli"].is_array()) return about;
  const auto is_wanted = [&](const ordered_json& stimulus) {
    if (!stimulus.is_object() || !stimulus.contains("id")) return false;
    return std::any_of(ids.begin(), ids.end(),
                       [&](const auto& id) { return stimulus["id"] == id; });
  };
  const ordered_json& all = document["stimuli"];
  // A foil is made of another stimulus, whose name it tells.
  const bool needs_others = std::any_of(all.begin(), all.end(), [&](const ordered_json& stimulus) {
    return is_wanted(stimulus) && stimulus.contains("foil");
  });
  if (needs_others) return about;
  about["stimuli"] = ordered_json::array();
  for (const ordered_json& stimulus : all) {
    if (is_wanted(stimulus)) about["stimuli"].push_back(stimulus);
  }
  return about;
}

}  // namespace mien::pipeline
