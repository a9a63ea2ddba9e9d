#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/base/reading/field_names.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/schema_paths.h"
#include "pipeline/production/run/option_variants.h"
#include "pipeline/production/run/run.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::optional<std::string> nothing(const std::string&) { return std::nullopt; }

/// What a task's products depend on by itself, beside its inputs' bytes.
std::string own_keys(const Task& task) {
  std::string keys = task.determinants.key();
  for (const Product& product : task.products) keys += " " + product.path + product.own.key();
  for (const std::string& input : task.inputs) keys += " " + input;
  return keys;
}

/// Tasks by their ids, with their own keys.
std::map<std::string, std::string> keys_of(const Production& production) {
  std::map<std::string, std::string> keys;
  for (const Task& task : production.graph().tasks) keys[task.id] = own_keys(task);
  return keys;
}

/// Kinds of tasks that are not the same in both.
std::set<std::string> changed_kinds(const Production& one, const Production& other) {
  const auto first = keys_of(one), second = keys_of(other);
  std::set<std::string> kinds;
  const auto add = [&](const auto& from, const auto& to) {
    for (const auto& [id, key] : from) {
      const auto same = to.find(id);
      if (same == to.end() || same->second != key) kinds.insert(id.substr(0, id.find(':')));
    }
  };
  add(first, second);
  add(second, first);
  return kinds;
}

/// An artifact and the key that it was made for.
using Artifacts = std::map<std::string, std::pair<Hash, Hash>>;

class Options : public testing::Test {
 protected:
  static void SetUpTestSuite() { test::write_variant_files(folder()); }

  static const fs::path& folder() {
    static const test::TemporaryFolder files;
    return files.path();
  }

  /// The manifest, which must be without faults.
  static Manifest checked(const json& document) {
    const fs::path file = folder() / "m.yaml";
    std::ofstream(file) << document.dump();
    const ManifestReading reading = check_manifest(file, nothing);
    if (!reading.faults.empty()) ADD_FAILURE() << Faults(reading.faults).what();
    return reading.manifest;
  }

  static Artifacts made(const json& document) {
    const test::TemporaryFolder store;
    Production production(checked(document), {.quality = {}, .only = {}, .jobs = 1});
    const RunResult result = run(production, store.path(), 1, {}, {});
    Artifacts artifacts;
    for (const TaskOutcome& outcome : result.outcomes) {
      EXPECT_TRUE(outcome.error.empty()) << outcome.error;
      for (const Receipt& product : outcome.products)
        artifacts[product.path] = {product.key, product.hash};
    }
    return artifacts;
  }

  /// Calls `visit(path, concerned, variants)` for every option of the schema that has two values.
  template <class Visit>
  static void for_each_option(const Visit& visit) {
    FieldNames names;
    names.of<Manifest>();
    for (const auto& [path, node] : test::properties_of(manifest_schema())) {
      if (test::has_one_value(path)) continue;
      SCOPED_TRACE(path);
      visit(path, names.names().at(path), test::variants_of(path, node));
    }
  }
};

TEST_F(Options, AreInTheKeysOfWhatTheyConcernAndOfNothingElse) {
  int options = 0;
  for_each_option([&](const std::string& path, unsigned concerned, const auto& variants) {
    if ((concerned & ~concerns::required) == concerns::nothing) {
      // A map around options that have their own, or what concerns no artifact: only read.
      checked(variants.first);
      checked(variants.second);
      return;
    }
    ++options;
    const Production first(checked(variants.first), {.quality = {}, .only = {}, .jobs = 1});
    const Production second(checked(variants.second), {.quality = {}, .only = {}, .jobs = 1});
    const std::set<std::string> kinds = changed_kinds(first, second);
    // An overlay has no motion of its own: how its motions are shown concerns its film.
    const bool is_overlay = path.starts_with("overlays");
    const bool moves = (concerned & (concerns::motion | concerns::repertoire)) != 0;
    const bool is_motion = moves && !is_overlay;
    const bool is_film =
        (concerned & (concerns::picture | concerns::stored | concerns::shown)) != 0 ||
        (moves && is_overlay);
    EXPECT_EQ(kinds.contains("motion"), is_motion) << path;
    if ((concerned & concerns::drawing) != 0) {
      EXPECT_NE(concerned & concerns::picture, 0u) << path;
    }
    const bool is_page =
        (concerned & ~(concerns::page | concerns::required | concerns::alone)) == 0;
    // Films are made alike by a table, which is among their inputs.
    if (path.starts_with("equalize.") && path.ends_with(".by")) {
      EXPECT_TRUE(kinds.contains("exposure") || kinds.contains("sizes") || kinds.contains("places"))
          << path;
    } else if (is_film) {
      EXPECT_TRUE(kinds.contains("film")) << path;
    }
    if (is_page) {
      EXPECT_FALSE(kinds.contains("film")) << path;
    }
    EXPECT_TRUE(kinds.contains("report")) << path;
  });
  EXPECT_GT(options, 200);
}

/// With MIEN_ALL_OPTIONS=1 every option is tried, else some of them: making studies takes its time.
TEST_F(Options, ThatDifferNeverShareAnArtifactThatDiffers) {
  const int step = std::getenv("MIEN_ALL_OPTIONS") != nullptr ? 1 : 90;
  std::map<std::string, Artifacts> known;
  const auto artifacts_of = [&](const json& document) -> const Artifacts& {
    const auto [entry, is_new] = known.try_emplace(document.dump());
    if (is_new) entry->second = made(document);
    return entry->second;
  };
  int option = 0;
  for_each_option([&](const std::string& path, unsigned, const auto& variants) {
    if (option++ % step != 0) return;
    const Artifacts& first = artifacts_of(variants.first);
    for (const auto& [file, artifact] : artifacts_of(variants.second)) {
      const auto other = first.find(file);
      if (other == first.end() || other->second.first != artifact.first) continue;
      EXPECT_EQ(other->second.second, artifact.second) << path << " changes " << file;
    }
  });
}

}  // namespace
}  // namespace mien::pipeline
