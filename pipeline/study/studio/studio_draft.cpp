#include "pipeline/study/studio/studio_draft.h"

#include <algorithm>
#include <utility>

#include "motion/error.h"
#include "motion/text/excerpt.h"
#include "pipeline/base/documents/fault_list.h"
#include "pipeline/manifest/checks/part_checks.h"
#include "pipeline/study/studio/studio_places.h"

namespace mien::pipeline {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t max_vocabularies = 8;

/// Visits all texts of a document with their paths.
void each_text(const ordered_json& value, const std::string& path, const auto& visit) {
  if (value.is_string()) visit(value.get_ref<const std::string&>(), path);
  if (!value.is_structured()) return;
  std::size_t index = 0;
  for (const auto& [key, one] : value.items())
    each_text(one, value.is_object() ? member_path(path, key) : element_path(path, index++), visit);
}

/// A placeholder for a stimulus that is not needed. It keeps the index of others, on which the
/// random numbers of modifications and the paths of faults depend.
ordered_json filler(std::size_t place) {
  return {{"id", "filler-" + std::to_string(place)}, {"path", {{{"walk", 1}}}}};
}

/// Escapes "$", so that expanded variables are not expanded again.
void escape_dollars(ordered_json& value) {
  if (value.is_string()) {
    std::string& text = value.get_ref<std::string&>();
    for (std::size_t at = text.find("${"); at != std::string::npos; at = text.find("${", at + 3))
      text.insert(at, "$");
  }
  if (!value.is_structured()) return;
  for (auto& one : value) escape_dollars(one);
}

/// A page's document as the text of a manifest.
std::string manifest_text(ordered_json document) {
  escape_dollars(document);
  return document.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

/// Path of the first occurrence of a text in a document; empty without one.
std::string first_path_of(const std::string& text, const ordered_json& document) {
  std::string place;
  each_text(document, "", [&](const std::string& one, const std::string& path) {
    if (place.empty() && one == text) place = path;
  });
  return place;
}

}  // namespace

ordered_json faults_json(const std::vector<Fault>& faults) {
  ordered_json list = ordered_json::array();
  for (const Fault& fault : faults)
    list.push_back({{"path", fault.path}, {"wrong", fault.wrong}, {"remedy", fault.remedy}});
  return list;
}

ManifestReading DraftReader::reading_of(const ordered_json& document) const {
  return parse_manifest(manifest_text(document), file_, environment_);
}

void DraftReader::check_files(const ordered_json& document, const ordered_json& known) const {
  const StudioPlaces places(file_, known);
  std::vector<NamedFile> others = named_files(manifest_text(document), file_, environment_);
  std::erase_if(others, [&](const NamedFile& one) {
    return places.contains(std::filesystem::absolute(one.file).string());
  });
  if (others.empty()) return;
  const std::vector<NamedFile> before = named_files(manifest_text(known), file_, environment_);
  std::vector<Fault> faults;
  for (const NamedFile& one : others) {
    if (std::ranges::find(before, one.file, &NamedFile::file) != before.end()) continue;
    faults.push_back({{},
                      first_path_of(one.text, document),
                      motion::in_quotes(one.text) + " is neither named in the manifest nor a "
                                                    "motion, folder or character inside its folder",
                      "choose an existing one, or enter it in the manifest by hand and reload"});
  }
  if (!faults.empty()) throw DraftFaults(std::move(faults));
}

Manifest DraftReader::read(const ordered_json& document) {
  const std::string key = examples_key(document);
  ManifestReading reading = reading_of(document);
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

Manifest DraftReader::read_examples(const ordered_json& asked) {
  ordered_json document = document_excerpt(asked, {});
  document["stimuli"] = {{{"id", "none"}, {"weights", {{"none", 1}}}}};
  ManifestReading reading = reading_of(document);
  if (!reading.faults.empty()) throw DraftFaults(std::move(reading.faults));
  return std::move(reading.manifest);
}

Vocabulary DraftReader::vocabulary(const std::string& key, const Manifest& manifest) {
  const std::lock_guard lock(mutex_);
  const auto found = vocabularies_.find(key);
  if (found != vocabularies_.end() && found->second.second.are_unchanged())
    return found->second.first;
  if (vocabularies_.size() >= max_vocabularies) vocabularies_.clear();
  SeenFiles files(files_of_examples(manifest));
  const std::pair words(vocabulary_of(manifest), std::move(files));
  return vocabularies_.insert_or_assign(key, words).first->second.first;
}

std::string examples_key(const ordered_json& document) {
  ordered_json parts = ordered_json::object();
  for (const char* name : {"examples", "seed"})
    if (document.contains(name)) parts[name] = document[name];
  return parts.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

ordered_json document_excerpt(const ordered_json& document, const std::vector<std::string>& ids) {
  ordered_json about = document;
  for (const char* name : {"sheets", "overlays", "questionnaire", "matching", "adaptive",
                           "equalize", "design", "mismatch"})
    about.erase(name);
  if (!document.contains("stimuli") || !document["stimuli"].is_array()) return about;
  for (ordered_json& stimulus : about["stimuli"]) {
    if (!stimulus.is_object()) continue;
    stimulus.erase("audio");
    stimulus.erase("levels");
  }
  const auto is_wanted = [&](const ordered_json& stimulus) {
    if (!stimulus.is_object() || !stimulus.contains("id")) return false;
    return std::any_of(ids.begin(), ids.end(),
                       [&](const auto& id) { return stimulus["id"] == id; });
  };
  const ordered_json all = about["stimuli"];
  // A foil depends on the stimulus that it names, an exchanged motion on that of another.
  const bool needs_others = std::any_of(all.begin(), all.end(), [&](const ordered_json& stimulus) {
    return is_wanted(stimulus) && (stimulus.contains("foil") || stimulus.contains("swap"));
  });
  if (needs_others) return about;
  // A contains depends on a reference, which resolve_holds chooses from all candidates.
  const bool holds = std::any_of(all.begin(), all.end(), [&](const ordered_json& stimulus) {
    return is_wanted(stimulus) && stimulus.contains("hold");
  });
  const auto is_needed = [&](const ordered_json& stimulus) {
    const bool is_reference =
        stimulus.is_object() && stimulus.value("role", ordered_json()) == "reference";
    return is_wanted(stimulus) || (holds && is_reference);
  };
  about["stimuli"] = ordered_json::array();
  if (std::none_of(all.begin(), all.end(), is_wanted)) return about;
  const auto last = std::find_if(all.rbegin(), all.rend(), is_needed).base();
  for (auto one = all.begin(); one != last; ++one)
    about["stimuli"].push_back(is_needed(*one) ? *one : filler(about["stimuli"].size()));
  return about;
}

}  // namespace mien::pipeline
