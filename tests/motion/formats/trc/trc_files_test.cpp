#include <string_view>

#include <gtest/gtest.h>

#include "motion/formats/trc/trc.h"

#include "real_data.h"

namespace mien::motion {
namespace {

/// What the nine real files hold, counted by a script that shares nothing with the reader.
struct RealTrc {
  const char* name;
  int points;
  int frames;
  double rate;
  const char* unit;
  int missing;       ///< positions
  const char* note;  ///< a part of the notes; empty: there are none
};

constexpr RealTrc real_files[] = {
    {"dataWithBlanksForMissingMarkers.trc", 40, 464, 250.0, "mm", 15005, ""},
    {"dataWithEformat.trc", 14, 5, 119.88012, "m", 0, ""},
    {"dataWithNaNsOfDifferentCases.trc", 14, 5, 250.0, "mm", 5, ""},
    {"exampleFormat.trc", 3, 5, 100.0, "m", 2, ""},
    {"markers_walk.trc", 41, 238, 100.0, "mm", 0, ""},
    {"subject01_walk1.trc", 41, 151, 60.0, "mm", 0, ""},
    {"walk_crlf.trc", 41, 10, 60.0, "mm", 0, ""},
    {"walk_free_01.trc", 41, 73, 60.0, "mm", 0, "says 900 frames, but the file has rows of 73"},
    {"walking5_markers.trc", 40, 111, 25.0, "mm", 2038,
     "The header says 250 Hz, but the Time column advances by 0.04 s: 25 Hz"},
};

TEST(TrcFiles, OfOpenSimAreRead) {
  const auto data = mien::test::real_data();
  if (!data) GTEST_SKIP() << "no real motion here: set MIEN_DATA to the folder that has it";
  for (const RealTrc& file : real_files) {
    SCOPED_TRACE(file.name);
    const PointRecording recording = read_trc(*data / "recordings" / "opensim" / file.name);
    EXPECT_EQ(recording.point_count(), file.points);
    EXPECT_EQ(recording.frame_count(), file.frames);
    EXPECT_EQ(recording.frames_per_second, file.rate);
    EXPECT_EQ(recording.unit, file.unit);
    ASSERT_EQ(recording.seen.size(), recording.positions.size());
    int missing = 0;
    for (const bool seen : recording.seen) missing += seen ? 0 : 1;
    EXPECT_EQ(missing, file.missing);
    std::string notes;
    for (const std::string& note : recording.notes) notes += note + "\n";
    EXPECT_NE(notes.find(file.note), std::string::npos) << notes;
    EXPECT_EQ(recording.notes.empty(), std::string_view(file.note).empty()) << notes;
  }
}

TEST(TrcFiles, OfOpenSimAreWrittenAndReadAgain) {
  const auto data = mien::test::real_data();
  if (!data) GTEST_SKIP() << "no real motion here: set MIEN_DATA to the folder that has it";
  for (const RealTrc& file : real_files) {
    const PointRecording first = read_trc(*data / "recordings" / "opensim" / file.name);
    const PointRecording again = parse_trc(to_trc(first), file.name);
    EXPECT_EQ(again.points, first.points);
    EXPECT_EQ(again.seen, first.seen);
    EXPECT_EQ(again.frames_per_second, first.frames_per_second);
    ASSERT_EQ(again.positions.size(), first.positions.size());
    for (std::size_t i = 0; i < first.positions.size(); ++i) {
      const Vec3 difference = again.positions[i] - first.positions[i];
      EXPECT_LE(difference.norm() * first.metres_per_unit, 1e-6);
    }
  }
}

}  // namespace
}  // namespace mien::motion
