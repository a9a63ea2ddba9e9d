#include "pipeline/study/studio/studio_places.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// A study's folder with captures in it and beside it.
class Places : public testing::Test {
 protected:
  Places() {
    put("study/my.yaml");
    put("study/captures/walk.bvh");
    put("study/captures/run.bvh");
    put("study/captures/notes.txt");
    put("study/captures/old/jump.amc");
    put("study/figures/robot.vrm");
    put("study/.hidden/secret.bvh");
    put("study/out/made/.mien/plan");
    put("study/out/made/clips/made.bvh");
    put("beside/wave.bvh");
    put("beside/more/nod.bvh");
    fs::create_directory_symlink(folder_.path() / "beside", folder_.path() / "study/way-out");
    fs::create_symlink(folder_.path() / "beside/wave.bvh",
                       folder_.path() / "study/figures/out.bvh");
  }

  void put(const std::string& name) const {
    fs::create_directories((folder_.path() / name).parent_path());
    write_file(folder_.path() / name, "x");
  }

  StudioPlaces places(const ordered_json& known = ordered_json::object()) const {
    return StudioPlaces(folder_.path() / "study/my.yaml", known);
  }

  test::TemporaryFolder folder_;
};

const ordered_json names_beside = {{"examples", {{"set", {{"folder", "../beside"}}}}}};

TEST_F(Places, AreTheFoldersOfCapturesBelowTheManifest) {
  const ordered_json listing = places().listing();
  std::vector<std::string> folders;
  for (const ordered_json& one : listing["folders"]) folders.push_back(one["folder"]);
  EXPECT_EQ(folders, (std::vector<std::string>{"captures", "captures/old", "figures"}));
  EXPECT_EQ(listing["folders"][0]["motions"], ordered_json({"run.bvh", "walk.bvh"}));
  EXPECT_EQ(listing["characters"], ordered_json({"figures/robot.vrm"}));
  EXPECT_EQ(listing["all"], true);
}

TEST_F(Places, AreAlsoBelowTheFolderThatTheManifestNames) {
  const ordered_json listing = places(names_beside).listing();
  std::vector<std::string> folders;
  for (const ordered_json& one : listing["folders"]) folders.push_back(one["folder"]);
  EXPECT_EQ(folders, (std::vector<std::string>{"../beside", "../beside/more", "captures",
                                               "captures/old", "figures"}));
  EXPECT_TRUE(places(names_beside).contains("../beside/more"));
  EXPECT_FALSE(places().contains("../beside/more"));
}

TEST_F(Places, HoldWhatIsThereAndNothingElse) {
  const StudioPlaces here = places();
  for (const char* name : {"captures", "captures/", "./captures/old", ".", "captures/walk.bvh",
                           "figures/robot.vrm", "captures/../captures"})
    EXPECT_TRUE(here.contains(name)) << name;
  for (const char* name :
       {"..", "../beside", "/etc", "/etc/passwd", "captures/notes.txt", "my.yaml", "captures/none",
        "way-out", "way-out/more", "figures/out.bvh", "captures/../../beside"})
    EXPECT_FALSE(here.contains(name)) << name;
}

TEST_F(Places, EndSomewhere) {
  std::string deep = "study";
  for (int depth = 0; depth < 9; ++depth) deep += "/d";
  put(deep + "/far.bvh");
  const ordered_json listing = places().listing();
  EXPECT_EQ(listing["all"], false);
  EXPECT_EQ(listing["folders"].size(), 3u);
}

}  // namespace
}  // namespace mien::pipeline
