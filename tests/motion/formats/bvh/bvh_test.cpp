#include "motion/formats/bvh/bvh.h"

#include <array>
#include <random>

#include <gtest/gtest.h>

#include "motion/formats/format_checks.h"
#include "motion/random_recording.h"
#include "motion/refusal.h"
#include "motion/text/file_contents.h"
#include "motion/text/result_file.h"

#include "real_data.h"

using namespace mien::motion;
using mien::test::random_recording;

namespace {

using mien::test::expect_near;
using mien::test::replaced;
using mien::test::tip_at;

constexpr std::string_view arm_head =
    "HIERARCHY\n"
    "ROOT Upper Arm\n"
    "{\n"
    "  OFFSET 1 2 3\n"
    "  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    "  JOINT Fore:Arm-1\n"
    "  {\n"
    "    OFFSET 0 -2 0\n"
    "    CHANNELS 3 Zrotation Xrotation Yrotation\n"
    "    End Site\n"
    "    {\n"
    "      OFFSET 0 -1 0\n"
    "    }\n"
    "  }\n"
    "}\n";

std::string bvh_arm(std::string_view motion) { return std::string(arm_head) + std::string(motion); }

std::string all_replaced(std::string text, std::string_view from, std::string_view to) {
  for (size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

const std::string arm_motion =
    "MOTION\nFrames: 2\nFrame Time: .0083333\n"
    "0 0 0 0 0 0 0 0 0\n"
    "10 20 30 90 0 0 90 0 0\n";

void expect_same_motion(const Recording& a, const Recording& b) {
  ASSERT_EQ(a.frame_count(), b.frame_count());
  EXPECT_NEAR(mien::test::largest_joint_distance(a, b), 0.0, 1e-12);
  EXPECT_NEAR(mien::test::largest_turn(a, b), 0.0, 1e-7);
}

}  // namespace

TEST(Bvh, PutsJointsWhereForwardKinematicsSays) {
  const Recording recording = parse_bvh(bvh_arm(arm_motion), "some/arm.bvh");
  EXPECT_EQ(recording.name, "arm");
  EXPECT_EQ(recording.format, "bvh");
  EXPECT_EQ(recording.frames_per_second, 120.0);
  ASSERT_EQ(recording.frame_count(), 2);
  ASSERT_EQ(recording.skeleton.size(), 2);
  EXPECT_EQ(recording.skeleton.joints[0].name, "Upper Arm");
  EXPECT_EQ(recording.skeleton.joints[1].name, "Fore:Arm-1");
  EXPECT_EQ(recording.skeleton.joints[1].parent, 0);
  expect_near(tip_at(recording, 0, 1), {0, -3, 0});
  // The upper arm turns -y to +x about z; the forearm then on to +y.
  expect_near(world_positions(recording.skeleton, recording.poses[1])[1], {12, 20, 30});
  expect_near(tip_at(recording, 1, 1), {12, 21, 30});
}

TEST(Bvh, MultipliesRotationsInTheOrderOfTheChannels) {
  std::array<std::string, 3> names = {"Xrotation", "Yrotation", "Zrotation"};
  std::array<int, 3> order = {0, 1, 2};
  const std::array<std::string, 3> written = {"20", "-35", "110"};
  const std::array<double, 3> degrees = {20, -35, 110};
  do {
    std::string text = "HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 3 " + names[size_t(order[0])] +
                       " " + names[size_t(order[1])] + " " + names[size_t(order[2])] +
                       " }\nMOTION\nFrames: 1\nFrame Time: 0.04\n";
    Mat3 expected = Mat3::Identity();
    for (const int axis : order) {
      text += written[size_t(axis)] + " ";
      expected *= Eigen::AngleAxisd(degrees[size_t(axis)] * radians_per_degree, Vec3::Unit(axis))
                      .toRotationMatrix();
    }
    const Recording recording = parse_bvh(text, "a.bvh");
    EXPECT_EQ(recording.frames_per_second, 25.0);
    EXPECT_LT((recording.poses[0].rotations[0].toRotationMatrix() - expected).norm(), 1e-12);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Bvh, LetsPositionChannelsReplaceTheOffsetCoordinateByCoordinate) {
  const Recording recording = parse_bvh(
      "HIERARCHY\nROOT a\n{\nOFFSET 1 2 3\nCHANNELS 2 Yposition Zrotation\n"
      "JOINT b\n{\nOFFSET 4 5 6\nCHANNELS 2 Zposition Xposition\n}\n"
      "JOINT c\n{\nOFFSET 7 8 9\n}\n}\n"
      "MOTION\nFrames: 1\nFrame Time: 0.01\n20 0 60 40\n",
      "a.bvh");
  const Pose& pose = recording.poses[0];
  expect_near(pose.root_position, {1, 20, 3});
  ASSERT_EQ(pose.offsets.size(), 3u);
  expect_near(pose.offsets[1], {40, 5, 60});
  expect_near(pose.offsets[2], {7, 8, 9});
  expect_near(world_positions(recording.skeleton, pose)[1], {41, 25, 63});
}

TEST(Bvh, LeavesARootWithoutPositionChannelsAtItsOffset) {
  const Recording recording = parse_bvh(
      "HIERARCHY\nROOT a\n{\nOFFSET 1 2 3\nCHANNELS 1 Zrotation\n}\n"
      "MOTION\nFrames: 1\nFrame Time: 0.01\n90\n",
      "a.bvh");
  expect_near(recording.poses[0].root_position, {1, 2, 3});
  EXPECT_TRUE(recording.poses[0].offsets.empty());
  EXPECT_FALSE(recording.skeleton.joints[0].tip);
}

TEST(Bvh, ReadsTheSameMotionHoweverTheTextIsLaidOut) {
  const Recording plain = parse_bvh(bvh_arm(arm_motion), "arm.bvh");
  const std::string crlf = all_replaced(bvh_arm(arm_motion), "\n", "\r\n");
  const std::string cr = all_replaced(bvh_arm(arm_motion), "\n", "\r");
  const std::string tabs = all_replaced(bvh_arm(arm_motion), " 0 0", "\t 0\t0\t");
  const std::string scientific = replaced(bvh_arm(arm_motion), "10 20 30", "1e1 +2.0E+01 .3e2");
  const std::string marked = "\xEF\xBB\xBF\n\n" + bvh_arm(arm_motion) + "\n\n \n";
  const std::string shouted = replaced(bvh_arm(arm_motion), "End Site", "END SITE");
  const std::string one_line_heads = all_replaced(bvh_arm(arm_motion), "\n{", " {");
  const std::string packed = all_replaced(bvh_arm(arm_motion), " 0\n    }", " 0}");
  const std::string loose = replaced(bvh_arm(arm_motion), "Frame Time: ", "Frame Time :\t");
  const std::string wrapped = replaced(bvh_arm(arm_motion), "10 20 30", "10\n20 30\n ");
  const std::string one_word = replaced(bvh_arm(arm_motion), "End Site", "EndSite");
  const std::string explained =
      replaced(replaced(bvh_arm(arm_motion), "MOTION", "# of an arm\nMOTION // two frames {"),
               "10 20 30", "# the second\n10 20 30");
  for (const std::string& text : {crlf, cr, tabs, scientific, marked, shouted, one_line_heads,
                                  packed, loose, wrapped, one_word, explained}) {
    const Recording other = parse_bvh(text, "arm.bvh");
    EXPECT_EQ(other.skeleton.joints[0].name, "Upper Arm");
    EXPECT_EQ(other.frames_per_second, 120.0);
    expect_same_motion(plain, other);
    EXPECT_TRUE(other.skeleton.joints[1].tip);
  }
}

TEST(Bvh, KeepsTheSignsOfCommentsInNames) {
  const Recording recording = parse_bvh(
      "HIERARCHY\nROOT Hip #1\n{\nOFFSET 1 2 3 # of the pelvis\nCHANNELS 1 Zrotation\n}\n"
      "MOTION\nFrames: 1\nFrame Time: 0.01\n90\n",
      "a.bvh");
  EXPECT_EQ(recording.skeleton.joints[0].name, "Hip #1");
  expect_near(recording.skeleton.joints[0].offset, {1, 2, 3});
}

TEST(Bvh, TakesNumbersTooSmallForADoubleAsZero) {
  const Recording recording =
      parse_bvh(bvh_arm(replaced(arm_motion, "10 20 30", "1e-400 -1e-400 3")), "arm.bvh");
  expect_near(recording.poses[1].root_position, {0, 0, 3});
}

TEST(Bvh, ReadsSkeletonsNestedAsDeeplyAsItLikes) {
  constexpr int depth = 20000;
  std::string text = "HIERARCHY\nROOT j\n{\nOFFSET 0 0 0\nCHANNELS 1 Zrotation\n";
  for (int i = 1; i < depth; ++i) text += "JOINT j\n{\nOFFSET 1 0 0\n";
  for (int i = 0; i < depth; ++i) text += "}\n";
  text += "MOTION\nFrames: 1\nFrame Time: 0.01\n0\n";
  const Recording recording = parse_bvh(text, "deep.bvh");
  EXPECT_EQ(recording.skeleton.size(), depth);
  EXPECT_EQ(world_positions(recording.skeleton, recording.poses[0]).back().x(), depth - 1);
}

TEST(Bvh, RefusesWhatIsWrongAtItsPlace) {
  struct Case {
    std::string text;
    std::string place;
    std::string words;
  };
  const std::string good = bvh_arm(arm_motion);
  const std::vector<Case> cases = {
      {"", "f.bvh:1:1", "a BVH file starts with HIERARCHY"},
      {"v 1 2 3\n", "f.bvh:1:1", "a BVH file starts with HIERARCHY"},
      {"HIERARCHY\n", "f.bvh:2:1", "expected ROOT, found the end"},
      {"HIERARCHY\nJOINT a\n", "f.bvh:2:1", "expected ROOT, found \"JOINT\""},
      {"HIERARCHY\nROOT\n{\n", "f.bvh:3:1", "ROOT has no name"},
      {"HIERARCHY\nROOT a\nOFFSET 0 0 0\n", "f.bvh:3:1", "expected \"{\" after ROOT \"a\""},
      {replaced(good, "  OFFSET 1 2 3\n", ""), "f.bvh:2:1", "\"Upper Arm\" has no OFFSET"},
      {replaced(good, "1 2 3", "1 2 3\n  OFFSET 1 2 3"), "f.bvh:5:3", "a second OFFSET"},
      {replaced(good, "1 2 3", "1 nan 3"), "f.bvh:4:12", "\"nan\" is not a valid number"},
      {replaced(good, "1 2 3", "1 2"), "f.bvh:5:3", "\"CHANNELS\" is not a valid number"},
      {replaced(good, "1 2 3", "1,5 2 3"), "f.bvh:4:10", "write decimals with a point"},
      {replaced(good, "CHANNELS 6", "CHANNELS 5"), "f.bvh:5:64", "more channels than CHANNELS"},
      {replaced(good, "CHANNELS 3", "CHANNELS 4"), "f.bvh:10:5",
       "expected a channel name, found \"End\""},
      {replaced(good, "CHANNELS 6", "CHANNELS 7"), "f.bvh:5:12", "7 channels on one joint"},
      {replaced(good, "CHANNELS 6", "CHANNELS -1"), "f.bvh:5:12", "\"-1\" is not a valid count"},
      {replaced(good, "CHANNELS 6", "CHANNELS 99999999999"), "f.bvh:5:12", "not a valid count"},
      {replaced(good, "Xrotation", "Xscale"), "f.bvh:5:54", "found \"Xscale\""},
      {replaced(good, "Yposition", "Xposition"), "f.bvh:5:24", "\"Xposition\" appears twice"},
      {replaced(good, "Xrotation", "Zrotation"), "f.bvh:5:54", "\"Zrotation\" appears twice"},
      {replaced(good, "    End Site", "    Middle"), "f.bvh:10:5", "unknown word \"Middle\""},
      {replaced(good, "      OFFSET 0 -1 0\n", ""), "f.bvh:12:5", "End Site holds no OFFSET"},
      {replaced(good, "}\nMOTION", "MOTION"), "f.bvh:15:1", "\"Upper Arm\" is not closed"},
      {replaced(good, "}\nMOTION", "}\n}\nMOTION"), "f.bvh:16:1", "expected MOTION, found \"}\""},
      {std::string(arm_head), "f.bvh:16:1", "expected MOTION, found the end"},
      {std::string(arm_head.substr(0, 200)), "f.bvh:9:45", "is not closed by"},
      {bvh_arm("MOTION\n"), "f.bvh:17:1", "expected \"Frames:\""},
      {replaced(good, "Frames: 2", "Frames: two"), "f.bvh:17:9", "\"two\" is not a valid count"},
      {replaced(good, "Frames: 2", "Frames: 0"), "f.bvh:17:9", "there are no frames"},
      {replaced(good, "Frames: 2", "Frames: 1"), "f.bvh:20:1", "more frames than the 1"},
      {replaced(good, "Frames: 2", "Frames: 3"), "f.bvh:17:9",
       "\"Frames:\" says 3, but the file holds 2"},
      {replaced(good, "Frames: 2", "Frames: 2000000000"), "f.bvh:17:9", "joints are too many"},
      {replaced(good, "Frames: 2", "Frames: 60000000"), "f.bvh:17:9",
       "says 60000000, but the file holds 2"},
      {replaced(good, ".0083333", "0"), "f.bvh:18:13", "a frame time of \"0\" seconds"},
      {replaced(good, ".0083333", "-0.1"), "f.bvh:18:13", "a frame time of \"-0.1\" seconds"},
      {replaced(good, ".0083333", "120"), "f.bvh:18:13", "a frame time of \"120\" seconds"},
      {replaced(good, ".0083333", "120"), "f.bvh:18:13", "0.00833333 for 120 frames per second"},
      {replaced(good, ".0083333", "inf"), "f.bvh:18:13", "\"inf\" is not a valid number"},
      {replaced(good, "10 20 30", "10 20 1e400"), "f.bvh:20:7", "\"1e400\" is not a valid"},
      {replaced(good, "10 20 30", "10 2x 30"), "f.bvh:20:4", "\"2x\" is not a valid number"},
      {replaced(good, "10 20 30", "10 30"), "f.bvh:20:20", "ends after 8 of 9 numbers"},
      {replaced(good, "10 20 30", "10 20 30 40"), "f.bvh:20:25", "more than 9 numbers"},
      {replaced(good, "0 0 0 0 0 0 0 0 0", "0 0 0 0 0 0 0 0"), "f.bvh:19:16",
       "ends after 8 of 9 numbers"},
      {good.substr(0, good.size() - 6), "f.bvh:20:", "the file is truncated"},
  };
  for (const Case& bad : cases) {
    const std::string said = mien::test::refusal_of([&] { parse_bvh(bad.text, "f.bvh"); });
    EXPECT_EQ(said.substr(0, bad.place.size()), bad.place) << said;
    EXPECT_NE(said.find(bad.words), std::string::npos) << said << "\nlacks: " << bad.words;
    EXPECT_NE(said.find("; "), std::string::npos) << "no remedy: " << said;
  }
}

TEST(Bvh, RefusesATextCutShortAnywhere) {
  const std::string good = bvh_arm(arm_motion);
  for (size_t length = 0; length + 2 < good.size(); ++length) {
    EXPECT_THROW(parse_bvh(good.substr(0, length), "f.bvh"), mien::Error) << length;
  }
}

TEST(Bvh, CountsColumnsInCharacters) {
  const std::string said =
      mien::test::refusal_of([] { parse_bvh("HIERARCHY\nROOT 腰 { OFSET", "骨.bvh"); });
  EXPECT_EQ(said.substr(0, said.find(' ')), "骨.bvh:2:10:");
}

TEST(BvhRoundTrip, KeepsRandomMotionsWithinAMillionth) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 40; ++trial) {
    mien::test::RandomRecordingOptions options;
    options.joints = 1 + trial % 25;
    options.unit = trial % 2 == 0 ? 1.0 : 50.0;
    options.moving_offsets = trial % 3 == 0;
    const Recording written = random_recording(random, options);
    const Recording read = parse_bvh(to_bvh(written), "random.bvh");
    ASSERT_EQ(read.skeleton.size(), written.skeleton.size());
    ASSERT_EQ(read.frame_count(), written.frame_count());
    EXPECT_EQ(read.frames_per_second, written.frames_per_second);
    for (size_t j = 0; j < written.skeleton.joints.size(); ++j) {
      const Joint& a = written.skeleton.joints[j];
      const Joint& b = read.skeleton.joints[j];
      EXPECT_EQ(a.name, b.name);
      EXPECT_EQ(a.parent, b.parent);
      expect_near(a.offset, b.offset, 1e-6);
      ASSERT_EQ(a.tip.has_value(), b.tip.has_value());
      if (a.tip) expect_near(*a.tip, *b.tip, 1e-6);
    }
    EXPECT_LT(mien::test::largest_joint_distance(written, read), 1e-6);
    EXPECT_LT(mien::test::largest_turn(written, read), 1e-6);
  }
}

TEST(BvhRoundTrip, KeepsMotionsReadFromAnyOrderOfChannels) {
  std::mt19937_64 random(8);
  std::array<std::string, 6> channels = {"Xposition", "Yposition", "Zposition",
                                         "Xrotation", "Yrotation", "Zrotation"};
  std::uniform_real_distribution<double> value(-180.0, 180.0);
  for (int trial = 0; trial < 30; ++trial) {
    std::string text = "HIERARCHY\n";
    int numbers = 0;
    constexpr int joints = 5;
    for (int j = 0; j < joints; ++j) {
      std::shuffle(channels.begin(), channels.end(), random);
      const int count = std::uniform_int_distribution<int>(j == 0 ? 1 : 0, 6)(random);
      text += (j == 0 ? "ROOT j" : "JOINT j") + std::to_string(j) + " {\nOFFSET 1 2 3\nCHANNELS " +
              std::to_string(count);
      for (int c = 0; c < count; ++c) text += " " + channels[size_t(c)];
      text += "\n";
      numbers += count;
    }
    for (int j = 0; j < joints; ++j) text += "}\n";
    text += "MOTION\nFrames: 10\nFrame Time: 0.02\n";
    for (int f = 0; f < 10; ++f) {
      for (int n = 0; n < numbers; ++n) text += std::to_string(value(random)) + " ";
      text += "\n";
    }
    const Recording first = parse_bvh(text, "first.bvh");
    const Recording second = parse_bvh(to_bvh(first), "second.bvh");
    EXPECT_LT(mien::test::largest_joint_distance(first, second), 1e-6);
    EXPECT_LT(mien::test::largest_turn(first, second), 1e-6);
  }
}

TEST(BvhRoundTrip, KeepsAWholeTurnOfGimbalLock) {
  Recording recording;
  recording.skeleton.joints = {{"a", -1, Vec3::Zero(), std::nullopt}};
  for (int f = 0; f <= 72; ++f) {
    const Quat pitch(Eigen::AngleAxisd(f * 5.0 * radians_per_degree, Vec3::UnitX()));
    recording.poses.push_back({Vec3::Zero(), {pitch}, {}});
  }
  const Recording read = parse_bvh(to_bvh(recording), "turn.bvh");
  EXPECT_LT(mien::test::largest_turn(recording, read), 1e-6);
}

TEST(BvhWriter, WritesTheSameTextAgainFromWhatItWrote) {
  std::mt19937_64 random(9);
  const Recording recording = random_recording(random, {.moving_offsets = true});
  const std::string text = to_bvh(recording);
  EXPECT_EQ(to_bvh(recording), text);
  const std::string again = to_bvh(parse_bvh(text, "random.bvh"));
  EXPECT_EQ(again.substr(0, again.find("MOTION")), text.substr(0, text.find("MOTION")));
}

TEST(BvhWriter, KeepsAnglesContinuousWhenAJointTurnsRoundAndRound) {
  Recording recording;
  recording.skeleton.joints = {{"a", -1, Vec3::Zero(), std::nullopt}};
  for (int f = 0; f < 50; ++f) {
    const Quat spin(Eigen::AngleAxisd(f * 20.0 * radians_per_degree, Vec3::UnitY()));
    recording.poses.push_back({Vec3::Zero(), {spin}, {}});
  }
  const std::string text = to_bvh(recording);
  EXPECT_TRUE(text.ends_with("\n0 0 0 0 0 980\n")) << text.substr(text.size() - 60);
}

TEST(BvhWriter, GivesSixChannelsOnlyToJointsThatMoveOnTheirParents) {
  std::mt19937_64 random(10);
  Recording recording = random_recording(random, {.joints = 3});
  for (Pose& pose : recording.poses) {
    for (const Joint& joint : recording.skeleton.joints) pose.offsets.push_back(joint.offset);
  }
  recording.poses[4].offsets[2].x() += 0.5;
  const std::string text = to_bvh(recording);
  EXPECT_NE(text.find("JOINT joint 1\n\t{\n"), std::string::npos);
  size_t sixes = 0;
  for (size_t at = 0; (at = text.find("CHANNELS 6", at)) != std::string::npos; ++at) ++sixes;
  EXPECT_EQ(sixes, 2u);
  const Recording read = parse_bvh(text, "random.bvh");
  EXPECT_NEAR(read.poses[4].offsets[2].x(), recording.poses[4].offsets[2].x(), 1e-6);
}

TEST(BvhWriter, MakesEveryNameReadable) {
  Recording recording;
  recording.skeleton.joints = {{" a{b}\n", -1, Vec3::Zero(), std::nullopt},
                               {"", 0, Vec3::Zero(), std::nullopt}};
  recording.poses.resize(1);
  recording.poses[0].rotations.resize(2, Quat::Identity());
  const Recording read = parse_bvh(to_bvh(recording), "names.bvh");
  EXPECT_EQ(read.skeleton.joints[0].name, "a_b__");
  EXPECT_EQ(read.skeleton.joints[1].name, "joint_1");
}

TEST(BvhFiles, OfTheRealDataAreReadAndRoundTrip) {
  const auto data = mien::test::real_data();
  if (!data) GTEST_SKIP() << "the real motion capture is not on this machine";
  int files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(*data / "mocap")) {
    if (entry.path().extension() != ".bvh") continue;
    ++files;
    const Recording recording = read_bvh(entry.path());
    EXPECT_TRUE(mien::test::is_sound(recording)) << entry.path();
    if (files % 10 != 1) continue;
    const Recording again = parse_bvh(to_bvh(recording), "again.bvh");
    EXPECT_LT(mien::test::largest_joint_distance(recording, again), 1e-6) << entry.path();
    EXPECT_LT(mien::test::largest_turn(recording, again), 1e-6) << entry.path();
  }
  EXPECT_GT(files, 0);
}

TEST(BvhFiles, GoToDiskAndBack) {
  std::mt19937_64 random(11);
  const Recording recording = random_recording(random);
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "mien_bvh_test.bvh";
  write_result(path, to_bvh(recording));
  EXPECT_EQ(read_contents(path), to_bvh(recording));
  EXPECT_EQ(read_bvh(path).name, "mien_bvh_test");
  std::filesystem::remove(path);
  EXPECT_NE(mien::test::refusal_of([&] { read_bvh(path); }).find("there is no such file"),
            std::string::npos);
}
