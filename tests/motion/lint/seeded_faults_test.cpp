#include "seeded_faults.h"

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/lint/checks.h"
#include "motion/rig/body_mapping.h"

#include "injected_faults.h"
#include "real_data.h"

// Faults that people see although they are small: a joint that leaps for one frame, white noise, an
// arm that no longer swings, an elbow that bends backwards.

namespace mien::motion {
namespace {

using namespace mien::test;
namespace fs = std::filesystem;

struct Twitch {
  BodyJoint joint;
  BodyJoint child;  ///< the next joint of the limb
  std::vector<std::string> ends;
};

const std::vector<Twitch> twitches = {{LeftShoulder, LeftElbow, {"LeftWrist"}},
                                      {RightShoulder, RightElbow, {"RightWrist"}},
                                      {LeftHip, LeftKnee, {"LeftAnkle"}},
                                      {RightHip, RightKnee, {"RightAnkle"}},
                                      {LeftKnee, LeftAnkle, {"LeftAnkle"}},
                                      {RightKnee, RightAnkle, {"RightAnkle"}},
                                      {Chest, Neck, {"Head", "LeftWrist", "RightWrist"}}};

bool is_found(const Findings& findings, const std::string& check,
              const std::vector<std::string>& joints, int first, int last) {
  return std::ranges::any_of(joints, [&](const std::string& joint) {
    return find(findings, check, joint, first, last) != nullptr;
  });
}

TEST(SeededFaults, ALeapOfTwelveDegreesForOneFrameIsFound) {
  std::mt19937_64 random(7);
  for (const Clip& loop : builtin_walks()) {
    for (const Twitch& twitched : twitches) {
      Clip clip = three_cycles(loop);
      const int frame = random_start(random, clip, 1);
      const Vec3 axis = axis_across(clip, twitched.joint, twitched.child, frame, random);
      twitch(clip, twitched.joint, frame, 12.0, axis);
      const Findings findings = lint(clip);
      EXPECT_TRUE(is_found(findings, "jump", twitched.ends, frame, frame + 1))
          << loop.name << " " << name_of(twitched.joint) << "\n"
          << all_of(findings);
    }
  }
}

// An arm of 0.55 m that is turned by 12° about an axis across it moves its hand by 0.115 m.
TEST(SeededFaults, ALeapIsMeasuredInMetres) {
  Clip clip = resampled(three_cycles(builtin_walks()[0]), 120.0);
  const Pose still = clip.poses[0];
  for (Pose& pose : clip.poses) pose = still;
  for (int t = 0; t < clip.frame_count(); ++t) clip.poses[t].root_position.z() += 0.01 * t;
  std::mt19937_64 random(8);
  twitch(clip, LeftShoulder, 60, 12.0, axis_across(clip, LeftShoulder, LeftElbow, 60, random));
  const JointTransforms before = world_transforms(clip.body, clip.poses[59]);
  const JointTransforms after = world_transforms(clip.body, clip.poses[60]);
  const double moved = ((after.positions[LeftWrist] - after.positions[Pelvis]) -
                        (before.positions[LeftWrist] - before.positions[Pelvis]))
                           .norm();
  const LintMotion motion = lint_motion(clip);
  const Findings findings = find_limb_jumps(motion, {}, {});
  const Finding* found = find(findings, "jump", "LeftWrist", 60, 61);
  ASSERT_TRUE(found) << all_of(findings);
  EXPECT_NEAR(found->measured * motion.scale, 0.75 * moved, 0.01 * moved);
  EXPECT_EQ(findings.size(), 1U) << all_of(findings);
}

TEST(SeededFaults, ALeapOfAJointIsNotFoundAgainAsThatOfItsLimb) {
  Clip clip = three_cycles(builtin_walks()[0]);
  leap(clip, LeftShoulder, clip.frame_count() / 2, 40.0, Vec3::UnitZ());
  const Findings findings = lint(clip);
  EXPECT_TRUE(find(findings, "jump", "LeftShoulder")) << all_of(findings);
  EXPECT_FALSE(find(findings, "jump", "LeftWrist")) << all_of(findings);
}

TEST(SeededFaults, WhiteNoiseOfOneDegreeIsFoundAndMeasured) {
  std::mt19937_64 random(9);
  for (const double rate : {30.0, 100.0}) {
    for (const Clip& loop : builtin_walks()) {
      for (const BodyJoint joint : {Chest, LeftShoulder}) {
        Clip clip = resampled(three_cycles(loop), rate);
        add_jitter(clip, joint, 1.0, random);
        const Findings findings = find_jitter(lint_motion(clip), {}, nullptr);
        const Finding* found = find(findings, "jitter", "LeftWrist");
        ASSERT_TRUE(found) << loop.name << " " << name_of(joint) << "\n" << all_of(findings);
        EXPECT_GT(found->measured, 0.003);
        EXPECT_LT(found->measured, 0.02);
        EXPECT_FALSE(find(findings, "jitter", "Ankle")) << all_of(findings);
      }
    }
  }
}

TEST(SeededFaults, ATremorIsNoWhiteNoise) {
  for (const Clip& loop : builtin_walks()) {
    Clip clip = resampled(three_cycles(loop), 60.0);
    for (int t = 0; t < clip.frame_count(); ++t) {
      const double tremor = 0.02 * std::sin(2 * pi * 8.0 * t / 60.0);
      clip.poses[t].rotations[RightShoulder] *= exp(Vec3(0, tremor, tremor));
    }
    const Findings findings = find_jitter(lint_motion(clip), {}, nullptr);
    EXPECT_TRUE(findings.empty()) << loop.name << "\n" << all_of(findings);
  }
}

TEST(SeededFaults, NoiseThatTheOriginalHasIsNotFound) {
  std::mt19937_64 random(10);
  Clip clip = resampled(three_cycles(builtin_walks()[0]), 60.0);
  add_jitter(clip, Chest, 1.0, random);
  EXPECT_TRUE(find(lint(clip), "jitter"));
  EXPECT_FALSE(find(lint(clip, {}, &clip), "jitter"));
}

/// How far the arm moves the left wrist from its mean place, root mean square, metres.
double swing(const Clip& clip) {
  const LintMotion motion = lint_motion(clip);
  std::vector<Vec3> places;
  Vec3 mean = Vec3::Zero();
  for (const JointTransforms& world : motion.world) {
    places.push_back(world.rotations[LeftClavicle].conjugate() *
                     (world.positions[LeftWrist] - world.positions[LeftClavicle]));
    mean += places.back() / static_cast<double>(motion.world.size());
  }
  double squares = 0.0;
  for (const Vec3& place : places) squares += (place - mean).squaredNorm();
  return std::sqrt(squares / static_cast<double>(places.size()));
}

TEST(SeededFaults, AnArmThatNoLongerSwingsIsFoundAndOneThatSwingsHalfAsFarIsNot) {
  int swinging = 0;
  for (const Clip& loop : builtin_walks()) {
    Clip stopped = loop;
    stop_arm(stopped, true);
    const Findings findings = lint(stopped, {}, &loop);
    const Finding* found = find(findings, "still-limb", "LeftWrist");
    const bool swings = swing(loop) > 0.045;
    swinging += swings ? 1 : 0;
    EXPECT_TRUE(found || !swings) << loop.name << "\n" << all_of(findings);
    EXPECT_FALSE(find(findings, "still-limb", "RightWrist")) << loop.name;
    Clip half = loop;
    for (int t = 0; t < loop.frame_count(); ++t) {
      for (const BodyJoint joint : {LeftShoulder, LeftElbow}) {
        half.poses[t].rotations[joint] =
            slerp(loop.poses[0].rotations[joint], loop.poses[t].rotations[joint], 0.5);
      }
    }
    EXPECT_FALSE(find(lint(half, {}, &loop), "still-limb")) << loop.name;
  }
  EXPECT_GT(swinging, 20);
}

/// The walk with its left elbow bent by at least 40°.
Clip with_bent_elbow(Clip clip) {
  for (Pose& pose : clip.poses) {
    pose.rotations[LeftElbow] = Quat(Eigen::AngleAxisd(-40.0 * radians_per_degree, Vec3::UnitY()));
  }
  return clip;
}

TEST(SeededFaults, AnElbowBentBackwardsThroughoutIsAnError) {
  for (const Clip& loop : builtin_walks()) {
    Clip clip = with_bent_elbow(loop);
    ASSERT_FALSE(find(lint(clip), "joint-limit", "LeftElbow")) << loop.name << all_of(lint(clip));
    turn_upper_arm(clip, true, 180.0);
    const Findings findings = lint(clip);
    EXPECT_TRUE(find_error(findings, "joint-limit", "LeftElbow", 0, clip.frame_count() - 1))
        << loop.name << "\n"
        << all_of(findings);
    EXPECT_FALSE(find(findings, "joint-limit", "RightElbow")) << loop.name;
    // It is no new fault of a motion whose original has it.
    EXPECT_FALSE(find(lint(clip, {}, &clip), "joint-limit", "LeftElbow")) << loop.name;
  }
}

// A run repeats itself after half a second: a limb that is one period late is not late. Every other
// swing of the arm is small, so that the path one period later is more like the original's than the
// path at the same time.
TEST(SeededFaults, AWholePeriodIsNoShift) {
  Clip loop = builtin_walks()[0];
  loop.frames_per_second = loop.frame_count() / 0.5;
  const Clip plain = repeated(loop, 8);
  const auto alternating = [&](int parity) {
    Clip clip = plain;
    for (int t = 0; t < clip.frame_count(); ++t) {
      if ((t / loop.frame_count()) % 2 == parity) continue;
      for (const BodyJoint joint : {LeftShoulder, LeftElbow}) {
        Quat& rotation = clip.poses[t].rotations[joint];
        rotation = slerp(plain.poses[0].rotations[joint], rotation, 0.6);
      }
    }
    return clip;
  };
  const Findings compared =
      find_shifted_limbs(lint_motion(alternating(0)), {}, lint_motion(alternating(1)));
  for (const Finding& finding : compared) EXPECT_NE(finding.unit, "s") << finding.sentence;
}

/// A capture with a fault that was recorded, as the paths of its joints show.
struct FaultyCapture {
  std::string file;
  std::string check;
  std::string joint;
  int first;
  int last;
};

const std::vector<FaultyCapture> faulty_captures = {
    // The landing foot leaps sideways by 3.6 cm to the place where it then stands quite still.
    {"dataset-1_walk_active_001", "jump", "RightAnkle", 121, 121},
    // A swinging foot stops for a frame (0.01 s) and then moves by 10 cm.
    {"k_limp_angry_k_walk_angry_000_100", "jump", "LeftAnkle", 285, 285},
    // A foot turns to and fro by 17° in each of six frames.
    {"k_limp_angry_k_walk_angry_100_000", "joint-speed", "LeftAnkle", 139, 144},
    // A head that is still leaps to the side and back by 27 to 31°, twice.
    {"k_limp_slow_k_walk_slow_100_000", "jump", "Head", 17, 36},
    // A foot that swings back nearly stops for two frames and then moves by 10 cm.
    {"k_run_fast_k_run_slow_000_100", "jump", "RightAnkle", 172, 172},
    // Both swinging feet stop for single frames; then one moves by 8 cm and the other turns by 42°.
    {"k_run_slow_k_limp_fast_k_walk_regular_000_000_100", "jump", "RightAnkle", 193, 193},
    // A foot leaps to and fro by 49°.
    {"k_walk_fast_k_walk_angry_k_walk_regular_100_000_000", "jump", "RightAnkle", 293, 296},
    // Frames 157, 160 and 162 repeat the frame before; the body then moves twice as far.
    {"t_walk_fast_t_walk_angry_t_walk_regular_100_000_000", "jump", "RightAnkle", 161, 161},
};

const FaultyCapture* known_fault(const fs::path& file) {
  const auto found = std::ranges::find(faulty_captures, file.stem().string(), &FaultyCapture::file);
  return found == faulty_captures.end() ? nullptr : &*found;
}

class SeededCaptures : public testing::Test {
 protected:
  void SetUp() override {
    const auto folder = real_data();
    if (!folder) GTEST_SKIP() << "no motion capture here: set MIEN_DATA to the folder that has it";
    for (const char* set : {"bandai-namco-1", "aalto-two-actors"}) {
      for (const auto& entry : fs::directory_iterator(*folder / "mocap" / set))
        if (entry.path().extension() == ".bvh") files.push_back(entry.path());
    }
    std::ranges::sort(files);
    for (const fs::path& file : files)
      if (!known_fault(file)) captures.push_back(to_body(read_motion(file)));
  }

  std::vector<fs::path> files;  ///< of all captures
  std::vector<Clip> captures;   ///< without the faulty ones
  std::mt19937_64 random{11};
};

TEST_F(SeededCaptures, NinetyFiveOfAHundredLeapsAreFound) {
  int seeded = 0;
  int found = 0;
  for (const Clip& capture : captures) {
    for (const Twitch& twitched : twitches) {
      Clip clip = capture;
      const int frame = random_start(random, clip, 1);
      twitch(clip, twitched.joint, frame, 12.0,
             axis_across(clip, twitched.joint, twitched.child, frame, random));
      const Findings findings = find_limb_jumps(lint_motion(clip), {}, {});
      ++seeded;
      found += is_found(findings, "jump", twitched.ends, frame, frame + 1) ? 1 : 0;
    }
  }
  EXPECT_GE(captures.size(), 60U);
  EXPECT_GE(found, 0.95 * seeded) << found << " of " << seeded;
}

TEST_F(SeededCaptures, NinetyFiveOfAHundredNoisyJointsAreFound) {
  int seeded = 0;
  int found = 0;
  for (const Clip& capture : captures) {
    for (const BodyJoint joint : {Chest, LeftShoulder, RightShoulder}) {
      Clip clip = capture;
      add_jitter(clip, joint, 1.0, random);
      const Findings findings = find_jitter(lint_motion(clip), {}, nullptr);
      ++seeded;
      found += is_found(findings, "jitter", {"LeftWrist", "RightWrist"}, 0, clip.frame_count());
    }
  }
  EXPECT_GE(found, 0.95 * seeded) << found << " of " << seeded;
}

TEST_F(SeededCaptures, NinetyFiveOfAHundredStoppedArmsAreFound) {
  int seeded = 0;
  int found = 0;
  for (const Clip& capture : captures) {
    if (swing(capture) < 0.08) continue;
    Clip clip = capture;
    stop_arm(clip, true);
    const Findings findings = find_still_limbs(lint_motion(clip), {}, lint_motion(capture));
    ++seeded;
    found += find(findings, "still-limb", "LeftWrist") ? 1 : 0;
  }
  EXPECT_GE(seeded, 30);
  EXPECT_GE(found, 0.95 * seeded) << found << " of " << seeded;
}

TEST_F(SeededCaptures, NinetyFiveOfAHundredBackwardElbowsAreFound) {
  int seeded = 0;
  int found = 0;
  for (const Clip& capture : captures) {
    Clip clip = with_bent_elbow(capture);
    if (!find_backward_elbows(lint_motion(clip), {}, nullptr).empty()) continue;
    turn_upper_arm(clip, true, 180.0);
    ++seeded;
    found += find(find_backward_elbows(lint_motion(clip), {}, nullptr), "joint-limit", "LeftElbow")
                 ? 1
                 : 0;
  }
  EXPECT_GE(seeded, 50);
  EXPECT_GE(found, 0.95 * seeded) << found << " of " << seeded;
}

TEST_F(SeededCaptures, OneInTwentyAtMostHasErrors) {
  std::string faulty;
  int count = 0;
  for (const Clip& capture : captures) {
    const Findings findings = lint(capture);
    if (!has_errors(findings)) continue;
    ++count;
    faulty += capture.name + "\n" + all_of(findings) + "\n";
  }
  EXPECT_LE(count, 0.05 * static_cast<double>(captures.size())) << faulty;
}

TEST_F(SeededCaptures, ThatAreFaultyHaveTheErrorsThatPeopleSee) {
  size_t found = 0;
  for (const fs::path& file : files) {
    const FaultyCapture* fault = known_fault(file);
    if (!fault) continue;
    const Findings findings = lint(to_body(read_motion(file)));
    EXPECT_TRUE(find_error(findings, fault->check, fault->joint, fault->first, fault->last))
        << file << "\n"
        << all_of(findings);
    ++found;
  }
  EXPECT_EQ(found, faulty_captures.size());
}

}  // namespace
}  // namespace mien::motion
