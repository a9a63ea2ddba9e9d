#include "pipeline/production/run/random_manifest.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "motion/formats/motion_file.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/recording.h"
#include "pipeline/base/reading/schema.h"

namespace mien::test {

namespace {

using nlohmann::json;

const std::vector<std::string> examples_shown = {"normal", "sad", "happy"};

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : engine_(seed), schema_(pipeline::manifest_schema()) {}

  json manifest() {
    json drawn = value(schema_, 0);
    drawn["mien"] = 1;
    drawn["study"] = "s";
    drawn["examples"] =
        chance(0.85) ? json{{"set", "builtin:walks-10"}} : json{{"set", {{"folder", "walks"}}}};
    if (chance(0.5)) drawn["examples"]["ratings"] = "simulated";
    drawn.erase("recipes");
    if (chance(0.2)) drawn["recipes"] = "fig29";
    if (!drawn.contains("output")) drawn["output"] = json::object();
    make_small(drawn["output"]);
    for (const auto& [key, smallest] : least_output.items()) {
      if (!drawn["output"].contains(key)) drawn["output"][key] = smallest;
    }
    drawn["stimuli"] = stimuli();
    drawn.erase("design");
    drawn.erase("overlays");
    if (chance(0.25)) drawn["overlays"] = json::array({overlay()});
    drawn.erase("sheets");
    if (chance(0.4)) drawn["sheets"] = json::array({sheet()});
    return drawn;
  }

 private:
  bool chance(double share) {
    return static_cast<double>(engine_() >> 11) < share * 9007199254740992.0;
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  double between(double least, double most) {
    return least + (most - least) * static_cast<double>(below(1001)) / 1000.0;
  }
  template <class List>
  auto one_of(const List& list) {
    return list[below(list.size())];
  }

  const json& followed(const json& node) const {
    if (!node.contains("$ref")) return node;
    return schema_.at(json::json_pointer(node["$ref"].get<std::string>().substr(1)));
  }

  json value(const json& given, int depth) {
    const json& node = followed(given);
    if (node.contains("const")) return node["const"];
    if (node.contains("enum")) return one_of(node["enum"]);
    if (node.contains("oneOf") && !node.contains("properties"))
      return value(one_of(node["oneOf"]), depth);
    const std::string type = node.value("type", "object");
    if (type == "boolean") return chance(0.5);
    if (type == "integer" || type == "number") return number(node, type == "integer");
    if (type == "array") return array(node, depth);
    if (type == "object") return object(node, depth);
    for (const json& example : node.value("examples", json::array())) {
      if (example.is_string() && chance(0.7)) return example;
    }
    return "normal";
  }

  json number(const json& node, bool is_whole) {
    const double least = node.value("minimum", 0.01);
    const double most = node.value("maximum", 10.0);
    const double near = std::min(most, least + 10.0);
    const double drawn = chance(0.2) ? least : chance(0.2) ? near : between(least, near);
    if (is_whole) return static_cast<std::int64_t>(std::round(drawn));
    return drawn;
  }

  json array(const json& node, int depth) {
    const json examples = node.value("examples", json::array());
    if (!examples.empty() && chance(0.3)) return one_of(examples);
    const std::size_t least = node.value("minItems", 0U);
    json list = json::array();
    for (std::size_t i = 0; i < least + below(2); ++i) {
      json element = value(node["items"], depth + 1);
      if (std::find(list.begin(), list.end(), element) == list.end() ||
          !node.value("uniqueItems", false))
        list.push_back(std::move(element));
    }
    return list;
  }

  json object(const json& node, int depth) {
    json map = json::object();
    const json required = node.value("required", json::array());
    const json properties = node.value("properties", json::object());
    for (const auto& [key, property] : properties.items()) {
      if (property.contains("x-now")) continue;  // a former name
      const bool is_required =
          std::find(required.begin(), required.end(), json(key)) != required.end();
      if (is_required || chance(depth == 0 ? 0.35 : 0.25)) map[key] = value(property, depth + 1);
    }
    if (properties.empty() && node.contains("additionalProperties") &&
        node["additionalProperties"].is_object())
      map[one_of(examples_shown)] = value(node["additionalProperties"], depth + 1);
    return map;
  }

  /// Few and tiny pictures, of sizes and rates at which encoders and readers are put to the test.
  void make_small(json& output) {
    static const json small = json::parse(R"({
      "size": [[32, 24], [16, 16], [48, 32], [64, 48], [20, 16], [33, 25], [64, 64], [130, 98]],
      "fps": [1, 2, 5, 7, 10, 12.5], "cycles": [1, 1, 2], "scale": [0.5, 1, 1.5, 2],
      "crop": [[0, 0, 16, 16], [4, 2, 18, 16]], "quality": ["draft"],
      "presentation": [{"fixation": 0.3}, {"card": {"text": "Watch", "seconds": 0.4}},
                       {"fade_in": 0.2, "fade_out": 0.5}, {"blank_before": 0.5, "background": 0}]})");
    for (const auto& [key, values] : small.items()) {
      if (output.contains(key)) output[key] = one_of(values);
    }
  }

  json named_numbers(const std::vector<std::string>& names) {
    json map = json::object();
    for (std::size_t i = 0; i < 1 + below(2); ++i) map[one_of(names)] = between(0.0, 1.0);
    return map;
  }

  json stimuli() {
    json list = json::array();
    const std::size_t count = 1 + below(3);
    for (std::size_t i = 0; i < count; ++i) list.push_back(stimulus(std::string(1, "abc"[i])));
    return list;
  }

  json stimulus(const std::string& id) {
    json drawn = value(followed(schema_["properties"]["stimuli"]["items"]), 1);
    for (const char* motion :
         {"adjectives", "features", "weights", "clip", "path", "people", "swap"})
      drawn.erase(motion);
    drawn["id"] = id;
    if (chance(0.15)) {
      for (const char* own : {"hold", "modify"}) drawn.erase(own);
      drawn["people"] = one_of(people);
      if (drawn.contains("output")) make_small(drawn["output"]);
      return drawn;
    }
    switch (below(6)) {
      case 0:
        drawn["adjectives"] = named_numbers({"quickness", "largeness", "sad-happy"});
        break;
      case 1:
        drawn["features"] = named_numbers({"step-length", "duration"});
        break;
      case 2:
        drawn["clip"] = one_of(clips);
        break;
      case 3:
        drawn["path"] = one_of(paths);
        break;
      default:
        drawn["weights"] = named_numbers(examples_shown);
    }
    if (drawn.contains("output")) make_small(drawn["output"]);
    return drawn;
  }

  json overlay() {
    json drawn = value(followed(schema_["properties"]["overlays"]["items"]), 1);
    drawn.erase("reference");
    drawn["id"] = "both";
    drawn["target"] = "a";
    drawn["created"] = "normal";
    if (drawn.contains("output")) make_small(drawn["output"]);
    return drawn;
  }

  json sheet() {
    static const json sheets = json::parse(
        R"([{"compare": {"target": "a", "created": "normal"}}, {"gallery": ["a", "normal", "sad"]},
            {"stills": ["a"]}])");
    return one_of(sheets);
  }

  std::mt19937_64 engine_;
  json schema_;
  const json least_output = json::parse(
      R"({"size": [32, 24], "fps": 5, "cycles": 1, "quality": "draft", "video": ["gif"]})");
  const json clips = json::parse(
      R"(["walk.bvh", "two.bvh", "one.bvh", {"file": "walk.bvh", "frames": [0, 2]},
          {"file": "walk.bvh", "frames": [3, 20]}])");
  const json people = json::parse(
      R"([[{"weights": {"sad": 1}, "place": {"x": -0.5, "turn": 90}},
           {"clip": "walk.bvh", "place": {"x": 0.5, "turn": -90}, "start": 0.3}],
          [{"clip": "walk.bvh"}, {"clip": "one.bvh"}, {"path": [{"walk": 0.5}]}]])");
  const json paths = json::parse(
      R"([[{"walk": 0.5}], [{"stand": 0.3}, {"turn": 45}], {"points": [[0, 0], [0.7, 0.2]]}])");
};

/// "stimuli[0].look" → "stimuli", "0", "look".
std::vector<std::string> steps_to(const std::string& path) {
  std::string spaced = path;
  std::ranges::replace_if(
      spaced, [](char c) { return c == '.' || c == '[' || c == ']'; }, ' ');
  std::istringstream words(spaced);
  std::vector<std::string> steps;
  for (std::string word; words >> word;) steps.push_back(word);
  return steps;
}

/// Removes the innermost option on the way to a path that may be left out.
bool remove_at(json& node, const std::vector<std::string>& steps, std::size_t depth) {
  if (depth == steps.size()) return false;
  const std::string& step = steps[depth];
  static const std::vector<std::string> needed = {"mien",    "study", "id",  "examples",
                                                  "stimuli", "set",   "size"};
  if (node.is_array()) {
    const std::size_t index = std::stoul(step);
    if (index >= node.size()) return false;
    if (remove_at(node[index], steps, depth + 1)) return true;
    if (node.size() == 1 || (depth == 1 && steps[0] == "stimuli")) return false;
    node.erase(index);
    return true;
  }
  // What is at fault but not written stands where a level sets it.
  if (node.is_object() && !node.contains(step) && node.contains("levels")) {
    node.erase("levels");
    return true;
  }
  if (!node.is_object() || !node.contains(step)) return false;
  if (remove_at(node[step], steps, depth + 1)) return true;
  if (std::ranges::find(needed, step) != needed.end()) return false;
  node.erase(step);
  return true;
}

}  // namespace

json random_manifest(std::uint64_t seed) { return Generator(seed).manifest(); }

std::optional<json> without_options(json manifest, const std::vector<std::string>& paths) {
  bool changed = false;
  for (const std::string& path : paths) changed |= remove_at(manifest, steps_to(path), 0);
  return changed ? std::optional(manifest) : std::nullopt;
}

void write_random_files(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "walks");
  const motion::ExampleSet walks = motion::builtin_examples("walks-10");
  for (const motion::Example& example : walks.examples) {
    const std::string name = example.clip.name;
    if (std::ranges::find(examples_shown, name) == examples_shown.end()) continue;
    motion::Clip clip = example.clip;
    motion::write_motion(motion::to_recording(clip), folder / "walks" / (name + ".bvh"));
    if (name != "normal") continue;
    motion::write_motion(motion::to_recording(clip), folder / "walk.bvh");
    clip.poses.resize(2);
    motion::write_motion(motion::to_recording(clip), folder / "two.bvh");
    clip.poses.resize(1);
    motion::write_motion(motion::to_recording(clip), folder / "one.bvh");
  }
}

}  // namespace mien::test
