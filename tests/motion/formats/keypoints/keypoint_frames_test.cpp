#include "motion/formats/keypoints/keypoint_frames.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/examples/example_set.h"
#include "motion/formats/keypoints/keypoints.h"
#include "motion/formats/motion_file.h"
#include "motion/refusal.h"
#include "motion/text/compressed_file.h"
#include "motion/text/frame_file_name.h"
#include "motion/text/result_file.h"
#include "pipeline/temporary_folder.h"

namespace mien::motion {
namespace {

std::string name_of(const std::string& recording, int number) {
  char text[64];
  std::snprintf(text, sizeof text, "_%012d_keypoints.json", number);
  return recording + text;
}

/// A person all of whose 25 points are at x = `metres`; nobody if it is negative.
std::string frame_at(double metres) {
  std::string text = R"({"version":1.3,"people":[)";
  if (metres >= 0.0) {
    text += R"({"person_id":[-1],"pose_keypoints_2d":[],"pose_keypoints_3d":[)";
    for (int i = 0; i < 25; ++i)
      text += (i == 0 ? "" : ",") + std::to_string(metres) + "," + std::to_string(i) + ",3,0.9";
    text += "]}";
  }
  return text + "]}";
}

class KeypointFrames : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    write_result(folder_.path() / name, text);
  }
  PointRecording read(const std::filesystem::path& path) {
    ReadOptions options;
    options.frames_per_second = 50.0;
    return std::get<PointRecording>(read_file(path, options));
  }
  std::string refusal(const std::filesystem::path& path) {
    return test::refusal_of([&] { read(path); });
  }

  test::TemporaryFolder folder_;
};

bool has(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(FrameFileNames, AreThoseOfOpenPose) {
  EXPECT_EQ(frame_file_name("a/walk_01_000000000012_keypoints.json"),
            (FrameFileName{"walk_01", 12}));
  EXPECT_EQ(frame_file_name("walk_000000000012_keypoints.json.gz"), (FrameFileName{"walk", 12}));
  for (const char* other :
       {"walk_12_keypoints.json", "_000000000012_keypoints.json", "walk_000000000012.json",
        "walk000000000012_keypoints.json", "walk_0000000000x2_keypoints.json", "_keypoints.json"})
    EXPECT_FALSE(frame_file_name(other)) << other;
  EXPECT_EQ(recording_name("a/walk_000000000012_keypoints.json"), "walk");
}

TEST_F(KeypointFrames, OfAFolderAreOneRecording) {
  for (const int number : {7, 5, 10, 6}) write(name_of("walk", number), frame_at(number));
  write("notes.txt", "by Ann");
  write("._" + name_of("walk", 4), "hidden");
  const PointRecording recording = read(folder_.path());
  EXPECT_EQ(recording.name, "walk");
  EXPECT_EQ(recording.frames_per_second, 50.0);
  ASSERT_EQ(recording.frame_count(), 6);
  for (const int frame : {0, 1, 2, 5}) {
    EXPECT_TRUE(recording.seen[recording.at(frame, 3)]);
    EXPECT_EQ(recording.positions[recording.at(frame, 3)], Vec3(frame + 5, 3, 3));
  }
  for (const int frame : {3, 4}) EXPECT_FALSE(recording.seen[recording.at(frame, 3)]);
  EXPECT_TRUE(std::ranges::any_of(recording.notes, [](const std::string& note) {
    return has(note, "2 of 6 frames have no file; they are gaps");
  }));
}

TEST_F(KeypointFrames, AreAllReadWhenOneIsNamed) {
  for (const int number : {0, 1, 2}) write(name_of("walk", number), frame_at(number));
  write(name_of("run", 0), frame_at(9));
  const PointRecording recording = read(folder_.path() / name_of("walk", 1));
  EXPECT_EQ(recording.frame_count(), 3);
  EXPECT_EQ(recording.positions[recording.at(2, 0)].x(), 2.0);
  ASSERT_FALSE(recording.notes.empty());
  EXPECT_EQ(recording.notes.back(),
            "The file is one of the 3 frames of \"walk\"; all those in the folder \"" +
                folder_.path().filename().string() + "\" are read.");
  EXPECT_TRUE(has(refusal(folder_.path()), "holds the frames of 2 recordings: run, walk; name"))
      << refusal(folder_.path());
}

// Manifests and folders of examples keep the first frame for the folder that holds it.
TEST_F(KeypointFrames, OfAFolderAreNotAnnouncedAsThoseOfAFile) {
  for (const int number : {3, 4, 5}) write(name_of("walk", number), frame_at(number));
  EXPECT_EQ(read(folder_.path()).notes, std::vector<std::string>());
  EXPECT_EQ(read(only_keypoint_recording(folder_.path())).notes, std::vector<std::string>());
  EXPECT_EQ(read(folder_.path() / name_of("walk", 4)).notes.size(), 1u);
}

TEST_F(KeypointFrames, InWhichNobodyIsFoundAreGaps) {
  write(name_of("walk", 0), frame_at(-1));
  write(name_of("walk", 1), frame_at(1));
  const PointRecording recording = read(folder_.path());
  EXPECT_EQ(recording.frame_count(), 2);
  EXPECT_FALSE(recording.seen[recording.at(0, 0)]);
  EXPECT_TRUE(recording.seen[recording.at(1, 0)]);
}

TEST_F(KeypointFrames, AreRefusedWithTheirFile) {
  EXPECT_TRUE(has(refusal(folder_.path()), "is a folder; name a motion file in it"));
  EXPECT_TRUE(has(refusal(folder_.path() / name_of("walk", 1)), "there is no such file"));
  write(name_of("walk", 0), frame_at(0));
  write(name_of("walk", 1), "{\"people\":");
  EXPECT_TRUE(has(refusal(folder_.path()), name_of("walk", 1) + ":1:11: "))
      << refusal(folder_.path());
  write(name_of("walk", 1), "[1, 2]");
  EXPECT_TRUE(has(refusal(folder_.path()), name_of("walk", 1) + ": has no list of people"))
      << refusal(folder_.path());
}

// The number of a frame is not trusted: nothing is made of so many frames.
TEST_F(KeypointFrames, WithNumbersBeyondTheirBytesAreRefused) {
  write(name_of("walk", 0), frame_at(0));
  write("walk_999999999999_keypoints.json", frame_at(0));
  write(name_of("walk", 7), frame_at(0));
  EXPECT_TRUE(has(refusal(folder_.path()), "far more than the file holds"))
      << refusal(folder_.path());
}

TEST_F(KeypointFrames, OfAllTheirFilesAreLimitedBeforeReading) {
  write(name_of("walk", 0), frame_at(0));
  write(name_of("walk", 1), "");
  std::filesystem::resize_file(folder_.path() / name_of("walk", 1), max_keypoint_bytes);
  EXPECT_TRUE(has(refusal(folder_.path()), "holds frames of more than the 256 MiB"))
      << refusal(folder_.path());
}

TEST_F(KeypointFrames, AreOneExampleOfAFolder) {
  for (const int number : {0, 1}) {
    write(name_of("walk", number), frame_at(number));
    std::filesystem::create_directory(folder_.path() / "jump");
    write("jump/" + name_of("jump", number), frame_at(number));
  }
  ExampleFolder examples;
  examples.path = folder_.path();
  EXPECT_EQ(example_files(examples), (std::vector{folder_.path() / "jump" / name_of("jump", 0),
                                                  folder_.path() / name_of("walk", 0)}));
  examples.include = "jump";
  EXPECT_EQ(example_names(examples), std::vector<std::string>{"jump"});
}

}  // namespace
}  // namespace mien::motion
