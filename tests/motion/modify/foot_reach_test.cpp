#include "motion/modify/foot_reach.h"

#include <gtest/gtest.h>

#include "motion/gait/foot_path.h"
#include "motion/math/rotation.h"
#include "motion/procedural/builtin_sets.h"

namespace mien::motion {
namespace {

Clip built_in_walk() { return builtin_examples("walks-10").examples[0].clip; }

/// The places of the left foot over some frames, moved by `offset`.
FootTrajectory moved_places(const Clip& clip, int first, int last, const Vec3& offset) {
  const FootPath path = foot_path(clip, true);
  FootTrajectory stretch{true, first, {}};
  for (int f = first; f <= last; ++f) {
    stretch.places.push_back({path.ankle_at(f) + offset, path.rotation_at(f)});
  }
  return stretch;
}

/// Horizontal distance from the left hip to where its foot is to be, maximum over the frames.
double farthest_target(const Clip& clip, const FootTrajectory& stretch) {
  const FootPath path = foot_path(clip, true);
  double farthest = 0.0;
  for (size_t k = 0; k < stretch.places.size(); ++k) {
    const int frame = stretch.first + static_cast<int>(k);
    const Pose& pose = clip.poses[static_cast<size_t>(path.wrapped(frame))];
    const Vec3 hip = world_transform(clip.body, pose, LeftHip).position;
    const Vec3 way = stretch.places[k].ankle - path.displacement(frame) - hip;
    farthest = std::max(farthest, horizontal(way).norm());
  }
  return farthest;
}

TEST(FootReach, IsBroughtAboutByMovingTheRootOverTheFloor) {
  const Clip walk = built_in_walk();
  const double leg =
      walk.body.joints[LeftKnee].offset.norm() + walk.body.joints[LeftAnkle].offset.norm();
  const int frames = walk.frame_count();
  for (const Vec3& offset : {Vec3(0, 0, 1.5), Vec3(-1.2, 0, 0.6), Vec3(0, 0.3, -2.0)}) {
    const FootTrajectory stretch = moved_places(walk, frames - 6, frames + 5, offset);
    ASSERT_GT(farthest_target(walk, stretch), leg);
    const Clip moved = with_feet_in_reach(walk, {stretch});
    EXPECT_LT(farthest_target(moved, stretch), 0.91 * leg);
    for (int f = 0; f < frames; ++f) {
      const auto at = static_cast<size_t>(f);
      EXPECT_EQ(moved.poses[at].root_position.y(), walk.poses[at].root_position.y());
      const Vec3 now = moved.poses[at].root_position - walk.poses[at].root_position;
      const auto next = static_cast<size_t>((f + 1) % frames);
      const Vec3 following = moved.poses[next].root_position - walk.poses[next].root_position;
      EXPECT_LT((following - now).norm(), 0.6) << f;  // smooth, over the seam, too
    }
  }
}

TEST(FootReach, LeavesMotionsAloneWhoseFeetAreInReach) {
  const Clip walk = built_in_walk();
  const Clip moved =
      with_feet_in_reach(walk, {moved_places(walk, 0, walk.frame_count() - 1, Vec3::Zero())});
  for (size_t f = 0; f < walk.poses.size(); ++f) {
    EXPECT_EQ(moved.poses[f].root_position, walk.poses[f].root_position);
  }
}

}  // namespace
}  // namespace mien::motion
