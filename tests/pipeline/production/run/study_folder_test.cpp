// What a run leaves beside pictures: tables that belong together, a codebook of all their columns,
// and a provenance that makes the study again.

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "motion/procedural/builtin_sets.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/checked_manifest.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/manifest/file_keys.h"
#include "pipeline/production/report/study_tasks.h"
#include "pipeline/production/run/codebook.h"
#include "pipeline/production/run/provenance.h"
#include "pipeline/production/run/run.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/tasks/store.h"
#include "pipeline/temporary_folder.h"

#include "shared_set_up.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr char manifest_text[] = R"(mien: 1
study: tiny
seed: 7
examples:
  set: builtin:walks-10
  scales: sub/my.scales.yaml
  ratings: simulated
  raters: 3
  expect: [{parameter: slow-fast, order: [slow, brisk]}, {parameter: slow-fast, order: [brisk, normal, slow]}]
recipes: my.recipes.yaml
look: {camera: {view: side, fov: 30}}
output: {size: [32, 24], fps: 6, cycles: 1, video: [gif], presentation: {blank_before: 0.5}}
equalize: [size, luminance]
stimuli:
  - {id: a, factors: {actor: k}, adjectives: {slow-fast: 0.6}}
  - {id: b, weights: {sad: 1}, look: {scene: my.set.yaml}}
  - {id: c, weights: {normal: 1}, modify: {emotion: heavy, strength: 0.5}, look: {figure: {mannequin: {sex: 0.2}}}}
overlays: [{target: a, created: b}]
sheets: [{compare: {target: a, created: b, reference: normal}}]
)";

/// Runs a manifest or a provenance into `out`.
void make(const fs::path& file, const fs::path& out, std::optional<Quality> quality) {
  Production production(load_manifest(file, [](const std::string&) { return std::nullopt; }),
                        {.quality = quality, .only = {}, .jobs = 1});
  const RunResult result = run(production, out, 1, {}, {});
  for (const TaskOutcome& outcome : result.outcomes) {
    if (!outcome.error.empty()) throw std::runtime_error(outcome.error);
  }
}

void make_draft(const fs::path& folder) {
  fs::create_directories(folder / "sub");
  write_file(folder / "m.yaml", manifest_text);
  write_file(
      folder / "sub/my.scales.yaml",
      "range: [1, 7]\nscales: {slow-fast: {low: slow, high: fast, loadings: {quickness: 1}}}\n");
  write_file(folder / "my.recipes.yaml",
             "recipes: {heavy: {tempo: 0.9, posture: {head-flexion: 10}}}\n");
  write_file(folder / "my.set.yaml", "name: bare\nbackground: \"#808080\"\n");
  make(folder / "m.yaml", folder / "draft/tiny", Quality::draft);
}

/// A folder with the manifest, what it names, and what was made of it as a draft.
class StudyFolder : public testing::Test {
 protected:
  StudyFolder() {
    fs::copy(test::shared_set_up("study_folder", make_draft), folder.path(),
             fs::copy_options::recursive);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder.path() / name) << text;
  }

  /// What a manifest or a provenance makes in a folder of that name.
  fs::path made(const fs::path& file, const std::string& name,
                std::optional<Quality> quality = Quality::draft) const {
    const fs::path made = folder.path() / name / "tiny";
    make(file, made, quality);
    return made;
  }

  static json document(const fs::path& file) { return json::parse(read_file(file)); }

  const test::TemporaryFolder folder;
  const fs::path out = folder.path() / "draft/tiny";
};

/// All files of a study by their paths, without what the store keeps for itself.
std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = fs::relative(entry.path(), folder).generic_string();
    if (entry.is_regular_file() && !path.starts_with(".mien/")) files[path] = read_file(entry);
  }
  return files;
}

std::vector<std::string> header_in(const fs::path& file) {
  std::vector<std::string> names;
  for (const CsvField& field : read_csv(file).header) names.push_back(field.text);
  return names;
}

std::string cell(const CsvTable& table, std::size_t row, const char* column) {
  return table.rows.at(row)[static_cast<std::size_t>(require_column(table, column))].text;
}

TEST_F(StudyFolder, HasACodebookOfEveryColumnOfEveryTable) {
  std::map<std::string, std::vector<std::string>> told;
  const json book = document(out / "metrics/codebook.json");
  for (const json& table : book["tables"]) {
    EXPECT_FALSE(table["row"].get<std::string>().empty());
    for (const json& column : table["columns"]) {
      EXPECT_FALSE(column["meaning"].get<std::string>().empty()) << column;
      told[table["file"]].push_back(column["name"]);
    }
  }
  std::set<std::string> written;
  for (const auto& [path, bytes] : files_in(out)) {
    if (!path.ends_with(".csv")) continue;
    written.insert(path);
    EXPECT_EQ(told[path], header_in(out / path)) << path;
  }
  EXPECT_EQ(written.size(), told.size());
  EXPECT_GE(written.size(), 16u);
}

TEST_F(StudyFolder, HasATableOfStimuliThatAllOthersJoin) {
  const CsvTable stimuli = read_csv(out / "metrics/stimuli.csv");
  ASSERT_EQ(stimuli.rows.size(), 4u);
  std::set<std::string> known;
  for (std::size_t r = 0; r < 4; ++r) known.insert(cell(stimuli, r, "stimulus"));
  for (const auto& [path, bytes] : files_in(out)) {
    if (!path.ends_with(".csv")) continue;
    const CsvTable table = read_csv(out / path);
    if (find_column(table, "stimulus") < 0) continue;
    for (std::size_t r = 0; r < table.rows.size(); ++r)
      EXPECT_TRUE(known.contains(cell(table, r, "stimulus"))) << path;
  }
  EXPECT_EQ(cell(stimuli, 0, "factor_actor"), "k");
  EXPECT_EQ(cell(stimuli, 1, "factor_actor"), "");
  EXPECT_EQ(cell(stimuli, 1, "factor_example"), "sad");
  EXPECT_EQ(cell(stimuli, 2, "factor_emotion"), "heavy");
  EXPECT_EQ(cell(stimuli, 0, "requested"), "slow-fast=0.6");
  EXPECT_EQ(cell(stimuli, 2, "figure_options"), R"({"sex":0.2})");
  EXPECT_EQ(cell(stimuli, 1, "scene"), "my.set.yaml");
  EXPECT_EQ(cell(stimuli, 2, "modified"), "heavy × 0.5");
  EXPECT_EQ(cell(stimuli, 0, "quality"), "draft");
  EXPECT_EQ(cell(stimuli, 0, "samples_per_pixel"), "2");
  EXPECT_EQ(cell(stimuli, 3, "kind"), "overlay");
}

TEST_F(StudyFolder, TellsFilesOfStimuliWithTheirLengthAndHash) {
  const CsvTable stimuli = read_csv(out / "metrics/stimuli.csv");
  for (std::size_t r = 0; r < 3; ++r) {
    const auto frames = std::stoul(cell(stimuli, r, "film_frames"));
    EXPECT_EQ(cell(stimuli, r, "video_hash"), hash_of_file(out / cell(stimuli, r, "video")));
    EXPECT_EQ(cell(stimuli, r, "clip_hash"), hash_of_file(out / cell(stimuli, r, "clip")));
    const auto files = fs::directory_iterator(out / cell(stimuli, r, "frames"));
    EXPECT_EQ(frames, static_cast<std::size_t>(std::distance(begin(files), end(files))));
    EXPECT_NEAR(std::stod(cell(stimuli, r, "film_s")), static_cast<double>(frames) / 6.0, 1e-12);
    EXPECT_NEAR(std::stod(cell(stimuli, r, "video_s")), std::stod(cell(stimuli, r, "film_s")) + 0.5,
                1e-9);
  }
  const CsvTable videos = read_csv(out / "metrics/videos.csv");
  ASSERT_FALSE(videos.rows.empty());
  for (std::size_t r = 0; r < videos.rows.size(); ++r)
    EXPECT_EQ(cell(videos, r, "video_hash"), hash_of_file(out / cell(videos, r, "file")));
}

TEST_F(StudyFolder, TellsWhichExpectationsHold) {
  const CsvTable table = read_csv(out / "metrics/expectations.csv");
  ASSERT_EQ(table.rows.size(), 5u);
  EXPECT_EQ(cell(table, 0, "above_previous"), "");
  EXPECT_EQ(cell(table, 1, "above_previous"), "1");
  EXPECT_EQ(cell(table, 1, "holds"), "1");
  EXPECT_EQ(cell(table, 2, "holds"), "0");
  EXPECT_EQ(cell(table, 4, "above_previous"), "0");
  EXPECT_EQ(cell(table, 4, "example"), "slow");
  EXPECT_EQ(cell(table, 4, "place"), "3");
}

TEST_F(StudyFolder, SaysWithWhatQualityItWasMade) {
  const fs::path standard = made(folder.path() / "m.yaml", "standard", std::nullopt);
  const json one = document(out / "provenance.json");
  const json other = document(standard / "provenance.json");
  EXPECT_EQ(one["command"], "mien run m.yaml --quality draft");
  EXPECT_EQ(other["command"], "mien run m.yaml");
  for (const json& stimulus : one["stimuli"]) EXPECT_EQ(stimulus["output"]["quality"], "draft");
  EXPECT_EQ(other["stimuli"][0]["output"]["samples_per_pixel"], 16);
  EXPECT_NE(read_file(out / "report.html").find("draft quality"), std::string::npos);
  EXPECT_EQ(read_file(standard / "report.html").find("draft quality"), std::string::npos);
}

TEST_F(StudyFolder, TellsAllSettingsOfEveryStimulus) {
  const json record = document(out / "provenance.json");
  ASSERT_EQ(record["stimuli"].size(), 3u);
  const json& heavy = record["stimuli"][2];
  EXPECT_EQ(heavy["modify"][0]["tempo"], 0.9);  // out of the file of recipes
  EXPECT_EQ(heavy["modify"][0]["paths"], 1.0);
  EXPECT_TRUE(heavy["modify"][0].contains("seed"));
  EXPECT_EQ(heavy["look"]["figure"]["mannequin"]["sex"], 0.2);
  EXPECT_TRUE(heavy["look"]["figure"]["mannequin"].contains("build"));
  EXPECT_EQ(heavy["interpolation"]["method"], "reach");
  EXPECT_EQ(record["overlays"][0]["opacity"], 0.75);
}

TEST_F(StudyFolder, KeepsCopiesOfWhatItWasDescribedBy) {
  EXPECT_EQ(read_file(out / "inputs/m.yaml"), manifest_text);
  for (const char* name : {"sub/my.scales.yaml", "my.recipes.yaml", "my.set.yaml"}) {
    EXPECT_EQ(read_file(out / "inputs" / name), read_file(folder.path() / name));
    EXPECT_EQ(document(out / "provenance.json")["inputs"]["inputs/" + std::string(name)],
              hash_of_file(folder.path() / name));
  }
}

TEST_F(StudyFolder, KeepsNoColumnsOfAnswersThatIdentifyParticipants) {
  std::string answers = "url_PROLIFIC_PID,participant,stimulus,scale,value,closing_comment\n";
  std::string kept = "participant,stimulus,scale,value\n";
  int value = 0;
  for (const std::string& name : motion::builtin_example_names("walks-10")) {
    const std::string answer = "p1," + name + ",slow-fast," + std::to_string(1 + value++ % 7);
    answers += "5f01person," + answer + ",\"Greetings, Eve\"\n";
    kept += answer + "\n";
  }
  write("answers.csv", answers);
  write("rated.yaml",
        "mien: 1\nstudy: rated\n"
        "examples: {set: builtin:walks-10, scales: sub/my.scales.yaml, ratings: answers.csv}\n"
        "stimuli: [{id: a, weights: {sad: 1}}]\n");
  const auto load = [](const fs::path& file) {
    return load_manifest(file, [](const std::string&) { return std::nullopt; });
  };
  const Manifest manifest = load(folder.path() / "rated.yaml");
  const std::map<std::string, Hash> hashes = hashes_of_inputs(manifest);
  EXPECT_EQ(hashes.at("inputs/answers.csv"), hash_of(kept));
  Store store(folder.path() / "rated");
  put_inputs(manifest, hashes, store);
  EXPECT_EQ(read_file(folder.path() / "rated/inputs/answers.csv"), kept);
  // From the copy, the study is made as from the answers.
  const Manifest again = load(folder.path() / "rated" / as_run_path);
  EXPECT_EQ(hashes_of_inputs(again).at("inputs/answers.csv"), hash_of(kept));
  FileKeys files, copies;
  EXPECT_EQ(shared_determinants(manifest, files).repertoire,
            shared_determinants(again, copies).repertoire);
}

TEST_F(StudyFolder, IsMadeAgainFromItsProvenanceToTheLastByte) {
  const auto files = files_in(out);
  for (const char* name : {"m.yaml", "my.recipes.yaml", "my.set.yaml", "sub/my.scales.yaml"})
    fs::remove(folder.path() / name);
  const fs::path again = made(out / "provenance.json", "again", std::nullopt);
  EXPECT_EQ(files_in(again), files);
  const fs::path copied = made(again / "inputs/m.yaml", "copied");
  EXPECT_EQ(files_in(copied), files);
}

// A number of samples applies to the quality that was replaced.
TEST_F(StudyFolder, IsMadeAgainWhereItsQualityWasReplaced) {
  write("r.yaml", R"(mien: 1
study: tiny
examples: {set: builtin:walks-10}
output: {size: [32, 24], fps: 6, cycles: 1, video: [gif], quality: reference, samples: 2}
stimuli: [{id: a, weights: {sad: 1}}]
)");
  const fs::path replaced = made(folder.path() / "r.yaml", "replaced", Quality::draft);
  const fs::path again = made(replaced / "provenance.json", "again", std::nullopt);
  EXPECT_EQ(files_in(again), files_in(replaced));
}

TEST_F(StudyFolder, IsFoundMadeByItsProvenance) {
  Production production(
      load_manifest(out / "provenance.json", [](const std::string&) { return std::nullopt; }),
      {.quality = {}, .only = {}, .jobs = 1});
  for (const TaskOutcome& outcome : plan(production.graph(), out))
    EXPECT_EQ(outcome.state, TaskState::cached);
}

TEST_F(StudyFolder, TellsWhichInputsHaveChangedSince) {
  const fs::path provenance = out / "provenance.json";
  const auto changes = [&] {
    return changes_since(
        provenance, load_manifest(provenance, [](const std::string&) { return std::nullopt; }));
  };
  EXPECT_TRUE(changes().empty());
  std::ofstream(provenance.parent_path() / "inputs/my.recipes.yaml")
      << "recipes: {heavy: {tempo: 0.8}}\n";
  EXPECT_EQ(changes(), std::vector<std::string>{"inputs/my.recipes.yaml has changed"});
}

TEST_F(StudyFolder, TellsThatTheManifestWhichIsRunHasChanged) {
  std::string text = read_file(out / "inputs/as-run.yaml");
  text.replace(text.find("0.6"), 3, "0.5");
  std::ofstream(out / "inputs/as-run.yaml") << text;
  const Manifest manifest =
      load_manifest(out / "provenance.json", [](const std::string&) { return std::nullopt; });
  EXPECT_EQ(changes_since(out / "provenance.json", manifest),
            std::vector<std::string>{"inputs/as-run.yaml has changed"});
}

TEST_F(StudyFolder, IsNotToldAsMadeOfInputsThatChangedMeanwhile) {
  Production production(
      load_manifest(folder.path() / "m.yaml", [](const std::string&) { return std::nullopt; }),
      {.quality = Quality::draft, .only = {}, .jobs = 1});
  write("my.recipes.yaml", "recipes: {heavy: {tempo: 0.8, posture: {head-flexion: 10}}}\n");
  const fs::path again = folder.path() / "again/tiny";
  try {
    run(production, again, 1, {}, {});
    FAIL() << "the change was not seen";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("inputs/my.recipes.yaml was changed"),
              std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(fs::exists(again / "provenance.json"));
}

TEST_F(StudyFolder, HasTablesOfTheEnvironmentsFactors) {
  std::string text = manifest_text;
  text.replace(text.find("actor: k"), 8, "actor: \"${ACTOR}\"");
  write("m.yaml", text);
  const auto key_with = [&](const char* actor) {
    const Production production(
        load_manifest(folder.path() / "m.yaml",
                      [&](const std::string&) { return std::optional<std::string>(actor); }),
        {.quality = Quality::draft, .only = {}, .jobs = 1});
    return production.graph().task("tables").determinants.key();
  };
  EXPECT_EQ(key_with("k"), key_with("k"));
  EXPECT_NE(key_with("k"), key_with("t"));
}

TEST_F(StudyFolder, IsNotMadeAgainWithoutItsInputs) {
  fs::remove(out / "inputs/m.yaml");
  const auto faults = check_manifest(out / "provenance.json", [](const std::string&) {
                        return std::nullopt;
                      }).faults;
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(to_string(faults[0]), (out / "provenance.json").string() + ": there is no " +
                                      (out / "inputs/m.yaml").string() +
                                      ", which it depends on; keep the folder inputs beside it");
}

TEST(Codebook, IsThePageOfTables) {
  const std::string page = read_file(fs::path(MIEN_SOURCE_DIR) / "manifests/TABLES.md");
  const std::size_t start = page.find("## ");
  ASSERT_NE(start, std::string::npos);
  EXPECT_EQ(page.substr(start), codebook_markdown());
}

TEST(Codebook, NamesNoTableAndNoColumnTwice) {
  std::set<std::string_view> paths;
  for (const TableForm& form : all_table_forms()) {
    EXPECT_TRUE(paths.insert(form.path).second) << form.path;
    std::set<std::string_view> names;
    for (const Column& column : form.columns) {
      EXPECT_TRUE(names.insert(column.name).second) << column.name;
      EXPECT_EQ(column.meaning.find('|'), std::string::npos) << column.meaning;
    }
  }
}

}  // namespace
}  // namespace mien::pipeline
