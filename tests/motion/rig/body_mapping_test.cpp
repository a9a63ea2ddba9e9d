#include "motion/rig/body_mapping.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "motion/other_rigs.h"
#include "motion/procedural/walker.h"
#include "motion/refusal.h"
#include "motion/skeleton/mirror.h"
#include "motion/skeleton/straighten.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

const double degree = radians_per_degree;

Clip walk() { return synthetic_clip(steady_walk(1.2, 3.0)); }

double largest_distance(const Clip& a, const Clip& b) {
  const auto p = joint_paths(a);
  const auto q = joint_paths(b);
  double largest = 0.0;
  for (size_t t = 0; t < p.size(); ++t) {
    for (int j = 0; j < body_joint_count; ++j) {
      largest = std::max(largest, (p[t][j] - q[t][j]).norm());
    }
  }
  return largest;
}

double largest_turn(const Clip& a, const Clip& b) {
  double largest = 0.0;
  for (size_t t = 0; t < a.poses.size(); ++t) {
    for (int j = 0; j < body_joint_count; ++j) {
      largest = std::max(largest, angle_between(a.poses[t].rotations[j], b.poses[t].rotations[j]));
    }
  }
  return largest;
}

TEST(BodyMapping, OfTheCanonicalBodyChangesNothing) {
  const Clip clip = walk();
  const Recording recording = to_recording(clip);
  const BodyMapping mapping = recognise(recording);
  EXPECT_EQ(mapping.rig, "mien");
  EXPECT_DOUBLE_EQ(mapping.metres_per_unit, 1.0);
  EXPECT_EQ(mapping.up, "+Y");
  EXPECT_GT(mapping.confidence, 0.9);
  EXPECT_TRUE(mapping.warnings.empty());
  const Clip mapped = to_body(recording, mapping);
  EXPECT_LT(largest_turn(clip, mapped), 1e-6);
  EXPECT_LT(largest_distance(clip, mapped), 1e-3);  // but for the floor, which is measured
  EXPECT_NEAR(standing_height(mapped.body), standing_height(clip.body), 1e-9);
}

// Also where a foot that rolls in a short piece looks as if it were posed wrongly.
TEST(BodyMapping, OfAMotionThatWasMappedOnceChangesNothing) {
  std::vector<Recording> recordings = {to_recording(walk()), on_other_rig(walk(), bones_along_x())};
  for (const unsigned seed : {1u, 2u, 3u}) {
    recordings.push_back(on_other_rig(walk(), random_turns(seed)));
    recordings.push_back(scaled(on_other_rig(walk(), random_turns(seed)), 100.0));
  }
  for (const Recording& recording : recordings) {
    for (const int length : {recording.frame_count(), 100, 40, 20}) {
      for (int first = 0; first + length <= recording.frame_count(); first += 37) {
        Recording part = recording;
        part.poses = {recording.poses.begin() + first, recording.poses.begin() + first + length};
        const Clip once = to_body(part);
        const Clip twice = to_body(to_recording(once));
        ASSERT_LT(largest_turn(once, twice), 1e-6) << first << " of " << length;
        ASSERT_LT(largest_distance(once, twice), 1e-4) << first << " of " << length;
      }
    }
  }
}

// Nothing in a piece of a step tells its rolling foot from one that is posed wrongly.
TEST(BodyMapping, OfTheBodyFittedToPointsIsThatBodyBeforeAndAfterItIsWritten) {
  const Clip step = mien::motion::walk({}, 250.0, standard_body()).clip;
  const int length = 30;
  for (int first = 0; first + length <= step.frame_count(); first += 20) {
    Clip piece = step;
    piece.loops = false;
    piece.cycle_displacement = Vec3::Zero();
    piece.poses = {step.poses.begin() + first, step.poses.begin() + first + length};
    Recording written = to_recording(piece);
    const Clip read = to_body(written);
    EXPECT_LT(largest_turn(piece, read), 1e-6) << first;
    Markers markers;
    markers.points = {"LASI"};
    markers.positions.assign(length, Vec3::UnitY());
    markers.seen.assign(length, true);
    markers.filled.assign(length, false);
    written.markers = markers;
    const Clip fitted = to_body(written);
    EXPECT_LT(largest_turn(piece, fitted), 1e-6) << first;
    EXPECT_LT(largest_distance(piece, fitted), 1e-9) << first;
  }
}

TEST(BodyMapping, SeesThroughBonesAlongX) {
  const Clip clip = walk();
  const Clip mapped = to_body(on_other_rig(clip, bones_along_x()));
  EXPECT_LT(largest_distance(clip, mapped), 1e-3);
  EXPECT_LT(largest_turn(clip, mapped), 1.0 * degree);
}

TEST(BodyMapping, SeesThroughAnyJointFrames) {
  const Clip clip = walk();
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Clip mapped = to_body(on_other_rig(clip, random_turns(seed)));
    EXPECT_LT(largest_distance(clip, mapped), 1e-3) << seed;
    // Hand, clavicle and head have no reference of their own; measured by their mean attitude.
    EXPECT_LT(largest_turn(clip, mapped), 25 * degree) << seed;
    for (size_t t = 0; t < clip.poses.size(); t += 10) {
      for (const int j : {Pelvis, Chest, LeftHip, LeftKnee, RightKnee, LeftElbow, RightShoulder}) {
        EXPECT_LT(angle_between(clip.poses[t].rotations[j], mapped.poses[t].rotations[j]),
                  2.0 * degree)
            << seed << " " << name_of(BodyJoint(j));
      }
    }
  }
}

TEST(BodyMapping, DoesNotDependOnUnitOrAxesOrHeading) {
  const Recording recording = on_other_rig(walk(), bones_along_x());
  const Clip reference = straightened(to_body(recording));
  const Quat z_up = about(Vec3::UnitX(), pi / 2);
  const struct {
    Recording recording;
    const char* up;
    double unit;
  } copies[] = {
      {scaled(recording, 100.0), "+Y", 0.01},
      {scaled(recording, 0.45 / 0.0254), "+Y", 0.0254 / 0.45},
      {turned(recording, z_up), "+Z", 1.0},
      {turned(recording, about(Vec3::UnitX(), -pi / 2)), "-Z", 1.0},
      {turned(recording, about(Vec3::UnitZ(), -pi / 2)), "+X", 1.0},
      {turned(recording, about(Vec3::UnitX(), pi)), "-Y", 1.0},
      {turned(recording, about(Vec3::UnitY(), 2.2)), "+Y", 1.0},
      {scaled(turned(turned(recording, about(Vec3::UnitY(), 0.9)), z_up), 1000.0), "+Z", 0.001},
  };
  for (const auto& copy : copies) {
    const BodyMapping mapping = recognise(copy.recording);
    EXPECT_EQ(mapping.up, copy.up);
    EXPECT_NEAR(mapping.metres_per_unit, copy.unit, 1e-12);
    const Clip clip = straightened(to_body(copy.recording, mapping));
    EXPECT_LT(largest_distance(reference, clip), 1e-6) << copy.up << copy.unit;
    EXPECT_LT(largest_turn(reference, clip), 1e-6) << copy.up << copy.unit;
  }
}

TEST(BodyMapping, IsTheSameWithoutNames) {
  for (const FrameTurns& turns : {bones_along_x(), random_turns(3)}) {
    const Recording recording = on_other_rig(walk(), turns);
    const BodyMapping named = recognise(recording);
    const BodyMapping nameless = recognise(without_names(recording));
    EXPECT_EQ(nameless.rig, "by topology");
    EXPECT_LT(nameless.confidence, named.confidence);
    for (int j = 0; j < body_joint_count; ++j) {
      EXPECT_EQ(named.joints[j].group, nameless.joints[j].group) << j;
    }
    EXPECT_LT(largest_distance(to_body(recording, named), to_body(recording, nameless)), 1e-9);
  }
}

TEST(BodyMapping, OfTheMirrorImageExchangesTheSides) {
  const Clip clip = walk();
  const Clip image = mirrored(clip);
  const Clip mapped = to_body(without_names(to_recording(image)));
  EXPECT_LT(largest_distance(image, mapped), 1e-3);
  EXPECT_LT(largest_turn(image, mapped), 1e-5);
}

TEST(BodyMapping, WarnsWhenNamesHaveTheSidesExchanged) {
  Recording recording = to_recording(walk());
  for (Joint& joint : recording.skeleton.joints) {
    if (joint.name.starts_with("Left")) {
      joint.name.replace(0, 4, "Right");
    } else if (joint.name.starts_with("Right")) {
      joint.name.replace(0, 5, "Left");
    }
  }
  const BodyMapping mapping = recognise(recording);
  ASSERT_FALSE(mapping.warnings.empty());
  EXPECT_NE(mapping.warnings[0].find("left and right may be exchanged"), std::string::npos);
}

TEST(BodyMapping, AveragesJointsThatMove) {
  const Clip clip = walk();
  Recording recording = to_recording(clip);
  for (size_t t = 0; t < recording.poses.size(); ++t) {
    Pose& pose = recording.poses[t];
    for (const Joint& joint : recording.skeleton.joints) pose.offsets.push_back(joint.offset);
    pose.offsets[LeftElbow].x() += t % 2 == 0 ? 0.002 : -0.002;
  }
  const BodyMapping mapping = recognise(recording);
  EXPECT_NEAR(mapping.body.joints[LeftElbow].offset.norm(),
              clip.body.joints[LeftElbow].offset.norm(), 1e-4);
  EXPECT_LT(largest_distance(clip, to_body(recording, mapping)), 0.004);
}

TEST(BodyMapping, FillsInMissingToesAndClavicles) {
  const Clip clip = walk();
  const Recording whole = to_recording(clip);
  // Drop toes and clavicles: their children hang on the joints above.
  Recording recording;
  recording.name = "sparse";
  recording.frames_per_second = whole.frames_per_second;
  std::array<int, body_joint_count> place{};
  std::vector<int> kept;
  for (int j = 0; j < body_joint_count; ++j) {
    if (j == LeftClavicle || j == RightClavicle || j == LeftToe || j == RightToe) continue;
    Joint joint = whole.skeleton.joints[j];
    if (j == LeftShoulder || j == RightShoulder) {
      joint.offset += whole.skeleton.joints[j - 1].offset;
      joint.parent = Chest;
    }
    if (joint.parent >= 0) joint.parent = place[joint.parent];
    place[j] = static_cast<int>(kept.size());
    kept.push_back(j);
    recording.skeleton.joints.push_back(joint);
  }
  for (const Pose& pose : whole.poses) {
    Pose sparse;
    sparse.root_position = pose.root_position;
    for (int j : kept) sparse.rotations.push_back(pose.rotations[j]);
    recording.poses.push_back(sparse);
  }
  const BodyMapping mapping = recognise(recording);
  EXPECT_TRUE(is_body(mapping.body));
  ASSERT_EQ(mapping.warnings.size(), 1u);
  EXPECT_NE(mapping.warnings[0].find("LeftClavicle, RightClavicle, LeftToe, RightToe"),
            std::string::npos);
  const Clip mapped = to_body(recording, mapping);
  const auto path = joint_paths(mapped);
  const auto known = joint_paths(clip);
  for (size_t t = 0; t < path.size(); t += 20) {
    EXPECT_NEAR((path[t][LeftWrist] - known[t][LeftWrist]).norm(), 0.0, 0.03);
    EXPECT_NEAR((path[t][LeftAnkle] - known[t][LeftAnkle]).norm(), 0.0, 0.03);
    EXPECT_NEAR((path[t][LeftToe] - path[t][LeftAnkle]).norm(), 0.15, 0.03);
  }
}

TEST(BodyMapping, OfSeveralTakesIsOneForAll) {
  const FrameTurns turns = random_turns(5);
  const std::vector<Recording> takes = {on_other_rig(synthetic_clip(steady_walk(1.2, 2.0)), turns),
                                        on_other_rig(synthetic_clip(steady_walk(0.8, 3.0)), turns)};
  const BodyMapping mapping = recognise(takes);
  for (const Recording& take : takes) EXPECT_NO_THROW(to_body(take, mapping));
  std::vector<Recording> mixed = takes;
  mixed[1] = to_recording(walk());
  mixed[1].name = "stranger";
  EXPECT_NE(refusal_of([&] { recognise(mixed); }).find("stranger: its rig differs from that of"),
            std::string::npos);
}

TEST(BodyMapping, OfWhatIsNoHumanIsRefused) {
  Recording snake;
  snake.name = "snake";
  for (int j = 0; j < 12; ++j) {
    Joint joint;
    joint.parent = j - 1;
    joint.offset = Vec3(0, 0.2, 0);
    snake.skeleton.joints.push_back(joint);
  }
  EXPECT_NE(refusal_of([&] { recognise(snake); }).find("snake: it holds no frames"),
            std::string::npos);
  Pose pose;
  pose.rotations.assign(12, Quat::Identity());
  snake.poses = {pose};
  const std::string refusal = refusal_of([&] { recognise(snake); });
  EXPECT_NE(refusal.find("snake: its 12 joints are not recognised as a human figure"),
            std::string::npos);
  const RigAnalysis drawn = analyse_rig(snake);
  EXPECT_FALSE(drawn.human);
  EXPECT_EQ(drawn.rejection, refusal);
  EXPECT_EQ(drawn.metres_per_unit, 1.0);
  EXPECT_EQ(drawn.up, "+Y");
  ASSERT_EQ(drawn.warnings.size(), 2u);
  EXPECT_NE(drawn.warnings[1].find("shown as it is: unscaled"), std::string::npos);
}

TEST(BodyMapping, KeepsTheTurnsOfAHeadOfAnotherName) {
  Recording recording = to_recording(walk());
  recording.skeleton.joints[Head].name = "Neck1";
  for (Pose& pose : recording.poses) {
    pose.rotations[Head] = about(Vec3::UnitY(), 60 * degree);
  }
  const Clip clip = to_body(recording);
  for (const Pose& pose : clip.poses) {
    EXPECT_NEAR(angle_between(pose.rotations[Head], Quat::Identity()), 60 * degree, 1e-6);
  }
}

TEST(BodyMapping, IsTheSameWhenAnyOneJointHasAnotherName) {
  const Recording recording = on_other_rig(walk(), bones_along_x());
  const BodyMapping named = recognise(recording);
  for (int renamed = 0; renamed < body_joint_count; ++renamed) {
    Recording other = recording;
    other.skeleton.joints[renamed].name = "Thing";
    const BodyMapping mapping = recognise(other);
    for (int j = 0; j < body_joint_count; ++j) {
      EXPECT_EQ(mapping.joints[j].group, named.joints[j].group)
          << name_of(BodyJoint(renamed)) << " for " << name_of(BodyJoint(j));
    }
    EXPECT_LT(largest_distance(to_body(recording, named), to_body(other, mapping)), 1e-9);
  }
}

TEST(BodyMapping, KeepsWhatGltfPromises) {
  // A figure that lies on its back all the time, and one of the size of a doll.
  Recording lying = turned(to_recording(walk()), about(Vec3::UnitX(), -pi / 2));
  EXPECT_EQ(recognise(lying).up, "-Z");
  lying.format = "gltf";
  const BodyMapping mapping = recognise(lying);
  EXPECT_EQ(mapping.up, "+Y");
  EXPECT_EQ(mapping.metres_per_unit, 1.0);
  ASSERT_FALSE(mapping.warnings.empty());
  EXPECT_NE(mapping.warnings[0].find("+Y is up in glTF"), std::string::npos);
  Recording doll = scaled(to_recording(walk()), 0.15);
  doll.format = "gltf";
  EXPECT_EQ(recognise(doll).metres_per_unit, 1.0);
}

TEST(BodyMapping, TellsWhatTheReaderTold) {
  Recording recording = to_recording(walk());
  recording.notes = {"The file holds 2 motions."};
  EXPECT_EQ(recognise(recording).warnings, recording.notes);
}

TEST(BodyMapping, RefusesARecordingOfAnotherRig) {
  const BodyMapping mapping = recognise(to_recording(walk()));
  Recording small = to_recording(walk());
  small.name = "small";
  small.skeleton.joints.resize(4);
  for (Pose& pose : small.poses) pose.rotations.resize(4);
  EXPECT_NE(refusal_of([&] { to_body(small, mapping); }).find("small: its joints differ"),
            std::string::npos);
}

/// Four legs of one length, the trunk level between them, a neck and a head; named as people are.
Recording dog() {
  Recording recording;
  recording.name = "dog";
  recording.format = "bvh";
  recording.frames_per_second = 30.0;
  const auto add = [&](const char* name, int parent, const Vec3& offset) {
    recording.skeleton.joints.push_back({name, parent, offset, std::nullopt});
    return recording.skeleton.size() - 1;
  };
  const int hips = add("Hips", -1, Vec3::Zero());
  const int spine = add("Spine", hips, {0, 0.02, 0.25});
  const int chest = add("Spine1", spine, {0, 0.0, 0.25});
  const int neck = add("Neck", chest, {0, 0.1, 0.1});
  add("Head", neck, {0, 0.12, 0.12});
  for (const std::string side : {"Left", "Right"}) {
    const double x = side == "Left" ? 0.08 : -0.08;
    const int shoulder = add((side + "Arm").c_str(), chest, {x, -0.05, 0.05});
    const int elbow = add((side + "ForeArm").c_str(), shoulder, {0, -0.25, -0.05});
    add((side + "Hand").c_str(), elbow, {0, -0.25, 0.05});
    const int hip = add((side + "UpLeg").c_str(), hips, {x, -0.05, 0});
    const int knee = add((side + "Leg").c_str(), hip, {0, -0.25, 0.05});
    add((side + "Foot").c_str(), knee, {0, -0.25, -0.05});
  }
  for (int t = 0; t < 60; ++t) {
    Pose pose;
    pose.root_position = Vec3(0, 0.55, 0.03 * t);
    pose.rotations.assign(recording.skeleton.joints.size(), Quat::Identity());
    recording.poses.push_back(pose);
  }
  return recording;
}

bool warns_of_all_fours(const BodyMapping& mapping) {
  return std::any_of(
      mapping.warnings.begin(), mapping.warnings.end(),
      [](const std::string& warning) { return warning.find("all fours") != std::string::npos; });
}

TEST(Recognition, WarnsOfFourLegs) {
  const BodyMapping mapping = recognise(dog());
  EXPECT_TRUE(warns_of_all_fours(mapping));
  EXPECT_LE(mapping.confidence, 0.5);
  const Recording human = to_recording(synthetic_clip(steady_walk(1.2, 2.0)));
  EXPECT_FALSE(warns_of_all_fours(recognise(human)));
}

TEST(Recognition, TakesFourLegsWithoutNamesForNoHuman) {
  const Recording animal = without_names(dog());
  EXPECT_NE(refusal_of([&] { recognise(animal); }).find("the shape is that of a quadruped"),
            std::string::npos);
  EXPECT_EQ(analyse_rig(animal).metres_per_unit, 1.0);
}

}  // namespace
}  // namespace mien::motion
