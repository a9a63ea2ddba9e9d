#include "scenes/point_light/marker_dots.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "motion/refusal.h"
#include "motion/skeleton/clip_markers.h"
#include "scenes/marked_clip.h"
#include "scenes/stage/shot.h"

namespace mien::scenes {
namespace {

using motion::Vec3;

constexpr int left_ankle = 0;
constexpr int head = 5;

class MarkerDots : public testing::Test {
 protected:
  motion::Clip clip = test::with_markers(test::walking_clip(60, Vec3::UnitZ(), 0.04));
  DotStage stage = {
      .centre = Vec3(0.4, 0.0, 0.5), .across = Vec3::UnitZ(), .step = mean_step(clip), .seed = 5};
  MarkersOptions options;

  std::vector<Dot> dots() const { return marker_dots(clip, options, stage); }
  std::string refusal() const {
    return mien::test::refusal_of([&] { dots(); });
  }
  int dark_frames(const Dot& dot) const {
    int dark = 0;
    for (std::size_t f = 0; f < dot.path.size(); ++f) dark += dot.is_shown(f) ? 0 : 1;
    return dark;
  }
};

TEST_F(MarkerDots, AreWhereTheMarkersAre) {
  const std::vector<Dot> shown = dots();
  ASSERT_EQ(shown.size(), test::carriers().size());
  const auto joints = motion::joint_paths(clip);
  for (std::size_t d = 0; d < shown.size(); ++d) {
    EXPECT_EQ(shown[d].kind, test::carriers()[d].first);
    for (std::size_t f = 0; f < joints.size(); ++f) {
      EXPECT_TRUE(shown[d].is_shown(f));
      EXPECT_LT((shown[d].path[f] - joints[f][test::carriers()[d].second]).norm(), 1e-12);
    }
  }
}

TEST_F(MarkerDots, AreThoseThatAnyPatternFits) {
  options.show = {"L*", "HEAD"};
  const std::vector<Dot> shown = dots();
  ASSERT_EQ(shown.size(), 4u);
  EXPECT_EQ(shown[0].kind, "LANK");
  EXPECT_EQ(shown[1].kind, "LKNE");
  EXPECT_EQ(shown[3].kind, "HEAD");
  options.pairs = {{"LKNE", "LANK"}};
  EXPECT_EQ(shown_markers(clip, options).pairs, (std::vector<Limb>{{1, 0}}));
}

TEST_F(MarkerDots, AreRefusedInWordsThatNameTheNearest) {
  clip.name = "walk";
  motion::attach(clip, *clip.markers);
  options.show = {"LANK", "LKNEE"};
  EXPECT_EQ(refusal(), "walk: markers.show[1]: no marker fits \"LKNEE\"; did you mean \"LKNE\"?");
  options.show = {"X*"};
  EXPECT_EQ(refusal(),
            "walk: markers.show[0]: no marker fits \"X*\"; use one of \"LANK\", \"RANK\", "
            "\"LKNE\", \"RKNE\", \"LWRA\", \"HEAD\"");
  options.show = {};
  options.pairs = {{"LANK", "LKNE"}, {"LKNE", "RKNEE"}};
  EXPECT_EQ(refusal(),
            "walk: markers.pairs[1]: there is no marker \"RKNEE\"; did you mean \"RKNE\"?");
  options.show = {"L*"};
  options.pairs = {{"LANK", "RANK"}};
  EXPECT_EQ(refusal(),
            "walk: markers.pairs[0]: marker \"RANK\" is not shown; add it to show, or omit the "
            "pair");
}

TEST_F(MarkerDots, OfAMotionWithoutMarkersAreRefused) {
  clip.name = "blend";
  clip.markers.reset();
  EXPECT_EQ(
      refusal(),
      "blend: this motion has no markers to show; show an unmodified recording of markers (in "
      "an AMASS file the take markers: FILE.npz#markers), "
      "or choose another figure, such as point-light");
  clip = test::with_markers(test::walking_clip(60, Vec3::UnitZ(), 0.04));
  clip.poses[3].rotations[motion::LeftElbow] = motion::Quat(Eigen::AngleAxisd(1.0, Vec3::UnitX()));
  EXPECT_NE(refusal().find("has no markers"), std::string::npos);
  Look look;
  look.figure = options;
  EXPECT_THROW(scenes::stage(clip, look), Error);
}

TEST_F(MarkerDots, AreDarkInGaps) {
  clip = test::with_gap(clip, left_ankle, 10, 19, false);
  const std::vector<Dot> shown = dots();
  for (std::size_t f = 0; f < 60; ++f) {
    EXPECT_EQ(shown[left_ankle].is_shown(f), f < 10 || f > 19) << f;
    EXPECT_TRUE(shown[head].is_shown(f));
  }
  // Nothing is drawn towards the zero that stands in the gap.
  const motion::Vec3 before = shown[left_ankle].path[9], after = shown[left_ankle].path[20];
  for (std::size_t f = 10; f < 20; ++f) {
    const motion::Vec3 at = shown[left_ankle].path[f];
    EXPECT_LT((at - before).norm() + (at - after).norm(), (after - before).norm() + 0.1) << f;
  }
  options.fills_gaps = true;  // this gap was not
  EXPECT_EQ(dark_frames(dots()[left_ankle]), 10);
}

TEST_F(MarkerDots, AreShownInGapsThatWereFilledInIfWanted) {
  clip = test::with_gap(clip, left_ankle, 10, 19, true);
  EXPECT_EQ(dark_frames(dots()[left_ankle]), 10);
  options.fills_gaps = true;
  EXPECT_EQ(dark_frames(dots()[left_ankle]), 0);
  const MarkerCounts counts = marker_counts(clip, options);
  EXPECT_EQ(counts.recorded, 6u);
  EXPECT_EQ(counts.shown, 6u);
  EXPECT_DOUBLE_EQ(counts.dark_share, 0.0);
  EXPECT_DOUBLE_EQ(counts.filled_share, 10.0 / 360.0);
  options.fills_gaps = false;
  EXPECT_DOUBLE_EQ(marker_counts(clip, options).dark_share, 10.0 / 360.0);
  EXPECT_DOUBLE_EQ(marker_counts(clip, options).filled_share, 0.0);
}

TEST_F(MarkerDots, HaveAPlaceInThePictureOnlyWhileTheyAreLit) {
  clip = test::with_gap(clip, left_ankle, 10, 19, true);
  const auto count_at = [&](std::size_t frame) {
    return marker_places(clip, options)[frame].size();
  };
  EXPECT_EQ(count_at(9), 6u);
  EXPECT_EQ(count_at(10), 5u);
  options.fills_gaps = true;
  EXPECT_EQ(count_at(10), 6u);
  options.show = {"R*"};
  EXPECT_EQ(count_at(10), 2u);
}

TEST_F(MarkerDots, ThatAreMissingThroughoutAreNotInvented) {
  clip = test::with_gap(clip, left_ankle, 0, 59, false);
  options.pairs = {{"LANK", "LKNE"}, {"RANK", "RKNE"}};
  EXPECT_EQ(dots().size(), 5u);
  EXPECT_EQ(shown_markers(clip, options).pairs, (std::vector<Limb>{{0, 2}}));
  EXPECT_EQ(marker_counts(clip, options).shown, 5u);
  options.pairs = {};
  options.show = {"LANK"};
  EXPECT_NE(refusal().find("missing in all frames"), std::string::npos);
}

TEST_F(MarkerDots, KeepTheirGapsInWhateverIsDoneToTheirTime) {
  clip = test::with_gap(clip, left_ankle, 10, 19, false);
  options.dots.reversed = true;
  const Dot backwards = dots()[left_ankle];
  for (std::size_t f = 0; f < 60; ++f) {
    EXPECT_EQ(backwards.is_shown(f), f < 40 || f > 49) << f;
  }
  options.dots.reversed = false;
  options.dots.phase_scrambled = true;
  EXPECT_EQ(dark_frames(dots()[left_ankle]), 10);
  options.dots.phase_scrambled = false;
  options.dots.constant_speed = true;
  const Dot even = dots()[left_ankle];
  EXPECT_GT(dark_frames(even), 2);
  EXPECT_LT(dark_frames(even), 30);
}

TEST_F(MarkerDots, TakeTheManipulationsOfPointLights) {
  clip = test::with_gap(clip, left_ankle, 10, 19, false);
  options.dots.scrambled = true;
  options.dots.noise = 3;
  options.dots.mask = 7;
  const std::vector<Dot> shown = dots();
  ASSERT_EQ(shown.size(), 16u);
  EXPECT_EQ(dark_frames(shown[left_ankle]), 10);
  EXPECT_EQ(dark_frames(shown[6]), 0);  // noise
  EXPECT_EQ(shown[9].kind, "mask");
  EXPECT_EQ(dark_frames(shown[9]), 10);   // has the motion of the first marker
  EXPECT_EQ(dark_frames(shown[15]), 10);  // and so has the seventh
  EXPECT_EQ(dark_frames(shown[10]), 0);
  EXPECT_EQ(shown[0].path, dots()[0].path);
  options.dots.seed = 6;
  EXPECT_NE(shown[0].path, dots()[0].path);
}

TEST_F(MarkerDots, LiveOnThePairsThatAreTheirLimbs) {
  options.dots.lifetime = 5;
  EXPECT_NE(refusal().find("name the two markers of each limb in pairs"), std::string::npos);
  options.pairs = {{"LANK", "LKNE"}};
  const auto joints = motion::joint_paths(clip);
  for (const Dot& dot : dots()) {
    EXPECT_EQ(dot.kind, "limb");
    for (std::size_t f = 0; f < joints.size(); ++f) {
      const Vec3 knee = joints[f][motion::LeftKnee];
      const Vec3 ankle = joints[f][motion::LeftAnkle];
      EXPECT_NEAR((dot.path[f] - knee).norm() + (dot.path[f] - ankle).norm(), (knee - ankle).norm(),
                  1e-9);
    }
  }
  clip = test::with_gap(clip, left_ankle, 10, 19, false);
  for (const Dot& dot : dots()) EXPECT_EQ(dark_frames(dot), 10);
}

TEST_F(MarkerDots, ThatAreScrambledHaveNoPairs) {
  options.pairs = {{"LANK", "LKNE"}};
  options.dots.scrambled = true;
  EXPECT_NE(refusal().find("omit scrambled or pairs"), std::string::npos);
}

/// A shot of the clip before a camera.
Shot shot_with(const motion::Clip& clip, const MarkersOptions& options, const char* view = "side") {
  Look look;
  look.figure = options;
  look.camera.view = view;
  return scenes::stage(clip, look);
}

std::size_t dots_in(const render::Scene& scene) {
  std::size_t corners = 0;
  for (const render::Mesh& mesh : scene.solids.meshes) corners += mesh.positions.size();
  return corners / 64;
}

TEST_F(MarkerDots, AndTheirSticksAreAbsentFromTheSceneWhereTheyAreDark) {
  clip = test::with_gap(clip, left_ankle, 10, 19, false);
  for (const auto& pair : {std::array<std::string, 2>{"LANK", "LKNE"}, {"LKNE", "LANK"}}) {
    options.pairs = {pair};
    const Shot one = shot_with(clip, options);
    EXPECT_EQ(scene_at(one, 9).solids.round_cones.size(), 1u) << pair[0];
    EXPECT_EQ(scene_at(one, 10).solids.round_cones.size(), 0u) << pair[0];
  }
  options.pairs = {{"LANK", "LKNE"}, {"RANK", "RKNE"}};
  const Shot shot = shot_with(clip, options);
  EXPECT_EQ(dots_in(scene_at(shot, 9)), 6u);
  EXPECT_EQ(scene_at(shot, 9).solids.round_cones.size(), 2u);
  EXPECT_EQ(dots_in(scene_at(shot, 10)), 5u);
  EXPECT_EQ(scene_at(shot, 10).solids.round_cones.size(), 1u);
  EXPECT_NO_THROW(render::validate(scene_at(shot, 10)));
  const render::RoundCone stick = scene_at(shot, 10).solids.round_cones.front();
  EXPECT_LT((stick.start.cast<double>() - shot.actors[0].dots[1].path[10]).norm(), 1e-5);
  EXPECT_LT((stick.end.cast<double>() - shot.actors[0].dots[3].path[10]).norm(), 1e-5);
  options.dots.size_m = 0.014;
  const render::Scene in_space = scene_at(shot_with(clip, options), 9);
  EXPECT_EQ(in_space.solids.spheres.size(), 6u);
  EXPECT_FLOAT_EQ(in_space.solids.spheres[0].radius, 0.007f);
  EXPECT_FLOAT_EQ(in_space.solids.round_cones[0].start_radius, 0.3f * 0.007f);
}

TEST_F(MarkerDots, AreInThePictureEvenIfTheBodyIsElsewhere) {
  motion::Markers markers = *motion::markers_of(clip);
  for (int f = 0; f < markers.frame_count(); ++f) {
    markers.positions[markers.at(f, head)] += Vec3(0.0, 1.5, 0.0);  // a raised wand
  }
  motion::attach(clip, markers);
  for (const char* view : {"front", "side", "three-quarter", "follow", "orbit"}) {
    for (const bool in_place : {false, true}) {
      Look look;
      look.figure = options;
      look.camera.view = view;
      look.in_place = in_place;
      const Shot shot = scenes::stage(clip, look);
      for (int frame = 0; frame < shot.frame_count(); frame += 7) {
        const render::Camera& camera = camera_at(shot, frame);
        for (const Dot& dot : shot.actors[0].dots) {
          const auto seen =
              render::project(camera, dot.path[static_cast<std::size_t>(frame)].cast<float>());
          ASSERT_TRUE(seen) << view;
          EXPECT_TRUE(seen->x() >= 0.0f && seen->x() <= static_cast<float>(camera.width) &&
                      seen->y() >= 0.0f && seen->y() <= static_cast<float>(camera.height))
              << view << ' ' << in_place << ' ' << frame << ' ' << dot.kind;
        }
      }
    }
  }
}

TEST_F(MarkerDots, StandOnTheStageWhereTheirBodyDoes) {
  for (motion::Pose& pose : clip.poses) pose.root_position.x() += 500.0;
  clip = test::with_markers(std::move(clip));
  const Shot shot = shot_with(clip, options);
  const motion::Clip& staged = shot.actors[0].clip;
  EXPECT_LT(staged.poses[0].root_position.norm(), 10.0);
  EXPECT_LT((shot.actors[0].dots[left_ankle].path[20] -
             motion::joint_paths(staged)[20][motion::LeftAnkle])
                .norm(),
            1e-9);
}

TEST_F(MarkerDots, NeedNoBody) {
  const motion::Clip alone =
      motion::clip_of_markers("points", clip.frames_per_second, *motion::markers_of(clip));
  EXPECT_NEAR(figure_height(alone), 1.5, 0.2);  // from the ankles to the neck's end
  const Shot shot = shot_with(alone, options, "three-quarter");
  EXPECT_EQ(shot.actors[0].dots.size(), 6u);
  EXPECT_NO_THROW(scene_at(shot, 5));
}

TEST_F(MarkerDots, OfSeveralMotionsAreNotShownTogether) {
  Look look;
  look.figure = options;
  const std::vector<Performance> two = {{.name = "a", .clip = clip}, {.name = "b", .clip = clip}};
  EXPECT_NE(mien::test::refusal_of([&] { scenes::stage(two, look); }).find("told apart"),
            std::string::npos);
}

TEST_F(MarkerDots, StandForAStickFigureOfPointsWithoutABody) {
  const motion::Markers* const markers = motion::markers_of(clip);
  ASSERT_NE(markers, nullptr);
  const motion::Clip points = motion::clip_of_markers("points", 60.0, *markers);
  Look look;
  look.figure = StickOptions{};
  EXPECT_EQ(scenes::stage(points, look).actors.front().dots.size(), test::carriers().size());
  EXPECT_TRUE(scenes::stage(clip, look).actors.front().dots.empty()) << "a body is drawn as one";
}

}  // namespace
}  // namespace mien::scenes
