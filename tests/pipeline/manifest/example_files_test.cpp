#include "pipeline/manifest/example_files.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/file_keys.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

TEST(MotionParts, AreFoundInUpperAndLowerCase) {
  const test::TemporaryFolder folder;
  for (const char* name : {"any.ASF", "other.asf", "walk.AMC", "walk.bin", "walk.bvh"})
    write_file(folder.path() / name, "");
  const auto names_of_parts = [&](const char* motion) {
    std::vector<std::string> names;
    for (const std::filesystem::path& part : motion_parts(folder.path() / motion))
      names.push_back(part.filename().string());
    return names;
  };
  EXPECT_EQ(names_of_parts("walk.AMC"), (std::vector<std::string>{"any.ASF", "other.asf"}));
  EXPECT_EQ(names_of_parts("walk.gltf"), std::vector<std::string>{"walk.bin"});
  EXPECT_EQ(names_of_parts("walk.bvh"), std::vector<std::string>{});
}

TEST(MotionParts, AreTheOtherFramesOfARecordingAndTheChannelsOfBids) {
  const test::TemporaryFolder folder;
  const std::string ending = "_keypoints.json";
  for (const char* name :
       {"walk_000000000000", "walk_000000000001", "walk_000000000003", "run_000000000001"})
    write_file(folder.path() / (name + ending), "{}");
  for (const char* name : {"a_motion.tsv", "a_channels.tsv", "b_channels.tsv.gz", "other.tsv"})
    write_file(folder.path() / name, "");
  const auto names_of_parts = [&](const std::string& motion) {
    std::vector<std::string> names;
    for (const std::filesystem::path& part : motion_parts(folder.path() / motion))
      if (!part.string().ends_with(ending) || motion.ends_with(ending))
        names.push_back(part.filename().string());
    return names;
  };
  EXPECT_EQ(names_of_parts("walk_000000000001" + ending),
            (std::vector<std::string>{"walk_000000000000" + ending, "walk_000000000003" + ending}));
  EXPECT_EQ(names_of_parts("a_motion.tsv"),
            (std::vector<std::string>{"a_channels.tsv", "b_channels.tsv.gz"}));
  EXPECT_EQ(names_of_parts("other.tsv"), std::vector<std::string>{});
}

TEST(MotionParts, DetermineTheKeyOfTheirRecording) {
  const test::TemporaryFolder folder;
  const auto frame = [&](int number) {
    return folder.path() / ("walk_00000000000" + std::to_string(number) + "_keypoints.json");
  };
  for (const int number : {0, 1}) write_file(frame(number), "{}");
  const Hash before = FileKeys().of(frame(0));
  write_file(frame(2), "{}");
  EXPECT_NE(FileKeys().of(frame(0)), before);
}

}  // namespace
}  // namespace mien::pipeline
