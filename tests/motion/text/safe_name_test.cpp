#include "motion/text/safe_name.h"

#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

namespace fs = std::filesystem;

/// A folder "home" with something beside it.
class SafeNameFolder : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::temp_directory_path() / (std::string("mien-safe-name-") + test->name());
    fs::remove_all(root_);
    fs::create_directories(home() / "stimuli");
    fs::create_directories(root_ / "beside");
    std::ofstream(root_ / "beside" / "secret") << "secret";
  }
  void TearDown() override { fs::remove_all(root_); }

  fs::path home() const { return root_ / "home"; }
  fs::path root_;
};

const std::vector<std::string> led_astray = {
    "",
    ".",
    "..",
    "../planted",
    "../../../planted",
    "/planted",
    "a/../../b",
    "a/b",
    "a\\b",
    "..\\b",
    "\\\\host\\share",
    "c:",
    "C:\\b",
    std::string("a\0b", 3),
    "a\nb",
    "\x1b[2J",
    "\x7f",
    "NUL",
    "con.txt",
    "aux ",
    "Com1.tar.gz",
    "lpt9",
    "a.",
    "a ",
    std::string(256, 'a'),
};

TEST(SafeName, TakesPlainNamesOfAnyLanguage) {
  for (const char* name : {"walk", "walk-2.mp4", ".hidden", "..walk", "a..b", "歩く", "étude 2",
                           "common", "com10", "console.txt", "nullable"})
    EXPECT_EQ(safe_component(name, {}), name) << fault_of_name(name);
  EXPECT_EQ(safe_component(std::string(255, 'a'), {}).size(), 255U);
}

TEST(SafeName, RefusesWhatIsNoNameOnAnySystem) {
  for (const std::string& name : led_astray) {
    EXPECT_NE(fault_of_name(name), "") << name;
    EXPECT_THROW(safe_component(name, {}), Error) << name;
  }
}

TEST(SafeName, TellsThePlaceWhatIsWrongAndHowToMendIt) {
  try {
    safe_component(std::string(1000, 'x') + "\x1b[2J", {"baseline.json", 3, 7});
    FAIL();
  } catch (const Error& error) {
    const std::string text = error.what();
    EXPECT_TRUE(text.starts_with("baseline.json:3:7: the name \"xxx")) << text;
    EXPECT_NE(text.find("; write a plain name"), std::string::npos) << text;
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_LT(text.size(), 300U);
  }
}

TEST(SafeName, PathsAreNamesWithSlashesBetween) {
  for (const char* path : {"walk", "frames/walk/00012.png", "a/b/c/d"})
    EXPECT_EQ(safe_names(path, {}), path) << fault_of_names(path);
  for (const char* path : {"", "/a", "a/", "a//b", "a/../b", "./a", "a/.", "a/nul/b", "a/c:/b"})
    EXPECT_THROW(safe_names(path, {}), Error) << path;
}

/// Whatever is accepted lies directly in the folder, however it was made.
TEST(SafeName, NoAcceptedNameLeadsAnywhereElse) {
  std::mt19937 random(7);
  const std::string letters("./\\:ab C\0\n~$", 12);
  int accepted = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    std::string name;
    for (std::size_t length = random() % 6; name.size() < length;)
      name += letters[random() % letters.size()];
    const fs::path folder("/some/folder");
    const fs::path meant = (folder / name).lexically_normal();
    if (fault_of_name(name).empty()) {
      ++accepted;
      EXPECT_EQ(meant.parent_path(), folder) << name;
    }
    if (fault_of_names(name).empty()) {
      EXPECT_TRUE(meant.string().starts_with("/some/folder/")) << name;
    }
  }
  EXPECT_GT(accepted, 100);
}

TEST_F(SafeNameFolder, PathsStayInsideAsTheyAreWritten) {
  EXPECT_EQ(inside(home(), "stimuli/walk", {}), home() / "stimuli/walk");
  EXPECT_EQ(inside(home(), "not/there/yet", {}), home() / "not/there/yet");
  for (const std::string& path :
       {std::string("../beside"), std::string("a/../../beside"), std::string("stimuli/.."),
        (root_ / "beside").string(), (home() / "stimuli").string(), std::string("."), std::string(),
        std::string("a\0b", 3)}) {
    EXPECT_FALSE(is_inside(home(), path)) << path;
    EXPECT_THROW(inside(home(), path, {}), Error) << path;
  }
}

TEST_F(SafeNameFolder, LinksMayLeadWithinTheFolderAndNowhereElse) {
  fs::create_directory_symlink("stimuli", home() / "within");
  fs::create_directory_symlink("../beside", home() / "out");
  fs::create_directory_symlink(root_ / "beside", home() / "stimuli" / "out");
  fs::create_symlink("/not/there", home() / "dangling");
  fs::create_symlink("round", home() / "round");
  fs::create_directory_symlink("out", home() / "twice");
  EXPECT_TRUE(is_inside(home(), "within/walk"));
  for (const char* path : {"out", "out/secret", "out/new", "stimuli/out/secret", "dangling",
                           "dangling/new", "round", "twice/secret", "within/out/new"})
    EXPECT_FALSE(is_inside(home(), path)) << path;
}

TEST_F(SafeNameFolder, TheFolderItselfMayBeALink) {
  fs::create_directory_symlink("home", root_ / "link");
  EXPECT_TRUE(is_inside(root_ / "link", "stimuli/walk"));
  EXPECT_TRUE(is_inside(root_ / "link/", "stimuli"));
  fs::create_directory_symlink("../beside", home() / "out");
  EXPECT_FALSE(is_inside(root_ / "link", "out/secret"));
}

}  // namespace
}  // namespace mien::motion
