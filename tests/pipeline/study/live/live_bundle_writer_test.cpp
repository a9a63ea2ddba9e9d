#include "pipeline/study/live/live_bundle_writer.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "motion/error.h"
#include "motion/examples/compared_example.h"
#include "motion/formats/motion_file.h"
#include "motion/live/live_core.h"
#include "pipeline/study/live/live_study.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

/// Largest distance between the same joints of two clips of one length, metres.
double apart(const motion::Clip& a, const motion::Clip& b) {
  if (a.frame_count() != b.frame_count()) return 1e9;
  double largest = 0.0;
  for (std::size_t f = 0; f < a.poses.size(); ++f) {
    const auto in_a = motion::world_positions(a.body, a.poses[f]);
    const auto in_b = motion::world_positions(b.body, b.poses[f]);
    for (std::size_t j = 0; j < in_a.size(); ++j)
      largest = std::max(largest, (in_a[j] - in_b[j]).norm());
  }
  return largest;
}

/// The bundle of a study whose stimuli are all targets, read back.
motion::LiveBundle bundle_of(const Manifest& manifest, Motions& motions) {
  LiveChoice choice = live_choice(manifest);
  for (const Stimulus& stimulus : manifest.stimuli) choice.targets.push_back(stimulus.id);
  return motion::parse_live_bundle(motion::to_bytes(live_bundle(manifest, motions, choice)));
}

constexpr const char* methods[] = {"reach", "cardinal", "knn", "inverse-distance",
                                   "grid",  "kriging",  "pca", "incremental"};

TEST(LiveBundleWriter, LetsSlidersMakeWhatStimuliAreMadeOf) {
  for (const char* method : methods) {
    for (const char* lock : {"true", "false"}) {
      const Manifest manifest =
          test::live_manifest("{method: " + std::string(method) + ", foot_lock: " + lock + "}");
      Motions motions(manifest);
      const motion::LiveBundle bundle = bundle_of(manifest, motions);
      motion::LiveCore core(bundle);
      for (const Stimulus& stimulus : manifest.stimuli) {
        const motion::LiveMotion live = core.make(test::setting_of(stimulus));
        const Synthesis& made = motions.of(stimulus.id);
        EXPECT_EQ(apart(live.motion.clip, made.motion.clip), 0.0) << method << " " << stimulus.id;
        EXPECT_EQ(live.motion.keytimes, made.motion.keytimes);
        EXPECT_EQ(apart(core.target(stimulus.id).motion.clip, made.motion.clip), 0.0);
      }
    }
  }
}

/// D of two clips as `mien motion compare` finds it of their files.
double compared_files(const motion::Clip& target, const motion::Clip& created) {
  const test::TemporaryFolder folder;
  const auto written = [&](const motion::Clip& clip, const char* name) {
    motion::write_motion(motion::to_recording(clip), folder.path() / name);
    return motion::compared_example(motion::read_motion(folder.path() / name));
  };
  return motion::distance(written(target, "target.bvh"), written(created, "created.bvh")).mean;
}

TEST(LiveBundleWriter, LetsDistancesBeThoseOfWrittenClips) {
  const struct {
    const char* interpolation;
    const char* output;
  } ways[] = {{"{method: reach}", "{fps: 30}"},
              {"{method: cardinal, foot_lock: false}", "{fps: 60, cycles: 2}"},
              {"{method: pca}", "{fps: 25, cycles: 1}"},
              {"{method: kriging}", "{fps: 30, in_place: true}"}};
  for (const auto& way : ways) {
    const Manifest manifest = test::live_manifest(way.interpolation, way.output);
    Motions motions(manifest);
    const motion::LiveBundle bundle = bundle_of(manifest, motions);
    motion::LiveCore core(bundle);
    for (const Stimulus& target : manifest.stimuli) {
      const motion::Clip aim = motions.shown(target);
      for (const Stimulus& created : manifest.stimuli) {
        const double live = core.distance(target.id, test::setting_of(created)).mean;
        EXPECT_NEAR(live, compared_files(aim, motions.shown(created)), 1e-12)
            << way.interpolation << " " << target.id << " " << created.id;
      }
    }
  }
}

TEST(LiveBundleWriter, TellsPagesWhatThereIsToChooseFrom) {
  const Manifest manifest = test::live_manifest("{method: reach}");
  Motions motions(manifest);
  const auto info = nlohmann::json::parse(bundle_of(manifest, motions).info);
  EXPECT_EQ(info["examples"].size(), 10u);
  EXPECT_EQ(info["body"]["names"].size(), 21u);
  EXPECT_EQ(info["targets"], nlohmann::json({"by-adjectives", "by-features", "by-weights"}));
  EXPECT_EQ(info["method"], "reach");
  int primary = 0;
  for (const auto& slider : info["sliders"]["adjectives"]) {
    primary += slider["primary"] ? 1 : 0;
    EXPECT_GT(slider["mean"].get<double>(), 0.0);
    if (!slider["primary"]) {
      EXPECT_EQ(slider["texts"]["ja"].size(), 2u) << slider;
    }
  }
  EXPECT_EQ(primary, 4);
  EXPECT_EQ(info["sliders"]["features"][0]["labels"]["en"], "lateral swing of the upper body");
}

TEST(LiveBundleWriter, RefusesExamplesThatCannotBeBlended) {
  Manifest manifest;
  manifest.examples.builtin = "actors";
  Motions motions(manifest);
  EXPECT_THROW(live_bundle(manifest, motions, live_choice(manifest)), Error);
  const Manifest other = test::live_manifest("{method: reach}");
  Motions others(other);
  LiveChoice choice = live_choice(other);
  choice.targets = {"nobody"};
  EXPECT_THROW(live_bundle(other, others, choice), Error);
}

}  // namespace
}  // namespace mien::pipeline
