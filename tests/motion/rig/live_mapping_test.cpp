#include "motion/rig/live_mapping.h"

#include <gtest/gtest.h>

#include "motion/modify/path_measures.h"
#include "motion/modify/real_takes.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/refusal.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Recording first_of(const Recording& recording) {
  Recording first = recording;
  first.poses.resize(1);
  return first;
}

Clip mapped_live(LiveMapping& mapping, const Recording& recording) {
  Clip clip;
  clip.body = mapping.mapping().body;
  clip.frames_per_second = recording.frames_per_second;
  for (const Pose& pose : recording.poses) clip.poses.push_back(mapping(pose));
  return clip;
}

TEST(LiveMapping, OfTheCanonicalBodyIsThatOfTheWholeButForItsFloor) {
  for (const Example& example : builtin_examples("walks-10").examples) {
    const Recording recording = to_recording(example.clip);
    LiveMapping mapping(first_of(recording));
    Clip live = mapped_live(mapping, recording);
    const Clip whole = to_body(recording);
    const double floor = whole.poses[0].root_position.y() - live.poses[0].root_position.y();
    EXPECT_LT(std::abs(floor), 0.03) << example.name;
    for (Pose& pose : live.poses) pose.root_position.y() += floor;
    EXPECT_LT(largest_distance(live, whole), 1e-3) << example.name;
  }
}

TEST(LiveMapping, CalibratedWithTheWholeIsThatOfTheWhole) {
  const Recording recording = to_recording(builtin_examples("actors").examples.front().clip);
  LiveMapping mapping(recording, first_of(recording));
  EXPECT_LT(largest_distance(mapped_live(mapping, recording), to_body(recording)), 1e-12);
}

TEST(LiveMapping, RefusesCalibrationOfAnotherRig) {
  const Recording one = to_recording(builtin_examples("actors").examples.front().clip);
  Recording other = one;
  other.name = "other";
  other.skeleton.joints[3].offset *= 2.0;
  EXPECT_NE(refusal_of([&] { LiveMapping(other, first_of(one)); }).find("other: its rig differs"),
            std::string::npos);
}

TEST(LiveMapping, RefusesWhatIsNoHuman) {
  Recording stick;
  stick.name = "stick";
  stick.skeleton.joints = {{"Root"}, {"Tip", 0, Vec3(0, 1, 0)}};
  stick.poses.resize(1);
  stick.poses[0].rotations.assign(2, Quat::Identity());
  EXPECT_NE(refusal_of([&] { LiveMapping{stick}; }).find("not recognised as a human"),
            std::string::npos);
}

TEST(LiveMapping, AsksForACalibrationWhereTheRestPoseSaysNothing) {
  const auto root = real_data();
  if (!root) GTEST_SKIP() << "no motion capture here: set MIEN_DATA";
  const Recording take = read_motion(*root / "mocap/bandai-namco-1/dataset-1_walk_normal_001.bvh");
  EXPECT_NE(refusal_of([&] { LiveMapping{first_of(take)}; }).find("--calibration"),
            std::string::npos);
  LiveMapping mapping(take, first_of(take));
  EXPECT_LT(largest_distance(mapped_live(mapping, take), to_body(take)), 1e-9);
}

}  // namespace
}  // namespace mien::motion
