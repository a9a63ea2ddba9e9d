#include "pipeline/manifest/example_files.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/base/documents/files.h"
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

}  // namespace
}  // namespace mien::pipeline
