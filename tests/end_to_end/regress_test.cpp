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

/// A walk as a file, and what became of it.
class Regress : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(run_mien({"motion", "blend", "--examples", "builtin:walks-10", "--weights",
                        "normal=1", "--cycles", "2", "-o", walk().string()})
                  .code,
              0);
  }

  fs::path walk() const { return scratch_.path() / "walk.bvh"; }

  /// The file with another text in place of one that it holds.
  fs::path changed(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = text_of(walk());
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    return scratch_.write(name, text);
  }

  Ended regress(const fs::path& now, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"regress", walk().string(), now.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_mien(arguments);
  }

  fs::path modified() const {
    const fs::path file = scratch_.path() / "modified.bvh";
    EXPECT_EQ(
        run_mien({"motion", "modify", walk().string(), "posture: {head-flexion: 2}", file.string()})
            .code,
        0);
    return file;
  }

  Scratch scratch_;
};

TEST_F(Regress, EndsWithZeroForTheSameMotion) {
  const Ended same = regress(walk());
  EXPECT_EQ(same.code, 0) << same.errors;
  EXPECT_EQ(same.output, walk().string() + ": identical (no difference)\n");
  const Ended strict = regress(walk(), {"--position", "0", "--rotation", "0", "--velocity", "0"});
  EXPECT_EQ(strict.code, 0);
}

TEST_F(Regress, EndsWithOneAndNamesWhatChanged) {
  const Ended differs = regress(modified());
  EXPECT_EQ(differs.code, 1) << differs.errors;
  EXPECT_EQ(differs.errors, "");
  EXPECT_NE(differs.output.find(": differs ("), std::string::npos) << differs.output;
  EXPECT_NE(differs.output.find("✗ rotation"), std::string::npos) << differs.output;
  EXPECT_NE(differs.output.find(" cm"), std::string::npos);
  EXPECT_NE(differs.output.find("°"), std::string::npos);
}

TEST_F(Regress, LetsPassWhatItsTolerancesAllow) {
  const Ended allowed =
      regress(modified(), {"--position", "1", "--rotation", "180", "--velocity", "100", "--slide",
                           "1", "--contacts", "10", "--any-lint"});
  EXPECT_EQ(allowed.code, 0) << allowed.output;
  EXPECT_NE(allowed.output.find(": alike ("), std::string::npos) << allowed.output;
}

TEST_F(Regress, IsAlikeForTheSameMotionInAnotherFormat) {
  const fs::path glb = scratch_.path() / "walk.glb";
  ASSERT_EQ(run_mien({"motion", "convert", walk().string(), glb.string()}).code, 0);
  const Ended alike = regress(glb);
  EXPECT_EQ(alike.code, 0) << alike.output << alike.errors;
}

TEST_F(Regress, TellsAnotherFrameRate) {
  const fs::path slow = changed("slow.bvh", "Frame Time: 0.03333", "Frame Time: 0.04");
  const Ended differs = regress(slow, {"--json"});
  EXPECT_EQ(differs.code, 1);
  const json told = json::parse(differs.output);
  EXPECT_TRUE(told["timing"]["other_pace"].get<bool>());
}

TEST_F(Regress, SaysAllOfItInJson) {
  const Ended differs = regress(modified(), {"--json"});
  EXPECT_EQ(differs.code, 1);
  const json told = json::parse(differs.output);
  EXPECT_FALSE(told["alike"].get<bool>());
  EXPECT_FALSE(told["excesses"].empty());
  EXPECT_FALSE(told["causes"].empty());
  const std::size_t frames = told["timing"]["before"]["frames"];
  EXPECT_EQ(told["joints"][0]["point_m"].size(), frames);
  const json same = json::parse(regress(walk(), {"--json"}).output);
  EXPECT_TRUE(same["identical"].get<bool>());
  EXPECT_EQ(same["position"]["worst"], 0.0);
}

TEST_F(Regress, RefusesWhatItCannotCompare) {
  const fs::path text = scratch_.write("notes.txt", "not a motion");
  const fs::path broken = scratch_.write("broken.bvh", "HIERARCHY\nROOT Hips\n{");
  for (const fs::path& now : {text, broken, scratch_.path() / "none.bvh"}) {
    const Ended refused = regress(now);
    EXPECT_EQ(refused.code, 2) << now;
    EXPECT_EQ(refused.output, "");
    EXPECT_NE(refused.errors.find(now.filename().string()), std::string::npos) << refused.errors;
  }
  for (const std::string rotation : {"-1", "181", "nan", "inf", "far"}) {
    const Ended refused = regress(walk(), {"--rotation", rotation});
    EXPECT_EQ(refused.code, 2) << rotation;
    EXPECT_NE(refused.errors.find(rotation + " is not a number from 0 to 180"), std::string::npos)
        << refused.errors;
  }
  EXPECT_EQ(regress(walk(), {"--position", "-1"}).code, 2);
  EXPECT_EQ(run_mien({"regress", walk().string()}).code, 2);
}

TEST_F(Regress, TellsWhatIsMissingOfALoneFile) {
  const Ended refused = run_mien({"regress", walk().string()});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.errors.find("a second file to compare with is missing"), std::string::npos)
      << refused.errors;
}

TEST_F(Regress, KnowsAFileThatGitHasNotFetched) {
  const fs::path pointer = scratch_.write(
      "large.bvh", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n");
  const Ended refused = regress(pointer);
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.errors.find("git lfs pull"), std::string::npos) << refused.errors;
}

TEST_F(Regress, RefusesFoldersWithoutPictures) {
  const fs::path empty = scratch_.path() / "empty";
  fs::create_directory(empty);
  const Ended refused = run_mien({"regress", empty.string(), empty.string()});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.errors.find("is a folder without images"), std::string::npos) << refused.errors;
}

}  // namespace
}  // namespace mien::test
