#include "motion/formats/keypoints/keypoints.h"

#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "motion/refusal.h"
#include "motion/text/excerpt.h"
#include "motion/text/result_file.h"

namespace mien::motion {
namespace {

using mien::test::refusal_of;

ReadOptions at_rate(double rate) {
  ReadOptions options;
  options.frames_per_second = rate;
  return options;
}

void expect_words(const std::string& text, const std::string& words) {
  EXPECT_NE(text.find(words), std::string::npos) << "\"" << words << "\" is not in: " << text;
}

std::string refusal(const std::string& text, const ReadOptions& options = at_rate(30)) {
  return refusal_of([&] { parse_keypoints(text, "walk.json", options); });
}

bool is_noted(const PointRecording& recording, const std::string& words) {
  for (const std::string& note : recording.notes)
    if (note.find(words) != std::string::npos) return true;
  return false;
}

/// A person of OpenPose: point i is at (base + i, i, 2); the nose is missing.
std::string openpose_person(int base, int id = -1, int count = 25) {
  std::string values;
  for (int i = 0; i < count; ++i)
    values += (i > 0 ? "," : "") + std::to_string(base + i) + "," + std::to_string(i) + ",2.0," +
              (i == 0 ? "0" : "0.9");
  return R"({"person_id":[)" + std::to_string(id) + R"(],"pose_keypoints_2d":[1,2,0.5],)" +
         R"("pose_keypoints_3d":[)" + values + "]}";
}

std::string openpose_frame(const std::string& people) {
  return R"({"version":1.3,"people":[)" + people + "]}";
}

TEST(Keypoints, OpenPoseIsRead) {
  const std::string frames = openpose_frame(openpose_person(10)) + "," + openpose_frame("") + "," +
                             openpose_frame(openpose_person(20));
  for (const std::string& text : {"[" + frames + "]", R"({"fps":30,"frames":[)" + frames + "]}"}) {
    const ReadOptions options = text[0] == '[' ? at_rate(30) : ReadOptions{};
    const PointRecording recording = parse_keypoints(text, "a/walk.json", options);
    EXPECT_EQ(recording.name, "walk");
    EXPECT_EQ(recording.format, "openpose");
    EXPECT_EQ(recording.frames_per_second, 30.0);
    ASSERT_EQ(recording.point_count(), 25);
    ASSERT_EQ(recording.frame_count(), 3);
    EXPECT_EQ(recording.points[8], "MidHip");
    EXPECT_EQ(recording.points[24], "RHeel");
    EXPECT_FALSE(recording.seen[recording.at(0, 0)]);
    EXPECT_EQ(recording.positions[recording.at(0, 0)], Vec3::Zero());
    EXPECT_EQ(recording.positions[recording.at(2, 8)], Vec3(28, 8, 2));
    EXPECT_FALSE(recording.seen[recording.at(1, 8)]);
    EXPECT_EQ(recording.metres_per_unit, 0.0);
  }
  EXPECT_EQ(
      parse_keypoints(openpose_frame(openpose_person(1, -1, 18)), "w.json", at_rate(30)).points[8],
      "RHip");
}

TEST(Keypoints, PeopleOfOpenPoseAreKeptApart) {
  const std::string text = "[" +
                           openpose_frame(openpose_person(10, 4) + "," + openpose_person(20, 7)) +
                           "," + openpose_frame(openpose_person(30, 7)) + "]";
  const PointRecording first = parse_keypoints(text, "w.json", at_rate(30));
  EXPECT_EQ(first.subjects, (std::vector<std::string>{"person 4", "person 7"}));
  EXPECT_EQ(first.subject, "person 4");
  EXPECT_FALSE(first.seen[first.at(1, 5)]);
  EXPECT_TRUE(is_noted(first, "2 people"));
  ReadOptions options = at_rate(30);
  options.subject = "2";
  const PointRecording second = parse_keypoints(text, "w.json", options);
  EXPECT_EQ(second.positions[second.at(1, 5)], Vec3(35, 5, 2));
  options.subject = "person 9";
  expect_words(refusal(text, options), "it holds person 4, person 7: choose one of these");
}

TEST(Keypoints, TwoDimensionalKeypointsAreRefused) {
  expect_words(refusal(openpose_frame(R"({"pose_keypoints_2d":[1,2,0.5],"pose_keypoints_3d":[]})")),
               "two-dimensional keypoints only (pose_keypoints_2d)");
  expect_words(refusal(R"([{"image_id":"1.jpg","keypoints":[1,2,0.5],"score":3}])"),
               "two-dimensional keypoints only (keypoints of COCO or AlphaPose)");
  expect_words(refusal(R"([[{"x":1,"y":2},{"x":1,"y":2}]])"), "two-dimensional");
}

/// The 33 landmarks of MediaPipe: landmark i is at (base + i, −i, 0.5).
std::string landmarks(int base) {
  std::string text;
  for (int i = 0; i < 33; ++i)
    text += (i > 0 ? "," : "") + (R"({"x":)" + std::to_string(base + i)) + R"(,"y":)" +
            std::to_string(-i) + R"(,"z":0.5,"visibility":0.9})";
  return "[" + text + "]";
}

TEST(Keypoints, MediaPipeIsReadInItsManyForms) {
  const std::string a = landmarks(0);
  const std::string b = landmarks(100);
  struct Form {
    std::string text;
    std::string unit;
  };
  const std::string world = R"({"timestamp_ms":)";
  const std::vector<Form> forms = {
      {"[" + a + "," + b + "]", ""},
      {"[[" + a + "],[" + b + "]]", ""},
      {R"([{"worldLandmarks":[)" + a + R"(]},{"worldLandmarks":[)" + b + "]}]", "m"},
      {R"({"frames":[{"pose_world_landmarks":)" + a + R"(},{"pose_world_landmarks":)" + b + "}]}",
       "m"},
      {R"([{"landmarks":)" + b + R"(,"world_landmarks":{"landmark":)" + a +
           R"(}},{"world_landmarks":{"landmark":)" + b + "}}]",
       "m"},
      {R"([{"pose_landmarks":)" + a + R"(},{"pose_landmarks":)" + b + "}]", ""}};
  for (const Form& form : forms) {
    SCOPED_TRACE(form.text.substr(0, 60));
    const PointRecording recording = parse_keypoints(form.text, "w.json", at_rate(25));
    EXPECT_EQ(recording.format, "mediapipe");
    ASSERT_EQ(recording.point_count(), 33);
    ASSERT_EQ(recording.frame_count(), 2);
    EXPECT_EQ(recording.points[23], "left_hip");
    EXPECT_EQ(recording.points[32], "right_foot_index");
    EXPECT_EQ(recording.positions[recording.at(1, 23)], Vec3(123, -23, 0.5));
    EXPECT_EQ(recording.unit, form.unit);
    EXPECT_EQ(is_noted(recording, "not to one scale"),
              form.text.starts_with(R"([{"pose_landmarks)"));
  }
}

TEST(Keypoints, FramesStateTimesAndGaps) {
  std::string text = "[";
  for (const int ms : {0, 33, 67, 133})
    text += (ms > 0 ? "," : "") + (R"({"timestamp_ms":)" + std::to_string(ms)) +
            R"(,"world_landmarks":)" + (ms == 33 ? "[]" : landmarks(ms)) + "}";
  const PointRecording recording = parse_keypoints(text + "]", "w.json", {});
  EXPECT_EQ(recording.frames_per_second, 30.0);
  ASSERT_EQ(recording.frame_count(), 5);
  for (int f = 0; f < 5; ++f) EXPECT_EQ(recording.seen[recording.at(f, 0)], f % 2 == 0);
  EXPECT_EQ(recording.positions[recording.at(4, 0)].x(), 133);
}

TEST(Keypoints, LandmarksMayBeMissing) {
  const PointRecording recording = parse_keypoints(
      R"([[{"name":"a","x":1,"y":2,"z":3},{"name":"b","x":NaN,"y":2,"z":3},{"name":"c","x":1,"y":null,"z":3}]])",
      "w.json", at_rate(30));
  EXPECT_EQ(recording.points, (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(recording.seen, (std::vector<bool>{true, false, false}));
}

TEST(Keypoints, OtherNumbersOfPointsNeedNames) {
  const std::string text = "[[[1,2,3],[4,5,6]],[[1,2,3],[4,5,7]]]";
  expect_words(refusal(text), "2 points without names");
  ReadOptions options = at_rate(30);
  options.joints = {"a", "b"};
  const PointRecording recording = parse_keypoints(text, "w.json", options);
  EXPECT_EQ(recording.points, options.joints);
  EXPECT_EQ(recording.positions[recording.at(1, 1)], Vec3(4, 5, 7));
}

TEST(Keypoints, NamesThatDoNotFitAreRefused) {
  ReadOptions options = at_rate(30);
  options.joints = {"a", "b", "c"};
  expect_words(refusal("[[[1,2,3],[4,5,6]]]", options),
               "3 names of points are given, but it holds 2");
}

TEST(Keypoints, FreeMocapIsRead) {
  std::string text = R"({"info":{},"data_by_frame":{)";
  for (int f = 0; f < 12; ++f)
    text += (f > 0 ? "," : "") + ("\"" + std::to_string(f)) +
            R"(":{"timestamps":{"mean":null},"tracked_points":{"body_nose":{"x":)" +
            std::to_string(f) + R"(,"y":2,"z":3},"body_left_hip":{"x":null,"y":null,"z":null}}})";
  const PointRecording recording = parse_keypoints(text + "}}", "w.json", at_rate(30));
  EXPECT_EQ(recording.format, "freemocap");
  EXPECT_EQ(recording.unit, "mm");
  EXPECT_EQ(recording.points, (std::vector<std::string>{"body_left_hip", "body_nose"}));
  ASSERT_EQ(recording.frame_count(), 12);
  for (int f = 0; f < 12; ++f) EXPECT_EQ(recording.positions[recording.at(f, 1)], Vec3(f, 2, 3));
  EXPECT_FALSE(recording.seen[0]);
  expect_words(refusal(text + "}}", {}), "fps:");
  const PointRecording older = parse_keypoints(
      R"({"data_by_frame":{"0":{"body":{"nose":{"x":1,"y":2,"z":3}},"left_hand":{"wrist":{"x":4,"y":5,"z":6}}}}})",
      "w.json", at_rate(30));
  EXPECT_EQ(older.points, (std::vector<std::string>{"nose", "left_hand_wrist"}));
}

TEST(Keypoints, BadFilesAreRefused) {
  expect_words(refusal("[[{\"x\":1,\n\"y\":}]]"),
               "walk.json:2:5: this is not the JSON of keypoints");
  expect_words(refusal("[[{\"x\":NaN,\n\"y\":}]]"),
               "walk.json:2:5: this is not the JSON of keypoints");
  expect_words(refusal("3"), "holds no keypoints");
  expect_words(refusal("[]"), "there are no frames");
  expect_words(refusal("{}"), "nobody is found");
  expect_words(refusal("[[],[]]"), "nobody is found");
  expect_words(refusal(R"([[{"x":"a","y":2,"z":3}]])"), "without names");
  expect_words(refusal(R"([[{"name":"n","x":"a","y":2,"z":3}]])"),
               "frame 1 is not a usable number");
  expect_words(refusal("[" + openpose_frame(openpose_person(1)) + ",{}]"), "frame 2 has no list");
  expect_words(refusal("[" + openpose_frame(openpose_person(1)) + "," +
                       openpose_frame(openpose_person(1, -1, 18)) + "]"),
               "frame 2 has 72 values");
  expect_words(refusal("[" + landmarks(0) + "]", {}), "fps:");
  expect_words(refusal(std::string(100'000, '[')), "nested more than 64 deep");
  expect_words(refusal(R"({"data_by_frame":{"a":{}}})"), "\"a\" is not the number of a frame");
  expect_words(refusal(R"([[{"x":1e999,"y":2,"z":3}]])"), "too large");
  expect_words(refusal(R"({"data_by_frame":{"0":{"body":{"n":{"x":1,"y":2,"z":3}}},)"
                       R"("1":{},"1000000000":{}}})"),
               "far more than the file holds");
}

TEST(Keypoints, FilesAreReadByTheirPath) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / "mien_keypoints.json";
  write_result(file, R"({"fps":25,"frames":[)" + landmarks(0) + "]}");
  EXPECT_EQ(read_keypoints(file).frames_per_second, 25.0);
  write_result(file, "HIERARCHY\n");
  expect_words(refusal_of([&] { read_keypoints(file); }), "BVH");
  std::filesystem::remove(file);
}

TEST(Keypoints, DamagedFilesAreReadOrRefused) {
  const std::string texts[] = {
      "[" + openpose_frame(openpose_person(10, 4)) + "," + openpose_frame("") + "]",
      R"({"fps":30,"frames":[{"t":0,"worldLandmarks":[[{"name":"a","x":1,"y":2,"z":3}]]}]})",
      R"({"data_by_frame":{"0":{"body":{"nose":{"x":1,"y":2,"z":3}}},"1":{"body":{}}}})"};
  std::mt19937 random(38);
  const auto read_anything = [](const std::string& text) {
    for (const ReadOptions& options : {ReadOptions{}, at_rate(30)}) {
      try {
        const PointRecording recording = parse_keypoints(text, "w.json", options);
        ASSERT_EQ(recording.positions.size(), recording.seen.size());
        ASSERT_GT(recording.frame_count(), 0);
      } catch (const Error&) {
      }
    }
  };
  for (const std::string& text : texts) {
    for (std::size_t i = 0; i < text.size(); ++i) read_anything(text.substr(0, i));
    for (int i = 0; i < 200; ++i) {
      std::string changed = text;
      for (int k = 0; k < 2; ++k)
        changed[random() % changed.size()] = "{}[],:\"019.-nx"[random() % 14];
      read_anything(changed);
    }
  }
}

}  // namespace
}  // namespace mien::motion
