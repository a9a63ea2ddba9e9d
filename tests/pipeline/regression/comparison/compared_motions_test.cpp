#include "pipeline/regression/comparison/compared_motions.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/formats/motion_file.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/two_takes.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/temporary_folder.h"

#include "real_data.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

class ComparedMotionFiles : public testing::Test {
 protected:
  std::string in(const std::string& name) const { return (folder_.path() / name).string(); }

  void write(const motion::Clip& clip, const std::string& name, double unit = 1.0) const {
    motion::Recording recording = motion::to_recording(clip);
    for (motion::Joint& joint : recording.skeleton.joints) {
      joint.offset *= unit;
      if (joint.tip) *joint.tip *= unit;
    }
    for (motion::Pose& pose : recording.poses) pose.root_position *= unit;
    motion::write_motion(recording, in(name));
  }

  motion::Clip walk_ = motion::repeated(motion::builtin_examples("walks-10").examples[0].clip, 3);

 private:
  test::TemporaryFolder folder_;
};

bool contains_words(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(ComparedMotionFiles, OfOtherUnitsAreToldInALine) {
  write(walk_, "a.bvh");
  write(walk_, "b.bvh", 10.0);
  const ComparedMotions motions = compared_motion_files(in("a.bvh"), in("b.bvh"), {});
  const std::string text = as_text(motions);
  EXPECT_FALSE(motions.are_alike());
  EXPECT_TRUE(contains_words(text, "differs (all lengths are 10 times as long")) << text;
  EXPECT_LE(std::ranges::count(text, '\n'), 2) << text;
}

TEST_F(ComparedMotionFiles, OfAnyRateNameWhatDiffersBesideIt) {
  write(walk_, "a.bvh");
  motion::Clip now = motion::resampled(walk_, 2.0 * walk_.frames_per_second);
  write(now, "alike.bvh");
  const int elbow = motion::find_joint(now.body, "LeftElbow");
  for (motion::Pose& pose : now.poses)
    pose.rotations[elbow] =
        pose.rotations[elbow] * motion::Quat(Eigen::AngleAxisd(0.3, motion::Vec3::UnitX()));
  write(now, "b.bvh");
  motion::MotionTolerance any_rate;
  any_rate.any_rate = true;
  const std::string text = as_text(compared_motion_files(in("a.bvh"), in("b.bvh"), any_rate));
  const std::string head = text.substr(0, text.find('\n'));
  EXPECT_TRUE(contains_words(head, "left forearm")) << head;
  EXPECT_FALSE(contains_words(head, "per second")) << head;
}

motion::ReadOptions of_take(const std::string& take) {
  motion::ReadOptions how;
  how.take = take;
  return how;
}

TEST_F(ComparedMotionFiles, OfSeveralTakesAreComparedTakeByTake) {
  write(walk_, "walk.bvh");
  write_file(in("takes.gltf"), test::two_takes(motion::read_motion(in("walk.bvh"))));
  const std::string file = in("takes.gltf");
  EXPECT_TRUE(compared_motion_files(file, file, {}).are_alike());
  EXPECT_TRUE(compared_motion_files(file, in("walk.bvh"), {}, {of_take("Walk"), {}}).are_alike());
  const ComparedMotions others =
      compared_motion_files(file, file, {}, {of_take("Walk"), of_take("Stand")});
  EXPECT_FALSE(others.are_alike());
  const std::string text = as_text(others);
  EXPECT_TRUE(contains_words(text, "take before: Walk of " + file)) << text;
  EXPECT_TRUE(contains_words(text, "take now: Stand of " + file)) << text;
  EXPECT_EQ(as_json(others)["take_now"], "Stand");
  EXPECT_THROW(compared_motion_files(file, file, {}, {motion::ReadOptions(), of_take("Jump")}),
               Error);
}

TEST_F(ComparedMotionFiles, OfOneTakeAreNotSaidToBeOfOne) {
  write(walk_, "walk.glb");
  const ComparedMotions same = compared_motion_files(in("walk.glb"), in("walk.glb"), {});
  EXPECT_TRUE(same.take_before.empty());
  EXPECT_TRUE(same.take_now.empty());
}

TEST_F(ComparedMotionFiles, OfHalfACycleAreCompared) {
  const auto data = test::real_data();
  if (!data) GTEST_SKIP() << "no motion capture here: set MIEN_DATA to the folder that has it";
  const std::string file = (*data / "faults" / "half-cycle.bvh").string();
  const ComparedMotions motions = compared_motion_files(file, file, {});
  EXPECT_TRUE(motions.difference.identical);
  EXPECT_TRUE(motions.are_alike());
}

}  // namespace
}  // namespace mien::pipeline
