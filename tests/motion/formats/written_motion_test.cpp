#include "motion/formats/written_motion.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <set>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/points/joint_points.h"
#include "motion/procedural/walker.h"
#include "motion/random_recording.h"
#include "motion/refusal.h"
#include "motion/rig/recording_clip.h"
#include "motion/skeleton/body.h"
#include "motion/text/file_contents.h"
#include "motion/text/result_file.h"
#include "pipeline/temporary_folder.h"

namespace mien::motion {
namespace {

namespace fs = std::filesystem;

const char* const bids_name = "sub-01_task-walk_tracksys-markers_motion.tsv";

/// A name of a file of each format that holds points.
std::vector<std::string> point_file_names() {
  std::vector<std::string> names;
  for (const MotionFormat& format : motion_formats()) {
    if (!format.holds_points()) continue;
    names.push_back(format.require_name == nullptr ? "walk" + std::string(format.ending)
                                                   : bids_name);
  }
  return names;
}

/// Markers that come and go, within a few metres.
PointRecording random_points(std::mt19937_64& random, double metres_per_unit, double rate) {
  PointRecording points;
  points.name = "walk";
  points.format = "c3d";
  points.points = {"LASI", "R.Knee", "head top", "a_x"};
  points.frames_per_second = rate;
  points.unit = metres_per_unit == 1.0 ? "m" : metres_per_unit == 0.001 ? "mm" : "";
  points.metres_per_unit = metres_per_unit;
  const double size = 3.0 / (metres_per_unit > 0.0 ? metres_per_unit : 0.001);
  for (int i = 0; i < 4 * 60; ++i) {
    points.seen.push_back(random() % 5 != 0);
    points.positions.push_back(points.seen.back() ? mien::test::random_vector(random, size)
                                                  : Vec3(Vec3::Zero()));
  }
  return points;
}

PointRecording points_in(const fs::path& file) { return std::get<PointRecording>(read_file(file)); }

double in_metres_of(const PointRecording& points) {
  return points.metres_per_unit > 0.0 ? points.metres_per_unit : 0.001;
}

TEST(WrittenPoints, KeepPositionsGapsNamesAndRates) {
  const mien::test::TemporaryFolder folder;
  std::mt19937_64 random(11);
  ASSERT_EQ(point_file_names().size(), 4u);
  for (const std::string& name : point_file_names()) {
    for (const double rate : {12.5, 25.0, 30.0, 59.94, 100.0, 119.88, 240.0, 1000.0}) {
      for (const double metres : {1.0, 0.001, 0.0}) {
        if (metres == 0.0 && motion_format(name)->states_unit) continue;
        const PointRecording written = random_points(random, metres, rate);
        write_results(point_files(written, folder.path() / name));
        const PointRecording read = points_in(folder.path() / name);
        EXPECT_EQ(read.points, written.points) << name;
        EXPECT_EQ(read.seen, written.seen) << name;
        EXPECT_NEAR(read.frames_per_second, rate, 1e-5 * rate) << name;
        EXPECT_EQ(read.metres_per_unit == 0.0, metres == 0.0) << name;
        ASSERT_EQ(read.positions.size(), written.positions.size()) << name;
        for (std::size_t i = 0; i < read.positions.size(); ++i) {
          const Vec3 off =
              in_metres_of(read) * read.positions[i] - in_metres_of(written) * written.positions[i];
          ASSERT_LT(off.norm(), 1e-5) << name << " " << rate << " " << metres;
        }
      }
    }
  }
}

TEST(WrittenMotions, OfOneFrameKeepTheirFrameRate) {
  const mien::test::TemporaryFolder folder;
  std::vector<std::string> names = point_file_names();
  names.insert(names.end(), {"a.bvh", "a.glb", "a.npz"});
  for (const double rate : {24.0, 59.94, 120.0}) {
    Clip clip = walk({}, rate, standard_body()).clip;
    clip.poses.resize(1);
    for (const std::string& name : names) {
      write_motion(to_recording(clip), folder.path() / name);
      const FileContents read = read_file(folder.path() / name);
      const auto* points = std::get_if<PointRecording>(&read);
      const double kept =
          points ? points->frames_per_second : std::get<Recording>(read).frames_per_second;
      EXPECT_NEAR(kept, rate, 1e-5 * rate) << name;
    }
  }
}

/// With few frames, rounded times are those of several rates.
TEST(WrittenPoints, OfFewFramesKeepRatesThatAreNotWhole) {
  const mien::test::TemporaryFolder folder;
  std::mt19937_64 random(15);
  for (const std::string name : {"walk.csv", "WALK.CSV"}) {
    for (const double rate : {12.5, 62.5, 59.94, 0.5}) {
      for (const std::size_t frames : {2u, 3u}) {
        PointRecording written = random_points(random, 1.0, rate);
        written.positions.resize(frames * written.points.size());
        written.seen.assign(written.positions.size(), true);
        write_results(point_files(written, folder.path() / name));
        EXPECT_EQ(points_in(folder.path() / name).frames_per_second, rate) << name << " " << frames;
      }
    }
  }
}

TEST(WrittenPoints, OfASkeletonAreItsJoints) {
  const mien::test::TemporaryFolder folder;
  std::mt19937_64 random(12);
  const Recording recording = mien::test::random_recording(random);
  for (const std::string& name : point_file_names()) {
    write_motion(recording, folder.path() / name);
    const PointRecording read = points_in(folder.path() / name);
    ASSERT_EQ(read.frame_count(), recording.frame_count()) << name;
    ASSERT_EQ(read.point_count(), recording.skeleton.size()) << name;
    EXPECT_NEAR(read.frames_per_second, recording.frames_per_second,
                1e-4 * recording.frames_per_second);
    for (int frame = 0; frame < read.frame_count(); ++frame) {
      const std::vector<Vec3> places =
          world_positions(recording.skeleton, recording.poses[static_cast<std::size_t>(frame)]);
      for (int joint = 0; joint < read.point_count(); ++joint) {
        const auto j = static_cast<std::size_t>(joint);
        EXPECT_EQ(read.points[j], recording.skeleton.joints[j].name) << name;
        const Vec3 place = in_metres_of(read) * read.positions[read.at(frame, joint)];
        ASSERT_LT((place - places[j]).norm(), 1e-5) << name;
      }
    }
  }
}

/// A motion goes through every format of skeletons to every format of points.
TEST(WrittenMotions, KeepTheirJointsThroughEveryPairOfFormats) {
  const mien::test::TemporaryFolder folder;
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  const Recording original = to_recording(clip);
  for (const char* first : {"a.bvh", "a.glb", "a.npz"}) {
    write_motion(original, folder.path() / first);
    const Recording read = in_metres(read_motion(folder.path() / first));
    const Recording body =
        read.skeleton.size() == body_joint_count ? read : to_recording(clip_of(read));
    for (const std::string& second : point_file_names()) {
      write_motion(body, folder.path() / second);
      const PointRecording points = points_in(folder.path() / second);
      ASSERT_EQ(points.frame_count(), clip.frame_count()) << first << " " << second;
      const PointRecording wanted = joint_points(original);
      EXPECT_EQ(points.points, wanted.points) << first << " " << second;
      for (std::size_t i = 0; i < wanted.positions.size(); ++i)
        ASSERT_LT((in_metres_of(points) * points.positions[i] - wanted.positions[i]).norm(), 1e-4)
            << first << " " << second << " " << wanted.points[i % body_joint_count];
    }
  }
}

TEST(WrittenMotions, AreTheFilesThatAreAnnounced) {
  std::mt19937_64 random(13);
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  for (const MotionFormat& format : motion_formats()) {
    if (!format.is_written()) continue;
    const mien::test::TemporaryFolder folder;
    const std::string name =
        format.require_name == nullptr ? "walk" + std::string(format.ending) : bids_name;
    const std::vector<fs::path> files = written_files(folder.path() / name);
    EXPECT_EQ(files.front(), folder.path() / name);
    write_motion(to_recording(clip), folder.path() / name);
    std::set<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder.path())) found.insert(entry.path());
    EXPECT_EQ(found, std::set<fs::path>(files.begin(), files.end())) << name;
    std::vector<std::string> first;
    for (const fs::path& file : files) first.push_back(read_contents(file));
    write_motion(to_recording(clip), folder.path() / name);
    for (std::size_t i = 0; i < files.size(); ++i)
      EXPECT_EQ(read_contents(files[i]), first[i]) << files[i];
  }
  EXPECT_EQ(written_files("a/walk.csv"), (std::vector<fs::path>{"a/walk.csv", "a/walk.csv.json"}));
  EXPECT_EQ(written_files("sub-1_task-x_tracksys-y_run-2_motion.tsv"),
            (std::vector<fs::path>{"sub-1_task-x_tracksys-y_run-2_motion.tsv",
                                   "sub-1_task-x_tracksys-y_run-2_channels.tsv",
                                   "sub-1_task-x_tracksys-y_run-2_motion.json"}));
}

TEST(WrittenMotions, AreRefusedUnderOtherNames) {
  for (const char* name : {"walk.fbx", "walk.c3d", "walk.json", "walk.gltf", "walk"}) {
    const std::string said = mien::test::refusal_of([&] { written_files(name); });
    EXPECT_EQ(said, std::string(name) +
                        ": is not a motion file that can be written; use BVH "
                        "(.bvh), glTF (.glb), TRC (.trc), NumPy (.npz, .npy) or "
                        "tables of points (.csv, *_motion.tsv)");
  }
  const std::string compressed = mien::test::refusal_of([] { written_files("walk.bvh.gz"); });
  EXPECT_NE(compressed.find("write walk.bvh"), std::string::npos) << compressed;
  for (const char* name :
       {"walk.tsv", "walk_motion.tsv", "sub-01_task-walk_motion.tsv", "_motion.tsv",
        "sub-0 1_task-walk_tracksys-a_motion.tsv", "task-walk_sub-01_tracksys-a_motion.tsv",
        "sub-_task-walk_tracksys-a_motion.tsv", "sub-01_task-walk_tracksys-a_b_motion.tsv"}) {
    const std::string said = mien::test::refusal_of([&] { written_files(name); });
    EXPECT_NE(said.find("sub-01_task-walk_tracksys-markers_motion.tsv"), std::string::npos)
        << name << ": " << said;
  }
}

/// The companion of a table cannot be written, because a folder has its name.
TEST(WrittenMotions, AreWholeOrAbsent) {
  const mien::test::TemporaryFolder folder;
  std::mt19937_64 random(14);
  const Recording recording = mien::test::random_recording(random);
  fs::create_directory(folder.path() / "walk.csv.json");
  EXPECT_THROW(write_motion(recording, folder.path() / "walk.csv"), WriteFailure);
  EXPECT_FALSE(fs::exists(folder.path() / "walk.csv"));
  std::ofstream(folder.path() / "walk.csv") << "older";
  EXPECT_THROW(write_motion(recording, folder.path() / "walk.csv"), WriteFailure);
  EXPECT_EQ(read_contents(folder.path() / "walk.csv"), "older");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 2);
}

TEST(JointPoints, OfMarkersWithoutABodyAreTheMarkers) {
  Recording recording;
  recording.skeleton.joints.emplace_back();
  recording.poses.assign(2, {.rotations = {Quat::Identity()}});
  recording.markers = Markers{.points = {"a", "b"},
                              .positions = {Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 9), {}},
                              .seen = {true, false, true, false},
                              .filled = {false, true, false, false}};
  const PointRecording points = joint_points(recording);
  EXPECT_EQ(points.points, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(points.seen, recording.markers->seen);
  EXPECT_EQ(points.positions[2], Vec3(7, 8, 9));
  EXPECT_EQ(points.positions[1], Vec3(Vec3::Zero()));  // filled, not recorded
  EXPECT_EQ(points.metres_per_unit, 1.0);
}

TEST(JointPoints, HaveNamesThatDiffer) {
  std::mt19937_64 random(15);
  Recording recording = mien::test::random_recording(random);
  recording.skeleton.joints[3].name = recording.skeleton.joints[5].name;
  recording.skeleton.joints[4].name = "";
  const std::vector<std::string> names = joint_points(recording).points;
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  EXPECT_EQ(names[4], "point_5");
}

}  // namespace
}  // namespace mien::motion
