#include "scenes/stage/trail_figure.h"

#include <set>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "render/geometry/shapes.h"
#include "scenes/stage/shot.h"
#include "scenes/walking_clip.h"

namespace mien::scenes {
namespace {

Shot staged(const TrailOptions& options) {
  Look look;
  look.figure = options;
  return stage(test::walking_clip(61, motion::Vec3::UnitZ(), 0.04), look);
}

TEST(TrailFigure, LeavesPosesBehindAndShowsThemAllAtTheEnd) {
  const TrailOptions options;
  EXPECT_TRUE(ghosts_at(options, 0, 61, 30.0).empty());
  EXPECT_EQ(ghosts_at(options, 25, 61, 30.0).size(), 3u);  // left at 0, 10 and 20
  const std::vector<Ghost> all = ghosts_at(options, 60, 61, 30.0);
  ASSERT_EQ(all.size(), 6u);
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_EQ(all[i].frame - all[i - 1].frame, 10);
    EXPECT_GT(all[i].opacity, all[i - 1].opacity);
  }
  EXPECT_NEAR(all.front().opacity, options.min_opacity, 1e-6);
}

TEST(TrailFigure, OnionSkinEndsWithTheClip) {
  TrailOptions options;
  options.poses = 0;
  options.before = 3;
  options.after = 2;
  options.every_s = 0.1;
  const auto at = [&](int frame) { return ghosts_at(options, frame, 61, 30.0); };
  ASSERT_EQ(at(30).size(), 5u);
  EXPECT_EQ(at(30).front(), (Ghost{21, at(30).front().opacity}));
  EXPECT_EQ(at(0).size(), 2u);
  EXPECT_EQ(at(60).size(), 3u);
  for (const Ghost& ghost : at(30)) {
    EXPECT_GT(ghost.opacity, 0.0f);
    EXPECT_LT(ghost.opacity, 1.0f);
  }
}

TEST(TrailFigure, EveryPoseIsAFigureOfItsOwn) {
  TrailOptions options;
  options.traces = {"feet", "LeftWrist"};
  const Shot shot = staged(options);
  const render::Scene scene = scene_at(shot, 60);
  EXPECT_NO_THROW(render::validate(scene));
  ASSERT_EQ(scene.figures.size(), 8u);  // the present, six left behind, the traces
  EXPECT_EQ(scene.figures[0].opacity, 1.0f);
  EXPECT_LT(scene.figures[1].opacity, 0.3f);
  std::vector<int> solids(scene.figures.size());
  for (const render::RoundCone& round_cone : scene.solids.round_cones) {
    ++solids[static_cast<std::size_t>(
        scene.parts[static_cast<std::size_t>(round_cone.part)].figure)];
  }
  for (std::size_t f = 1; f < 7; ++f) EXPECT_EQ(solids[f], solids[0]);
  EXPECT_GT(solids[7], 30);
}

TEST(TrailFigure, ShowsAPoseOnce) {
  TrailOptions options;
  options.poses = 12;
  const std::vector<Ghost> ghosts = ghosts_at(options, 5, 6, 30.0);
  std::set<int> frames;
  for (const Ghost& ghost : ghosts) EXPECT_TRUE(frames.insert(ghost.frame).second);
  EXPECT_EQ(frames.size(), 5u);
}

/// What a shutter or a layer of motion needs: the same solids, elsewhere.
TEST(TrailFigure, IsMadeOfTheSameSolidsInTheNextFrame) {
  TrailOptions options;
  options.traces = {"feet"};
  options.before = options.after = 2;
  const Shot shot = staged(options);
  for (int frame = 0; frame + 1 < shot.frame_count(); ++frame) {
    EXPECT_NO_THROW(render::shapes_between(scene_at(shot, frame), scene_at(shot, frame + 1, frame)))
        << frame;
  }
}

TEST(TrailFigure, RefusesTracesOfWhatIsNotThere) {
  TrailOptions options;
  options.traces = {"tail"};
  EXPECT_THROW(staged(options), Error);
}

TEST(TrailFigure, ShowsOneMotionOnly) {
  Look look;
  look.figure = TrailOptions();
  const motion::Clip clip = test::walking_clip(61, motion::Vec3::UnitZ(), 0.04);
  EXPECT_NO_THROW(stage({Performance{.clip = clip}}, look));
  EXPECT_THROW(stage({Performance{.clip = clip}, Performance{.clip = clip}}, look), Error);
}

}  // namespace
}  // namespace mien::scenes
