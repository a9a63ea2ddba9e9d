#include "motion/skeleton/clip_markers.h"

#include <cmath>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"
#include "motion/skeleton/mirror.h"
#include "motion/skeleton/straighten.h"
#include "motion/synthetic_walk.h"

namespace mien::motion {
namespace {

using namespace mien::test;

constexpr BodyJoint carriers[] = {LeftWrist, RightWrist, Head};

/// A walk with a marker on each wrist and the head, without gaps.
Clip marked_walk(double seconds = 2.0, double heading = 0.0) {
  SyntheticWalk walk = steady_walk(1.2, seconds);
  walk.heading = heading;
  Clip clip = synthetic_clip(walk);
  Markers markers;
  markers.points = {"LWRI", "RWRI", "HEAD"};
  for (const std::vector<Vec3>& joints : joint_paths(clip)) {
    for (const BodyJoint joint : carriers) markers.positions.push_back(joints[joint]);
  }
  markers.seen.assign(markers.positions.size(), true);
  markers.filled.assign(markers.positions.size(), false);
  attach(clip, std::move(markers));
  return clip;
}

/// The largest distance of a marker from the joint that carries it; 1 if the clip has no markers.
double distance_from_body(const Clip& clip, double tolerance_frames = 0.0) {
  const Markers* markers = markers_of(clip);
  if (markers == nullptr || markers->frame_count() != clip.frame_count()) return 1.0;
  const std::vector<std::vector<Vec3>> joints = joint_paths(clip);
  double most = tolerance_frames;
  for (int frame = 0; frame < clip.frame_count(); ++frame) {
    for (int point = 0; point < 3; ++point) {
      most = std::max(most, (markers->positions[markers->at(frame, point)] -
                             joints[static_cast<size_t>(frame)][carriers[point]])
                                .norm());
    }
  }
  return most;
}

/// The clip with a point hidden from frame `first` to `last`, or filled in there.
Clip with_gap(Clip clip, int point, int first, int last, bool filled = false) {
  Markers markers = *markers_of(clip);
  for (int frame = first; frame <= last; ++frame) {
    markers.seen[markers.at(frame, point)] = false;
    markers.filled[markers.at(frame, point)] = filled;
    if (!filled) markers.positions[markers.at(frame, point)] = Vec3::Zero();
  }
  attach(clip, std::move(markers));
  return clip;
}

TEST(ClipMarkers, AreThoseOfTheMotionThatTheyWereAttachedTo) {
  const Clip clip = marked_walk();
  ASSERT_NE(markers_of(clip), nullptr);
  EXPECT_NE(markers_of(Clip(clip)), nullptr);
  EXPECT_EQ(markers_of(synthetic_clip(steady_walk(1.2, 1.0))), nullptr);
}

TEST(ClipMarkers, AreNotShownWithAnotherMotion) {
  const auto has_markers_after = [](const auto& change) {
    Clip clip = marked_walk();
    change(clip);
    return markers_of(clip) != nullptr;
  };
  EXPECT_FALSE(has_markers_after([](Clip& clip) { clip.poses[7].root_position.y() += 1e-9; }));
  EXPECT_FALSE(has_markers_after([](Clip& clip) { clip.poses.pop_back(); }));
  EXPECT_FALSE(has_markers_after([](Clip& clip) { clip.frames_per_second *= 1.1; }));
  EXPECT_FALSE(has_markers_after([](Clip& clip) { std::swap(clip.poses[3], clip.poses[4]); }));
  EXPECT_FALSE(has_markers_after([](Clip& clip) { clip.body.joints[LeftElbow].offset *= 1.1; }));
  // Two signs that change at once, as in a mirror image.
  EXPECT_FALSE(has_markers_after(
      [](Clip& clip) { clip.poses[5].rotations[LeftHip].coeffs().head<2>() *= -1.0; }));
  EXPECT_TRUE(has_markers_after([](Clip& clip) { clip.name = "other"; }));
}

TEST(ClipMarkers, StayOnTheBodyWhereverItIsMoved) {
  const Clip clip = marked_walk(2.0, 0.7);
  ASSERT_LT(distance_from_body(clip), 1e-12);
  EXPECT_LT(distance_from_body(straightened(clip)), 1e-9);
  EXPECT_LT(distance_from_body(kept_in_place(clip)), 1e-9);
  EXPECT_LT(distance_from_body(playback_clip(clip, {.cycles = 1, .in_place = true})), 1e-9);
  const Clip part = cut(clip, 20, 60);
  EXPECT_EQ(part.frame_count(), 41);
  EXPECT_LT(distance_from_body(part), 1e-12);
  EXPECT_LT((part.poses[3].root_position - clip.poses[23].root_position).norm(), 1e-12);
}

TEST(ClipMarkers, AreMirroredWithTheirSides) {
  const Clip image = mirrored(marked_walk(1.0, 0.3));
  EXPECT_LT(distance_from_body(image), 1e-9);
  EXPECT_EQ(markers_of(image)->points.front(), "LWRI");
}

TEST(ClipMarkers, AreRepeatedWithALoop) {
  Clip loop = marked_walk(1.0);
  const Markers markers = *markers_of(loop);
  loop.loops = true;
  loop.cycle_displacement = Vec3(0.0, 0.0, 1.2);
  EXPECT_EQ(markers_of(loop), nullptr);
  attach(loop, markers);
  const Clip three = repeated(loop, 3);
  EXPECT_EQ(three.frame_count(), 3 * loop.frame_count());
  EXPECT_LT(distance_from_body(three), 1e-9);
  EXPECT_LT(distance_from_body(in_place(loop)), 1e-9);
  EXPECT_LT(distance_from_body(travelling(in_place(loop), Vec3(0.0, 0.0, 0.8))), 1e-9);
  EXPECT_NE(markers_of(resampled(loop, 37.0)), nullptr);
}

TEST(ClipMarkers, FollowThePathAtAnotherRate) {
  const Clip clip = marked_walk();  // 100 frames per second
  const Clip half = resampled(clip, 50.0);
  EXPECT_LT(distance_from_body(half), 1e-9);
  const Clip other = resampled(clip, 60.0);
  ASSERT_NE(markers_of(other), nullptr);
  EXPECT_EQ(markers_of(other)->frame_count(), other.frame_count());
  EXPECT_LT(distance_from_body(other), 1e-3);  // slerp beside a cubic path
  EXPECT_EQ(resampled(clip, 100.0).markers->positions, clip.markers->positions);
}

TEST(ClipMarkers, ThatAreMissingStayMissingAtAnotherRate) {
  const Clip clip = with_gap(marked_walk(), 1, 40, 60);
  const Clip other = resampled(clip, 60.0);
  const Markers& markers = *markers_of(other);
  int dark = 0;
  for (int frame = 0; frame < other.frame_count(); ++frame) {
    const double at = frame * 100.0 / 60.0;
    const std::size_t index = markers.at(frame, 1);
    const bool expected =
        std::floor(at + 1e-9) < 40 || std::ceil(at - 1e-9) < 40 || std::floor(at + 1e-9) > 60;
    EXPECT_EQ(markers.seen[index], expected) << at;
    EXPECT_FALSE(markers.filled[index]);
    EXPECT_EQ(markers.positions[index].isZero(), !expected);
    dark += expected ? 0 : 1;
    EXPECT_TRUE(markers.seen[markers.at(frame, 0)]);
  }
  EXPECT_GT(dark, 10);
  // Beside the gap nothing is drawn towards the zero that stands in it.
  EXPECT_LT((markers.positions[markers.at(23, 1)] - joint_paths(other)[23][RightWrist]).norm(),
            2e-3);
}

TEST(ClipMarkers, ThatWereFilledInAreStillToldApart) {
  const Clip other = resampled(with_gap(marked_walk(), 0, 40, 60, true), 60.0);
  const Markers& markers = *markers_of(other);
  for (int frame = 0; frame < other.frame_count(); ++frame) {
    const std::size_t index = markers.at(frame, 0);
    EXPECT_TRUE(markers.is_known(index));
    EXPECT_NE(markers.seen[index], markers.filled[index]);
  }
  EXPECT_LT(distance_from_body(other), 1e-3);
  EXPECT_TRUE(markers.filled[markers.at(30, 0)]);  // at frame 50 of 100 per second
}

TEST(ClipMarkers, BetweenASeenFrameAndAnotherAreAsTheOther) {
  constexpr int before = 25, after = 35;  // at frames 41.7 and 58.3 of 100 per second
  const Clip missing = resampled(with_gap(marked_walk(), 0, 42, 58), 60.0);
  const Clip filled = resampled(with_gap(marked_walk(), 0, 42, 58, true), 60.0);
  for (const int frame : {before, after}) {
    const std::size_t index = markers_of(missing)->at(frame, 0);
    EXPECT_FALSE(markers_of(missing)->is_known(index)) << frame;
    EXPECT_FALSE(markers_of(filled)->seen[index]) << frame;
    EXPECT_TRUE(markers_of(filled)->filled[index]) << frame;
  }
  EXPECT_TRUE(markers_of(missing)->seen[markers_of(missing)->at(before - 1, 0)]);
  EXPECT_TRUE(markers_of(missing)->seen[markers_of(missing)->at(after + 1, 0)]);
}

TEST(ClipMarkers, AloneMoveAJointInTheirCentre) {
  const Clip marked = with_gap(marked_walk(), 2, 0, 10);
  const Clip clip = clip_of_markers("points", 100.0, *marked.markers);
  EXPECT_EQ(clip.body.size(), 1);
  EXPECT_FALSE(is_body(clip.body));
  EXPECT_EQ(clip.frame_count(), marked.frame_count());
  ASSERT_NE(markers_of(clip), nullptr);
  const std::vector<std::vector<Vec3>> joints = joint_paths(marked);
  Vec3 centre = Vec3::Zero();
  for (const BodyJoint joint : carriers) centre += joints[50][joint] / 3.0;
  EXPECT_LT((clip.poses[50].root_position - centre).norm(), 1e-12);
  // A marker that appears does not make the body jump.
  EXPECT_LT((clip.poses[11].root_position - clip.poses[10].root_position).norm(), 0.02);
  EXPECT_NE(markers_of(kept_in_place(clip)), nullptr);
  EXPECT_NE(markers_of(resampled(clip, 30.0)), nullptr);
  EXPECT_NE(markers_of(straightened(clip)), nullptr);
}

}  // namespace
}  // namespace mien::motion
