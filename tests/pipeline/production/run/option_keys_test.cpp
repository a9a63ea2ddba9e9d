#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "pipeline/base/documents/concerns.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/base/reading/field_names.h"
#include "pipeline/base/reading/schema.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/look/point_form.h"
#include "pipeline/manifest/manifest.h"
#include "pipeline/manifest/schema_paths.h"
#include "pipeline/production/run/made_artifacts.h"
#include "pipeline/production/run/option_variants.h"
#include "pipeline/production/run/production.h"
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

/// The study with a comparison sheet and a gallery, which options of the look and of videos cannot
/// change.
json with_sheets(json document, unsigned concerned) {
  constexpr unsigned unseen =
      concerns::picture | concerns::stored | concerns::shown | concerns::files | concerns::drawing;
  constexpr unsigned seen = concerns::repertoire | concerns::motion | concerns::page;
  if (document.contains("sheets") || ((concerned & unseen) != 0 && (concerned & seen) == 0))
    return document;
  json shown = json::array();
  for (const json& stimulus : document["stimuli"])
    if (!stimulus.contains("people") && !stimulus.contains("levels"))
      shown.push_back(stimulus["id"]);
  if (shown.size() < 2) return document;
  document["sheets"] = {{{"compare", {{"target", shown[0]}, {"created", shown[1]}}}},
                        {{"gallery", {shown[0], shown[1]}}}};
  return document;
}

/// A document of which one value is that of an environment variable.
struct VariableDocument {
  json document;
  std::string first, second;  ///< values of the variable
};

/// Nothing where the documents differ in more than one text, number or word.
std::optional<VariableDocument> with_variable(const test::OptionVariants& variants) {
  const json changes = json::diff(variants.first, variants.second);
  if (changes.size() != 1 || changes[0]["op"] != "replace" || changes[0]["value"].is_structured())
    return std::nullopt;
  const json::json_pointer place(changes[0]["path"].get<std::string>());
  if (variants.first.at(place).is_structured()) return std::nullopt;
  const auto text_of = [](const json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
  };
  VariableDocument variable{variants.first, text_of(variants.first.at(place)),
                            text_of(changes[0]["value"])};
  variable.document.at(place) = "${MIEN_VALUE}";
  return variable;
}

/// All texts in a document.
void add_texts(const json& value, std::set<std::string>& texts) {
  if (value.is_string()) texts.insert(value.get<std::string>());
  if (!value.is_structured()) return;
  for (const json& member : value) add_texts(member, texts);
}

class Options : public testing::Test {
 protected:
  static void SetUpTestSuite() { test::write_variant_files(folder()); }

  static const fs::path& folder() {
    static const test::TemporaryFolder files;
    return files.path();
  }

  static ManifestReading reading_of(const json& document, const Environment& environment) {
    const fs::path file = folder() / "m.yaml";
    std::ofstream(file) << document.dump();
    return check_manifest(file, environment);
  }

  /// The manifest, which must be without faults.
  static Manifest checked(const json& document) {
    const ManifestReading reading = reading_of(document, nothing);
    if (!reading.faults.empty()) ADD_FAILURE() << Faults(reading.faults).what();
    return reading.manifest;
  }

  /// What the report depends on.
  static std::string report_key(const Manifest& manifest) {
    const Production production(manifest, {.quality = {}, .only = {}, .jobs = 1});
    return own_keys(production.graph().task("report"));
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

// The text of the manifest is then the same.
TEST_F(Options, FromTheEnvironmentAreInTheKeyOfTheReport) {
  int options = 0;
  for_each_option([&](const std::string& path, unsigned, const auto& variants) {
    const std::optional<VariableDocument> variable = with_variable(variants);
    if (!variable) return;
    const auto reading_with = [&](const std::string& value) {
      return reading_of(variable->document,
                        [&](const std::string&) { return std::optional(value); });
    };
    const ManifestReading first = reading_with(variable->first);
    const ManifestReading second = reading_with(variable->second);
    // Where numbers and texts are allowed, a variable is a text.
    if (!first.faults.empty() || !second.faults.empty()) return;
    ++options;
    EXPECT_NE(report_key(first.manifest), report_key(second.manifest)) << path;
  });
  EXPECT_GT(options, 300);
}

TEST_F(Options, HaveTheContentsOfTheFilesThatTheyNameInTheKeyOfTheReport) {
  int files = 0;
  for_each_option([&](const std::string& path, unsigned, const auto& variants) {
    std::set<std::string> texts;
    for (const json& change : json::diff(variants.first, variants.second))
      if (change.contains("value")) add_texts(change["value"], texts);
    for (const std::string& text : texts) {
      const fs::path file = folder() / text;
      if (!fs::is_regular_file(file)) continue;
      ++files;
      const std::string before = report_key(checked(variants.second));
      const std::string content = read_file(file);
      std::ofstream(file, std::ios::app) << "\n";
      EXPECT_NE(report_key(checked(variants.second)), before) << path << ", " << text;
      write_file(file, content);
    }
  });
  EXPECT_GT(files, 40);
}

// Making studies takes time.
TEST_F(Options, ThatDifferNeverShareAnArtifactThatDiffers) {
  const test::TriedPart tried = test::tried_part(90);
  std::map<std::string, test::KeyedArtifacts> known;
  const auto artifacts_of = [&](const json& document) -> const test::KeyedArtifacts& {
    const auto [entry, is_new] = known.try_emplace(document.dump());
    if (is_new) entry->second = test::made_artifacts(checked(document));
    return entry->second;
  };
  int option = 0;
  for_each_option([&](const std::string& path, unsigned concerned, const auto& variants) {
    if (!tried.has(option++)) return;
    const test::KeyedArtifacts& first = artifacts_of(with_sheets(variants.first, concerned));
    test::expect_none_stale(first, artifacts_of(with_sheets(variants.second, concerned)), path);
  });
}

}  // namespace
}  // namespace mien::pipeline
