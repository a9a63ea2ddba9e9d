#include "motion/formats/gltf/gltf.h"

#include <array>
#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "motion/formats/format_checks.h"
#include "motion/formats/motion_file.h"
#include "motion/gltf_text.h"
#include "motion/random_recording.h"
#include "motion/refusal.h"
#include "motion/rig/body_mapping.h"
#include "motion/text/file_contents.h"
#include "motion/text/result_file.h"

#include "real_data.h"

using namespace mien::motion;
using mien::test::gltf_channel;
using mien::test::gltf_sampler;
using mien::test::gltf_text;
using mien::test::GltfNumbers;

namespace {

using mien::test::replaced;
using mien::test::tip_at;

const float half = static_cast<float>(std::sqrt(0.5));

/// Upper arm and forearm, 2 long, bent by the forearm's rotation about z from 0° to 90° in a
/// second; the shoulder moves from x = 0 to 4.
const std::string arm_nodes =
    R"("nodes":[{"name":"upper","children":[1]},)"
    R"({"name":"fore","translation":[0,2,0],"children":[2]},{"translation":[0,1,0]}],)"
    R"("skins":[{"joints":[1,0]}])";

std::string gltf_arm(const std::string& nodes = arm_nodes, const std::string& kind = "LINEAR") {
  GltfNumbers numbers;
  const int times = numbers.add({0, 1}, "SCALAR");
  const int turns = numbers.add({0, 0, 0, 1, 0, 0, half, half}, "VEC4");
  const int places = numbers.add({0, 0, 0, 4, 0, 0}, "VEC3");
  return gltf_text(numbers, nodes,
                   gltf_channel(0, 1, "rotation") + "," + gltf_channel(1, 0, "translation"),
                   gltf_sampler(times, turns, kind) + "," + gltf_sampler(times, places, kind));
}

void expect_close(const Vec3& a, const Vec3& b, double tolerance = 1e-6) {
  EXPECT_LT((a - b).norm(), tolerance) << a.transpose() << " is not " << b.transpose();
}

/// A single node that a track turns about z; the angles at the frames, degrees.
std::vector<double> angles_of(const GltfNumbers& numbers, const std::string& sampler) {
  const Recording recording =
      parse_gltf(gltf_text(numbers, R"("nodes":[{}])", gltf_channel(0, 0, "rotation"), sampler),
                 "angles.gltf");
  std::vector<double> angles;
  for (const Pose& pose : recording.poses) {
    angles.push_back(log(pose.rotations[0]).z() / radians_per_degree);
  }
  return angles;
}

}  // namespace

TEST(Gltf, PutsJointsWhereForwardKinematicsSays) {
  const Recording recording = parse_gltf(gltf_arm(), "some/arm.gltf");
  EXPECT_EQ(recording.name, "arm");
  EXPECT_EQ(recording.format, "gltf");
  EXPECT_EQ(recording.frames_per_second, 30.0);
  ASSERT_EQ(recording.frame_count(), 31);
  ASSERT_EQ(recording.skeleton.size(), 2);
  EXPECT_EQ(recording.skeleton.joints[0].name, "upper");
  EXPECT_EQ(recording.skeleton.joints[1].parent, 0);
  EXPECT_TRUE(recording.poses[0].offsets.empty());
  expect_close(tip_at(recording, 0, 1), {0, 3, 0});
  // Half way the forearm stands at 45°.
  expect_close(tip_at(recording, 15, 1), {2.0 - half, 2.0 + half, 0});
  expect_close(tip_at(recording, 30, 1), {3, 2, 0});
}

TEST(Gltf, HoldsStepsUntilTheNextKey) {
  const Recording recording = parse_gltf(gltf_arm(arm_nodes, "STEP"), "arm.gltf");
  expect_close(tip_at(recording, 29, 1), {0, 3, 0});
  expect_close(tip_at(recording, 30, 1), {3, 2, 0});
}

TEST(Gltf, FoldsWhatIsAboveTheRootIntoItsPose) {
  // Z up, half size and 10 to the right, as a matrix (column by column) and as TRS.
  const std::string matrix = R"("matrix":[0.5,0,0,0, 0,0,-0.5,0, 0,0.5,0,0, 10,0,0,1])";
  const std::string trs =
      R"("translation":[10,0,0],"rotation":[-0.70710678,0,0,0.70710678],"scale":[0.5,0.5,0.5])";
  for (const std::string& above : {matrix, trs}) {
    const std::string nodes =
        replaced(arm_nodes, R"("nodes":[)", R"("nodes":[{"children":[1],)" + above + "},");
    std::string text = gltf_arm(nodes);
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {R"("upper","children":[1])", R"("upper","children":[2])"},
             {R"([0,2,0],"children":[2])", R"([0,2,0],"children":[3])"},
             {R"("joints":[1,0])", R"("joints":[2,1])"},
             {R"("node":1)", R"("node":2)"},
             {R"("node":0)", R"("node":1)"}}) {
      text = replaced(text, from, to);
    }
    const Recording recording = parse_gltf(text, "arm.gltf");
    ASSERT_EQ(recording.skeleton.size(), 2);
    EXPECT_TRUE(recording.poses[0].offsets.empty());
    // y becomes −z.
    expect_close(tip_at(recording, 0, 1), {10, 0, -1.5});
    expect_close(tip_at(recording, 30, 1), {11.5, 0, -1});
    expect_close(recording.skeleton.joints[1].offset, {0, 1, 0});
  }
}

TEST(Gltf, KeepsPositionsUnderScalesThatDifferByAxis) {
  const std::string nodes =
      replaced(arm_nodes, R"("upper",)", R"("upper","scale":[3,1,1],"rotation":[0,0,0,1],)");
  const Recording recording = parse_gltf(gltf_arm(nodes), "arm.gltf");
  expect_close(tip_at(recording, 0, 1), {0, 3, 0});
  const Vec3 elbow = world_positions(recording.skeleton, recording.poses[30])[1];
  expect_close(elbow, {4, 2, 0});
}

TEST(Gltf, FollowsCubicSplines) {
  // One turn by the formula of appendix C at a quarter of the way; tangents are per second.
  GltfNumbers numbers;
  const int times = numbers.add({0, 2}, "SCALAR");
  const std::vector<float> keys = {0, 0, 0, 1, 2, 3, 0, 4, 0,  // in-tangent, value, out-tangent
                                   0, 2, 0, 5, 6, 7, 0, 0, 0};
  const int places = numbers.add(keys, "VEC3");
  const Recording recording =
      parse_gltf(gltf_text(numbers, R"("nodes":[{}])", gltf_channel(0, 0, "translation"),
                           gltf_sampler(times, places, "CUBICSPLINE")),
                 "spline.gltf");
  ASSERT_EQ(recording.frame_count(), 61);
  expect_close(recording.poses[0].root_position, {1, 2, 3});
  expect_close(recording.poses[60].root_position, {5, 6, 7});
  const double t = 0.25;
  const double start = 2 * t * t * t - 3 * t * t + 1;
  const double leave = 2.0 * (t * t * t - 2 * t * t + t);
  const double arrive = 2.0 * (t * t * t - t * t);
  const Vec3 expected = start * Vec3(1, 2, 3) + (1 - start) * Vec3(5, 6, 7) +
                        leave * Vec3(0, 4, 0) + arrive * Vec3(0, 2, 0);
  expect_close(recording.poses[15].root_position, expected);
}

TEST(Gltf, ReadsNormalisedIntegers) {
  GltfNumbers numbers;
  const int times = numbers.add({0, 0.1f, 0.2f}, "SCALAR");
  const std::vector<std::int16_t> shorts = {0, 0, 0, 32767, 0, 0, 23170, 23170, 0, 0, 32767, 0};
  const std::vector<std::int8_t> bytes = {0, 0, 0, 127, 0, 0, 90, 90, 0, 0, 127, 0};
  const std::vector<std::uint8_t> ubytes = {0, 0, 0, 255, 0, 0, 180, 180, 0, 0, 255, 0};
  const std::vector<std::uint16_t> ushorts = {0, 0, 0, 65535, 0, 0, 46341, 46341, 0, 0, 65535, 0};
  for (const int output :
       {numbers.add(shorts, "VEC4", 5122, true), numbers.add(bytes, "VEC4", 5120, true),
        numbers.add(ubytes, "VEC4", 5121, true), numbers.add(ushorts, "VEC4", 5123, true)}) {
    const std::vector<double> angles = angles_of(numbers, gltf_sampler(times, output, "LINEAR"));
    ASSERT_EQ(angles.size(), 3u);
    EXPECT_NEAR(angles[0], 0.0, 1e-6);
    EXPECT_NEAR(angles[1], 90.0, 1e-3);
    EXPECT_NEAR(std::abs(angles[2]), 180.0, 1e-5);
  }
}

TEST(Gltf, PutsSparseValuesIn) {
  GltfNumbers numbers;
  const int times = numbers.add({0, 0.1f, 0.2f}, "SCALAR");
  const int places = numbers.add({1, 0, 0, 2, 0, 0, 3, 0, 0}, "VEC3");
  numbers.add(std::vector<std::uint16_t>{1}, "SCALAR", 5123, false);
  numbers.add({7, 8, 9}, "VEC3");
  const std::string text = gltf_text(numbers, R"("nodes":[{}])", gltf_channel(0, 0, "translation"),
                                     gltf_sampler(times, places, "LINEAR"));
  const std::string sparse =
      R"("sparse":{"count":1,"indices":{"bufferView":2,"componentType":5123},)"
      R"("values":{"bufferView":3}},"count":3,"type":"VEC3")";
  const Recording recording =
      parse_gltf(replaced(text, R"("count":3,"type":"VEC3")", sparse), "sparse.gltf");
  expect_close(recording.poses[0].root_position, {1, 0, 0});
  expect_close(recording.poses[1].root_position, {7, 8, 9});
  expect_close(recording.poses[2].root_position, {3, 0, 0});
}

TEST(Gltf, TakesTheFrameRateFromEvenKeys) {
  for (const double rate : {24.0, 30.0, 60.0, 120.0, 30000.0 / 1001.0}) {
    GltfNumbers numbers;
    std::vector<float> times;
    std::vector<float> places;
    for (int f = 0; f < 50; ++f) {
      times.push_back(static_cast<float>(1.0 / rate + f / rate));
      places.insert(places.end(), {static_cast<float>(f), 0, 0});
    }
    const int input = numbers.add(times, "SCALAR");
    const Recording recording =
        parse_gltf(gltf_text(numbers, R"("nodes":[{}])", gltf_channel(0, 0, "translation"),
                             gltf_sampler(input, numbers.add(places, "VEC3"), "LINEAR")),
                   "rate.gltf");
    EXPECT_EQ(recording.frames_per_second, rate);
    ASSERT_EQ(recording.frame_count(), 50);
    expect_close(recording.poses[49].root_position, {49, 0, 0}, 1e-3);
  }
}

/// A root with two children, the second with a child of its own; only the first child moves.
std::string tree_that_moves_one(const std::string& more_nodes = "") {
  GltfNumbers numbers;
  const int times = numbers.add({0, 1}, "SCALAR");
  const int turns = numbers.add({0, 0, 0, 1, 0, 0, half, half}, "VEC4");
  const std::string nodes =
      R"("nodes":[{"name":"Hips","translation":[0,1,0],"children":[1,2]},)"
      R"({"name":"LeftArm","translation":[1,0,0]},)"
      R"({"name":"Spine","translation":[0,1,0],"children":[3]},)"
      R"({"name":"Head","translation":[0,1,0],"children":[4]},{"name":"Head_end","translation":[0,0.5,0]})" +
      more_nodes + "]";
  return gltf_text(numbers, nodes, gltf_channel(0, 1, "rotation"),
                   gltf_sampler(times, turns, "LINEAR"));
}

TEST(Gltf, WithoutASkinHasAllNodesOfTheTreeThatMoves) {
  const Recording recording = parse_gltf(tree_that_moves_one(), "tree.gltf");
  ASSERT_EQ(recording.skeleton.size(), 4);
  EXPECT_EQ(recording.skeleton.joints[0].name, "Hips");
  EXPECT_EQ(recording.skeleton.joints[3].name, "Head");
  ASSERT_TRUE(recording.skeleton.joints[3].tip);
  expect_close(*recording.skeleton.joints[3].tip, {0, 0.5, 0});
  expect_close(world_positions(recording.skeleton, recording.poses[0])[3], {0, 3, 0});
  EXPECT_TRUE(recording.notes.empty());
}

TEST(Gltf, LeavesOutNodesThatNothingMovesElsewhere) {
  // Another tree, of a camera and a house, stands still.
  const Recording recording = parse_gltf(
      tree_that_moves_one(R"(,{"name":"house","children":[6]},{"name":"door"})"), "tree.gltf");
  EXPECT_EQ(recording.skeleton.size(), 4);
  EXPECT_TRUE(recording.notes.empty());
}

/// Two figures: "a" of two joints, at rest, and "b" of three joints.
std::string two_figures() {
  const std::string nodes =
      R"("nodes":[{"name":"a","children":[1]},{"name":"a1","translation":[0,1,0]},)"
      R"({"name":"b","children":[3]},{"name":"b1","translation":[0,1,0],"children":[4]},)"
      R"({"name":"b2","translation":[0,1,0]}],)"
      R"("skins":[{"joints":[0,1]},{"joints":[2,3]},{"joints":[3,4]}])";
  GltfNumbers numbers;
  const int times = numbers.add({0, 1}, "SCALAR");
  const int turns = numbers.add({0, 0, 0, 1, 0, 0, half, half}, "VEC4");
  return gltf_text(numbers, nodes, gltf_channel(0, 3, "rotation"),
                   gltf_sampler(times, turns, "LINEAR"));
}

TEST(Gltf, TellsOfASecondFigure) {
  const Recording recording = parse_gltf(two_figures(), "two.gltf");
  // The second and third skin share a joint: one figure, and the larger one.
  ASSERT_EQ(recording.skeleton.size(), 3);
  EXPECT_EQ(recording.skeleton.joints[0].name, "b");
  ASSERT_EQ(recording.notes.size(), 1u);
  EXPECT_EQ(recording.notes[0],
            "The file holds 2 figures (a, b); that of \"b\" is used, because it has the most "
            "joints and no subject was chosen.");
  EXPECT_EQ(recording.subject, "b");
}

TEST(Gltf, ReadsTheFigureThatIsAskedFor) {
  for (const char* wanted : {"a", "1"}) {
    const Recording a = parse_gltf(two_figures(), "two.gltf", std::nullopt, wanted);
    EXPECT_EQ(a.skeleton.size(), 2);
    EXPECT_EQ(a.subjects, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(a.subject, "a");
    EXPECT_TRUE(a.notes.empty());
  }
  const std::string said =
      mien::test::refusal_of([&] { parse_gltf(two_figures(), "two.gltf", std::nullopt, "c"); });
  EXPECT_NE(said.find("there is no subject \"c\"; it holds a, b"), std::string::npos) << said;
}

/// The arm with a second and a third animation, of other lengths; the third has no name.
std::string arm_with_takes() {
  const std::string one = gltf_arm();
  const size_t start = one.find(R"({"channels")");
  const size_t end = one.find("]}]", start) + 2;
  const std::string animation = one.substr(start, end - start);
  const std::string still =
      replaced(animation, R"("node":1,"path":"rotation")", R"("node":0,"path":"rotation")");
  return one.substr(0, start) + R"({"name":"Bend",)" + animation.substr(1) + R"(,{"name":"Sway",)" +
         still.substr(1) + "," + still + one.substr(end);
}

TEST(Gltf, ListsItsTakesAndTakesTheOneThatIsNamed) {
  const std::string text = arm_with_takes();
  const Recording first = parse_gltf(text, "arm.gltf");
  EXPECT_EQ(first.takes, (std::vector<std::string>{"Bend", "Sway", "take 3"}));
  EXPECT_EQ(first.take, "Bend");
  ASSERT_EQ(first.notes.size(), 1u);
  EXPECT_EQ(first.notes[0],
            "The file holds 3 motions (Bend, Sway, take 3); \"Bend\" is used, because no take was "
            "chosen.");
  expect_close(tip_at(first, 30, 1), {3, 2, 0});
  for (const char* name : {"Sway", "take 3"}) {
    const Recording second = parse_gltf(text, "arm.gltf", name);
    EXPECT_EQ(second.take, name);
    EXPECT_TRUE(second.notes.empty());
    expect_close(tip_at(second, 30, 1), {1, 0, 0});
  }
  const std::string said = mien::test::refusal_of([&] { parse_gltf(text, "arm.gltf", "Walk"); });
  EXPECT_EQ(said,
            "arm.gltf: there is no take \"Walk\"; it holds Bend, Sway, take 3: choose "
            "one of these");
  EXPECT_TRUE(parse_gltf(gltf_arm(), "arm.gltf").notes.empty());
}

TEST(Gltf, CallsTakesOfOneNameApart) {
  const Recording recording =
      parse_gltf(replaced(arm_with_takes(), R"("name":"Sway")", R"("name":"Bend")"), "arm.gltf");
  EXPECT_EQ(recording.takes, (std::vector<std::string>{"Bend", "Bend 2", "take 3"}));
}

TEST(GltfRoundTrip, KeepsAnyFrameRateOfAnyNumberOfFrames) {
  std::mt19937_64 random(5);
  for (const double rate : {0.5, 1.0, 4.0, 7.5, 9.0, 10.0, 23.7, 30000.0 / 1001.0, 100.05, 240.0,
                            1000.0, 2000.0, 5000.0}) {
    for (const int frames : {1, 2, 3, 20}) {
      mien::test::RandomRecordingOptions options;
      options.frames = frames;
      Recording written = random_recording(random, options);
      written.frames_per_second = rate;
      const Recording read = parse_gltf(to_glb(written), "rate.glb");
      EXPECT_EQ(read.frames_per_second, rate) << frames;
      EXPECT_EQ(read.frame_count(), frames) << rate;
    }
  }
}

TEST(Gltf, TakesSlowKeysOfARecordingForFrames) {
  GltfNumbers numbers;
  std::vector<float> times;
  std::vector<float> places;
  for (int f = 0; f < 12; ++f) {
    times.push_back(static_cast<float>(0.2 * f));
    places.insert(places.end(), {static_cast<float>(f), 0, 0});
  }
  const int input = numbers.add(times, "SCALAR");
  const int output = numbers.add(places, "VEC3");
  const auto rate_with = [&](const std::string& kind) {
    return parse_gltf(gltf_text(numbers, R"("nodes":[{}])", gltf_channel(0, 0, "translation"),
                                gltf_sampler(input, output, kind)),
                      "slow.gltf")
        .frames_per_second;
  };
  EXPECT_EQ(rate_with("LINEAR"), 5.0);
  // Two keys a second apart are poses that somebody set.
  EXPECT_EQ(parse_gltf(gltf_arm(), "arm.gltf").frames_per_second, 30.0);
}

TEST(Gltf, GivesTheRestPoseWhenThereIsNoAnimation) {
  const std::string text =
      R"({"asset":{"version":"2.0"},)" + replaced(arm_nodes, "[0,2,0]", "[0,5,0]") + "}";
  const Recording recording = parse_gltf(text, "rest.gltf");
  ASSERT_EQ(recording.frame_count(), 1);
  expect_close(tip_at(recording, 0, 1), {0, 6, 0});
}

TEST(Gltf, NamesJointsThatHaveNone) {
  const Recording recording =
      parse_gltf(replaced(gltf_arm(), R"("name":"fore",)", ""), "nameless.gltf");
  EXPECT_EQ(recording.skeleton.joints[0].name, "upper");
  EXPECT_EQ(recording.skeleton.joints[1].name, "joint_1");
}

TEST(Gltf, MovesJointsOnTheirParentsOnlyWhenTheyMove) {
  const Recording recording = parse_gltf(
      replaced(gltf_arm(), R"("node":0,"path":"translation")", R"("node":1,"path":"translation")"),
      "sliding.gltf");
  ASSERT_EQ(recording.poses[0].offsets.size(), 2u);
  expect_close(recording.poses[30].offsets[1], {4, 0, 0});
  expect_close(world_positions(recording.skeleton, recording.poses[15])[1], {2, 0, 0});
}

TEST(Gltf, ReadsBuffersBesideTheFile) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "mien_gltf_test";
  std::filesystem::create_directories(folder);
  const std::array<float, 8> numbers = {0, 1, 0, 0, 0, 3, 0, 0};
  write_result(folder / "a walk.bin", {reinterpret_cast<const char*>(numbers.data()), 32});
  const std::string text =
      R"({"asset":{"version":"2.0"},"nodes":[{}],"buffers":[{"byteLength":32,"uri":"a%20walk.bin"}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":32}],"accessors":[)"
      R"({"bufferView":0,"componentType":5126,"count":2,"type":"SCALAR"},)"
      R"({"bufferView":0,"byteOffset":8,"componentType":5126,"count":2,"type":"VEC3"}],)"
      R"("animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],)"
      R"("samplers":[{"input":0,"output":1}]}]})";
  write_result(folder / "walk.gltf", text);
  const Recording recording = read_motion(folder / "walk.gltf");
  expect_close(recording.poses.back().root_position, {3, 0, 0});
  const std::string said = mien::test::refusal_of([&] { parse_gltf(text, "walk.gltf"); });
  EXPECT_NE(said.find("walk.gltf: its buffers are not in the file"), std::string::npos) << said;
  std::filesystem::remove_all(folder);
}

/// An animation of the first of so many nodes, all roots.
std::string gltf_of_roots(int count) {
  GltfNumbers numbers;
  const int times = numbers.add({0.0f, 1.0f}, "SCALAR");
  const int places = numbers.add({0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f}, "VEC3");
  std::string nodes;
  for (int i = 0; i < count; ++i) nodes += i == 0 ? "{}" : ",{}";
  return R"({"asset":{"version":"2.0"},"nodes":[)" + nodes + "]," + numbers.json() +
         R"(,"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],)"
         R"("samplers":[{"input":)" +
         std::to_string(times) + R"(,"output":)" + std::to_string(places) + "}]}]}";
}

// The square of these numbers would take minutes.
TEST(Gltf, OfManyNodesIsReadInOneGoAndRefusedWhenNoFigureHasAsMany) {
  EXPECT_EQ(parse_gltf(gltf_of_roots(130'000), "f.gltf").skeleton.size(), 1);
  const std::string said =
      mien::test::refusal_of([] { parse_gltf(gltf_of_roots(2'000'000), "f.gltf"); });
  EXPECT_EQ(said, "f.gltf: has more than 131072 nodes; keep the nodes of one figure");
}

TEST(Gltf, RefusesWhatIsWrongNamingTheFile) {
  struct Case {
    std::string text;
    std::string words;
  };
  const std::string good = gltf_arm();
  const std::string loop = replaced(good, R"({"translation":[0,1,0]})", R"({"children":[0]})");
  const std::vector<Case> cases = {
      {"", "f.gltf:1:1: this is not the JSON"},
      {"{\n \"asset\": ]}", "f.gltf:2:11: this is not the JSON"},
      {"[]", "is not a glTF file"},
      {R"({"nodes":[{"scale":[1e999,1,1]}]})", "a number that is too large"},
      {"{}", "is not glTF of version 2"},
      {replaced(good, R"("2.0")", R"("1.0")"), "is not glTF of version 2"},
      {R"({"asset":{"version":"2.0"}})", "neither a skin nor an animation"},
      {std::string(100, '['), "nested more than 64 deep"},
      {"glTF", "not a binary glTF file of version 2"},
      {std::string("glTF\2\0\0\0\x14\0\0\0\xFF\0\0\0JSON", 20), "truncated"},
      {loop, "their own descendants"},
      {replaced(good, R"("children":[2])", R"("children":[7])"), "child that does not exist"},
      {replaced(good, R"("children":[2])", R"("children":[1])"), "node 1 has two parents"},
      {replaced(good, "[0,2,0]", "[0,2]"), "node 1 has a faulty transform"},
      {replaced(good, "[0,2,0]", "[0,2e300,0]"), "node 1 has a faulty transform"},
      {replaced(good, R"({"translation":[0,1,0]})", R"({"rotation":[0,0,0,0]})"),
       "node 2 has a rotation of length zero"},
      {replaced(good, R"("joints":[1,0])", R"("joints":[1,9])"), "joint that does not exist"},
      {replaced(good, R"("upper","children":[1])", R"("upper")"), "joints are not connected"},
      {replaced(good, R"("sampler":0)", R"("sampler":5)"), "a track has no sampler"},
      {replaced(good, R"("node":1)", R"("node":3)"), "a node that does not exist"},
      {replaced(good, R"("node":1,"path":"rotation")", R"("node":0,"path":"translation")"),
       "keys: an accessor of an unsuitable type"},
      {replaced(good, R"("node":0,"path":"translation")", R"("node":1,"path":"rotation")"),
       "two tracks move the same part"},
      {replaced(good, R"("input":0)", R"("input":99)"), "key times: there is no accessor 99"},
      {replaced(good, R"("input":0)", R"("input":1)"),
       "key times: an accessor of an unsuitable type"},
      {replaced(good, "LINEAR", "CURVED"), "an interpolation that glTF does not know"},
      {replaced(good, "LINEAR", "CUBICSPLINE"), "a track has more or fewer values"},
      {replaced(good, R"("bufferView":0)", R"("bufferView":9)"), "there is no buffer view 9"},
      {replaced(good, R"("buffer":0)", R"("buffer":4)"), "there is no buffer 4"},
      {replaced(good, R"("byteOffset":0)", R"("byteOffset":4000)"), "beyond its buffer"},
      {replaced(good, R"("byteLength":8})", R"("byteLength":4})"), "beyond its buffer view"},
      {replaced(good, R"("count":2)", R"("count":4611686018427387905)"), "beyond its buffer view"},
      {replaced(good, R"("bufferView":0,)", ""), "the key times of a track do not increase"},
      {replaced(replaced(good, R"("bufferView":0,)", ""), R"("count":2)", R"("count":99999999)"),
       "too many elements"},
      {replaced(good, R"("componentType":5126)", R"("componentType":5125)"),
       "of an unsuitable type"},
      {replaced(good, R"({"byteLength":64,)", R"({"byteLength":65,)"), "shorter than its"},
      {replaced(good, R"({"byteLength":64,)", R"({)"), "a buffer has no byteLength"},
      {replaced(good, R"("count":2)",
                R"("count":2,"sparse":{"count":1,"indices":{"bufferView":0,"componentType":5123},)"
                R"("values":{"bufferView":77}})"),
       "there is no buffer view 77"},
  };
  for (const Case& bad : cases) {
    const std::string said = mien::test::refusal_of([&] { parse_gltf(bad.text, "f.gltf"); });
    EXPECT_TRUE(said.starts_with("f.gltf:")) << said;
    EXPECT_NE(said.find(bad.words), std::string::npos) << said << "\nlacks: " << bad.words;
    EXPECT_NE(said.find("; "), std::string::npos) << "no remedy: " << said;
  }
}

TEST(Gltf, RefusesNumbersThatNoMotionHas) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  struct Case {
    std::vector<float> times;
    float last;
    std::string words;
  };
  for (const Case& bad : std::vector<Case>{{{0, nan}, 1, "a number that is not finite"},
                                           {{0, 1}, infinite, "a number that is not finite"},
                                           {{0, 1}, 3e38f, "value of a key is too large"},
                                           {{0, 1}, 2e9f, "too far away"},
                                           {{0, 1e9f}, 1, "longer than an hour"},
                                           {{-1, 1}, 1, "begins before zero"},
                                           {{1, 1}, 1, "do not increase"}}) {
    GltfNumbers numbers;
    const int times = numbers.add(bad.times, "SCALAR");
    const int places = numbers.add({0, 0, 0, bad.last, 0, 0}, "VEC3");
    const std::string text =
        gltf_text(numbers, R"("nodes":[{}])", gltf_channel(0, 0, "translation"),
                  gltf_sampler(times, places, "LINEAR"));
    const std::string said = mien::test::refusal_of([&] { parse_gltf(text, "f.gltf"); });
    EXPECT_NE(said.find(bad.words), std::string::npos) << said << "\nlacks: " << bad.words;
  }
}

TEST(Gltf, RefusesScalesThatMultiplyBeyondAllNumbers) {
  std::string nodes;
  for (int node = 0; node < 60; ++node) {
    nodes += R"({"scale":[1e12,1e12,0],"translation":[0,1,0],"children":[)" +
             std::to_string(node + 1) + "]},";
  }
  const std::string text = R"({"asset":{"version":"2.0"},"nodes":[)" + nodes +
                           R"({"translation":[0,1,1]}],"skins":[{"joints":[60]}]})";
  const std::string said = mien::test::refusal_of([&] { parse_gltf(text, "f.gltf"); });
  EXPECT_NE(said.find("too far away"), std::string::npos) << said;
}

TEST(Gltf, RefusesABinaryFileCutShortAnywhere) {
  std::mt19937_64 random(5);
  const std::string good = to_glb(mien::test::random_recording(random, {.joints = 2, .frames = 2}));
  for (size_t length = 0; length < good.size(); length += 7) {
    EXPECT_THROW(parse_gltf(good.substr(0, length), "f.glb"), mien::Error) << length;
  }
}

TEST(GltfRoundTrip, KeepsRandomMotionsWithinAMillionth) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 40; ++trial) {
    mien::test::RandomRecordingOptions options;
    options.joints = 1 + trial % 25;
    options.unit = 0.3;  // about the longest bones of a person, metres
    options.moving_offsets = trial % 3 == 0;
    Recording written = mien::test::random_recording(random, options);
    if (trial % 4 == 1) {  // heads have one beside their jaw and eyes
      for (Joint& joint : written.skeleton.joints) joint.tip = Vec3(0.01 * trial, 0.2, -0.1);
    }
    const Recording read = parse_gltf(to_glb(written), "random.glb");
    ASSERT_EQ(read.skeleton.size(), written.skeleton.size());
    ASSERT_EQ(read.frame_count(), written.frame_count());
    EXPECT_EQ(read.frames_per_second, written.frames_per_second);
    EXPECT_EQ(read.poses[0].offsets.empty(), !options.moving_offsets || options.joints < 4);
    for (size_t j = 0; j < written.skeleton.joints.size(); ++j) {
      const Joint& a = written.skeleton.joints[j];
      const Joint& b = read.skeleton.joints[j];
      EXPECT_EQ(a.name, b.name);
      EXPECT_EQ(a.parent, b.parent);
      expect_close(a.offset, b.offset);
      ASSERT_EQ(a.tip.has_value(), b.tip.has_value());
      if (a.tip) expect_close(*a.tip, *b.tip);
    }
    EXPECT_LT(mien::test::largest_joint_distance(written, read), 1e-6);
    EXPECT_LT(mien::test::largest_turn(written, read), 1e-6);
  }
}

TEST(GltfWriter, WritesTheSameBytesAgain) {
  std::mt19937_64 random(9);
  const Recording recording = mien::test::random_recording(random, {.moving_offsets = true});
  EXPECT_EQ(to_glb(recording), to_glb(recording));
}

TEST(GltfWriter, WritesNamesThatAreNoUtf8) {
  Recording recording;
  recording.skeleton.joints = {{"a\xFF\"b", -1, Vec3::Zero(), std::nullopt}};
  recording.poses = {{Vec3(1, 2, 3), {Quat::Identity()}, {}}};
  const Recording read = parse_gltf(to_glb(recording), "names.glb");
  EXPECT_EQ(read.skeleton.joints[0].name, "a\xEF\xBF\xBD\"b");
  expect_close(read.poses[0].root_position, {1, 2, 3});
}

TEST(GltfFiles, GoToDiskAndBack) {
  std::mt19937_64 random(11);
  const Recording recording = mien::test::random_recording(random);
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "mien_test.glb";
  write_motion(recording, path);
  EXPECT_EQ(read_contents(path), to_glb(recording));
  EXPECT_EQ(read_motion(path).name, "mien_test");
  std::filesystem::remove(path);
}

TEST(GltfFiles, OfARealCharacterIsReadAndRecognised) {
  const auto data = mien::test::real_data();
  if (!data) GTEST_SKIP() << "the real characters are not on this machine";
  const Recording recording = read_motion(*data / "characters" / "cesium_man.gltf");
  ASSERT_TRUE(mien::test::is_sound(recording));
  EXPECT_EQ(recording.skeleton.size(), 19);
  EXPECT_EQ(recording.frames_per_second, 24.0);
  EXPECT_EQ(recording.frame_count(), 49);
  EXPECT_TRUE(recording.poses[0].offsets.empty());
  EXPECT_EQ(recording.skeleton.joints[3].name, "joint_3");
  const BodyMapping mapping = recognise(recording);
  EXPECT_EQ(mapping.rig, "by topology");
  EXPECT_EQ(mapping.up, "+Y");
  EXPECT_EQ(mapping.metres_per_unit, 1.0);
  EXPECT_LT(
      mien::test::largest_joint_distance(recording, parse_gltf(to_glb(recording), "again.glb")),
      2e-6);
}
