#include <filesystem>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/random_recording.h"

#include "real_data.h"

namespace mien::test {

// Every motion file of the real data loads.
TEST(RealFiles, LoadWithFiniteValues) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "no real motion here: set MIEN_DATA to the folder that has it";
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(*data)) {
    if (!motion::is_found_as_motion(entry.path())) continue;
    ++files;
    const motion::Recording recording = motion::read_motion(entry.path());
    EXPECT_TRUE(is_sound(recording)) << entry.path();
    EXPECT_GE(recording.skeleton.size(), 15) << entry.path();
    EXPECT_GT(recording.frame_count(), 1) << entry.path();
  }
  EXPECT_GT(files, 0);
}

}  // namespace mien::test
