#include <random>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/formats/c3d/c3d.h"
#include "motion/formats/c3d/written_c3d.h"
#include "motion/refusal.h"
#include "motion/text/excerpt.h"

namespace mien::motion {
namespace {

using mien::test::WrittenC3d;

WrittenC3d full_file(int processor, bool floats) {
  WrittenC3d file;
  file.processor = processor;
  file.floats = floats;
  file.analog = 3;
  file.labels = {"Ann:LASI", "Ann:RASI", "Bo:LASI", "Bo:LHipAngles"};
  file.frames.assign(
      5, {{1.0, 2.0, 3.0, 0.0}, {4.0, 5.0, 6.0, 1.0}, {0.0, 0.0, 0.0, -1.0}, {7.0, 8.0, 9.0, 0.0}});
  file.more =
      file.group(3, "EVENT") + file.words(3, "USED", {1}) + file.texts(3, "LABELS", {"Foot Off"}) +
      file.texts(3, "CONTEXTS", {"Left"}) + file.floats_of(3, "TIMES", {0.0, 0.02}, {2, 1}) +
      file.group(4, "SUBJECTS") + file.texts(4, "NAMES", {"Ann", "Bo"}) + file.group(2, "TRIAL") +
      file.words(2, "ACTUAL_START_FIELD", {1, 0}) + file.words(2, "ACTUAL_END_FIELD", {5, 0}) +
      file.group(5, "ROTATION") + file.words(5, "USED", {1}) + file.words(5, "DATA_START", {3}) +
      file.texts(5, "LABELS", {"pelvis_4X4"});
  return file;
}

/// The bytes are a sound recording or are refused; returns whether they were read.
bool is_sound_or_refused(const std::string& bytes) {
  bool is_read = false;
  try {
    const PointRecording recording = parse_c3d(bytes, "a.c3d");
    is_read = true;
    EXPECT_EQ(recording.seen.size(), recording.positions.size());
    EXPECT_GT(recording.frame_count(), 0);
    EXPECT_EQ(recording.positions.size() % recording.points.size(), 0u);
    EXPECT_LE(recording.positions.size(), bytes.size());
    for (const Vec3& position : recording.positions) EXPECT_TRUE(position.allFinite());
    for (const std::string& note : recording.notes) EXPECT_LT(note.size(), 1500u);
  } catch (const Error& error) {
    EXPECT_LT(std::string_view(error.what()).size(), 1500u);
    EXPECT_EQ(printable(error.what()), error.what());
  }
  try {
    const Recording recording = parse_c3d_rotations(bytes, "a.c3d");
    EXPECT_TRUE(is_well_formed(recording.skeleton));
  } catch (const Error&) {
  }
  return is_read;
}

TEST(C3dDamage, TruncatedAnywhereIsReadOrRefused) {
  const std::string bytes = full_file(84, true).bytes();
  ASSERT_TRUE(is_sound_or_refused(bytes));
  for (std::size_t length = 0; length < bytes.size(); ++length)
    is_sound_or_refused(bytes.substr(0, length));
}

TEST(C3dDamage, MutatedAnyhowIsReadOrRefused) {
  std::mt19937_64 random(11);
  int read = 0;
  for (int trial = 0; trial < 1200; ++trial) {
    std::string bytes = full_file(84 + trial % 3, trial % 2 == 0).bytes();
    for (std::size_t change = 0; change <= random() % 8; ++change) {
      // Half of the changes hit the header and the first parameters.
      const std::size_t range = random() % 2 == 0 ? 700 : bytes.size();
      bytes[random() % range] = static_cast<char>(random());
    }
    if (is_sound_or_refused(bytes)) ++read;
  }
  EXPECT_GT(read, 100);
  EXPECT_LT(read, 1200);
}

TEST(C3dDamage, NamesAreQuotedInParts) {
  WrittenC3d file = full_file(84, true);
  file.labels.assign(200, "\x1b[2J\xff Angles");
  for (auto& frame : file.frames) frame.resize(200, {1.0, 2.0, 3.0, 0.0});
  const std::string said = mien::test::refusal_of([&] { parse_c3d(file.bytes(), "a.c3d"); });
  EXPECT_EQ(printable(said), said);
  EXPECT_LT(said.size(), 1500u);
  EXPECT_NE(said.find("(200 in all)"), std::string::npos) << said;
}

}  // namespace
}  // namespace mien::motion
