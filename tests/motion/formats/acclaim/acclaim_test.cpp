#include "motion/formats/acclaim/acclaim.h"

#include <array>
#include <cctype>

#include <gtest/gtest.h>

#include "motion/formats/format_checks.h"
#include "motion/random_recording.h"
#include "motion/refusal.h"
#include "motion/text/result_file.h"

#include "real_data.h"

using namespace mien::motion;

namespace {

using mien::test::expect_near;
using mien::test::replaced;

const std::string arm_asf =
    "# a hand-made arm\n"
    ":version 1.10\n"
    ":name arm\n"
    ":units\n"
    "  mass 1.0\n"
    "  length 0.0254\n"
    "  angle deg\n"
    ":documentation\n"
    "   free text\n"
    ":root\n"
    "   order TX TY TZ RX RY RZ\n"
    "   axis XYZ\n"
    "   position 0 0 0\n"
    "   orientation 0 0 0\n"
    ":bonedata\n"
    "  begin\n"
    "     id 1\n"
    "     name upper\n"
    "     direction 1 0 0\n"
    "     length 2\n"
    "     axis 0 0 90 XYZ\n"
    "     dof rx ry rz\n"
    "     limits (-160.0 20.0)\n"
    "            (-70.0 70.0)\n"
    "            (-60.0 70.0)\n"
    "  end\n"
    "  begin\n"
    "     id 2\n"
    "     name lower\n"
    "     direction 1 0 0\n"
    "     length 1\n"
    "     axis 0 0 0 XYZ\n"
    "     dof rz\n"
    "  end\n"
    "  begin\n"
    "     id 3\n"
    "     name stiff\n"
    "     direction 0 2 0\n"
    "     length 3\n"
    "     axis 0 0 0 XYZ\n"
    "  end\n"
    ":hierarchy\n"
    "  begin\n"
    "    root upper stiff\n"
    "    upper lower\n"
    "  end\n";

const std::string arm_amc =
    "#!OML:ASF\n"
    ":FULLY-SPECIFIED\n"
    ":DEGREES\n"
    "1\n"
    "root 0 0 0 0 0 0\n"
    "upper 0 0 0\n"
    "lower 0\n"
    "2\n"
    "root 1 2 3 0 0 90\n"
    "upper 90 0 0\n"
    "lower 90\n";

Recording arm(const std::string& amc = arm_amc, const std::string& asf = arm_asf) {
  return parse_amc({amc, "data/arm.amc"}, {asf, "data/arm.asf"});
}

Vec3 tip_of(const Recording& recording, size_t frame, std::string_view name) {
  const auto joint = static_cast<size_t>(find_joint(recording.skeleton, name));
  const JointTransforms world = world_transforms(recording.skeleton, recording.poses[frame]);
  return world.positions[joint] + world.rotations[joint] * *recording.skeleton.joints[joint].tip;
}

}  // namespace

TEST(Acclaim, MakesAJointOfEveryBoneAtTheBonesStart) {
  const Recording recording = arm();
  EXPECT_EQ(recording.name, "arm");
  EXPECT_EQ(recording.format, "amc");
  EXPECT_EQ(recording.frames_per_second, 120.0);
  const std::vector<Joint>& joints = recording.skeleton.joints;
  ASSERT_EQ(joints.size(), 4u);
  EXPECT_EQ(joints[0].name, "root");
  EXPECT_EQ(joints[1].name, "upper");
  EXPECT_EQ(joints[2].name, "lower");
  EXPECT_EQ(joints[2].parent, 1);
  EXPECT_EQ(joints[3].name, "stiff");
  EXPECT_EQ(joints[3].parent, 0);
  expect_near(joints[1].offset, {0, 0, 0});
  expect_near(joints[2].offset, {2, 0, 0});
  EXPECT_FALSE(joints[1].tip);
  expect_near(*joints[2].tip, {1, 0, 0});
  expect_near(*joints[3].tip, {0, 3, 0});
}

TEST(Acclaim, TurnsBonesAboutTheirOwnAxes) {
  const Recording recording = arm();
  ASSERT_EQ(recording.frame_count(), 2);
  expect_near(tip_of(recording, 0, "lower"), {3, 0, 0});
  // The upper bone's x axis is the world's y: 90° about it takes the bone from +x to −z; the lower
  // bone turns about z, within the turned frame, from −z to +y; the root then turns by 90° about z.
  const JointTransforms world = world_transforms(recording.skeleton, recording.poses[1]);
  expect_near(world.positions[2], {1, 2, 1});
  expect_near(tip_of(recording, 1, "lower"), {0, 2, 1});
  expect_near(tip_of(recording, 1, "stiff"), {-2, 2, 3});
}

TEST(Acclaim, AppliesTheFirstListedRotationInnermost) {
  const Recording recording =
      arm(replaced(arm_amc, "root 1 2 3 0 0 90\n", "root 0 0 0 20 -35 110\n"));
  const auto turn = [](double degrees, const Vec3& axis) {
    return Eigen::AngleAxisd(degrees * radians_per_degree, axis).toRotationMatrix();
  };
  const Mat3 expected =
      turn(110, Vec3::UnitZ()) * turn(-35, Vec3::UnitY()) * turn(20, Vec3::UnitX());
  const Mat3 got = recording.poses[1].rotations[0].toRotationMatrix();
  EXPECT_LT((got - expected).norm(), 1e-12);
}

TEST(Acclaim, ReadsTheRootsNumbersInTheOrderTheSkeletonGives) {
  const std::string asf = replaced(arm_asf, "TX TY TZ RX RY RZ", "RZ RY RX TZ TY TX");
  const Recording recording =
      arm(replaced(arm_amc, "root 1 2 3 0 0 90\n", "root 110 -35 20 3 2 1\n"), asf);
  expect_near(recording.poses[1].root_position, {1, 2, 3});
  const auto turn = [](double degrees, const Vec3& axis) {
    return Eigen::AngleAxisd(degrees * radians_per_degree, axis).toRotationMatrix();
  };
  const Mat3 expected =
      turn(20, Vec3::UnitX()) * turn(-35, Vec3::UnitY()) * turn(110, Vec3::UnitZ());
  EXPECT_LT((recording.poses[1].rotations[0].toRotationMatrix() - expected).norm(), 1e-12);
}

TEST(Acclaim, ConvertsToMetresByTheUnitOfTheCmuDatabase) {
  const Recording metres = arm(arm_amc, replaced(arm_asf, "length 0.0254", "length 0.45"));
  const double metre = 0.0254 / 0.45;
  expect_near(metres.skeleton.joints[2].offset, {2 * metre, 0, 0});
  expect_near(metres.poses[1].root_position, Vec3(1, 2, 3) * metre);
  const Recording units = arm(arm_amc, replaced(arm_asf, "length 0.0254", "length 1.0"));
  expect_near(units.poses[1].root_position, {1, 2, 3});
}

TEST(Acclaim, ReadsRadiansInBothFiles) {
  std::string asf = replaced(arm_asf, "angle deg", "angle rad");
  asf = replaced(asf, "axis 0 0 90 XYZ", "axis 0 0 1.5707963267948966 XYZ");
  const std::string amc = replaced(arm_amc, ":DEGREES\n", "");
  const std::string turned = replaced(amc, "upper 90", "upper 1.5707963267948966");
  const Recording radians = arm(replaced(replaced(turned, "lower 90", "lower 1.5707963267948966"),
                                         "0 0 90\n", "0 0 1.5707963267948966\n"),
                                asf);
  expect_near(tip_of(radians, 1, "lower"), tip_of(arm(), 1, "lower"));
}

TEST(Acclaim, TakesTheRateFromTheFileThenTheCallerThenTheDatabase) {
  const std::string rated = replaced(arm_amc, ":DEGREES\n", ":DEGREES\n:SAMPLES-PER-SECOND 60\n");
  const auto rate_of = [](const std::string& amc, std::optional<double> given) {
    return parse_amc({amc, "a.amc"}, {arm_asf, "a.asf"}, given).frames_per_second;
  };
  EXPECT_EQ(rate_of(rated, std::nullopt), 60.0);
  EXPECT_EQ(rate_of(rated, 100.0), 60.0);
  EXPECT_EQ(rate_of(arm_amc, 100.0), 100.0);
  EXPECT_EQ(rate_of(arm_amc, std::nullopt), 120.0);
}

TEST(Acclaim, ReadsFilesWithCarriageReturns) {
  std::string amc;
  for (const char c : arm_amc) amc += c == '\n' ? "\r\n" : std::string(1, c);
  std::string asf;
  for (const char c : arm_asf) asf += c == '\n' ? "\r\n" : std::string(1, c);
  expect_near(tip_of(arm(amc, asf), 1, "lower"), {0, 2, 1});
}

TEST(Acclaim, RefusesWhatIsWrongInTheMotionAtItsPlace) {
  const std::vector<std::array<std::string, 3>> cases = {
      {"", "data/arm.amc:1:1", "there are no frames"},
      {":DEGREES\n", "data/arm.amc:2:1", "there are no frames"},
      {"root 0 0 0 0 0 0\n", "data/arm.amc:1:1", "expected the number of the first frame"},
      {replaced(arm_amc, "lower 90\n", ""), "data/arm.amc:8:1", "frame 2 lacks bone \"lower\""},
      {replaced(arm_amc, "upper 0 0 0\n", ""), "data/arm.amc:4:1", "frame 1 lacks bone \"upper\""},
      {replaced(arm_amc, "lower 0\n", "lower 0\nlower 0\n"), "data/arm.amc:8:1",
       "bone \"lower\" appears twice in frame 1"},
      {replaced(arm_amc, "lower 0\n", "hip 0\nlower 0\n"), "data/arm.amc:7:1",
       "the skeleton has no bone \"hip\""},
      {replaced(arm_amc, "upper 0 0 0", "upper 0 0"), "data/arm.amc:6:10",
       "has 2 numbers, its degrees of freedom are 3"},
      {replaced(arm_amc, "upper 0 0 0", "upper 0 0 0 0"), "data/arm.amc:6:13",
       "has more numbers, its degrees of freedom are 3"},
      {replaced(arm_amc, "upper 0 0 0", "upper 0 nan 0"), "data/arm.amc:6:9",
       "\"nan\" is not a valid number"},
      {replaced(arm_amc, "\n2\n", "\n3\n"), "data/arm.amc:8:1", "frame 3 follows frame 1"},
      {replaced(arm_amc, "\n2\n", "\n99999999999\n"), "data/arm.amc:8:1", "not a valid count"},
      {replaced(arm_amc, "\n2\n", "\n2\n:DEGREES\n"), "data/arm.amc:9:1",
       "\":DEGREES\" appears after the first frame"},
      {replaced(arm_amc, ":DEGREES", ":SAMPLES-PER-SECOND 0"), "data/arm.amc:3:21",
       "samples per second"},
  };
  for (const auto& [text, place, words] : cases) {
    const std::string said = mien::test::refusal_of([&, &amc = text] { arm(amc); });
    EXPECT_EQ(said.substr(0, place.size() + 1), place + ":") << said;
    EXPECT_NE(said.find(words), std::string::npos) << said << "\nlacks: " << words;
  }
}

TEST(Acclaim, SaysOfEveryMotionThatEndsWithinAWordThatItIsTruncated) {
  const std::string amc = replaced(arm_amc, "lower 90", "lower -0.9e2");
  size_t refused = 0;
  for (size_t size = amc.find("upper") + 1; size < amc.size(); ++size) {
    const std::string cut = amc.substr(0, size);
    if (std::isspace(static_cast<unsigned char>(cut.back())) != 0) continue;
    try {
      arm(cut);  // what is left of the last number may be one
    } catch (const mien::Error& error) {
      ++refused;
      EXPECT_NE(std::string(error.what()).find("truncated"), std::string::npos) << cut << "\n"
                                                                                << error.what();
    }
  }
  EXPECT_GT(refused, 20u);
}

TEST(Acclaim, RefusesWhatIsWrongInTheSkeletonAtItsPlace) {
  const std::vector<std::array<std::string, 3>> cases = {
      {"", "data/arm.asf:1:1", "there is no :hierarchy"},
      {"HIERARCHY\n", "data/arm.asf:1:1", "expected a section"},
      {arm_asf.substr(0, arm_asf.find(":hierarchy")), "data/arm.asf:42:1", "no :hierarchy"},
      {replaced(arm_asf, "length 0.0254", "length 0"), "data/arm.asf:6:3", "is not positive"},
      {replaced(arm_asf, "angle deg", "angle gon"), "data/arm.asf:7:9", "\"gon\""},
      {replaced(arm_asf, "RX RY RZ", "RX RY RQ"), "data/arm.asf:11:25", "\"RQ\" is not a usable"},
      {replaced(arm_asf, "axis XYZ", "axis XXZ"), "data/arm.asf:12:9", "not an order of axes"},
      {replaced(arm_asf, "     name upper\n", ""), "data/arm.asf:16:3", "has no name"},
      {replaced(arm_asf, "name lower", "name upper"), "data/arm.asf:27:3",
       "a second bone named \"upper\""},
      {replaced(arm_asf, "name lower", "name root"), "data/arm.asf:27:3", "a second bone named"},
      {replaced(arm_asf, "     length 2\n", ""), "data/arm.asf:16:3",
       "lacks its direction, length or axis"},
      {replaced(arm_asf, "direction 1 0 0", "direction 0 0 0"), "data/arm.asf:16:3",
       "has no direction"},
      {replaced(arm_asf, "direction 1 0 0", "direction 1 0"), "data/arm.asf:19:19",
       "expected a number"},
      {replaced(arm_asf, "dof rz", "dof tx rz"), "data/arm.asf:33:6", "moves on its parent"},
      {replaced(arm_asf, "dof rz", "dof rz l"), "data/arm.asf:33:13", "\"l\" is not a usable"},
      {replaced(arm_asf, "  end\n:hierarchy", ":hierarchy"), "data/arm.asf:35:3",
       "this bone has no end"},
      {replaced(arm_asf, "upper lower\n", "upper hand\n"), "data/arm.asf:45:11",
       "there is no bone \"hand\""},
      {replaced(arm_asf, "upper lower\n", "stiff upper\n"), "data/arm.asf:45:11",
       "\"upper\" has a second parent"},
      {replaced(arm_asf, "upper lower\n", "\n"), "data/arm.asf:27:3",
       "\"lower\" is not connected to the root"},
      {replaced(arm_asf, "upper lower\n", "lower lower\n"), "data/arm.asf:27:3",
       "\"lower\" is not connected to the root"},
      {replaced(arm_asf, "upper lower\n", "upper root\n"), "data/arm.asf:45:11",
       "\"root\" has a second parent"},
  };
  for (const auto& [text, place, words] : cases) {
    const std::string said = mien::test::refusal_of([&, &asf = text] { arm(arm_amc, asf); });
    EXPECT_EQ(said.substr(0, place.size() + 1), place + ":") << said;
    EXPECT_NE(said.find(words), std::string::npos) << said << "\nlacks: " << words;
  }
}

TEST(Acclaim, SaysThatASkeletonOfAnotherNameWasTaken) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "mien_foreign_asf_test";
  std::filesystem::create_directories(folder);
  write_result(folder / "02_01.amc", arm_amc);
  write_result(folder / "stranger.asf", arm_asf);
  const Recording foreign = read_amc(folder / "02_01.amc");
  ASSERT_EQ(foreign.notes.size(), 1u);
  EXPECT_NE(foreign.notes[0].find("The skeleton is that of stranger.asf"), std::string::npos);
  std::filesystem::rename(folder / "stranger.asf", folder / "02.asf");
  EXPECT_TRUE(read_amc(folder / "02_01.amc").notes.empty());
  std::filesystem::remove_all(folder);
}

TEST(Acclaim, FindsTheSkeletonOfAMotion) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "mien_acclaim_test";
  fs::remove_all(folder);
  fs::create_directories(folder);
  write_result(folder / "02_01.amc", arm_amc);
  const auto refusal = [&] {
    return mien::test::refusal_of([&] { read_amc(folder / "02_01.amc"); });
  };
  EXPECT_NE(refusal().find("there is no skeleton (.asf) beside this motion"), std::string::npos);
  write_result(folder / "any.ASF", arm_asf);
  EXPECT_EQ(find_asf(folder / "02_01.amc"), folder / "any.ASF");
  EXPECT_EQ(read_amc(folder / "02_01.amc").frame_count(), 2);
  write_result(folder / "other.asf", "");
  EXPECT_NE(refusal().find("several skeletons"), std::string::npos);
  EXPECT_EQ(read_amc(folder / "02_01.amc", {.skeleton = folder / "any.ASF"}).frame_count(), 2);
  write_result(folder / "02_01.asf", "");
  EXPECT_EQ(find_asf(folder / "02_01.amc"), folder / "02_01.asf");
  write_result(folder / "02.asf", arm_asf);
  EXPECT_EQ(find_asf(folder / "02_01.amc"), folder / "02.asf");
  fs::remove_all(folder);
}

TEST(Acclaim, WalkersOfTheCmuDatabaseStandUprightInMetres) {
  const auto data = mien::test::real_data();
  if (!data) GTEST_SKIP() << "the real motion capture is not on this machine";
  for (const char* name : {"02_01.amc", "02_02.amc", "02_03.amc"}) {
    const Recording recording = read_amc(*data / "mocap" / "cmu" / name);
    ASSERT_TRUE(mien::test::is_sound(recording)) << name;
    for (size_t f = 0; f < recording.poses.size(); f += 20) {
      const std::vector<Vec3> at = world_positions(recording.skeleton, recording.poses[f]);
      const auto height = [&](std::string_view joint) {
        return at[static_cast<size_t>(find_joint(recording.skeleton, joint))].y();
      };
      const double floor = std::min(height("ltoes"), height("rtoes"));
      EXPECT_GT(height("head") - floor, 1.3) << name << " frame " << f;
      EXPECT_LT(height("head") - floor, 1.8) << name << " frame " << f;
      EXPECT_GT(height("root") - height("ltibia"), 0.2) << name << " frame " << f;
      EXPECT_GT(height("root") - height("rtibia"), 0.2) << name << " frame " << f;
    }
  }
}
