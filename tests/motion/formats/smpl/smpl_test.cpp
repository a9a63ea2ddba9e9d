#include "motion/formats/smpl/smpl.h"

#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/formats/smpl/smpl_files.h"
#include "motion/formats/smpl/smpl_joints.h"
#include "motion/refusal.h"
#include "pipeline/temporary_folder.h"

#include "real_data.h"

namespace mien::motion {
namespace {

using namespace mien::test;

bool contains(const std::string& text, std::string_view words) {
  return text.find(words) != std::string::npos;
}

std::vector<double> random_numbers(std::size_t count, double size, unsigned seed = 38) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-size, size);
  std::vector<double> numbers(count);
  for (double& one : numbers) one = number(random);
  return numbers;
}

/// A motion of random rotations, of every angle.
SmplMotion random_motion(std::size_t joints, std::size_t frames = 4) {
  return {joints, random_numbers(3 * frames * joints, 2.5), random_numbers(3 * frames, 3.0, 5),
          frames};
}

Recording recording_of(const std::vector<ZipMember>& members, const ReadOptions& options = {}) {
  return parse_smpl(npz_file(members), "walk_01.npz", options);
}

std::string refusal_of_members(const std::vector<ZipMember>& members,
                               const ReadOptions& options = {}) {
  return refusal_of([&] { recording_of(members, options); });
}

std::vector<ZipMember> without(std::vector<ZipMember> members, std::string_view name) {
  std::erase_if(members, [&](const ZipMember& member) { return member.name == name; });
  return members;
}

std::vector<ZipMember> with(std::vector<ZipMember> members, const ZipMember& member) {
  members = without(std::move(members), member.name);
  members.push_back(member);
  return members;
}

/// Compares with the tree walk of the tests.
void expect_oracle(const Recording& recording, const SmplMotion& motion) {
  std::vector<Vec3> offsets;
  std::vector<int> parents;
  for (const Joint& joint : recording.skeleton.joints) {
    offsets.push_back(joint.offset);
    parents.push_back(joint.parent);
  }
  ASSERT_EQ(recording.poses.size(), motion.frames);
  ASSERT_EQ(offsets.size(), motion.joints);
  for (std::size_t t = 0; t < motion.frames; ++t) {
    std::vector<Vec3> turns;
    for (std::size_t j = 0; j < motion.joints; ++j)
      turns.push_back(Vec3::Map(&motion.poses[3 * (t * motion.joints + j)]));
    const std::vector<Vec3> expected =
        smpl_positions(offsets, parents, turns, Vec3::Map(&motion.trans[3 * t]));
    const std::vector<Vec3> read = world_positions(recording.skeleton, recording.poses[t]);
    for (std::size_t j = 0; j < motion.joints; ++j) {
      EXPECT_LT((read[j] - expected[j]).norm(), 1e-12) << t << " " << j;
      // Positions do not show how the last joint of a limb is turned.
      const Mat3 turn = recording.poses[t].rotations[j].toRotationMatrix();
      EXPECT_LT((turn - rodrigues(turns[j])).norm(), 1e-12) << t << " " << j;
    }
  }
}

TEST(Smpl, JointsHaveTheirNamesAndParents) {
  for (const std::size_t joints : {22U, 24U, 52U, 55U}) {
    const Skeleton skeleton = smpl_skeleton(joints);
    ASSERT_EQ(skeleton.joints.size(), joints);
    EXPECT_TRUE(is_well_formed(skeleton));
    for (std::size_t j = 0; j < 22; ++j) {
      EXPECT_EQ(skeleton.joints[j].name, smpl_names[j]);
      EXPECT_EQ(skeleton.joints[j].parent, smpl_parents[j]);
    }
  }
  const auto named = [](std::size_t joints, std::string_view name) {
    return find_joint(smpl_skeleton(joints), name);
  };
  EXPECT_EQ(named(24, "left_hand"), 22);
  EXPECT_EQ(named(24, "right_hand"), 23);
  EXPECT_EQ(named(52, "left_index1"), 22);
  EXPECT_EQ(named(52, "left_middle1"), 25);
  EXPECT_EQ(named(52, "left_pinky1"), 28);
  EXPECT_EQ(named(52, "left_ring1"), 31);
  EXPECT_EQ(named(52, "left_thumb3"), 36);
  EXPECT_EQ(named(52, "right_index1"), 37);
  EXPECT_EQ(named(52, "right_thumb3"), 51);
  EXPECT_EQ(named(55, "jaw"), 22);
  EXPECT_EQ(named(55, "left_eye"), 23);
  EXPECT_EQ(named(55, "right_eye"), 24);
  EXPECT_EQ(named(55, "left_index1"), 25);
  EXPECT_EQ(named(55, "right_index1"), 40);
}

TEST(Smpl, RestPlacesAreThoseOfTheStandardBody) {
  Pose rest;
  rest.rotations.assign(52, Quat::Identity());
  const std::vector<Vec3> places = world_positions(smpl_skeleton(52), rest);
  rest.rotations.resize(body_joint_count);
  const std::vector<Vec3> body = world_positions(standard_body(), rest);
  for (std::size_t j = 0; j < 22; ++j) {
    if (smpl_to_body[j] >= 0) {
      EXPECT_LT((places[j] - body[static_cast<std::size_t>(smpl_to_body[j])]).norm(), 1e-12) << j;
    }
  }
  for (std::size_t j = 22; j < 37; ++j) {  // fingers, mirrored, palm down, left towards +X
    EXPECT_EQ(places[j].x(), -places[j + 15].x());
    EXPECT_EQ(places[j].z(), places[j + 15].z());
    EXPECT_GT(places[j].x(), places[20].x());
    EXPECT_LT(places[j].x(), places[20].x() + 0.17);
  }
}

TEST(Smpl, EveryLayoutOfPosesIsTurnedAsItSays) {
  for (const std::size_t joints : {22U, 24U, 52U, 55U}) {
    const SmplMotion motion = random_motion(joints);
    const Recording recording = recording_of(amass_members(motion, 120.0));
    EXPECT_EQ(recording.name, "walk_01");
    EXPECT_EQ(recording.format, "smpl");
    EXPECT_EQ(recording.frames_per_second, 120.0);
    expect_oracle(recording, motion);
  }
}

TEST(Smpl, PosesOfThreeDimensionsAndSmallNumbersAreRead) {
  const SmplMotion motion = random_motion(24);
  std::vector<ZipMember> members = amass_members(motion, 60.0);
  members = with(members, {"poses", npy_f8("(4, 24, 3)", motion.poses)});
  expect_oracle(recording_of(members), motion);
  const std::vector<float> floats(motion.poses.begin(), motion.poses.end());
  SmplMotion rounded = motion;
  rounded.poses.assign(floats.begin(), floats.end());
  members = with(members, {"poses", npy_file("'>f4'", "(4, 72)", bytes_of(floats, true))});
  expect_oracle(recording_of(members), rounded);
}

/// Columns of the rotations as an array of its own.
std::string columns(const SmplMotion& motion, std::size_t joint, std::size_t joints) {
  std::vector<double> numbers;
  for (std::size_t t = 0; t < motion.frames; ++t)
    for (std::size_t k = 0; k < 3 * joints; ++k)
      numbers.push_back(motion.poses[3 * (t * motion.joints + joint) + k]);
  return npy_f8(shape_of(motion.frames, 3 * joints), numbers);
}

TEST(Smpl, SeveralArraysArePutTogether) {
  const SmplMotion motion = random_motion(55);
  const std::vector<ZipMember> others = without(amass_members(motion, 30.0), "poses");
  std::vector<ZipMember> amass = others;
  amass.insert(amass.end(), {{"root_orient", columns(motion, 0, 1)},
                             {"pose_body", columns(motion, 1, 21)},
                             {"pose_jaw", columns(motion, 22, 1)},
                             {"pose_eye", columns(motion, 23, 2)},
                             {"pose_hand", columns(motion, 25, 30)}});
  expect_oracle(recording_of(amass), motion);
  std::vector<ZipMember> package = without(others, "trans");  // names of the smplx package
  package.insert(package.end(), {{"transl", npy_f8("(4, 3)", motion.trans)},
                                 {"global_orient", columns(motion, 0, 1)},
                                 {"body_pose", columns(motion, 1, 21)},
                                 {"jaw_pose", columns(motion, 22, 1)},
                                 {"leye_pose", columns(motion, 23, 1)},
                                 {"reye_pose", columns(motion, 24, 1)},
                                 {"left_hand_pose", columns(motion, 25, 15)},
                                 {"right_hand_pose", columns(motion, 40, 15)}});
  expect_oracle(recording_of(package), motion);
  const SmplMotion hands = random_motion(52);
  std::vector<ZipMember> smplh = without(amass_members(hands, 30.0), "poses");
  smplh.insert(smplh.end(), {{"root_orient", columns(hands, 0, 1)},
                             {"pose_body", columns(hands, 1, 21)},
                             {"pose_hand", columns(hands, 22, 30)}});
  expect_oracle(recording_of(smplh), hands);
}

TEST(Smpl, HandsOfPrincipalComponentsAreLeftAtRestAndNoted) {
  const SmplMotion motion = random_motion(22);
  std::vector<ZipMember> members = without(amass_members(motion, 30.0), "poses");
  members.insert(members.end(), {{"global_orient", columns(motion, 0, 1)},
                                 {"body_pose", columns(motion, 1, 21)},
                                 {"left_hand_pose", npy_f8("(4, 6)", std::vector<double>(24))}});
  const Recording recording = recording_of(members);
  expect_oracle(recording, motion);
  EXPECT_TRUE(contains(recording.notes.front(), "\"left_hand_pose\" holds principal components"));
}

TEST(Smpl, BodyAndGenderAreNoted) {
  const Recording recording = recording_of(amass_members(random_motion(52), 30.0));
  ASSERT_EQ(recording.notes.size(), 1u);
  EXPECT_EQ(recording.notes[0],
            "The body is mien's own, 1.75 m tall with its soles: the person's proportions are not "
            "in the file. The file states the gender: female.");
}

TEST(Smpl, TheRateIsNeverGuessed) {
  const std::vector<ZipMember> members =
      without(amass_members(random_motion(52), 30.0), "mocap_framerate");
  EXPECT_EQ(refusal_of_members(members),
            "walk_01.npz: does not state its frame rate; state the rate with fps: "
            "(--recorded-fps on the command line)");
  ReadOptions options;
  options.frames_per_second = 25.0;
  EXPECT_EQ(recording_of(members, options).frames_per_second, 25.0);
  const auto rated = [&](const char* name, double rate) {
    return recording_of(with(members, {name, npy_f8("(1,)", {rate})})).frames_per_second;
  };
  for (const char* name : {"mocap_frame_rate", "fps", "frame_rate", "framerate"})
    EXPECT_EQ(rated(name, 120.0), 120.0);
  EXPECT_EQ(rated("fps", 119.99998), 120.0);
  const std::vector<ZipMember> two =
      with(with(members, {"fps", npy_f8("()", {30})}), {"mocap_framerate", npy_f8("()", {120})});
  EXPECT_TRUE(contains(refusal_of_members(two),
                       "its frame rates contradict each other: "
                       "mocap_framerate is 120 Hz, fps is 30 Hz"));
  EXPECT_EQ(recording_of(two, options).frames_per_second, 25.0);
  for (const char* rate : {"(2,)", "()"}) {
    const bool is_single = rate[1] == ')';
    const std::string array =
        npy_f8(rate, is_single ? std::vector<double>{0} : std::vector<double>{30, 30});
    EXPECT_TRUE(
        contains(refusal_of_members(with(members, {"fps", array})), "which is no frame rate"));
  }
  options.frames_per_second = -1.0;
  EXPECT_TRUE(
      contains(refusal_of_members(members, options), "the given frame rate, -1, is not between"));
}

TEST(Smpl, WithoutTranslationTheFigureStaysInPlace) {
  const Recording recording = recording_of(without(amass_members(random_motion(52), 30), "trans"));
  EXPECT_TRUE(recording.poses[2].root_position.isZero());
  EXPECT_TRUE(contains(recording.notes[0], "stays in place"));
}

TEST(Smpl, WrongShapesAreRefusedByName) {
  const SmplMotion motion = random_motion(52);
  const std::vector<ZipMember> members = amass_members(motion, 30.0);
  const auto refused = [&](const char* name, const char* shape, std::size_t count) {
    return refusal_of_members(with(members, {name, npy_f8(shape, std::vector<double>(count))}));
  };
  EXPECT_TRUE(
      contains(refused("poses", "(4, 51)", 204), "the array \"poses\" has the shape (4, 51)"));
  EXPECT_TRUE(contains(refused("poses", "(4, 24, 3, 3)", 864), "that of rotation matrices"));
  EXPECT_TRUE(contains(refused("poses", "(624,)", 624), "has the shape (624,)"));
  EXPECT_TRUE(contains(refused("poses", "(0, 156)", 0), ""));
  EXPECT_TRUE(
      contains(refused("trans", "(3, 3)", 9), "\"trans\" has the shape (3, 3), not (4, 3)"));
  SmplMotion wrong = motion;
  wrong.poses[156 * 2 + 7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(refusal_of_members(amass_members(wrong, 30.0)),
                       "\"poses\" holds a number in frame 3 that is not finite"));
  EXPECT_TRUE(
      contains(refusal_of_members(without(members, "poses")),
               "holds no SMPL motion: it has neither poses nor root_orient and pose_body, but "
               "trans, betas, gender, mocap_framerate"));
  EXPECT_TRUE(contains(refusal_of_members(with(members, {"poses", npy_file("'|O'", "()", "x")})),
                       "\"poses\" holds Python objects, which are never unpickled"));
}

TEST(Smpl, ObjectsOfARealFileAreRefusedByName) {
  const auto data = real_data();
  if (!data) GTEST_SKIP() << "no real data";
  const std::filesystem::path file = *data / "recordings" / "npz" / "objects_romp.npz";
  EXPECT_TRUE(contains(refusal_of([&] { read_smpl(file); }),
                       "the array \"results\" holds Python objects, which are never unpickled"));
}

TEST(Smpl, MarkersAtTheOriginAreMissing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<ZipMember> members = {
      {"marker_data", npy_f8("(2, 4, 3)", {1, 2, 3, 0, 0, 0, 4,   5, 6, 7, 8, 9,  //
                                           1, 2, 4, 0, 0, 1, nan, 5, 6, 7, 8, 8})},
      {"marker_labels", npy_text({"LFHD", "", "LFHD", "RFHD"}, 4)},
      {"mocap_framerate", npy_f8("()", {120})}};
  const PointRecording read = parse_smpl_markers(npz_file(members), "m.npz");
  EXPECT_EQ(read.points, (std::vector<std::string>{"LFHD", "marker_2", "LFHD 2", "RFHD"}));
  EXPECT_EQ(read.frame_count(), 2);
  EXPECT_EQ(read.seen, (std::vector<bool>{true, false, true, true, true, true, false, true}));
  EXPECT_EQ(read.positions[read.at(1, 0)], Vec3(1, 2, 4));
  EXPECT_EQ(read.positions[read.at(1, 2)], Vec3(0, 0, 0));
  EXPECT_EQ(read.frames_per_second, 120.0);
  EXPECT_EQ(read.metres_per_unit, 0.0);
  EXPECT_TRUE(contains(refusal_of([&] {
                         parse_smpl_markers(npz_file(without(members, "mocap_framerate")), "m.npz");
                       }),
                       "does not state its frame rate"));
  const auto named = [&](const std::vector<std::string>& labels) {
    const auto file = with(members, {"marker_labels", npy_text(labels, 8)});
    return parse_smpl_markers(npz_file(file), "m.npz").points;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(named({"A", "A", "A 2", "A"}), (Names{"A", "A 3", "A 2", "A 4"}));
  EXPECT_EQ(named({"", "marker_1", "", ""}),
            (Names{"marker_1 2", "marker_1", "marker_3", "marker_4"}));
  const auto other = with(members, {"marker_labels", npy_text({"A", "B"}, 1)});
  EXPECT_TRUE(contains(refusal_of([&] { parse_smpl_markers(npz_file(other), "m.npz"); }),
                       "holds 2 names for 4 markers"));
  EXPECT_TRUE(contains(refusal_of([&] { parse_smpl_markers(npz_file({members[2]}), "m.npz"); }),
                       "it has no array marker_data"));
}

TEST(Smpl, MarkersAreATakeOfTheirFile) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "walk.npz";
  const auto written = [&](const std::vector<ZipMember>& members) {
    std::ofstream(file, std::ios::binary) << npz_file(members);
  };
  const std::vector<ZipMember> motion = amass_members(random_motion(52, 2), 60.0);
  written(with(motion, {"marker_data", npy_f8("(2, 1, 3)", {1, 2, 3, 4, 5, 6})}));
  const auto taken = [&](const char* take) {
    ReadOptions options;
    options.take = take;
    return read_file(file, options);
  };
  EXPECT_EQ(std::get<PointRecording>(taken("markers")).positions[1], Vec3(4, 5, 6));
  const Recording body = std::get<Recording>(read_file(file));
  EXPECT_EQ(body.takes, (std::vector<std::string>{"body", "markers"}));
  EXPECT_EQ(body.take, "body");
  EXPECT_EQ(std::get<Recording>(taken("body")).poses.size(), body.poses.size());
  EXPECT_TRUE(contains(refusal_of([&] { taken("feet"); }), "choose body or markers"));
  ReadOptions model;
  model.take = "markers";
  model.body_model = "model.npz";
  EXPECT_TRUE(contains(refusal_of([&] { read_file(file, model); }), "no body model"));
  written(motion);
  EXPECT_TRUE(std::get<Recording>(read_file(file)).takes.empty());
  EXPECT_TRUE(contains(refusal_of([&] { taken("markers"); }), "holds no markers"));
  EXPECT_TRUE(contains(refusal_of([&] { taken("body"); }), "no take"));
}

TEST(Smpl, MotionIsToldFromOtherArrays) {
  EXPECT_TRUE(holds_smpl_motion(npz_file(amass_members(random_motion(52), 30.0)), "a.npz"));
  EXPECT_FALSE(holds_smpl_motion(npz_file({{"joints", npy_f8("(1, 1, 3)", {1, 2, 3})}}), "a.npz"));
}

TEST(Smpl, EveryTruncationAndManyMutationsAreReadOrRefused) {
  const std::string whole = npz_file(amass_members(random_motion(22, 1), 30.0));
  const auto reads = [](const std::string& file) {
    try {
      parse_smpl(file, "a.npz");
      return true;
    } catch (const Error&) {
      return false;
    }
  };
  EXPECT_TRUE(reads(whole));
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(reads(whole.substr(0, size)));
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    std::string changed = whole;
    changed[random() % whole.size()] = static_cast<char>(random());
    reads(changed);
  }
}

}  // namespace
}  // namespace mien::motion
