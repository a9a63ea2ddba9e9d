#include <cmath>
#include <cstdlib>
#include <cstring>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "motion/live/live_core.h"
#include "motion/live/live_message.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/reading/recipes.h"
#include "pipeline/study/live/live_script.h"
#include "pipeline/study/live/live_study.h"
#include "pipeline/temporary_folder.h"

// The motion core as WebAssembly against the same code as it runs here. ./mien test builds it where
// it can be had.

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using motion::InterfaceKind;
using motion::LiveSetting;
using nlohmann::json;

fs::path pages() { return fs::path(MIEN_SOURCE_DIR) / "build/release/pages"; }

json request_of(const LiveSetting& setting) {
  return {
      {"kind", name_of(setting.kind)}, {"sliders", setting.sliders}, {"values", setting.values}};
}

/// Largest difference of the doubles of two answers, from `first` to the last whole one.
double largest_difference(const std::string& a, const std::string& b, std::size_t first) {
  if (a.size() != b.size()) return 1e9;
  double largest = 0.0;
  for (std::size_t at = first; at + 8 <= a.size(); at += 8) {
    double in_a = 0.0, in_b = 0.0;
    std::memcpy(&in_a, a.data() + at, 8);
    std::memcpy(&in_b, b.data() + at, 8);
    largest = std::max(largest, std::abs(in_a - in_b));
  }
  return largest;
}

class LiveModule : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("node --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no Node.js here";
    if (!fs::exists(pages() / "live_core/live_core.wasm") ||
        !fs::exists(pages() / "live/live.js")) {
      GTEST_SKIP()
          << "no build/release/pages/live_core: ./mien test makes it where em++ is installed";
    }
  }

  /// Asks the module for what `requests` want; the answers lie in the folder.
  void ask(const motion::LiveBundle& bundle, const json& requests) {
    write_file(folder.path() / "bundle.bin", motion::to_bytes(bundle));
    write_file(folder.path() / "requests.json", requests.dump());
    std::string command = "node '" MIEN_SOURCE_DIR "/tests/pipeline/study/live/live_module.mjs'";
    for (const fs::path& argument :
         {pages() / "live_core/live_core.wasm", pages() / "live/live.js",
          folder.path() / "bundle.bin", folder.path() / "requests.json", folder.path()}) {
      command += " '" + argument.string() + "'";
    }
    ASSERT_EQ(std::system(command.c_str()), 0);
  }

  std::string answer(std::size_t index) const {
    const fs::path file = folder.path() / (std::to_string(index) + ".bin");
    return fs::exists(file) ? read_file(file) : "";
  }

  test::TemporaryFolder folder;
};

TEST_F(LiveModule, MakesTheSameMotionsAndDistances) {
  double motions_apart = 0.0, distances_apart = 0.0;
  for (const char* interpolation :
       {"{method: reach}", "{method: cardinal, foot_lock: false}", "{method: knn}",
        "{method: inverse-distance, rotations: markley-mean}", "{method: grid}",
        "{method: kriging, rotations: direction-vectors}", "{method: pca}",
        "{method: incremental, time_warp: linear}"}) {
    const Manifest manifest = test::live_manifest(interpolation);
    Motions motions(manifest);
    LiveChoice choice = live_choice(manifest);
    for (const Stimulus& stimulus : manifest.stimuli) choice.targets.push_back(stimulus.id);
    const motion::LiveBundle bundle = live_bundle(manifest, motions, choice);
    motion::LiveCore core(bundle);
    json requests = json::array();
    std::vector<std::string> expected;
    std::vector<bool> is_distance;
    const auto expect = [&](const json& request, const std::string& bytes, bool distance) {
      requests.push_back(request);
      expected.push_back(bytes);
      is_distance.push_back(distance);
    };
    for (const Stimulus& stimulus : manifest.stimuli) {
      const LiveSetting setting = test::setting_of(stimulus);
      expect({{"what", "make"}, {"setting", request_of(setting)}},
             motion::to_message(core.make(setting)), false);
      expect({{"what", "target"}, {"name", stimulus.id}},
             motion::to_message(core.target(stimulus.id)), false);
      for (const Stimulus& other : manifest.stimuli) {
        expect({{"what", "distance"}, {"target", other.id}, {"setting", request_of(setting)}},
               motion::to_message(core.distance(other.id, setting)), true);
      }
    }
    expect({{"what", "example"}, {"name", "sad"}}, motion::to_message(core.example("sad")), false);
    ask(bundle, requests);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const std::string made = answer(i);
      ASSERT_EQ(made.size(), expected[i].size()) << interpolation << " " << requests[i];
      const double apart = largest_difference(made, expected[i], is_distance[i] ? 8 : 24);
      EXPECT_LT(apart, 1e-9) << interpolation << " " << requests[i];
      double& largest = is_distance[i] ? distances_apart : motions_apart;
      largest = std::max(largest, apart);
    }
  }
  RecordProperty("motions", std::to_string(motions_apart));
  std::printf("motions within %.2g, distances within %.2g\n", motions_apart, distances_apart);
}

TEST_F(LiveModule, MakesTheSameModifications) {
  const Manifest manifest = test::live_manifest("{method: reach}");
  Motions motions(manifest);
  LiveChoice choice = live_choice(manifest);
  choice.only = "normal";
  motion::LiveBundle bundle = live_bundle(manifest, motions, choice);
  bundle.modification.original = "normal";
  const RecipeBook book = read_recipes("builtin", {});
  for (const Recipe& recipe : book.recipes)
    bundle.modification.dimensions.push_back(
        {.name = recipe.name, .recipe = with_edit({}, recipe.edit), .high = 1.5});
  bundle.modification.dimensions.push_back(
      {.name = "paths", .value = motion::ModificationValue::paths, .high = 2.0});
  motion::LiveCore core(bundle);
  json requests = json::array();
  std::vector<std::string> expected;
  for (const Recipe& recipe : book.recipes) {
    const LiveSetting setting{InterfaceKind::modifications, {recipe.name, "paths"}, {1.1, 1.2}};
    requests.push_back({{"what", "make"}, {"setting", request_of(setting)}});
    expected.push_back(motion::to_message(core.make(setting)));
  }
  ASSERT_GT(expected.size(), 5U);
  ask(bundle, requests);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(answer(i).size(), expected[i].size()) << requests[i];
    EXPECT_LT(largest_difference(answer(i), expected[i], 24), 1e-9) << requests[i];
  }
}

TEST_F(LiveModule, RunsOnAPageThatNobodyServes) {
  const fs::path driver = pages() / "work/tests/live/static_page.mjs";
  if (std::system("chromium --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "no Chromium here";
  if (!fs::exists(driver) || !fs::exists(pages() / "work/node_modules/playwright-core"))
    GTEST_SKIP() << "no playwright-core in build/release/pages/work: ./mien test brings it";
  const Manifest manifest = test::live_manifest("{method: reach}");
  Motions motions(manifest);
  LiveChoice choice = live_choice(manifest);
  choice.targets = {"by-weights"};
  const motion::LiveBundle bundle = live_bundle(manifest, motions, choice);
  const LiveSetting setting = test::setting_of(manifest.stimuli[0]);
  write_file(folder.path() / "live_files.js",
             live_script(pages() / "live_core/live_core.wasm", bundle));
  fs::copy_file(pages() / "live/live.js", folder.path() / "live.js");
  write_file(
      folder.path() / "requests.json",
      json({{{"what", "make"}, {"setting", request_of(setting)}},
            {{"what", "distance"}, {"target", "by-weights"}, {"setting", request_of(setting)}},
            {{"what", "target"}, {"name", "nobody"}}})
          .dump());
  const std::string command = "node '" + driver.string() + "' '" + folder.path().string() + "' '" +
                              (folder.path() / "requests.json").string() + "' >'" +
                              (folder.path() / "found.json").string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const json found = json::parse(read_file(folder.path() / "found.json"));
  EXPECT_EQ(found["faults"], json::array());
  EXPECT_EQ(found["worker"], true);
  motion::LiveCore core(bundle);
  const motion::Clip clip = core.make(setting).motion.clip;
  const auto joints = motion::world_positions(clip.body, clip.poses.back());
  ASSERT_EQ(found["answers"][0]["frames"], clip.frame_count());
  for (std::size_t i = 0; i < 3 * joints.size(); ++i) {
    const double there = found["answers"][0]["joints"][i];
    EXPECT_NEAR(there, joints[i / 3][static_cast<int>(i % 3)], 1e-6);
  }
  const double d = core.distance("by-weights", setting).mean;
  EXPECT_NEAR(found["answers"][1]["D"].get<double>(), d, 1e-9);
  EXPECT_EQ(found["answers"][2]["error"], "there is no target \"nobody\"; name one of the targets");
  std::printf("milliseconds of a slider's change in Chromium: %s\n",
              found["milliseconds"].dump().c_str());
}

TEST_F(LiveModule, SaysWhyItRefuses) {
  const Manifest manifest = test::live_manifest("{method: reach}");
  Motions motions(manifest);
  const motion::LiveBundle bundle = live_bundle(manifest, motions, live_choice(manifest));
  const json requests = {
      {{"what", "example"}, {"name", "nobody"}},
      {{"what", "make"}, {"setting", request_of({InterfaceKind::weights, {"sad"}, {2.0}})}},
      {{"what", "make"}, {"setting", request_of({InterfaceKind::weights, {"sad"}, {1.0}})}}};
  ask(bundle, requests);
  EXPECT_EQ(read_file(folder.path() / "0.txt"),
            "there is no example \"nobody\"; name one of the set's examples");
  EXPECT_EQ(read_file(folder.path() / "1.txt"),
            "slider \"sad\" is not between 0 and 1; give a value from 0 to 1");
  motion::LiveCore core(bundle);
  EXPECT_LT(
      largest_difference(
          answer(2), motion::to_message(core.make({InterfaceKind::weights, {"sad"}, {1.0}})), 24),
      1e-9);
}

}  // namespace
}  // namespace mien::pipeline
