#include <cmath>

#include <gtest/gtest.h>

#include "motion/formats/c3d/c3d.h"
#include "motion/formats/trc/trc.h"

#include "real_data.h"

namespace mien::motion {
namespace {

double share_missing(const PointRecording& recording) {
  std::size_t missing = 0;
  for (const bool seen : recording.seen) missing += seen ? 0 : 1;
  return static_cast<double>(missing) / static_cast<double>(recording.seen.size());
}

// OpenSim's own reading of the file, at every tenth frame and to five significant digits.
TEST(C3dFiles, OfViconAgreesWithAnotherReader) {
  const auto data = mien::test::real_data();
  if (!data) GTEST_SKIP() << "no real motion here: set MIEN_DATA to the folder that has it";
  const auto folder = *data / "recordings" / "opensim";
  const PointRecording c3d = read_c3d(folder / "walking5.c3d");
  const PointRecording trc = read_trc(folder / "walking5_markers.trc");
  EXPECT_EQ(c3d.name, "walking5");
  EXPECT_EQ(c3d.frames_per_second, 250.0);
  EXPECT_EQ(c3d.frame_count(), 1103);
  EXPECT_EQ(c3d.unit, "mm");
  EXPECT_EQ(c3d.subjects, std::vector<std::string>{"Treadmill"});
  EXPECT_TRUE(c3d.notes.empty());
  EXPECT_NEAR(share_missing(c3d), 0.45, 0.01);
  ASSERT_EQ(c3d.points, trc.points);
  ASSERT_EQ(trc.frame_count(), 111);
  std::size_t compared = 0;
  double largest = 0.0;
  for (int frame = 0; frame < trc.frame_count(); ++frame) {
    const double seconds = frame / trc.frames_per_second;
    const int same_time = static_cast<int>(std::lround(seconds * c3d.frames_per_second));
    for (int point = 0; point < trc.point_count(); ++point) {
      const std::size_t in_trc = trc.at(frame, point);
      const std::size_t in_c3d = c3d.at(same_time, point);
      ASSERT_EQ(trc.seen[in_trc], c3d.seen[in_c3d]) << trc.points[point] << " at " << seconds;
      if (!trc.seen[in_trc]) continue;
      ++compared;
      const Vec3 difference = trc.positions[in_trc] - c3d.positions[in_c3d];
      largest = std::max(largest, difference.cwiseAbs().maxCoeff());
    }
  }
  EXPECT_GT(compared, 2000u);
  EXPECT_LE(largest, 0.051);  // mm
}

TEST(C3dFiles, OfOptotrakIsReadAsFarAsItGoes) {
  const auto data = mien::test::real_data();
  if (!data) GTEST_SKIP() << "no real motion here: set MIEN_DATA to the folder that has it";
  const PointRecording recording = read_c3d(*data / "recordings" / "optotrak.c3d");
  EXPECT_EQ(recording.point_count(), 54);
  EXPECT_EQ(recording.points[53], "Marker_54");
  EXPECT_EQ(recording.frame_count(), 29);
  EXPECT_EQ(recording.frames_per_second, 30.0);
  EXPECT_NEAR(share_missing(recording), 0.038, 0.0005);
  ASSERT_EQ(recording.notes.size(), 1u);
  EXPECT_EQ(recording.notes[0],
            "The header says 1149 frames, but the file ends after 29: these are read.");
}

}  // namespace
}  // namespace mien::motion
