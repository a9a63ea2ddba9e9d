#include "pipeline/production/synthesis/walked_path.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "motion/formats/motion_file.h"
#include "motion/gait/foot_slide.h"
#include "motion/lint/lint.h"
#include "motion/skeleton/body.h"
#include "motion/walker_motions.h"
#include "pipeline/production/synthesis/motions.h"
#include "pipeline/temporary_folder.h"

namespace mien::pipeline {
namespace {

Stimulus stimulus_of(const WalkPath& path) {
  Stimulus stimulus;
  stimulus.id = "a";
  stimulus.output.fps = 30.0;
  stimulus.walk = path;
  return stimulus;
}

motion::Clip clip_of(const WalkPath& path) { return walked(stimulus_of(path)).clip; }

double heading_of(const motion::Pose& pose) {
  const motion::Vec3 forward = pose.rotations[0] * motion::Vec3::UnitZ();
  return std::atan2(forward.x(), forward.z()) / motion::radians_per_degree;
}

double way_over_floor(const motion::Clip& clip) {
  motion::Vec3 way = clip.poses.back().root_position - clip.poses.front().root_position;
  way.y() = 0.0;
  return way.norm();
}

TEST(WalkedPath, WalksTurnsAndStands) {
  WalkPath path;
  path.script = {{.walk_s = 3.0}, {.turn_deg = 90.0}, {.walk_s = 1.0}, {.stand_s = 1.0}};
  const motion::Clip clip = clip_of(path);
  EXPECT_FALSE(clip.loops);
  EXPECT_NEAR(heading_of(clip.poses.back()), 90.0, 12.0);
  EXPECT_GT(way_over_floor(clip), 3.0);
  const motion::WalkedClip walk = walked(stimulus_of(path));
  EXPECT_GT(walk.plants.size(), 8U);
  EXPECT_LT(motion::planted_slide(walk.clip, walk.plants), 0.001);
}

TEST(WalkedPath, ATurnAfterStandingIsOnTheSpot) {
  WalkPath path;
  path.script = {{.stand_s = 0.5}, {.turn_deg = -90.0}, {.stand_s = 0.5}};
  const motion::Clip clip = clip_of(path);
  EXPECT_NEAR(heading_of(clip.poses.back()), -90.0, 12.0);
  EXPECT_LT(way_over_floor(clip), 0.3);
}

TEST(WalkedPath, EndsAtTheLastPoint) {
  WalkPath path;
  path.points = {{1.0, 0.0}, {1.0, 2.0}, {0.0, 3.5}, {0.0, 5.0}};
  path.mood = {{"sad", 1.0}};
  const motion::Clip clip = clip_of(path);
  EXPECT_LT(
      std::hypot(clip.poses.front().root_position.x() - 1.0, clip.poses.front().root_position.z()),
      0.15);
  EXPECT_LT(
      std::hypot(clip.poses.back().root_position.x(), clip.poses.back().root_position.z() - 5.0),
      0.3);
  EXPECT_FALSE(motion::has_errors(motion::lint(clip)));
}

/// A step of half the pace gets half as far; a mood has its own speed.
TEST(WalkedPath, PaceAndMoodSetTheSpeed) {
  WalkPath path;
  path.script = {{.walk_s = 6.0}};
  const double own = way_over_floor(clip_of(path));
  path.pace = 0.5;
  const double half = way_over_floor(clip_of(path));
  EXPECT_NEAR(half / own, 0.5, 0.06);
  path.pace = 1.0;
  path.script.front().mood = {{"tired", 2.0}};
  EXPECT_LT(way_over_floor(clip_of(path)), 0.85 * own);
}

/// A mood of a step counts from that step on, and until then nothing is changed by it.
TEST(WalkedPath, AMoodBeginsAtItsStep) {
  WalkPath plain, later;
  plain.script = {{.walk_s = 2.0}, {.walk_s = 2.0}};
  later.script = plain.script;
  later.script[1].mood = {{"sad", 1.0}};
  const motion::Clip a = clip_of(plain);
  const motion::Clip b = clip_of(later);
  ASSERT_EQ(a.frame_count(), b.frame_count());
  const auto apart = [&](std::size_t frame) {
    double most = 0.0;
    for (std::size_t j = 0; j < a.poses[frame].rotations.size(); ++j)
      most =
          std::max(most, a.poses[frame].rotations[j].angularDistance(b.poses[frame].rotations[j]));
    return most;
  };
  EXPECT_LT(apart(60), 1e-9);
  EXPECT_GT(apart(75), 0.05);
}

/// The walk of a blend is that of a stimulus which asks for the same.
TEST(WalkedPath, AdjectivesAreThoseOfBlends) {
  Manifest manifest;
  manifest.examples.builtin = "walks-10";
  manifest.ratings.source = Ratings::Source::builtin;
  manifest.stimuli = {plain_stimulus(manifest)};
  manifest.stimuli[0].id = "quick";
  manifest.stimuli[0].adjectives = {{"quickness", 0.6}, {"largeness", 0.4}};
  Motions motions(manifest);
  const Eigen::VectorXd weights = motions.of("quick").weights;
  WalkPath path;
  path.script = {{.walk_s = 2.0, .mood = {{"sad", 1.0}}},
                 {.walk_s = 2.0, .mood = {{"quickness", 0.6}, {"largeness", 0.4}}}};
  const WalkPath walked = in_walks(path);
  EXPECT_EQ(walked.script[0], path.script[0]);
  const std::vector<std::string> walks = walks_of(path);
  double sum = 0.0;
  for (const auto& [name, share] : walked.script[1].mood) {
    const auto at = std::ranges::find(walks, name) - walks.begin();
    EXPECT_NEAR(share, weights(at), 1e-12) << name;
    sum += share;
  }
  EXPECT_NEAR(sum, 1.0, 1e-12);
}

TEST(WalkedPath, QuickerAdjectivesGoFartherInTheSameTime) {
  const auto way = [](double quickness) {
    WalkPath path;
    path.script = {{.walk_s = 4.0, .mood = {{"quickness", quickness}}}};
    return way_over_floor(clip_of(path));
  };
  EXPECT_GT(way(0.9), 1.3 * way(0.1));
}

TEST(WalkedPath, OnlyWalksThatAreNamedAreFitted) {
  WalkPath path;
  path.script = {{.walk_s = 1.0}};
  EXPECT_EQ(moods_of(path), std::vector<std::string>{"normal"});
  path.script.front().mood = {{"sad", 1.0}, {"happy", 0.0}};
  EXPECT_EQ(moods_of(path), (std::vector<std::string>{"happy", "sad"}));
  path.set = "builtin:walks-27";
  EXPECT_EQ(walks_of(path).size(), 27U);
}

TEST(WalkedPath, IsDescribedInFewWords) {
  WalkPath path;
  path.script = {{.walk_s = 3.0}, {.turn_deg = 90.0}, {.stand_s = 1.0, .mood = {{"sad", 1.0}}}};
  EXPECT_EQ(described(path), "walk 3 s, turn 90°, stand 1 s like sad");
}

/// Built-in takes as files, for a graph.
class WalkedGraph : public testing::Test {
 protected:
  void SetUp() override {
    for (const motion::Clip& clip :
         motion::test::walker_motions(motion::WalkStyle{}, 30.0, motion::standard_body())) {
      files_.push_back({folder_.path() / (clip.name + ".bvh"), ""});
      motion::write_motion(motion::to_recording(clip), files_.back().file);
    }
  }

  test::TemporaryFolder folder_;
  std::vector<GraphMotion> files_;
};

TEST_F(WalkedGraph, TurnsAsFarAsItIsTold) {
  WalkPath path;
  path.graph = files_;
  path.script = {{.walk_s = 3.0}, {.turn_deg = 90.0}, {.walk_s = 1.0}, {.stand_s = 1.0}};
  const motion::WalkedClip walk = walked(stimulus_of(path));
  EXPECT_NEAR(heading_of(walk.clip.poses.back()), 90.0, 8.0);
  EXPECT_LT(motion::planted_slide(walk.clip, walk.plants), 0.006);
}

/// What is missing to 1 is as captured; half of an emotion lies between.
TEST_F(WalkedGraph, MoodsAreTheRecipesOfEmotions) {
  WalkPath path;
  path.graph = files_;
  path.script = {{.walk_s = 3.0}};
  Stimulus stimulus = stimulus_of(path);
  const double plain = way_over_floor(walked(stimulus).clip);
  stimulus.walk_moods.resize(1);
  stimulus.walk_moods.front().emotion = "slow";
  stimulus.walk_moods.front().modification.tempo = 0.5;
  const auto way_with = [&](double share) {
    stimulus.walk->script.front().mood = {{"slow", share}};
    return way_over_floor(walked(stimulus).clip);
  };
  EXPECT_NEAR(way_with(0.0), plain, 0.05);
  const double half = way_with(0.5);
  const double whole = way_with(1.0);
  EXPECT_LT(whole, 0.7 * plain);
  EXPECT_LT(half, plain - 0.2);
  EXPECT_GT(half, whole + 0.2);
}

TEST_F(WalkedGraph, RefusesTurnsThatItsMotionsDoNotMake) {
  WalkPath path;
  path.graph = {files_[2]};  // "walk": straight on
  path.script = {{.walk_s = 2.0}, {.turn_deg = 90.0, .pace = 1.0}, {.walk_s = 1.0}};
  try {
    walked(stimulus_of(path));
    FAIL() << "was walked";
  } catch (const UnwalkableStep& fault) {
    EXPECT_EQ(fault.step(), 1U);
    const Error placed = fault.at({"m.yaml", 5, 20});
    EXPECT_EQ(std::string(placed.what()).find("m.yaml:5:20: the motions of the graph cannot turn"),
              0U)
        << placed.what();
  }
}

}  // namespace
}  // namespace mien::pipeline
