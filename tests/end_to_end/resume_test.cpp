#include <fstream>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

// Small pictures and few samples: what counts is that every kind of artifact is made.
constexpr const char* manifest_text = R"(mien: 1
study: resume
seed: 3
examples: {set: "builtin:walks-10", ratings: builtin}
output: {size: [160, 90], fps: 15, cycles: 1, quality: draft, frames: png, video: [mp4], clips: [bvh, glb]}
stimuli:
  - {id: one, role: target, adjectives: {quickness: 0.7, largeness: 0.6}}
  - {id: two, weights: {normal: 0.5, sad: 0.5}, look: {camera: follow}}
sheets:
  - compare: {target: one, created: two, reference: normal}
)";

/// Every file that a run leaves, but for its own bookkeeping.
std::map<std::string, std::string> contents_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string name = std::filesystem::relative(entry.path(), folder).string();
    if (!entry.is_regular_file() || name.find("/.mien/") != std::string::npos) continue;
    contents[name] = text_of(entry.path());
  }
  return contents;
}

void expect_same(const std::map<std::string, std::string>& expected,
                 const std::map<std::string, std::string>& actual) {
  for (const auto& [name, bytes] : expected) {
    ASSERT_TRUE(actual.contains(name)) << name << " is missing";
    EXPECT_TRUE(actual.at(name) == bytes) << name << " differs";
  }
  for (const auto& [name, bytes] : actual) {
    EXPECT_TRUE(expected.contains(name)) << name << " was left behind";
  }
}

class Resume : public testing::Test {
 protected:
  Scratch scratch;
  std::filesystem::path manifest = scratch.write("study.yaml", manifest_text);

  Ended run(const std::string& out, const std::string& jobs, double kill_after = -1.0,
            int signal = 9) {
    return run_mien(
        {"run", manifest.string(), "--out", (scratch.path() / out).string(), "--jobs", jobs},
        kill_after, signal);
  }
};

TEST_F(Resume, OneAndTwoJobsAndFiveKilledRunsLeaveTheSameBytes) {
  const Ended one = run("one", "1");
  ASSERT_EQ(one.code, 0) << one.errors;
  const auto expected = contents_of(scratch.path() / "one");
  EXPECT_GE(expected.size(), 30u);

  const Ended two = run("two", "2");
  ASSERT_EQ(two.code, 0) << two.errors;
  expect_same(expected, contents_of(scratch.path() / "two"));

  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> moment(0.05, 1.5);
  for (int attempt = 0; attempt < 5; ++attempt) run("killed", "2", moment(random));
  const Ended last = run("killed", "2");
  ASSERT_EQ(last.code, 0) << last.errors;
  expect_same(expected, contents_of(scratch.path() / "killed"));
}

TEST_F(Resume, ASecondRunDoesNothingAndSaysSo) {
  ASSERT_EQ(run("out", "2").code, 0);
  std::map<std::string, std::filesystem::file_time_type> before;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch.path() / "out")) {
    if (entry.is_regular_file()) before[entry.path()] = entry.last_write_time();
  }
  const Ended again = run("out", "2");
  EXPECT_EQ(again.code, 0);
  EXPECT_NE((again.output + again.errors).find("nothing to do"), std::string::npos)
      << again.output << again.errors;
  for (const auto& [path, time] : before) {
    if (path.find("/frames/") == std::string::npos && path.find("/videos/") == std::string::npos) {
      continue;
    }
    EXPECT_EQ(std::filesystem::last_write_time(path), time) << path;
  }
}

TEST_F(Resume, ADamagedArtifactIsMadeAgain) {
  ASSERT_EQ(run("out", "2").code, 0);
  const auto expected = contents_of(scratch.path() / "out");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch.path() / "out")) {
    const std::string name = entry.path().filename().string();
    if (name == "one.mp4" || name == "two.bvh") {
      std::string bytes = text_of(entry.path());
      bytes[bytes.size() / 2] ^= 1;
      std::ofstream(entry.path(), std::ios::binary) << bytes;
    }
  }
  ASSERT_EQ(run("out", "2").code, 0);
  expect_same(expected, contents_of(scratch.path() / "out"));
}

TEST_F(Resume, AnInterruptedRunSaysSoAndGoesOn) {
  const Ended interrupted = run("out", "1", 0.4, 2);
  if (interrupted.code == 0) GTEST_SKIP() << "the run was over before it could be interrupted";
  EXPECT_EQ(interrupted.code, 130) << interrupted.errors;
  const Ended resumed = run("out", "1");
  EXPECT_EQ(resumed.code, 0) << resumed.errors;
}

TEST(RunFaults, AreLocatedInTheManifest) {
  const Scratch scratch;
  const std::string manifest =
      scratch.write("held.yaml",
                    "mien: 1\nstudy: held\nexamples: {set: builtin:walks-10}\n"
                    "output: {size: [64, 36], quality: draft}\nstimuli:\n"
                    "  - {id: walk, weights: {sad: 1}, modify: {ends: {before: 0.5}}}\n");
  const Ended run = run_mien({"run", manifest, "-o", (scratch.path() / "out").string()});
  EXPECT_NE(run.code, 0);
  EXPECT_NE(run.errors.find("held.yaml:6:5: stimuli[0]: the first and last pose of a motion that "
                            "loops cannot be held; omit ends"),
            std::string::npos)
      << run.errors;
}

}  // namespace
}  // namespace mien::test
