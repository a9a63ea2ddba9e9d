#include "pipeline/manifest/ratings/scales/scales.h"

#include <array>
#include <map>

#include "motion/text/excerpt.h"
#include "motion/text/file_contents.h"
#include "motion/text/nearest_word.h"
#include "pipeline/base/documents/fault.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/base/reading/yaml_json.h"
#include "pipeline/manifest/ratings/words/adjective_pairs.h"

namespace mien::pipeline {

namespace {

using nlohmann::json;
using Range = std::array<double, 2>;

Scale scale_from(const std::string& id, const json& given, Range range) {
  Scale scale;
  scale.id = id;
  scale.low = given["low"];
  scale.high = given["high"];
  if (given.contains("ja")) {
    scale.japanese_low = given["ja"][0];
    scale.japanese_high = given["ja"][1];
  }
  for (const char* language : {"de", "fr", "es", "fi", "zh", "ar"})
    if (given.contains(language))
      scale.words.emplace_back(language, given[language].get<std::array<std::string, 2>>());
  if (given.contains("in"))
    for (const auto& [language, ends] : given["in"].items())
      scale.words.emplace_back(language, ends.get<std::array<std::string, 2>>());
  if (given.contains("range")) range = given["range"].get<Range>();
  scale.least = range[0];
  scale.most = range[1];
  if (given.contains("loadings")) {
    for (const auto& [axis, loading] : given["loadings"].items()) {
      scale.loadings.emplace_back(axis, loading.get<double>());
    }
  }
  return scale;
}

ScaleGroup group_from(const std::string& id, const json& given) {
  ScaleGroup group;
  group.id = id;
  group.japanese = given.value("ja", "");
  group.scales = given["scales"].get<std::vector<std::string>>();
  return group;
}

ScaleSet build(const JsonReading& reading) {
  const json& document = reading.document;
  ScaleSet set;
  set.name = document.value("name", "");
  const Range range = document.value("range", Range{-2.0, 2.0});
  for (const std::string& id : written_order(document["scales"], "scales", reading.places)) {
    set.scales.push_back(scale_from(id, document["scales"][id], range));
  }
  if (!document.contains("groups")) return set;
  for (const std::string& id : written_order(document["groups"], "groups", reading.places)) {
    set.groups.push_back(group_from(id, document["groups"][id]));
  }
  return set;
}

std::vector<std::string> ids_of(const ScaleSet& set) {
  std::vector<std::string> ids;
  for (const Scale& scale : set.scales) ids.push_back(scale.id);
  return ids;
}

/// Ranges that are empty and groups that name no scale or take a scale's name.
std::vector<Fault> check(const ScaleSet& set, const Places& places) {
  std::vector<Fault> faults;
  const std::vector<std::string> ids = ids_of(set);
  for (const Scale& scale : set.scales) {
    if (scale.least < scale.most) continue;
    const std::string own = member_path(member_path("scales", scale.id), "range");
    const std::string path = places.values.contains(own) ? own : "range";
    faults.push_back({place_of(places, path), path, "the lower limit is not below the upper limit",
                      "write [low, high]; to reverse a scale, exchange the names of its ends"});
  }
  for (const ScaleGroup& group : set.groups) {
    const std::string path = member_path("groups", group.id);
    if (find_scale(set, group.id) != nullptr) {
      faults.push_back(
          {key_place_of(places, path), path, "a scale has the same name", "rename the group"});
    }
    for (std::size_t i = 0; i < group.scales.size(); ++i) {
      if (find_scale(set, group.scales[i]) != nullptr) continue;
      const std::string member = element_path(member_path(path, "scales"), i);
      faults.push_back({place_of(places, member), member,
                        "unknown scale " + motion::in_quotes(group.scales[i]),
                        motion::did_you_mean(group.scales[i], ids)});
    }
  }
  return faults;
}

}  // namespace

ScaleSet builtin_scales() {
  ScaleSet set;
  set.name = "adjective pairs";
  std::map<Primary, std::vector<std::string>> members;
  for (const AdjectivePair& pair : adjective_pairs()) {
    set.scales.push_back({std::string(pair.key),
                          std::string(pair.low),
                          std::string(pair.high),
                          std::string(pair.ja_low),
                          std::string(pair.ja_high),
                          -2.0,
                          2.0,
                          {}});
    if (pair.table_2) members[*pair.table_2].emplace_back(pair.key);
  }
  for (int i = 0; i < primary_count; ++i) {
    const auto primary = static_cast<Primary>(i);
    set.groups.push_back(
        {std::string(name_of(primary)), std::string(japanese_name_of(primary)), members[primary]});
  }
  return set;
}

ScaleSet read_scales(const std::filesystem::path& file) {
  const motion::FileReading reading = motion::bytes_of_file(file, motion::max_document_bytes);
  if (reading.bytes) return parse_scales(*reading.bytes, file.string());
  throw Error({file.string(), 0, 0}, reading.error, "name a scales file (YAML)");
}

ScaleSet parse_scales(std::string_view yaml, const std::string& file) {
  const JsonReading reading = read_valid_json(yaml, file, scales_schema());
  ScaleSet set = build(reading);
  std::vector<Fault> faults = check(set, reading.places);
  set.lexicon = lexicon_from(reading.document, ids_of(set), reading.places, faults);
  if (!faults.empty()) throw Faults(faults);
  return set;
}

const Scale* find_scale(const ScaleSet& set, std::string_view id) {
  for (const Scale& scale : set.scales) {
    if (scale.id == id) return &scale;
  }
  return nullptr;
}

std::optional<std::array<std::string, 2>> ends_in(const Scale& scale, std::string_view language) {
  if (language == "en") return std::array{scale.low, scale.high};
  if (language == "ja" && !scale.japanese_low.empty())
    return std::array{scale.japanese_low, scale.japanese_high};
  for (const auto& [tag, ends] : scale.words)
    if (tag == language) return ends;
  return std::nullopt;
}

std::unordered_map<std::string_view, const Scale*> scales_by_id(const ScaleSet& set) {
  std::unordered_map<std::string_view, const Scale*> scales;
  for (const Scale& scale : set.scales) scales.emplace(scale.id, &scale);
  return scales;
}

double share_of(const Scale& scale, double answer) {
  return (answer - scale.least) / (scale.most - scale.least);
}

ScaleSet emotion_scales() {
  ScaleSet set;
  set.name = "emotions";
  // The features that simulated raters use are our own choice, as for the adjective pairs.
  const auto add = [&](const char* low, const char* high, const char* japanese_low,
                       const char* japanese_high,
                       std::vector<std::pair<std::string, double>> loadings) {
    set.scales.push_back({.id = std::string(low) + "-" + high,
                          .low = low,
                          .high = high,
                          .japanese_low = japanese_low,
                          .japanese_high = japanese_high,
                          .loadings = std::move(loadings)});
  };
  add("sad", "happy", "悲しい", "嬉しい", {{"activeness", 0.4}, {"valence", 0.7}});
  add("tired", "excited", "疲れた", "興奮した", {{"quickness", 0.5}, {"arousal", 0.6}});
  add("angry", "relaxed", "怒った", "くつろいだ", {{"tension", -0.6}, {"arousal", -0.5}});
  add("weak", "strong", "弱い", "強い", {{"largeness", 0.7}, {"stability", 0.3}});
  add("afraid", "confident", "怖がった", "自信のある", {{"largeness", 0.3}, {"stability", 0.6}});
  add("masculine", "feminine", "男性的な", "女性的な", {{"largeness", -0.5}, {"clearness", 0.3}});
  return set;
}

}  // namespace mien::pipeline
