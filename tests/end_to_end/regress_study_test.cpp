#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "end_to_end/program.h"

namespace mien::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A study that lies in a folder of a git repository, and names a motion beside it.
class RegressStudy : public testing::Test {
 protected:
  void SetUp() override {
    if (run_program({"git", "--version"}).code != 0) GTEST_SKIP() << "git is not installed";
    fs::create_directories(root() / "studies");
    ASSERT_EQ(run_mien({"motion", "blend", "--examples", "builtin:walks-10", "--weights",
                        "normal=1", "--cycles", "1", "-o", (root() / "walk.bvh").string()})
                  .code,
              0);
    write_manifest(0.4);
    git({"init", "--quiet"});
    git({"config", "user.name", "A Tester"});
    git({"config", "user.email", "tester@example.org"});
  }

  fs::path root() const { return scratch_.path() / "repository"; }
  fs::path manifest() const { return root() / "studies" / "small.yaml"; }

  void write_manifest(double proud) const {
    scratch_.write("repository/studies/small.yaml",
                   "mien: 1\nstudy: small\nexamples: {set: builtin:walks-10}\n"
                   "output: {size: [96, 54], fps: 10, cycles: 1, quality: draft, frames: none,"
                   " video: [gif]}\n"
                   "stimuli:\n  - {id: blend, weights: {normal: 1, proud: " +
                       std::to_string(proud) + "}}\n  - {id: file, clip: ../walk.bvh}\n");
  }

  Ended git(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"git", "-C", root().string()});
    return run_program(arguments);
  }

  void commit() const {
    git({"add", "--all"});
    const Ended end = git({"commit", "--quiet", "-m", "approved"});
    ASSERT_EQ(end.code, 0) << end.errors;
  }

  Ended approve() const {
    return run_mien({"regress", "approve", manifest().string(), "--reason", "it is right",
                     "--without-videos", "--out", out()});
  }

  Ended regress(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"regress", manifest().string(), "--without-videos",
                                          "--out", out()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_mien(arguments);
  }

  std::string out() const { return (scratch_.path() / "out").string(); }

  Scratch scratch_;
};

TEST_F(RegressStudy, ComparesWithTheBaselineOfACommit) {
  const Ended approved = approve();
  ASSERT_EQ(approved.code, 0) << approved.errors;
  commit();
  git({"tag", "first"});
  EXPECT_EQ(regress({}).code, 0);
  EXPECT_EQ(regress({"--baseline", "first"}).code, 0);

  write_manifest(0.42);
  const Ended differs = regress({"--baseline", "first", "--json"});
  EXPECT_EQ(differs.code, 1) << differs.errors;
  const json told = json::parse(differs.output);
  EXPECT_NE(differs.output.find("weights.proud 0.4 → 0.42"), std::string::npos) << differs.output;
  EXPECT_TRUE(fs::exists(fs::path(out()) / "small-regression" / "report.html"));

  // Approved anew, and yet not as it was at the tag.
  ASSERT_EQ(approve().code, 0);
  commit();
  EXPECT_EQ(regress({"--baseline", "HEAD"}).code, 0);
  EXPECT_EQ(regress({}).code, 0);
  EXPECT_EQ(regress({"--baseline", "first"}).code, 1);
  EXPECT_EQ(git({"status", "--porcelain"}).output, "");  // nothing is left in the repository
  EXPECT_NE(text_of(root() / "studies/baselines/small/baseline.json").find("A Tester"),
            std::string::npos);
}

TEST_F(RegressStudy, ComparesSomeStimuliAndSaysThatOthersWereNot) {
  ASSERT_EQ(approve().code, 0);
  write_manifest(0.6);
  EXPECT_EQ(regress({}).code, 1);
  const Ended holds = regress({"--only", "file"});  // what differs is not asked for
  EXPECT_EQ(holds.code, 0) << holds.output << holds.errors;
  EXPECT_NE(holds.output.find("NOT COMPARED (excluded by --only): 1 of 2: blend"),
            std::string::npos)
      << holds.output;
  const fs::path report = fs::path(out()) / "small-regression";
  const json told = json::parse(text_of(report / "regression.json"));
  EXPECT_EQ(told.at("not_compared"), json({"blend"}));
  EXPECT_EQ(told.at("stimuli").size(), 1u);
  EXPECT_NE(text_of(report / "junit.xml").find("name=\"blend\"><skipped"), std::string::npos);
  for (const char* file : {"summary.md", "report.html"})
    EXPECT_NE(text_of(report / file).find("NOT COMPARED"), std::string::npos) << file;

  EXPECT_EQ(regress({"--only", "blend"}).code, 1);
  const Ended all = regress({"--only", "blend,file", "--json"});
  EXPECT_EQ(all.code, 1);
  EXPECT_EQ(json::parse(all.output).at("not_compared"), json::array());
  const Ended unknown = regress({"--only", "bland"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(unknown.errors.find("no stimulus \"bland\"; did you mean \"blend\"?"),
            std::string::npos)
      << unknown.errors;
}

TEST_F(RegressStudy, RefusesWhatHoldsNoBaseline) {
  const Ended none = regress({});
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.errors.find("regress approve"), std::string::npos) << none.errors;
  commit();
  for (const char* name : {"HEAD", "no-such-branch", "--help-me"}) {
    const Ended refused = regress({std::string("--baseline=") + name});
    EXPECT_NE(refused.code, 0) << name;
    EXPECT_NE(refused.errors, "") << name;
    EXPECT_EQ(refused.errors.find("terminate"), std::string::npos) << refused.errors;
  }
}

// Videos and all: in chunks of any number that workers make in any order, by runs that are killed
// and go on, with one thread or two.
TEST_F(RegressStudy, HoldsHoweverTheStudyIsMadeAgain) {
  const Ended approved = run_mien({"regress", "approve", manifest().string(), "--reason",
                                   "it is right", "--keep-videos", "--out", out()});
  ASSERT_EQ(approved.code, 0) << approved.errors;
  const char* asked = std::getenv("MIEN_UNCHANGED_RERUNS");
  const int reruns = asked != nullptr ? std::atoi(asked) : 3;
  for (int k = 0; k < reruns; ++k) {
    const std::string again = (scratch_.path() / "again").string();
    const std::string jobs = std::to_string(1 + k / 2 % 2);
    fs::remove_all(again);
    if (k % 3 == 1) {
      run_mien({"run", manifest().string(), "--out", again, "--jobs", jobs}, 0.05 * (k % 20),
               SIGKILL);
    } else {
      const int chunks = 1 + k % 5;
      for (int chunk = chunks; chunk > chunks / 2; --chunk) {
        const std::string piece =
            "film:blend[" + std::to_string(chunk) + "/" + std::to_string(chunks) + "]";
        const Ended end = run_mien({"farm", "worker", manifest().string(), "--out", again, "--jobs",
                                    jobs, "--tasks", piece});
        ASSERT_EQ(end.code, 0) << end.errors;
      }
    }
    const Ended end =
        run_mien({"regress", manifest().string(), "--out", again, "--jobs", jobs, "--json"});
    EXPECT_EQ(end.code, 0) << k << end.output << end.errors;
    EXPECT_NE(end.output.find("\"verdict\": \"same\""), std::string::npos) << k << end.output;
    EXPECT_EQ(end.output.find("\"verdict\": \"alike\""), std::string::npos) << k << end.output;
  }
}

// Key frames show neither what is around a film nor what is on overlays.
TEST_F(RegressStudy, SeesWhatVideosShowAroundFilmsAndOnOverlays) {
  const auto write = [&](const std::string& background, const std::string& opacity,
                         const std::string& video) {
    scratch_.write("repository/studies/small.yaml",
                   "mien: 1\nstudy: small\nexamples: {set: builtin:walks-10}\n"
                   "output: {size: [96, 54], fps: 10, cycles: 1, quality: draft, frames: none,"
                   " video: " +
                       video + ", presentation: {blank_after: 0.3, background: " + background +
                       "}}\nstimuli:\n  - {id: blend, weights: {normal: 1, proud: 0.4}}\n"
                       "  - {id: file, clip: ../walk.bvh}\n"
                       "overlays:\n  - {id: both, target: blend, created: file, opacity: " +
                       opacity + "}\n");
  };
  const auto run = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments = {"regress", manifest().string(), "--out", out()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_mien(arguments);
  };
  write("0.4", "0.6", "[gif]");
  ASSERT_EQ(run_mien({"regress", "approve", manifest().string(), "--out", out(), "--reason",
                      "it is right"})
                .code,
            0);
  EXPECT_EQ(run({}).code, 0);
  write("0.25", "0.6", "[gif]");
  const Ended presented = run({});
  EXPECT_EQ(presented.code, 1) << presented.errors;
  EXPECT_NE(presented.output.find("output.presentation.background 0.4 → 0.25 (presentation): 3 "),
            std::string::npos)
      << presented.output;
  write("0.4", "0.5", "[gif]");
  const Ended overlaid = run({});
  EXPECT_EQ(overlaid.code, 1) << overlaid.errors;
  EXPECT_NE(overlaid.output.find("opacity 0.6 → 0.5 (scene): 1 stimulus: both"), std::string::npos)
      << overlaid.output;
  EXPECT_EQ(run({"--only", "blend,file"}).code, 0);
  EXPECT_EQ(run({"--only", "both"}).code, 1);
  write("0.4", "0.6", "[]");
  const Ended none = run({});
  EXPECT_EQ(none.code, 1) << none.errors;
  EXPECT_NE(none.output.find("gif: is no longer made"), std::string::npos) << none.output;
}

// A report that is put into a study's folder by mistake would replace its frames, videos and
// report.
TEST_F(RegressStudy, WritesOverNothingThatIsNotItsOwn) {
  ASSERT_EQ(approve().code, 0);
  const fs::path precious = scratch_.path() / "precious";
  for (const char* file : {"frames/a.png", "videos/a.mp4", "report.html"})
    scratch_.write(std::string("precious/") + file, "kept");
  const Ended report = regress({"--report", precious.string()});
  EXPECT_EQ(report.code, 2);
  EXPECT_NE(report.errors.find("--report"), std::string::npos) << report.errors;
  const Ended baseline = run_mien({"regress", "approve", manifest().string(), "--reason", "w",
                                   "--without-videos", "--baseline", precious.string()});
  EXPECT_EQ(baseline.code, 2);
  EXPECT_NE(baseline.errors.find("--baseline"), std::string::npos) << baseline.errors;
  for (const char* file : {"frames/a.png", "videos/a.mp4", "report.html"})
    EXPECT_EQ(text_of(precious / file), "kept") << file;
  EXPECT_FALSE(fs::exists(precious / "stimuli"));
}

TEST_F(RegressStudy, ReplacesItsOwnReport) {
  ASSERT_EQ(approve().code, 0);
  const std::string report = (scratch_.path() / "report").string();
  write_manifest(0.5);
  EXPECT_EQ(regress({"--report", report}).code, 1);
  EXPECT_FALSE(fs::is_empty(fs::path(report) / "frames"));
  write_manifest(0.4);
  EXPECT_EQ(regress({"--report", report}).code, 0);
  EXPECT_FALSE(fs::exists(fs::path(report) / "frames"));
}

// Making a study may take hours.
TEST_F(RegressStudy, MakesNothingBeforeItKnowsWhatToCompareWith) {
  const Ended none = run_mien({"regress", manifest().string(), "--out", out()});
  EXPECT_EQ(none.code, 2);
  const Ended unknown = run_mien({"regress", "approve", manifest().string(), "--reason", "w",
                                  "--only", "blent", "--out", out()});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_FALSE(fs::exists(fs::path(out()) / "small"));
}

// A file of the baseline that nobody looks at until something has changed would be missed then.
TEST_F(RegressStudy, SeesADamagedBaselineBeforeItMakesAnything) {
  ASSERT_EQ(approve().code, 0);
  const fs::path kept = root() / "studies" / "baselines" / "small" / "stimuli";
  fs::copy_file(kept / "file" / "motion.bvh", kept / "blend" / "motion.bvh",
                fs::copy_options::overwrite_existing);
  fs::remove_all(out());
  const Ended end = run_mien({"regress", manifest().string(), "--out", out()});
  EXPECT_EQ(end.code, 2);
  EXPECT_NE(end.errors.find("blend/motion.bvh: differs from what was approved"), std::string::npos)
      << end.errors;
  EXPECT_FALSE(fs::exists(fs::path(out()) / "small"));
}

TEST_F(RegressStudy, RefusesTheBaselineOfAnotherStudy) {
  ASSERT_EQ(approve().code, 0);
  const fs::path document = root() / "studies" / "baselines" / "small" / "baseline.json";
  json other = json::parse(text_of(document));
  other["study"] = "other";
  // A baseline of 0.2, which no checksum holds.
  other.erase("checksum");
  other.erase("sums");
  scratch_.write("repository/studies/baselines/small/baseline.json", other.dump());
  const Ended end = regress({});
  EXPECT_EQ(end.code, 2);
  EXPECT_NE(end.errors.find("the study \"other\""), std::string::npos) << end.errors;
}

TEST_F(RegressStudy, LeavesNoGreenReportBehindWhenItFails) {
  ASSERT_EQ(approve().code, 0);
  ASSERT_EQ(regress({}).code, 0);
  const fs::path report = fs::path(out()) / "small-regression";
  ASSERT_NE(text_of(report / "summary.md").find("✅"), std::string::npos);
  fs::remove(root() / "studies" / "baselines" / "small" / "stimuli" / "file" / "motion.bvh");
  EXPECT_EQ(regress({}).code, 2);
  EXPECT_NE(text_of(report / "summary.md").find("❌"), std::string::npos);
  EXPECT_FALSE(fs::exists(report / "report.html"));
  EXPECT_FALSE(fs::exists(report / "junit.xml"));
}

TEST_F(RegressStudy, ApprovesThatAStimulusIsGone) {
  ASSERT_EQ(approve().code, 0);
  scratch_.write("repository/studies/small.yaml",
                 "mien: 1\nstudy: small\nexamples: {set: builtin:walks-10}\n"
                 "output: {size: [96, 54], fps: 10, cycles: 1, quality: draft, frames: none,"
                 " video: [gif]}\nstimuli:\n  - {id: file, clip: ../walk.bvh}\n");
  EXPECT_EQ(regress({}).code, 1);
  const Ended end = run_mien({"regress", "approve", manifest().string(), "--reason", "not needed",
                              "--only", "blend", "--without-videos", "--out", out()});
  EXPECT_EQ(end.code, 0) << end.errors;
  EXPECT_NE(end.output.find("blend was removed from the baseline"), std::string::npos);
  EXPECT_EQ(regress({}).code, 0);
}

TEST_F(RegressStudy, TellsThatALimitIsWiderThanApproved) {
  ASSERT_EQ(approve().code, 0);
  scratch_.write("repository/studies/small.yaml",
                 text_of(manifest()) + "regression: {position_mm: 50}\n");
  const Ended end = regress({});
  EXPECT_EQ(end.code, 0);
  EXPECT_NE(end.output.find("limit wider than approved: position_mm 1 → 50"), std::string::npos)
      << end.output;
}

TEST_F(RegressStudy, RefusesOptionsThatWouldDoNothing) {
  ASSERT_EQ(approve().code, 0);
  const Ended study = regress({"--position", "0.02"});
  EXPECT_EQ(study.code, 2);
  EXPECT_NE(study.errors.find("--position: applies to two files"), std::string::npos)
      << study.errors;
  const std::string walk = (root() / "walk.bvh").string();
  const Ended files = run_mien({"regress", walk, walk, "--repeat", "2"});
  EXPECT_EQ(files.code, 2);
  EXPECT_NE(files.errors.find("--repeat: applies to studies"), std::string::npos) << files.errors;
}

// With large files in git LFS, a commit has no more than pointers to them.
TEST_F(RegressStudy, ComparesWithTheBaselineOfACommitThatKeepsFilesInLfs) {
  if (run_program({"git", "lfs", "version"}).code != 0) GTEST_SKIP() << "git LFS is not installed";
  ASSERT_EQ(git({"lfs", "install", "--local"}).code, 0);
  scratch_.write("repository/.gitattributes",
                 "*.exr filter=lfs diff=lfs merge=lfs -text\n"
                 "*.png filter=lfs diff=lfs merge=lfs -text\n"
                 "motion.bvh filter=lfs diff=lfs merge=lfs -text\n");
  ASSERT_EQ(approve().code, 0);
  commit();
  const Ended kept = git({"lfs", "ls-files"});
  ASSERT_NE(kept.output.find("motion.bvh"), std::string::npos) << kept.output << kept.errors;
  const Ended end = regress({"--baseline", "HEAD"});
  EXPECT_EQ(end.code, 0) << end.output << end.errors;
  // And where nobody fetched them, that is what is said.
  const fs::path motion =
      root() / "studies" / "baselines" / "small" / "stimuli" / "file" / "motion.bvh";
  fs::remove(motion);
  ASSERT_EQ(git({"-c", "filter.lfs.smudge=cat", "-c", "filter.lfs.process=", "-c",
                 "filter.lfs.required=false", "checkout", "--", motion.string()})
                .code,
            0);
  const Ended pointer = regress({});
  EXPECT_EQ(pointer.code, 2);
  EXPECT_NE(pointer.errors.find("was not fetched by git LFS"), std::string::npos) << pointer.errors;
}

/// As a runner of a CI does: another folder, and nothing but what is committed.
TEST_F(RegressStudy, HoldsInAnotherCheckout) {
  ASSERT_EQ(approve().code, 0);
  commit();
  const fs::path clone = scratch_.path() / "elsewhere" / "clone";
  ASSERT_EQ(run_program({"git", "clone", "--quiet", root().string(), clone.string()}).code, 0);
  fs::remove_all(root());
  const Ended same = run_mien({"regress", (clone / "studies/small.yaml").string(),
                               "--without-videos", "--audits", "1", "--out", out()});
  EXPECT_EQ(same.code, 0) << same.output << same.errors;
}

TEST_F(RegressStudy, SaysWhatGitKnowsOfANameThatIsNone) {
  ASSERT_EQ(approve().code, 0);
  const Ended outside = regress({"--baseline", "nosuch"});
  EXPECT_EQ(outside.code, 2);
  EXPECT_NE(outside.errors.find("git says: fatal: "), std::string::npos) << outside.errors;
  EXPECT_EQ(outside.errors.find("regress approve"), std::string::npos) << outside.errors;
}

TEST_F(RegressStudy, KeepsNoBaselineInAFolderCalledLikeACommit) {
  commit();
  git({"tag", "v1"});
  const Ended refused = run_mien({"regress", "approve", manifest().string(), "--reason", "w",
                                  "--without-videos", "--baseline", "v1", "--out", out()});
  EXPECT_EQ(refused.code, 2) << refused.output;
  EXPECT_NE(refused.errors.find("v1: is a commit"), std::string::npos) << refused.errors;
  EXPECT_FALSE(fs::exists("v1"));
}

TEST_F(RegressStudy, WantsAReason) {
  for (const char* why : {"", "  "}) {
    const Ended refused =
        run_mien({"regress", "approve", manifest().string(), "--reason", why, "--out", out()});
    EXPECT_EQ(refused.code, 2) << "'" << why << "'";
  }
}

}  // namespace
}  // namespace mien::test
