// A study on a cluster that fails in every way at once, against the same study made undisturbed.

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"
#include "end_to_end/slurm_cluster.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Thirteen clips of every kind, small enough that what is tested is the farm.
constexpr const char* study_of_thirteen = R"(mien: 1
study: thirteen
seed: 3
examples: {set: "builtin:walks-10", ratings: builtin}
output: {size: [96, 54], fps: 12, cycles: 1, quality: draft, video: [mp4]}
equalize: [size, place]
stimuli:
  - {id: normal, weights: {normal: 1}, output: {frames: png, clips: [bvh, glb]}}
  - {id: sad, weights: {sad: 1}, output: {frames: exr}}
  - {id: half, weights: {normal: 0.5, sad: 0.5}, look: {camera: follow}}
  - {id: quick, adjectives: {quickness: 0.6}, output: {clips: [bvh]}}
  - {id: large, adjectives: {largeness: 0.6}}
  - {id: slow, adjectives: {quickness: 0.45}, output: {video: [gif, mp4]}}
  - {id: side, weights: {normal: 1}, look: {camera: side}}
  - {id: dots, weights: {normal: 1}, look: {figure: point-light}}
  - {id: body, weights: {sad: 1}, look: {figure: mannequin}}
  - {id: twice, weights: {normal: 0.3, sad: 0.7}, output: {cycles: 2}}
  - {id: heavy, weights: {normal: 1}, modify: {emotion: sad, strength: 0.5}}
  - {id: calm, weights: {normal: 0.8, sad: 0.2}}
  - {id: grave, weights: {normal: 0.1, sad: 0.9}, output: {frames: png16}}
sheets:
  - compare: {target: normal, created: half, reference: sad}
)";

/// Files of a study by name, without its own bookkeeping and that of the farm.
std::map<std::string, std::string> artifacts_of(const fs::path& study) {
  std::map<std::string, std::string> bytes;
  for (const auto& entry : fs::recursive_directory_iterator(study)) {
    const std::string name = entry.path().lexically_relative(study).generic_string();
    const bool is_kept_book = name.starts_with(".mien/") || name.starts_with("farm/");
    if (entry.is_regular_file() && !is_kept_book) bytes[name] = text_of(entry.path());
  }
  return bytes;
}

class FarmThatFails : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string obstacle = SlurmCluster::obstacle(); !obstacle.empty())
      GTEST_SKIP() << "Slurm cannot run here: " << obstacle;
    try {
      cluster = std::make_unique<SlurmCluster>();
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << "Slurm cannot run here: " << error.what();
    }
  }

  Ended farm(const std::string& command, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {"farm", command, manifest.string(), "--out", out.string()};
    words.insert(words.end(), more.begin(), more.end());
    return run_mien(words);
  }

  json status() const { return json::parse(farm("status", {"--json"}).output); }

  /// Files that are finished: of which there are receipts.
  std::vector<fs::path> finished(const std::string& ending) const {
    std::vector<fs::path> files;
    std::error_code none;
    for (const auto& entry : fs::recursive_directory_iterator(study / ".mien" / "receipts", none)) {
      const std::string name =
          entry.path().lexically_relative(study / ".mien" / "receipts").generic_string();
      if (name.ends_with(ending + ".json"))
        files.push_back(study / name.substr(0, name.size() - 5));
    }
    std::ranges::sort(files);
    return files;
  }

  Scratch scratch;
  fs::path manifest = scratch.write("thirteen.yaml", study_of_thirteen);
  fs::path out = scratch.path() / "farm";
  fs::path study = out / "thirteen";
  std::unique_ptr<SlurmCluster> cluster;
};

TEST_F(FarmThatFails, LeavesTheBytesOfAnUndisturbedRun) {
  const fs::path alone = scratch.path() / "alone";
  const Ended undisturbed = run_mien({"run", manifest.string(), "--out", alone.string()});
  ASSERT_EQ(undisturbed.code, 0) << undisturbed.errors;
  const auto expected = artifacts_of(alone / "thirteen");

  ASSERT_EQ(farm("submit", {"--chunk", "5"}).code, 0);
  ASSERT_TRUE(wait_until(120.0, [&] { return finished(".mp4").size() >= 3; }))
      << farm("logs").output;
  cluster->kill_node(1);
  cluster->kill_steps();

  // Three finished files: one truncated, one of zeros, one with a bit turned over.
  const std::vector<fs::path> videos = finished(".mp4");
  fs::resize_file(videos[0], fs::file_size(videos[0]) / 2);
  std::ofstream(videos[1], std::ios::binary) << std::string(fs::file_size(videos[1]), '\0');
  std::string bytes = text_of(videos[2]);
  bytes[bytes.size() / 3] ^= 4;
  std::ofstream(videos[2], std::ios::binary) << bytes;

  ASSERT_TRUE(
      wait_until(30.0, [&] { return farm("cancel").code == 0 && cluster->wait_until_empty(5.0); }));
  cluster->restart_node(1);
  ASSERT_NE(artifacts_of(study), expected) << "nothing was left to be made again";
  const Ended resumed = farm("resume");
  ASSERT_EQ(resumed.code, 0) << resumed.errors;
  ASSERT_TRUE(cluster->wait_until_empty(240.0));
  EXPECT_TRUE(status()["complete"]) << farm("logs").output;

  const auto actual = artifacts_of(study);
  for (const auto& [name, content] : expected) {
    ASSERT_TRUE(actual.contains(name)) << name << " is missing\n" << farm("logs").output;
    EXPECT_TRUE(actual.at(name) == content) << name << " differs";
  }
  for (const auto& [name, content] : actual)
    EXPECT_TRUE(expected.contains(name)) << name << " was left behind";
  EXPECT_EQ(run_mien({"verify", study.string()}).code, 0);
}

TEST_F(FarmThatFails, TakesBackWhatWaitsOfAStudyThatWasEdited) {
  ASSERT_EQ(farm("submit", {"--chunk", "1000"}).code, 0);
  std::string edited = study_of_thirteen;
  edited.replace(edited.find("normal: 0.8, sad: 0.2"), 21, "normal: 0.7, sad: 0.3");
  std::ofstream(manifest) << edited;
  EXPECT_FALSE(status()["outdated"].empty()) << status().dump();
  const Ended resumed = farm("resume");
  ASSERT_EQ(resumed.code, 0) << resumed.errors;
  EXPECT_NE(resumed.errors.find("before it was edited, and are cancelled"), std::string::npos)
      << resumed.errors;
  ASSERT_TRUE(cluster->wait_until_empty(240.0));
  EXPECT_TRUE(status()["complete"]) << farm("logs").output;
}

}  // namespace
}  // namespace mien::test
