#include "pipeline/production/synthesis/motion_task.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "pipeline/base/documents/csv.h"
#include "pipeline/base/documents/files.h"
#include "pipeline/manifest/people.h"
#include "pipeline/production/run/rehearsal.h"
#include "pipeline/production/synthesis/durations_task.h"
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

/// The films of several people end with the last of them.
TEST(DurationsTask, DependsOnWhenPeopleBegin) {
  const auto key_of = [](double start) {
    Manifest manifest;
    manifest.equalize.duration = true;
    Stimulus& pair = manifest.stimuli.emplace_back();
    pair.id = "pair";
    for (const char* name : {"one", "other"}) {
      Person person = plain_person(pair);
      person.name = name;
      person.motion.weights = {{"normal", 1.0}};
      pair.people.push_back(std::move(person));
    }
    name_people(manifest);
    pair.people.back().start = start;
    FileKeys files;
    Motions motions(manifest);
    return durations_task(manifest, shared_determinants(manifest, files), motions)
        .determinants.key();
  };
  EXPECT_NE(key_of(0.5), key_of(1.0));
  EXPECT_EQ(key_of(0.5), key_of(0.5));
}

/// The task of one stimulus, made into a folder.
class ClipOfStimulus {
 public:
  ClipOfStimulus(Manifest manifest, const std::filesystem::path& folder)
      : manifest_(std::move(manifest)), motions_(manifest_), store_(folder) {
    FileKeys files;
    const SharedDeterminants shared = shared_determinants(manifest_, files);
    TaskGraph graph;
    for (const Stimulus& stimulus : manifest_.stimuli) {
      graph.add(motion_task(stimulus, shared, motions_));
      graph.add(clip_task(stimulus, manifest_.equalize, shared, motions_));
    }
    for (const Product& product : graph.tasks.back().products) paths.push_back(product.path);
    for (const TaskOutcome& outcome : run(graph, store_, 1, {}, {})) errors += outcome.error;
  }

  std::string unwritable() { return unwritable_clip(manifest_.stimuli.front(), motions_); }

  std::vector<std::string> paths;
  std::string errors;

 private:
  Manifest manifest_;
  Motions motions_;
  Store store_;
};

Manifest clips_of(const std::vector<std::string>& formats) {
  Manifest manifest;
  manifest.stimuli.emplace_back();
  manifest.stimuli.back().id = "a";
  manifest.stimuli.back().output.clips = formats;
  return manifest;
}

TEST(ClipTask, MakesTheFilesThatBelongBesideAFormatToo) {
  const test::TemporaryFolder folder;
  Manifest manifest = clips_of({"trc", "npz", "npy", "csv"});
  manifest.examples.builtin = "walks-10";
  manifest.stimuli.back().weights = {{"normal", 1.0}};
  const ClipOfStimulus made(manifest, folder.path());
  EXPECT_EQ(made.errors, "");
  EXPECT_EQ(made.paths,
            (std::vector<std::string>{"clips/a.trc", "clips/a.npz", "clips/a.npy",
                                      "clips/a.npy.json", "clips/a.csv", "clips/a.csv.json"}));
  for (const std::string& path : made.paths)
    EXPECT_TRUE(std::filesystem::exists(folder.path() / path)) << path;
  const CsvTable table = read_csv(folder.path() / "clips/a.csv");
  ASSERT_EQ(table.header.size(), clip_points_form.columns.size());
  for (std::size_t c = 0; c < table.header.size(); ++c)
    EXPECT_EQ(table.header[c].text, clip_points_form.columns[c].name);
  EXPECT_EQ(table.rows[1][2].text, "Spine");
}

/// Points without a body are written as points, and cannot be written as rotations of one.
TEST(ClipTask, WritesMarkersToWhichNoBodyCanBeFitted) {
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "lights.csv";
  write_file(file,
             "frame,time_s,point,x_m,y_m,z_m\n0,0,p,0,1,0\n0,0,q,0,2,0\n1,0.1,p,0,1,0\n"
             "1,0.1,q,,,\n2,0.2,p,0,1,0\n2,0.2,q,0,2,1\n");
  Manifest manifest = clips_of({"csv"});
  Stimulus& stimulus = manifest.stimuli.back();
  stimulus.clip.emplace();
  stimulus.clip->file = file;
  stimulus.look.figure = scenes::MarkersOptions();
  stimulus.output.fps = 10.0;
  ClipOfStimulus made(manifest, folder.path() / "out");
  EXPECT_EQ(made.errors, "");
  const CsvTable table = read_csv(folder.path() / "out/clips/a.csv");
  ASSERT_EQ(table.rows.size(), 6u);
  EXPECT_EQ(table.rows[1][2].text, "q");
  EXPECT_EQ(table.rows[3][3].text, "");  // a gap, although it is filled where it is shown
  EXPECT_NE(table.rows[5][3].text, "");
  EXPECT_EQ(made.unwritable(), "");
  manifest.stimuli.back().output.clips = {"npz"};
  ClipOfStimulus refused(manifest, folder.path() / "npz");
  EXPECT_EQ(refused.unwritable(), "npz cannot hold it: its points could not be fitted to a body");
  EXPECT_NE(refused.errors, "");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "npz/clips/a.npz"));
  const std::vector<Fault> faults = rehearse(manifest);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].path, "output.clips");
}

}  // namespace
}  // namespace mien::pipeline
