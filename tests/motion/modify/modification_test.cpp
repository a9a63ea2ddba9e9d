#include "motion/modify/modification.h"

#include <algorithm>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "motion/examples/make_example.h"
#include "motion/gait/contact.h"
#include "motion/math/rotation.h"
#include "motion/modify/feet_apart.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/procedural/walker.h"
#include "motion/random_motion.h"
#include "motion/refusal.h"
#include "motion/skeleton/mirror.h"
#include "motion/skeleton/straighten.h"
#include "motion/synthetic_walk.h"

#include "path_measures.h"
#include "real_takes.h"

namespace mien::motion {
namespace {

using namespace mien::test;
using enum PostureUnit;

Modification recipe(double paths, double acceleration, std::vector<PostureChange> posture = {}) {
  Modification m;
  m.paths = paths;
  m.acceleration = acceleration;
  m.posture = std::move(posture);
  return m;
}

std::map<std::string, Modification> recipes() {
  return {{"angry", recipe(1.7, 0.8)},
          {"sad", recipe(0.5, 0.0, {{head_flexion, 25.0}, {chest_flexion, 6.0}})},
          {"tired", recipe(0.05, 0.0, {{head_flexion, 12.0}})},
          {"strong", recipe(1.7, 0.0, {{shoulder_abduction, 20.0}})},
          {"relaxed", recipe(1.0, -0.7)},
          {"afraid", recipe(0.5, 0.0, {{shoulder_abduction, -8.0}, {hip_abduction, -3.0}})}};
}

Modification everything() {
  Modification m = recipe(1.6, 0.5, {{head_flexion, 10.0}, {hip_abduction, 4.0}});
  m.tempo = 1.2;
  m.variation = 0.5;
  PoseDifference difference;
  difference.turns[Chest] = exp(Vec3(0.1, 0.05, 0.0));
  m.pose_difference = difference;
  return m;
}

/// Walks of the parametric walker, as loops that travel, as loops in place, and as open clips.
std::vector<Clip> synthetic_walks() {
  std::vector<Clip> clips;
  for (const Example& example : builtin_examples("walks-10", 100.0).examples) {
    clips.push_back(example.clip);
    clips.back().name = example.name;
  }
  clips.push_back(in_place(clips[0]));
  clips.push_back(repeated(clips[5], 3));
  return clips;
}

TEST(Modification, ByDefaultChangesNothing) {
  std::mt19937_64 random(2);
  const Clip clip = random_loop(random, 40).clip;
  EXPECT_TRUE(is_identity(Modification()));
  EXPECT_EQ(largest_distance(modified(clip, {}), clip), 0.0);
}

TEST(Modification, OfNoStrengthChangesNothing) {
  const Clip clip = walk({}, 30.0, standard_body()).clip;
  Modification with_gains = everything();
  with_gains.gains = PathGains{0.8, 1.5, 0.2, {0.3, 1.7}};
  for (const Modification& m : {everything(), with_gains}) {
    EXPECT_FALSE(is_identity(m));
    EXPECT_TRUE(is_identity(scaled(m, 0.0)));
    EXPECT_EQ(largest_distance(modified(clip, scaled(m, 0.0)), clip), 0.0);
  }
}

TEST(Modification, OfFullStrengthIsItself) {
  const Modification m = scaled(everything(), 1.0);
  EXPECT_EQ(m.paths, everything().paths);
  EXPECT_EQ(m.tempo, everything().tempo);
  const Modification half = scaled(everything(), 0.5);
  EXPECT_DOUBLE_EQ(half.paths, 1.3);
  EXPECT_DOUBLE_EQ(half.acceleration, 0.25);
  EXPECT_DOUBLE_EQ(half.posture[0].degrees, 5.0);
  EXPECT_DOUBLE_EQ(half.tempo.factor, std::sqrt(1.2));
  EXPECT_NEAR(log(half.pose_difference->turns[Chest]).x(), 0.05, 1e-12);
}

TEST(Modification, AtUnitGainsAndMiddleOfTheGridChangesNothing) {
  Modification m = recipe(1.0, 0.0, {{head_flexion, 0.0}});
  EXPECT_TRUE(is_identity(m));
  m.gains = PathGains{};
  EXPECT_TRUE(is_identity(m));
  m.gains->bands = {1.0, 1.0};
  EXPECT_TRUE(is_identity(m));
  m.gains->bands = {1.0, 1.1};
  EXPECT_FALSE(is_identity(m));
}

TEST(Modification, NeverChangesBoneLengths) {
  for (const Clip& clip : synthetic_walks()) {
    const Clip after = modified(clip, everything());
    const auto paths = joint_paths(after);
    for (const auto& places : paths) {
      for (int j = 1; j < body_joint_count; ++j) {
        const double bone = (places[size_t(j)] - places[size_t(body_parents[size_t(j)])]).norm();
        EXPECT_NEAR(bone, clip.body.joints[size_t(j)].offset.norm(), 1e-9);
      }
    }
    for (const Pose& pose : after.poses) {
      EXPECT_TRUE(pose.offsets.empty());
      for (const Quat& rotation : pose.rotations) EXPECT_NEAR(rotation.norm(), 1.0, 1e-12);
    }
  }
}

TEST(Modification, KeepsLoopsLoopsAndClipsInPlaceInPlace) {
  for (const Clip& clip : synthetic_walks()) {
    for (const auto& [name, m] : recipes()) {
      const Clip after = modified(clip, m);
      EXPECT_EQ(after.loops, clip.loops);
      EXPECT_EQ(after.frame_count(), clip.frame_count());
      EXPECT_EQ(after.name, clip.name);
      EXPECT_EQ(after.cycle_displacement.isZero(), clip.cycle_displacement.isZero());
      if (!clip.loops) continue;
      // The step over the seam is no larger than those within.
      const auto paths = joint_paths(repeated(after, 2));
      double seam = 0.0;
      double inside = 0.0;
      for (size_t f = 1; f < paths.size(); ++f) {
        for (size_t j = 0; j < paths[f].size(); ++j) {
          double& largest = f == after.poses.size() ? seam : inside;
          largest = std::max(largest, (paths[f][j] - paths[f - 1][j]).norm());
        }
      }
      EXPECT_LE(seam, inside) << clip.name << " " << name;
    }
  }
}

TEST(Modification, OfALoopDoesNotMindItsFirstFrame) {
  // Paths and posture; timing divides a loop into segments from its first frame on.
  const Clip clip = in_place(walk({}, 100.0, standard_body()).clip);
  const Modification m = recipe(1.7, 0.0, {{head_flexion, 10.0}});
  Clip turned = clip;
  std::rotate(turned.poses.begin(), turned.poses.begin() + 31, turned.poses.end());
  Clip expected = modified(clip, m);
  std::rotate(expected.poses.begin(), expected.poses.begin() + 31, expected.poses.end());
  const Clip after = modified(turned, m);
  double largest = 0.0;
  for (size_t f = 0; f < after.poses.size(); ++f) {
    for (size_t j = 0; j < body_joint_count; ++j) {
      largest = std::max(
          largest, angle_between(after.poses[f].rotations[j], expected.poses[f].rotations[j]));
    }
  }
  EXPECT_LT(largest, 0.01);
}

bool remarks(const ModifiedClip& after, const std::string& part) {
  const auto& all = after.report.remarks;
  return std::any_of(all.begin(), all.end(), [&](const std::string& remark) {
    return remark.find(part) != std::string::npos;
  });
}

TEST(Modification, AcceleratesAtContactsNowhereWithoutContacts) {
  Clip stands = walk({}, 100.0, standard_body()).clip;
  stands.loops = false;
  stands.cycle_displacement = Vec3::Zero();
  for (Pose& pose : stands.poses) {
    const Quat arm = pose.rotations[LeftShoulder];
    pose = standing_pose(stands.body);
    pose.rotations[LeftShoulder] = arm;
  }
  Modification m = recipe(1.0, 0.8);
  m.acceleration_place = AccelerationPlace::contacts;
  m.repair = FootRepair::none;
  const ModifiedClip after = modify(stands, m);
  EXPECT_EQ(largest_distance(after.clip, stands), 0.0);
  EXPECT_TRUE(remarks(after, "there are no hits of hands and no foot contacts"));
  EXPECT_TRUE(remarks(after, "feet stand throughout"));
  m.acceleration_place = AccelerationPlace::pauses;
  const ModifiedClip everywhere = modify(stands, m);
  EXPECT_FALSE(remarks(everywhere, "there are no hits of hands and no foot contacts"));
}

// On a treadmill feet move as fast as the belt: they bear weight, but are not planted.
TEST(Modification, SaysWhyNoFootIsPlanted) {
  const std::string reason = "no foot is planted, so feet were not locked: none stays within 4 cm";
  Clip clip = synthetic_clip(steady_walk(1.2, 3.0));
  EXPECT_FALSE(remarks(modify(clip, recipe(0.8, 0.0)), "no foot is planted"));
  for (int f = 0; f < clip.frame_count(); ++f)
    clip.poses[static_cast<std::size_t>(f)].root_position.z() -= 1.2 * f / clip.frames_per_second;
  const ModifiedClip after = modify(clip, recipe(0.8, 0.0));
  EXPECT_EQ(after.report.plants, 0);
  EXPECT_TRUE(remarks(after, reason + " of its lowest height and slower than 0.15 m/s for 0.1 s"));
}

TEST(Modification, FindsContactsWhereFeetAreNotRepaired) {
  const Clip clip = walk({}, 100.0, standard_body()).clip;
  Modification m = recipe(1.0, 0.8);
  m.repair = FootRepair::none;
  const Clip everywhere = modified(clip, m);
  m.acceleration_place = AccelerationPlace::contacts;
  const ModifiedClip near = modify(clip, m);
  EXPECT_FALSE(remarks(near, "there are no hits of hands and no foot contacts"));
  EXPECT_GT(largest_distance(near.clip, everywhere), 0.001);
}

TEST(Modification, CrossesNoFeet) {
  const Modification inwards = recipe(1.0, 0.0, {{hip_abduction, -8.0}});
  for (const Clip& clip : synthetic_walks()) {
    if (clip.loops && clip.cycle_displacement.isZero(1e-6)) continue;  // walks in place
    const std::vector<FootPlant> plants = foot_plants(clip);
    const std::optional<double> before = least_step_width(clip, plants);
    ASSERT_TRUE(before) << clip.name;
    const ModifiedClip after = modify(clip, inwards);
    EXPECT_GE(*least_step_width(after.clip, plants),
              std::min(*before, foot_width(clip.body)) - 0.005)
        << clip.name;
    EXPECT_TRUE(remarks(after, "thighs were rotated inwards by")) << clip.name;
  }
}

TEST(Modification, LetsFeetStandOfSyntheticWalks) {
  for (const Clip& clip : synthetic_walks()) {
    for (const auto& [name, m] : recipes()) {
      const ModifiedClip after = modify(clip, m);
      EXPECT_GT(after.report.plants, 0) << clip.name;
      EXPECT_LT(after.report.drift_after_repair, 0.002) << clip.name << " " << name;
    }
  }
}

TEST(Modification, StatesHowFarFeetSlideThatAreNotRepaired) {
  Modification m = recipe(1.4, 0.0);
  m.repair = FootRepair::none;
  for (const Clip& clip : synthetic_walks()) {
    const ModificationReport report = modify(clip, m).report;
    EXPECT_EQ(report.plants, 0) << clip.name;
    EXPECT_GT(report.drift_after_repair, 0.01) << clip.name;
    EXPECT_DOUBLE_EQ(report.drift_after_repair, report.drift_before_repair) << clip.name;
  }
}

TEST(Modification, WalksFartherWithLongerPaths) {
  const Clip clip = walk({}, 100.0, standard_body()).clip;
  double before = 0.0;
  for (const double paths : {0.0, 0.5, 1.5, 2.0}) {
    const ModifiedClip after = modify(clip, recipe(paths, 0.0));
    EXPECT_GT(after.report.travel_ratio, before) << paths;
    EXPECT_EQ(after.report.travel_ratio > 1.0, paths > 1.0);
    before = after.report.travel_ratio;
  }
}

/// The percentage in "distance travelled rose to 125 %"; 100 without the remark.
double reported_travel(const ModificationReport& report) {
  for (const std::string& remark : report.remarks) {
    if (remark.starts_with("distance travelled"))
      return std::stod(remark.substr(remark.find(" to ") + 4));
  }
  return 100.0;
}

TEST(Modification, TellsTheWayOfAWalkThatReturns) {
  SyntheticWalk walk = steady_walk(1.2, 10.0, 60.0);
  walk.turn_start = 5.0;
  walk.turn_length = 2.0;
  walk.turn_angle = 0.97 * pi;
  const Clip clip = synthetic_clip(walk);
  const Vec3 apart = clip.poses.back().root_position - clip.poses.front().root_position;
  ASSERT_LT(apart.norm(), 3.0);
  const Clip straight = synthetic_clip(steady_walk(1.2, 10.0, 60.0));
  const Modification longer = recipe(1.4, 0.0);
  EXPECT_NEAR(reported_travel(modify(clip, longer).report),
              reported_travel(modify(straight, longer).report), 5.0);
}

TEST(Modification, OfALoopInPlaceHasNoWay) {
  const Clip loop = walk({}, 100.0, standard_body()).clip;
  const ModifiedClip travelled = modify(loop, recipe(1.4, 0.0));
  EXPECT_GT(reported_travel(travelled.report), 105.0);
  const ModifiedClip stayed = modify(in_place(loop), recipe(1.4, 0.0));
  EXPECT_EQ(reported_travel(stayed.report), 100.0);
}

TEST(Modification, OfTempoDividesTheDurationAndKeepsTheFeet) {
  Modification m;
  m.tempo = 0.8;
  for (const Clip& clip : synthetic_walks()) {
    const ModifiedClip after = modify(clip, m);
    EXPECT_NEAR(after.clip.duration_seconds(), clip.duration_seconds() / 0.8, 0.006) << clip.name;
    EXPECT_LT(after.report.drift_after_repair, 0.002) << clip.name;
  }
}

TEST(Modification, TellsATempoThatWholeFramesDoNotGive) {
  const auto remarks_on_tempo = [](const ModificationReport& report) {
    return std::count_if(report.remarks.begin(), report.remarks.end(), [](const auto& remark) {
      return remark.find("instead of the requested") != std::string::npos;
    });
  };
  for (const Clip& clip : synthetic_walks()) {
    for (const double tempo : {1.01, 1.004, 0.8, 2.0, 1.0}) {
      Modification m;
      m.tempo = tempo;
      const ModifiedClip after = modify(clip, m);
      EXPECT_NEAR(after.report.tempo, clip.duration_seconds() / after.clip.duration_seconds(),
                  1e-12)
          << clip.name;
      EXPECT_EQ(remarks_on_tempo(after.report) > 0,
                std::abs(after.report.tempo / tempo - 1.0) > 5e-4)
          << clip.name << " at " << tempo << ": " << after.report.tempo;
    }
  }
  Modification m;
  m.tempo = 1.01;
  const ModifiedClip coarse = modify(walk({}, 10.0, standard_body()).clip, m);
  EXPECT_EQ(coarse.report.tempo, 1.0);
  EXPECT_EQ(remarks_on_tempo(coarse.report), 1);
}

TEST(Modification, RepeatsItselfAndFollowsItsSeed) {
  const Clip clip = walk({}, 30.0, standard_body()).clip;
  Modification m;
  m.variation = 1.0;
  const Clip first = modified(clip, m);
  EXPECT_EQ(largest_distance(modified(clip, m), first), 0.0);
  m.seed = 2;
  EXPECT_GT(largest_distance(modified(clip, m), first), 0.01);
}

TEST(Modification, OfAMirroredWalkIsTheMirroredModification) {
  const Clip clip = walk({}, 100.0, standard_body()).clip;
  Modification m = recipe(1.7, 0.5, {{shoulder_abduction, 12.0}, {spine_flexion, 5.0}});
  EXPECT_LT(largest_distance(modified(mirrored(clip), m), mirrored(modified(clip, m))), 1e-6);
}

TEST(Modification, RefusesWhatIsOutOfRange) {
  const Clip clip = walk({}, 30.0, standard_body()).clip;
  Modification m;
  m.paths = 2.5;
  EXPECT_EQ(refusal_of([&] { modified(clip, m); }), "paths is 2.5; give a number from 0 to 2");
  m = {};
  m.tempo = 0.0;
  EXPECT_EQ(refusal_of([&] { check(m); }), "tempo is 0; give a number from 0.25 to 4");
  m = {};
  m.posture = {{head_flexion, NAN}};
  EXPECT_NE(refusal_of([&] { check(m); }).find("head-flexion is nan"), std::string::npos);
}

TEST(Modification, RefusesOtherSkeletons) {
  Clip clip = walk({}, 30.0, standard_body()).clip;
  clip.body.joints.pop_back();
  EXPECT_NE(refusal_of([&] { modified(clip, {}); }).find("canonical body"), std::string::npos);
}

class ModifiedTakes : public testing::Test {
 protected:
  void SetUp() override {
    walks = real_walks();
    waves = real_waves();
    if (walks.empty()) GTEST_SKIP() << "no motion capture here: set MIEN_DATA";
  }

  std::vector<Clip> walks;
  std::vector<Clip> waves;
};

double length_of_ends(const Clip& clip) {
  double sum = 0.0;
  for (const BodyJoint end : {LeftWrist, RightWrist, LeftAnkle, RightAnkle}) {
    sum += path_length(clip, end);
  }
  return sum;
}

TEST_F(ModifiedTakes, HaveLongerAndShorterPaths) {
  ASSERT_EQ(walks.size(), 30u);
  for (const Clip& take : walks) {
    const double before = length_of_ends(take);
    EXPECT_GT(length_of_ends(modified(take, recipe(2.0, 0.0))), 1.15 * before) << take.name;
    EXPECT_LT(length_of_ends(modified(take, recipe(0.0, 0.0))), 0.85 * before) << take.name;
  }
  ASSERT_EQ(waves.size(), 15u);
  int shorter = 0;
  for (const Clip& take : waves) {
    const auto length = [](const Clip& clip) {
      return path_length(clip, LeftWrist) + path_length(clip, RightWrist);
    };
    const double before = length(take);
    EXPECT_GT(length(modified(take, recipe(2.0, 0.0))), 1.15 * before) << take.name;
    const double shortest = length(modified(take, recipe(0.0, 0.0))) / before;
    EXPECT_LT(shortest, 0.9) << take.name;
    shorter += shortest < 0.85;
  }
  EXPECT_GE(shorter, 13);  // most of two slow waves lies below 1 Hz, which keeps its length
}

TEST_F(ModifiedTakes, StandOnTheirFeet) {
  for (const std::vector<Clip>* takes : {&walks, &waves}) {
    for (const Clip& take : *takes) {
      for (const auto& [name, m] : recipes()) {
        const ModifiedClip after = modify(take, m);
        EXPECT_LT(after.report.drift_after_repair, 0.002) << take.name << " " << name;
      }
    }
  }
}

TEST_F(ModifiedTakes, DoNotPop) {
  // Second differences go with the length of paths and the square of speed.
  const std::map<std::string, double> allowed = {{"angry", 4.0}, {"sad", 1.2}, {"tired", 1.2}};
  for (const Clip& take : walks) {
    for (const auto& [name, factor] : allowed) {
      const Clip after = modified(take, recipes()[name]);
      EXPECT_LT(largest_second_difference(after), factor * largest_second_difference(take))
          << take.name << " " << name;
    }
  }
}

TEST_F(ModifiedTakes, LoweringTheHeadLowerItByTheStatedAngle) {
  for (const Clip& take : walks) {
    Modification m = recipe(1.0, 0.0, {{head_flexion, 25.0}});
    const Clip after = modified(take, m);
    for (size_t f = 0; f < take.poses.size(); ++f) {
      const Quat before = world_transforms(take.body, take.poses[f]).rotations[Head];
      const Quat now = world_transforms(take.body, after.poses[f]).rotations[Head];
      EXPECT_NEAR(angle_between(before, now), 25.0 * radians_per_degree, 1e-6) << take.name;
    }
  }
}

TEST_F(ModifiedTakes, MayAlsoBeLoopsInPlace) {
  for (size_t i = 0; i < walks.size(); i += 7) {
    const Clip loop = make_example(walks[i]).clip;
    const Clip still = in_place(loop);
    const ModifiedClip travelled = modify(loop, recipes()["strong"]);
    const ModifiedClip stayed = modify(still, recipes()["strong"]);
    EXPECT_TRUE(stayed.clip.cycle_displacement.isZero());
    EXPECT_LT(stayed.report.drift_after_repair, 0.002) << loop.name;
    EXPECT_NEAR(stayed.report.travel_ratio, travelled.report.travel_ratio, 0.05) << loop.name;
  }
}

TEST(Modification, SaysThatThereAreNoFingersToScale) {
  Modification m = recipe(1.5, 0.0);
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  const auto says = [&] {
    const std::vector<std::string> remarks = modify(clip, m).report.remarks;
    return std::any_of(remarks.begin(), remarks.end(), [](const std::string& remark) {
      return remark.find("the motion has no fingers") == 0;
    });
  };
  EXPECT_FALSE(says());
  m.hands = FingerPaths::scaled;
  EXPECT_TRUE(says());
}

}  // namespace
}  // namespace mien::motion
