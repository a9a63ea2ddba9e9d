#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/production/run/made_artifacts.h"
#include "pipeline/production/run/option_variants.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A study with all kinds of motions, sheets and films, as small as possible.
constexpr char every_kind[] = R"({"mien": 1, "study": "s", "seed": 1,
  "examples": {"set": "builtin:walks-10"}, "equalize": ["duration", "size"],
  "output": {"size": [32, 24], "fps": 6, "cycles": 1, "quality": "draft", "video": ["mp4"]},
  "stimuli": [
    {"id": "a", "role": "target", "adjectives": {"quickness": 0.7}},
    {"id": "b", "weights": {"sad": 1}},
    {"id": "c", "role": "reference", "clip": "one/normal.bvh"},
    {"id": "d", "clip": "one/sad.bvh"},
    {"id": "pair", "people": [{"weights": {"normal": 1}, "place": {}},
                              {"weights": {"sad": 1}, "place": {"x": 1}}]}],
  "sheets": [
    {"id": "blends", "compare": {"target": "a", "created": "b", "reference": "normal"}},
    {"id": "files", "compare": {"target": "c", "created": "d"}},
    {"id": "all", "gallery": ["a", "b", "c", "sad"]},
    {"id": "pictures", "stills": ["a", "pair"]}],
  "overlays": [{"id": "both", "target": "a", "created": "b"}],
  "questionnaire": {"participants": 4, "scales": "all"}})";

/// A change that is not the value of one option, or that shows only beside other parts of a study:
/// what is done to the study before (JSON Patch), and what after.
struct Change {
  const char* name;
  const char* before;
  const char* after;
};

constexpr Change study_changes[] = {
    {"a role", "[]", R"([{"op": "replace", "path": "/stimuli/0/role", "value": "created"}])"},
    {"a role in its colour", R"([{"op": "add", "path": "/look", "value": {"colours": "role"}}])",
     R"([{"op": "replace", "path": "/stimuli/0/role", "value": "reference"}])"},
    {"the order of stimuli", "[]",
     R"([{"op": "move", "from": "/stimuli/0", "path": "/stimuli/1"}])"},
    {"an id", "[]",
     R"([{"op": "replace", "path": "/stimuli/3/id", "value": "e"},
         {"op": "replace", "path": "/sheets/1/compare/created", "value": "e"}])"},
    {"the name of the study", "[]", R"([{"op": "replace", "path": "/study", "value": "t"}])"},
    {"the seed", "[]", R"([{"op": "replace", "path": "/seed", "value": 2}])"},
    {"the language of names", "[]", R"([{"op": "add", "path": "/names", "value": "ja"}])"},
    {"the language of pages", "[]",
     R"([{"op": "add", "path": "/questionnaire/language", "value": "ja"}])"},
    {"the kind of a sheet", "[]",
     R"([{"op": "replace", "path": "/sheets/0",
          "value": {"id": "blends", "gallery": ["a", "b", "normal"]}}])"},
    {"the reference of a sheet", "[]",
     R"([{"op": "remove", "path": "/sheets/0/compare/reference"}])"},
    {"the order of a gallery", "[]",
     R"([{"op": "replace", "path": "/sheets/2/gallery", "value": ["sad", "b", "c", "a"]}])"},
    {"the statement of weights", "[]",
     R"([{"op": "add", "path": "/stimuli/1/weights/normal", "value": 0}])"},
    {"the statement of a motion", "[]",
     R"([{"op": "replace", "path": "/stimuli/3", "value": {"id": "d", "weights": {"sad": 1}}}])"},
    {"when people begin",
     R"([{"op": "add", "path": "/stimuli/4/people/0/start", "value": -0.4},
         {"op": "add", "path": "/stimuli/4/people/1/start", "value": -0.4}])",
     R"([{"op": "replace", "path": "/stimuli/4/people/0/start", "value": -0.7},
         {"op": "replace", "path": "/stimuli/4/people/1/start", "value": -0.7}])"},
    {"the name of a person", "[]",
     R"([{"op": "add", "path": "/stimuli/4/people/0/name", "value": "x"}])"},
    {"the order of people", "[]",
     R"([{"op": "move", "from": "/stimuli/4/people/0", "path": "/stimuli/4/people/1"}])"},
    {"the name of a recipe",
     R"([{"op": "add", "path": "/recipes", "value": "same.recipes.yaml"},
         {"op": "add", "path": "/stimuli/1/modify", "value": {"emotion": "one"}}])",
     R"([{"op": "replace", "path": "/stimuli/1/modify/emotion", "value": "other"}])"},
    {"whose sound it is",
     R"([{"op": "add", "path": "/stimuli/0/audio", "value": {"file": "one.wav", "length": "cut"}},
         {"op": "add", "path": "/stimuli/1/audio", "value": {"file": "one.wav", "length": "cut"}},
         {"op": "add", "path": "/stimuli/2/audio", "value": {"from": "a", "length": "cut"}}])",
     R"([{"op": "replace", "path": "/stimuli/2/audio/from", "value": "b"}])"},
};

TEST(StudyChanges, LeaveNoArtifactStale) {
  const test::TemporaryFolder files;
  test::write_variant_files(files.path());
  std::ofstream(files.path() / "same.recipes.yaml")
      << "recipes:\n  one: {tempo: 0.9}\n  other: {tempo: 0.9}\n";
  std::map<std::string, test::KeyedArtifacts> known;
  const auto artifacts_of = [&](const json& document) -> const test::KeyedArtifacts& {
    const auto [entry, is_new] = known.try_emplace(document.dump());
    if (!is_new) return entry->second;
    const fs::path file = files.path() / "m.yaml";
    std::ofstream(file) << document.dump();
    const ManifestReading reading =
        check_manifest(file, [](const std::string&) { return std::nullopt; });
    if (!reading.faults.empty()) ADD_FAILURE() << Faults(reading.faults).what();
    return entry->second = test::made_artifacts(reading.manifest);
  };
  const test::TriedPart tried = test::tried_part(6);
  int number = 0;
  for (const Change& change : study_changes) {
    if (!tried.has(number++)) continue;
    SCOPED_TRACE(change.name);
    const json before = json::parse(every_kind).patch(json::parse(change.before));
    const json after = before.patch(json::parse(change.after));
    const test::KeyedArtifacts& first = artifacts_of(before);
    test::expect_none_stale(first, artifacts_of(after), change.name);
  }
}

}  // namespace
}  // namespace mien::pipeline
