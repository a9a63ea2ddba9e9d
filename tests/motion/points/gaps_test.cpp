#include "motion/points/gaps.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mien::motion {
namespace {

/// One point on a smooth path, 100 frames per second.
PointRecording swinging() {
  PointRecording recording;
  recording.points = {"A"};
  recording.frames_per_second = 100.0;
  for (int frame = 0; frame < 200; ++frame) {
    const double t = 0.01 * frame;
    recording.positions.emplace_back(std::sin(5.0 * t), 0.9 + 0.1 * std::cos(8.0 * t), 1.2 * t);
    recording.seen.push_back(true);
  }
  return recording;
}

PointRecording without(PointRecording recording, int first, int past) {
  for (int frame = first; frame < past; ++frame) {
    recording.positions[recording.at(frame, 0)].setZero();
    recording.seen[recording.at(frame, 0)] = false;
  }
  return recording;
}

TEST(Gaps, AreMeasured) {
  PointRecording recording = without(without(swinging(), 0, 10), 50, 80);
  recording.points.push_back("B");
  std::vector<Vec3> positions;
  std::vector<bool> seen;
  for (int frame = 0; frame < 200; ++frame) {
    positions.push_back(recording.positions[static_cast<std::size_t>(frame)]);
    positions.push_back(Vec3::Ones());
    seen.push_back(recording.seen[static_cast<std::size_t>(frame)]);
    seen.push_back(true);
  }
  recording.positions = positions;
  recording.seen = seen;
  const GapSummary gaps = gaps_of(recording);
  EXPECT_DOUBLE_EQ(gaps.points[0].missing_share, 0.2);
  EXPECT_DOUBLE_EQ(gaps.points[0].longest_gap_seconds, 0.3);
  EXPECT_EQ(gaps.points[1].missing_share, 0.0);
  EXPECT_DOUBLE_EQ(gaps.missing_share, 0.1);
  EXPECT_DOUBLE_EQ(gaps.longest_gap_seconds, 0.3);
}

TEST(Gaps, AreFilledNearThePath) {
  const PointRecording whole = swinging();
  const FilledPoints result = filled(without(whole, 90, 110));
  for (int frame = 0; frame < 200; ++frame) {
    const std::size_t at = whole.at(frame, 0);
    EXPECT_TRUE(result.recording.seen[at]);
    EXPECT_EQ(result.filled[at], frame >= 90 && frame < 110);
    EXPECT_LT((result.recording.positions[at] - whole.positions[at]).norm(), 0.006) << frame;
  }
}

TEST(Gaps, LongerThanTheLimitStay) {
  const PointRecording gap = without(swinging(), 90, 111);
  const FilledPoints result = filled(gap);
  EXPECT_EQ(result.recording.seen, gap.seen);
  EXPECT_EQ(filled(gap, 0.21).recording.seen, std::vector<bool>(200, true));
}

TEST(Gaps, AtTheEndsStay) {
  const PointRecording gap = without(without(swinging(), 0, 3), 196, 200);
  EXPECT_EQ(filled(gap).recording.seen, gap.seen);
}

TEST(Gaps, WithOneNeighbourOnEachSideAreBridged) {
  PointRecording lonely = without(without(without(swinging(), 0, 89), 90, 100), 101, 200);
  const FilledPoints result = filled(lonely);
  const Vec3 from = lonely.positions[89];
  const Vec3 to = lonely.positions[100];
  for (int frame = 90; frame < 100; ++frame) {
    EXPECT_TRUE(result.recording.seen[static_cast<std::size_t>(frame)]);
    const Vec3 place = result.recording.positions[static_cast<std::size_t>(frame)];
    EXPECT_LE((place - from).norm(), (to - from).norm());
  }
}

}  // namespace
}  // namespace mien::motion
