#include <filesystem>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/random_recording.h"

#include "real_data.h"

namespace mien::test {

int count_sound_files(const std::filesystem::path& folder, int least_joints) {
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    // The cases of rotation orders are meshes alone.
    const bool is_case = entry.path().filename().string().starts_with("casegen_");
    if (is_case || !motion::is_found_as_motion(entry.path())) continue;
    ++files;
    const motion::Recording recording = motion::read_motion(entry.path());
    EXPECT_TRUE(is_sound(recording)) << entry.path();
    EXPECT_GE(recording.skeleton.size(), least_joints) << entry.path();
    if (recording.markers) {
      EXPECT_EQ(recording.markers->frame_count(), recording.frame_count()) << entry.path();
    }
  }
  return files;
}

TEST(RealFiles, LoadWithFiniteValues) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "no real motion here: set MIEN_DATA to the folder that has it";
  EXPECT_GT(count_sound_files(*data / "mocap", 15), 0);
  if (std::filesystem::is_directory(*data / "recordings")) {
    EXPECT_GT(count_sound_files(*data / "recordings", 1), 0);
  }
}

}  // namespace mien::test
