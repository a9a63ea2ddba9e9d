#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/examples/make_example.h"
#include "motion/formats/motion_file.h"
#include "motion/gait/contact.h"
#include "motion/math/rotation.h"
#include "motion/other_rigs.h"
#include "motion/rig/body_mapping.h"
#include "motion/rig/rig_motion.h"
#include "motion/skeleton/floor.h"
#include "motion/sole_heights.h"

#include "real_data.h"

// What the mapping and the gait make of real recordings.

namespace mien::motion {
namespace {

using namespace mien::test;
namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& folder, const std::string& part) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    const bool is_motion = extension == ".bvh" || extension == ".amc";
    if (is_motion && entry.path().filename().string().find(part) != std::string::npos) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

class RealMotion : public testing::Test {
 protected:
  void SetUp() override {
    const auto folder = real_data();
    if (!folder) GTEST_SKIP() << "no motion capture here: set MIEN_DATA to the folder that has it";
    mocap = *folder / "mocap";
  }

  fs::path mocap;
};

/// Distance of the clip's joints to the rig's, whatever was done to the floor.
double largest_error(const Recording& recording, const BodyMapping& mapping, const Clip& clip) {
  const RigMotion rig = rig_motion(recording, mapping.joints, mapping.to_y_up);
  double largest = 0.0;
  for (size_t t = 0; t < clip.poses.size(); ++t) {
    const auto positions = world_positions(clip.body, clip.poses[t]);
    for (int a = 1; a < body_joint_count; ++a) {
      if (!rig.has(BodyJoint(a))) continue;
      const double from_pelvis = (positions[a] - positions[Pelvis]).norm();
      const double known =
          mapping.metres_per_unit *
          (rig.point(rig.frames[t], BodyJoint(a)) - rig.point(rig.frames[t], Pelvis)).norm();
      largest = std::max(largest, std::abs(from_pelvis - known));
    }
  }
  return largest;
}

TEST_F(RealMotion, OfEveryRigIsRecognised) {
  const std::map<std::string, std::string> families = {{"bandai-namco-1", "bandai-namco"},
                                                       {"aalto-two-actors", "optitrack-arena"},
                                                       {"01_01.bvh", "cmu-bvh"},
                                                       {".amc", "acclaim"}};
  int count = 0;
  for (const fs::path& file : files_in(mocap, "")) {
    const Recording recording = read_motion(file);
    const BodyMapping mapping = recognise(recording);
    for (const auto& [part, rig] : families) {
      if (file.string().find(part) != std::string::npos) {
        EXPECT_EQ(mapping.rig, rig) << file;
      }
    }
    EXPECT_GT(mapping.confidence, 0.9) << file;
    EXPECT_EQ(mapping.up, "+Y") << file;
    EXPECT_GT(standing_height(mapping.body), 1.4) << file;
    EXPECT_LT(standing_height(mapping.body), 1.8) << file;
    ++count;
  }
  EXPECT_EQ(count, 73);
}

TEST_F(RealMotion, KeepsItsJointsWhereTheyWere) {
  for (const fs::path& file : files_in(mocap, "")) {
    const Recording recording = read_motion(file);
    const BodyMapping mapping = recognise(recording);
    // CMU rigs have two joints for one in spine and neck; their bones bend between.
    const bool is_cmu = file.string().find("cmu") != std::string::npos;
    EXPECT_LT(largest_error(recording, mapping, to_body(recording, mapping)), is_cmu ? 0.03 : 1e-9)
        << file;
  }
}

TEST_F(RealMotion, IsMappedTheSameWithoutNames) {
  for (const fs::path& file : files_in(mocap, "")) {
    const Recording recording = read_motion(file);
    const BodyMapping named = recognise(recording);
    const BodyMapping nameless = recognise(without_names(recording));
    for (int j = 0; j < body_joint_count; ++j) {
      EXPECT_EQ(named.joints[j].group, nameless.joints[j].group) << file << " " << j;
      EXPECT_EQ(named.joints[j].position, nameless.joints[j].position) << file << " " << j;
    }
  }
}

TEST_F(RealMotion, StandsOnTheFloor) {
  for (const fs::path& file : files_in(mocap, "walk")) {
    const Clip clip = to_body(read_motion(file));
    std::vector<double> heights = test::lowest_sole_heights(clip);
    std::sort(heights.begin(), heights.end());
    // Feet whose markers say that one stands lower than the other sink by that much.
    EXPECT_GT(heights[heights.size() / 50], -0.035) << file;
    EXPECT_LT(heights[heights.size() / 2], 0.05) << file;
  }
}

TEST_F(RealMotion, OfTheThirtyWalksGivesPlausibleCycles) {
  int count = 0;
  for (const fs::path& file : files_in(mocap / "bandai-namco-1", "_walk_")) {
    const PreparedExample prepared = prepare_example(to_body(read_motion(file)));
    ASSERT_TRUE(prepared.cycle) << file;
    EXPECT_GT(prepared.cycle->steadiness, 0.6) << file;
    const std::vector<double>& keys = prepared.example.keytimes;
    ASSERT_EQ(keys.size(), 7u) << file;
    const double period = keys[6];
    const double cadence = 120.0 / period;
    EXPECT_GT(cadence, 55.0) << file;  // sad and tired walks are slow
    EXPECT_LT(cadence, 160.0) << file;
    const double left_stance = keys[4] / period;
    const double right_stance = (period - keys[3] + keys[1]) / period;
    for (const double stance : {left_stance, right_stance}) {
      EXPECT_GT(stance, 0.57) << file;
      EXPECT_LT(stance, 0.78) << file;
    }
    EXPECT_NEAR(left_stance, right_stance, 0.06) << file;
    EXPECT_NEAR(keys[3] / period, 0.5, 0.05) << file;
    const double speed = prepared.example.clip.cycle_displacement.z() / period;
    EXPECT_GT(speed, 0.35) << file;
    EXPECT_LT(speed, 2.0) << file;
    ++count;
  }
  EXPECT_EQ(count, 30);
}

TEST_F(RealMotion, LeadsWithTheLeftFootAtTheFirstKeytime) {
  for (const fs::path& file : files_in(mocap / "bandai-namco-1", "_walk_")) {
    const Example example = make_example(to_body(read_motion(file)));
    const auto at = [&](double seconds) {
      return world_positions(example.clip.body, pose_at(example.clip, seconds));
    };
    const auto left_strike = at(0.0);
    const auto right_strike = at(example.keytimes[3]);
    EXPECT_GT(left_strike[LeftAnkle].z() - left_strike[RightAnkle].z(), 0.2) << file;
    EXPECT_GT(right_strike[RightAnkle].z() - right_strike[LeftAnkle].z(), 0.2) << file;
    EXPECT_GT(left_strike[LeftToe].z() - left_strike[LeftAnkle].z(), 0.05) << file;
    EXPECT_GT(right_strike[RightToe].z() - right_strike[RightAnkle].z(), 0.05) << file;
    for (const auto& p : {left_strike, right_strike}) {
      EXPECT_GT(p[LeftHip].x(), p[RightHip].x()) << file;
      EXPECT_GT(p[LeftShoulder].x(), p[RightShoulder].x()) << file;
      EXPECT_GT(p[Head].y(), p[Pelvis].y() + 0.3) << file;
    }
  }
}

TEST_F(RealMotion, OfBothActorsGivesACycleWalkingLimpingOrRunning) {
  int count = 0;
  for (const fs::path& file : files_in(mocap / "aalto-two-actors", "")) {
    const PreparedExample prepared = prepare_example(to_body(read_motion(file)));
    ASSERT_TRUE(prepared.cycle) << file;
    const std::vector<double>& keys = prepared.example.keytimes;
    ASSERT_EQ(keys.size(), 7u) << file;
    for (size_t k = 1; k < 7; ++k) {
      EXPECT_GE(keys[k] - keys[k - 1], 0.9 / prepared.example.clip.frames_per_second) << file;
    }
    EXPECT_GT(keys[6], 0.6) << file;
    EXPECT_LT(keys[6], 2.5) << file;
    ++count;
  }
  EXPECT_EQ(count, 24);
}

TEST_F(RealMotion, OfTheCmuRunHasFlightPhases) {
  const PreparedExample run = prepare_example(to_body(read_motion(mocap / "cmu" / "02_03.amc")));
  ASSERT_TRUE(run.cycle);
  EXPECT_TRUE(run.cycle->has_flight);
  EXPECT_NEAR(run.example.keytimes[3] / run.example.keytimes[6], 0.5, 0.03);
  EXPECT_NEAR(run.example.clip.cycle_displacement.z() / run.example.keytimes[6], 2.7, 0.2);
}

TEST_F(RealMotion, OfClimbingIsNoGait) {
  EXPECT_FALSE(prepare_example(to_body(read_motion(mocap / "cmu" / "01_01.bvh"))).cycle);
}

TEST_F(RealMotion, OfANamelessCharacterIsFoundByTopology) {
  const Recording recording = read_motion(mocap / ".." / "characters" / "cesium_man.gltf");
  const BodyMapping mapping = recognise(recording);
  EXPECT_EQ(mapping.rig, "by topology");
  EXPECT_EQ(mapping.up, "+Y");
  EXPECT_DOUBLE_EQ(mapping.metres_per_unit, 1.0);
  for (int j = 0; j < body_joint_count; ++j) {
    const bool has = j != LeftClavicle && j != RightClavicle;
    EXPECT_EQ(mapping.joints[j].position >= 0, has) << name_of(BodyJoint(j));
    EXPECT_GT(mapping.joints[j].confidence, has ? 0.75 : -1.0) << name_of(BodyJoint(j));
  }
  const Clip clip = to_body(recording, mapping);
  EXPECT_LT(largest_error(recording, mapping, clip), 1e-4);
  // One cycle of two seconds; knees bend forward, but for the animator's straight stance legs.
  const PreparedExample prepared = prepare_example(clip);
  ASSERT_TRUE(prepared.cycle);
  EXPECT_NEAR(prepared.example.keytimes.back(), 2.0, 0.15);
  EXPECT_NEAR(prepared.example.keytimes[3], 1.0, 0.1);
  double most_bent = 0.0;
  for (const Pose& pose : prepared.example.clip.poses) {
    for (const int knee : {LeftKnee, RightKnee}) {
      EXPECT_GT(log(pose.rotations[knee]).x(), -0.15);
      most_bent = std::max(most_bent, log(pose.rotations[knee]).x());
    }
  }
  EXPECT_GT(most_bent, 1.0);
}

TEST_F(RealMotion, OfTheSecondActorIsLevelled) {
  // The capture volume sloped by 2.6° in all of that actor's takes, and in a fast run of the other,
  // who would hang in the air by 10 cm.
  for (const fs::path& file : files_in(mocap / "aalto-two-actors", "")) {
    const BodyMapping mapping = recognise(read_motion(file));
    const bool levelled = std::any_of(
        mapping.warnings.begin(), mapping.warnings.end(),
        [](const std::string& text) { return text.find("slopes by 2.") != std::string::npos; });
    const std::string name = file.filename().string();
    EXPECT_EQ(levelled, name.starts_with("t_") || name == "k_run_fast_k_run_slow_100_000.bvh")
        << file;
  }
}

TEST_F(RealMotion, OfOneRigIsCalibratedAlike) {
  // Each take by itself: limbs and trunk come out the same, feet to some degrees.
  std::vector<BodyMapping> mappings;
  for (const fs::path& file : files_in(mocap / "bandai-namco-1", "_walk_")) {
    mappings.push_back(recognise(read_motion(file)));
  }
  for (const BodyMapping& mapping : mappings) {
    for (int j = 0; j < body_joint_count; ++j) {
      const bool is_foot = j == LeftAnkle || j == LeftToe || j == RightAnkle || j == RightToe;
      const double difference =
          angle_between(mapping.calibration[j], mappings.front().calibration[j]);
      EXPECT_LT(difference, (is_foot ? 6.0 : 0.5) * radians_per_degree) << name_of(BodyJoint(j));
    }
  }
}

}  // namespace
}  // namespace mien::motion
