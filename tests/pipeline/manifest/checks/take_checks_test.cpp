#include "pipeline/manifest/checks/take_checks.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/formats/smpl/smpl.h"
#include "motion/formats/smpl/smpl_model_file.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/skeleton/body.h"
#include "motion/two_takes.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/checks/manifest_reader.h"
#include "pipeline/manifest/determinants.h"
#include "pipeline/production/run/study_inputs.h"
#include "pipeline/production/synthesis/synthesis.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

namespace fs = std::filesystem;

class Takes : public testing::Test {
 protected:
  Takes() {
    const motion::Clip walk =
        motion::repeated(motion::builtin_examples("walks-10").examples[0].clip, 3);
    fs::create_directory(folder_.path() / "captures");
    motion::write_motion(motion::to_recording(walk), folder_.path() / "captures" / "walk.bvh");
    write_file(folder_.path() / "takes.gltf", test::two_takes(motion::to_recording(walk)));
  }

  ManifestReading read(const std::string& rest) const {
    return parse_manifest("mien: 1\nstudy: s\n" + rest, folder_.path() / "m.yaml",
                          process_environment());
  }

  /// Where the only fault of a manifest is: "path:line".
  std::string fault_in(const std::string& rest) const {
    const ManifestReading reading = read(rest);
    if (reading.faults.size() != 1) return Faults(reading.faults).what();
    const Fault& fault = reading.faults[0];
    EXPECT_NE(fault.remedy, "");
    return fault.path + ":" + std::to_string(fault.place.line);
  }

  motion::Clip motion_of(const std::string& stimulus) const {
    const ManifestReading reading = read("stimuli:\n  - " + stimulus + "\n");
    EXPECT_TRUE(reading.faults.empty()) << Faults(reading.faults).what();
    return synthesize(reading.manifest.stimuli.at(0), {}).motion.clip;
  }

  test::TemporaryFolder folder_;
};

/// Radians that the left knee bends over a clip.
double bend(const motion::Clip& clip) {
  double largest = 0.0;
  for (const motion::Pose& pose : clip.poses) {
    const motion::Quat& now = pose.rotations[motion::LeftKnee];
    largest = std::max(largest, now.angularDistance(clip.poses[0].rotations[motion::LeftKnee]));
  }
  return largest;
}

TEST_F(Takes, OfFilesThatHoldOneMotionAreRefusedWhereTheyStand) {
  EXPECT_EQ(fault_in("stimuli:\n  - id: a\n    clip: {file: captures/walk.bvh,\n      take: Walk}"),
            "stimuli[0].clip.take:6");
  EXPECT_EQ(
      fault_in("stimuli:\n  - id: a\n    path:\n      script: [{walk: 1}]\n      graph:\n"
               "        - captures/walk.bvh\n        - {file: captures/walk.bvh, take: Walk}"),
      "stimuli[0].path.graph[1].take:9");
  EXPECT_EQ(fault_in("stimuli:\n  - id: a\n    clip: captures/walk.bvh\n    modify:\n      pose:\n"
                     "        neutral: captures/walk.bvh\n"
                     "        posed: {motion: captures/walk.bvh, take: Walk}"),
            "stimuli[0].modify.pose.posed.take:9");
  EXPECT_EQ(fault_in("examples:\n  set: {folder: captures, take: Walk}\n  ratings: none\n"
                     "stimuli: [{id: a, weights: {walk: 1}}]"),
            "examples.set.take:4");
}

TEST_F(Takes, OfSmplMotionsHaveTheBodyOfTheirModel) {
  const motion::Clip walk = motion::builtin_examples("walks-10").examples[0].clip;
  motion::write_motion(motion::to_recording(walk), folder_.path() / "walk.npz");
  write_file(folder_.path() / "tall.npz", test::smpl_model_of_size(1.1));
  const auto leg = [&](const std::string& more) {
    return motion::leg_length(motion_of("{id: a, clip: {file: walk.npz" + more + "}}").body);
  };
  EXPECT_NEAR(leg(", body_model: tall.npz") / leg(""), 1.1, 1e-6);
  EXPECT_EQ(fault_in("stimuli:\n  - id: a\n    clip: {file: walk.npz,\n      body_model: no.npz}"),
            "stimuli[0].clip.body_model:6");
  EXPECT_EQ(fault_in("stimuli:\n  - id: a\n    clip: {file: captures/walk.bvh,\n"
                     "      body_model: tall.npz}"),
            "stimuli[0].clip.body_model:6");
  EXPECT_EQ(fault_in("examples:\n  set: {folder: captures,\n    body_model: no.npz}\n"
                     "  ratings: none\nstimuli: [{id: a, weights: {walk: 1}}]"),
            "examples.set.body_model:5");
}

// What is made depends on the model's contents, which are among the inputs of the study.
TEST_F(Takes, OfSmplMotionsDependOnTheirModel) {
  const motion::Clip walk = motion::builtin_examples("walks-10").examples[0].clip;
  motion::write_motion(motion::to_recording(walk), folder_.path() / "walk.npz");
  write_file(folder_.path() / "m.yaml", "mien: 1\n");
  std::set<std::string> hashes, keys;
  for (const double size : {0.9, 1.1}) {
    write_file(folder_.path() / "model.npz", test::smpl_model_of_size(size));
    const Manifest manifest =
        read("stimuli: [{id: a, clip: {file: walk.npz, body_model: model.npz}}]").manifest;
    for (const auto& [name, hash] : hashes_of_inputs(manifest)) {
      if (name.ends_with("/model.npz")) hashes.insert(hash);
    }
    FileKeys files;
    KeyBuilder key;
    add_motion(key, manifest.stimuli.at(0), files);
    keys.insert(key.key());
  }
  EXPECT_EQ(hashes.size(), 2u);
  EXPECT_EQ(keys.size(), 2u);
}

TEST_F(Takes, OfClipsAreShownByName) {
  EXPECT_GT(bend(motion_of("{id: a, clip: takes.gltf}")), 0.3);
  EXPECT_GT(bend(motion_of("{id: a, clip: {file: takes.gltf, take: Walk}}")), 0.3);
  EXPECT_LT(bend(motion_of("{id: a, clip: {file: takes.gltf, take: Stand}}")), 1e-6);
  EXPECT_THROW(motion_of("{id: a, clip: {file: takes.gltf, take: Jump}}"), Error);
}

/// The difference of a take and itself is none, that of two takes is one.
TEST_F(Takes, OfPosesAreTakenByName) {
  const auto posed_by = [&](const std::string& take) {
    return motion_of(
        "{id: a, clip: takes.gltf, modify: {pose: {neutral: {motion: takes.gltf, take: "
        "Walk, frame: 5}, posed: {motion: takes.gltf, take: " +
        take + ", frame: 5}}}}");
  };
  const auto distance = [&](const motion::Clip& a, const motion::Clip& b) {
    double sum = 0.0;
    for (int j = 0; j < a.body.size(); ++j)
      sum += a.poses[3].rotations[j].angularDistance(b.poses[3].rotations[j]);
    return sum;
  };
  const motion::Clip plain = motion_of("{id: a, clip: takes.gltf}");
  EXPECT_LT(distance(posed_by("Walk"), plain), 1e-6);
  EXPECT_GT(distance(posed_by("Stand"), plain), 0.1);
}

/// A graph of a walk walks, one of somebody who stands cannot.
TEST_F(Takes, OfGraphsAreTakenByName) {
  const auto walked = [&](const std::string& graph) {
    return motion_of("{id: a, path: {graph: [" + graph + "], script: [{walk: 1}]}}");
  };
  const motion::Clip by_file = walked("captures/walk.bvh");
  const motion::Clip by_take = walked("{file: takes.gltf, take: Walk}");
  ASSERT_EQ(by_take.frame_count(), by_file.frame_count());
  EXPECT_NEAR((by_take.poses.back().root_position - by_file.poses.back().root_position).norm(), 0.0,
              0.01);
  EXPECT_GT(bend(by_take), 0.3);
  EXPECT_LT(bend(walked("{file: takes.gltf, take: Stand}")), 1e-3);
}

/// Whatever else is wrong.
TEST_F(Takes, AndFramesThatFilesDoNotHoldAreToldWhereTheyStand) {
  const ManifestReading reading = read(
      "examples: {set: builtin:walks-11}\nstuff: 1\nstimuli:\n"
      "  - id: a\n    clip: {file: takes.gltf,\n      take: walk}\n"
      "  - id: b\n    clip:\n      file: takes.gltf\n      take: Stand\n"
      "      frames: [1, 9000]\n"
      "  - id: c\n    clip: captures/walk.bvh\n    modify:\n      pose:\n"
      "        neutral: captures/walk.bvh\n        posed: {motion: captures/walk.bvh,\n"
      "          frame: 8000}");
  const std::vector<Fault> faults = check_recordings(reading.manifest);
  ASSERT_EQ(faults.size(), 3u);
  EXPECT_EQ(faults[0].path, "stimuli[0].clip.take");
  EXPECT_EQ(faults[0].place.line, 8);
  EXPECT_NE(faults[0].wrong.find("there is no take \"walk\""), std::string::npos);
  EXPECT_EQ(faults[1].path, "stimuli[1].clip.frames");
  EXPECT_EQ(faults[1].place.line, 13);
  EXPECT_NE(faults[1].wrong.find("its take \"Stand\" has "), std::string::npos);
  EXPECT_NE(faults[1].remedy, "");
  EXPECT_EQ(faults[2].path, "stimuli[2].modify.pose.posed.frame");
  EXPECT_EQ(faults[2].place.line, 20);
  EXPECT_NE(faults[2].wrong.find("it has "), std::string::npos);
}

TEST_F(Takes, ThatNobodyChoseAreTold) {
  const ManifestReading reading = read(
      "stimuli:\n"
      "  - {id: a, clip: takes.gltf}\n"
      "  - {id: b, clip: {file: takes.gltf, take: Walk}}\n"
      "  - {id: c, clip: captures/walk.bvh, modify: {pose: {neutral: captures/walk.bvh,\n"
      "      posed: {motion: takes.gltf, frame: 5}}}}\n"
      "  - {id: d, path: {graph: [takes.gltf], script: [{walk: 1}]}}\n");
  std::vector<std::string> told;
  for (const Fault& one : default_take_warnings(reading.manifest)) {
    told.push_back(one.path + ":" + std::to_string(one.place.line));
    EXPECT_NE(one.wrong.find("\"Walk\" is used"), std::string::npos) << one.wrong;
  }
  EXPECT_EQ(told,
            (std::vector<std::string>{"stimuli[0].clip:4", "stimuli[2].modify.pose.posed.motion:7",
                                      "stimuli[3].path.graph[0]:8"}));
  for (const Stimulus& stimulus : reading.manifest.stimuli) {
    const std::vector<std::string> warnings = synthesize(stimulus, {}).warnings;
    const auto telling = std::ranges::count_if(warnings, [](const std::string& warning) {
      return warning.find("\"Walk\" is used") != std::string::npos;
    });
    EXPECT_EQ(telling, stimulus.id == "b" ? 0 : 1) << stimulus.id;
  }
}

}  // namespace
}  // namespace mien::pipeline
