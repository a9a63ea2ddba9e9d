#include "pipeline/production/synthesis/motion_task.h"

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

/// glTF tells times and no rate: below ten frames a second it is read at thirty.
TEST(ClipTask, WritesGltfOfAnyRate) {
  for (const double rate : {1.0, 2.0, 5.0, 7.0, 9.5, 12.5, 30.0}) {
    const test::TemporaryFolder folder;
    Manifest manifest;
    manifest.examples.builtin = "walks-10";
    manifest.stimuli.emplace_back();
    Stimulus& stimulus = manifest.stimuli.back();
    stimulus.id = "a";
    stimulus.weights = {{"normal", 1.0}};
    stimulus.output.fps = rate;
    stimulus.output.clips = {"bvh", "glb"};
    FileKeys files;
    const SharedDeterminants shared = shared_determinants(manifest, files);
    Motions motions(manifest);
    TaskGraph graph;
    graph.add(motion_task(stimulus, shared, motions));
    graph.add(clip_task(stimulus, manifest.equalize, shared, motions));
    Store store(folder.path());
    for (const TaskOutcome& outcome : run(graph, store, 1, {}, {}))
      EXPECT_EQ(outcome.error, "") << rate;
    const motion::Recording bvh = motion::read_motion(folder.path() / "clips/a.bvh");
    const motion::Recording glb = motion::read_motion(folder.path() / "clips/a.glb");
    EXPECT_NEAR((glb.frame_count() - 1) / glb.frames_per_second,
                (bvh.frame_count() - 1) / bvh.frames_per_second, 1.0 / glb.frames_per_second)
        << rate;
  }
}

}  // namespace
}  // namespace mien::pipeline
