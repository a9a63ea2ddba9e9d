#include <random>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/formats/trc/trc.h"
#include "motion/text/excerpt.h"

namespace mien::motion {
namespace {

const std::string small_file =
    "PathFileType\t4\t(X/Y/Z)\twalk.trc\n"
    "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\n"
    "100\t100\t3\t2\tmm\n"
    "Frame#\tTime\tLASI\t\t\tRASI\t\t\n"
    "\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n"
    "\n"
    "1\t0.00\t1\t2\t3\t4.5\t-5\t6e1\n"
    "2\t0.01\t1.5\t2\t3\tnan\tnan\tnan\n"
    "4\t0.03\t0\t0\t0\t\t\t\n";

/// The text is a sound recording, which can be written and read again, or is refused.
bool is_sound_or_refused(const std::string& text) {
  PointRecording recording;
  try {
    recording = parse_trc(text, "a.trc");
  } catch (const Error& error) {
    EXPECT_LT(std::string_view(error.what()).size(), 1500u);
    EXPECT_EQ(printable(error.what()), error.what());
    return false;
  }
  EXPECT_EQ(recording.seen.size(), recording.positions.size());
  EXPECT_GT(recording.frame_count(), 0);
  EXPECT_GT(recording.frames_per_second, 0.0);
  EXPECT_EQ(recording.positions.size() % recording.points.size(), 0u);
  EXPECT_LE(recording.positions.size(), 4 * text.size() + (1u << 20));
  for (const Vec3& position : recording.positions) EXPECT_TRUE(position.allFinite());
  recording.metres_per_unit = 0.001;
  const PointRecording again = parse_trc(to_trc(recording), "again.trc");
  EXPECT_EQ(again.seen, recording.seen);
  return true;
}

TEST(TrcDamage, TruncatedAnywhereIsReadOrRefused) {
  ASSERT_TRUE(is_sound_or_refused(small_file));
  for (std::size_t length = 0; length < small_file.size(); ++length)
    is_sound_or_refused(small_file.substr(0, length));
}

TEST(TrcDamage, MutatedAnyhowIsReadOrRefused) {
  const std::string likely = "0123456789\t\t\t\n\r.-+eEnaNXYZ \xff\x1b";
  std::mt19937_64 random(13);
  int read = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::string text = small_file;
    for (std::size_t change = 0; change <= random() % 4; ++change) {
      const std::size_t at = random() % text.size();
      const char other = likely[random() % likely.size()];
      if (random() % 3 == 0) {
        text.erase(at, 1 + random() % 5);
      } else if (random() % 2 == 0) {
        text.insert(at, 1, other);
      } else {
        text[at] = other;
      }
    }
    if (is_sound_or_refused(text)) ++read;
  }
  EXPECT_GT(read, 100);
  EXPECT_LT(read, 1000);
}

}  // namespace
}  // namespace mien::motion
