#include "motion/steered_walk/scripted_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/gait/foot_slide.h"
#include "motion/lint/lint.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/procedural/expressive_walks.h"
#include "motion/steered_walk/floor_path.h"
#include "motion/walker_motions.h"

namespace mien::motion {
namespace {

using Kind = WalkSegment::Kind;

const WalkerGaits& normal_and_sad() {
  static const WalkerGaits gaits =
      fit_walker(std::array<WalkStyle, 2>{WalkStyle{}, sad_walk()}, standard_body());
  return gaits;
}

double heading_of(const Pose& pose) {
  const Vec3 forward = pose.rotations[Pelvis] * Vec3::UnitZ();
  return std::atan2(forward.x(), forward.z()) / radians_per_degree;
}

/// Largest distance of the pelvis from a polyline on the floor.
double farthest_from(const std::vector<Vec3>& path, const Clip& clip) {
  double farthest = 0.0;
  for (const Pose& pose : clip.poses) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Vec3 piece = path[i] - path[i - 1];
      const Vec3 from = horizontal(pose.root_position) - path[i - 1];
      const double t = std::clamp(from.dot(piece) / piece.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (from - t * piece).norm());
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

TEST(ScriptedWalk, WalksTurnsAndStandsAsItIsTold) {
  const std::vector<WalkSegment> script = {{.kind = Kind::walk, .seconds = 3.0},
                                           {.kind = Kind::turn, .degrees = 90.0, .pace = 0.0},
                                           {.kind = Kind::stand, .seconds = 1.0}};
  const Clip clip = scripted_walk(normal_and_sad(), script).clip;
  EXPECT_FALSE(clip.loops);
  EXPECT_GT(clip.poses[90].root_position.z(), 2.5);
  EXPECT_NEAR(clip.poses[90].root_position.x(), 0.0, 0.05);
  EXPECT_NEAR(heading_of(clip.poses.back()), 90.0, 10.0);
  const Vec3 last_second =
      clip.poses.back().root_position - clip.poses[clip.poses.size() - 30].root_position;
  EXPECT_LT(last_second.norm(), 0.02);
}

TEST(ScriptedWalk, TurnsMoreThanHalfACircleTheWayItIsTold) {
  for (const double degrees : {270.0, -270.0}) {
    const std::vector<WalkSegment> script = {{.kind = Kind::turn, .degrees = degrees, .pace = 0.0}};
    const Clip clip = scripted_walk(normal_and_sad(), script).clip;
    double turned = 0.0;
    for (std::size_t i = 1; i < clip.poses.size(); ++i) {
      turned += std::remainder(heading_of(clip.poses[i]) - heading_of(clip.poses[i - 1]), 360.0);
    }
    EXPECT_NEAR(turned, degrees, 15.0);
  }
}

TEST(ScriptedWalk, MoodsComeWhenTheyAreDue) {
  ScriptedWalkOptions options;
  options.moods = {{0.0, {1.0, 0.0}}, {4.0, {0.0, 1.0}}};
  const std::vector<WalkSegment> script = {{.kind = Kind::walk, .seconds = 8.0}};
  const Clip clip = scripted_walk(normal_and_sad(), script, options).clip;
  const auto way = [&](int from, int to) {
    return clip.poses[static_cast<std::size_t>(to)].root_position.z() -
           clip.poses[static_cast<std::size_t>(from)].root_position.z();
  };
  EXPECT_NEAR(way(90, 120), 1.35, 0.1);
  EXPECT_LT(way(210, 240), 1.0);  // the sad walk is slow
}

TEST(ScriptedWalk, CirclesAndSlalomsAreFollowed) {
  std::vector<Vec3> circle;
  std::vector<Vec3> slalom;
  for (int i = 0; i <= 80; ++i) {
    const double angle = 2.0 * pi * i / 80;
    circle.emplace_back(2.0 * std::sin(angle), 0.0, 2.0 - 2.0 * std::cos(angle));
    slalom.emplace_back(0.8 * std::sin(2.0 * angle), 0.0, 0.1 * i);
  }
  for (const std::vector<Vec3>& path : {circle, slalom}) {
    const Clip clip = walk_along(normal_and_sad(), path).clip;
    EXPECT_LT(farthest_from(path, clip), 0.2);
    EXPECT_LT((horizontal(clip.poses.back().root_position) - path.back()).norm(), 0.15);
  }
}

TEST(ScriptedWalk, CornersAreRounded) {
  const std::vector<Vec3> path = {{0, 0, 0}, {0, 0, 3}, {3, 0, 3}, {3, 0, 0}};
  EXPECT_LT(farthest_from(path, walk_along(normal_and_sad(), path).clip), 0.25);
}

/// Narrow, fast and hardly lifted steps, round sharp corners and on the spot: legs pass beside each
/// other, ankles stay within their range, and no foot slides.
TEST(ScriptedWalk, SharpTurnsBreakNothing) {
  const std::vector<WalkSegment> script = {{.kind = Kind::walk, .seconds = 2.0},
                                           {.kind = Kind::turn, .degrees = 135.0},
                                           {.kind = Kind::walk, .seconds = 1.0},
                                           {.kind = Kind::stand, .seconds = 0.3},
                                           {.kind = Kind::turn, .degrees = -170.0, .pace = 0.0},
                                           {.kind = Kind::stand, .seconds = 0.5}};
  for (const NamedStyle& walk : builtin_styles("walks-27")) {
    if (walk.name != "afraid-normal" && walk.name != "excited-fast" && walk.name != "bored-fast")
      continue;
    const WalkedClip walked = scripted_walk(fit_walker({&walk.style, 1}, standard_body()), script);
    EXPECT_LT(planted_slide(walked.clip, walked.plants), 0.001) << walk.name;
    for (const Finding& finding : lint(walked.clip)) {
      EXPECT_NE(finding.severity, Severity::error) << walk.name << ": " << finding.sentence;
      EXPECT_NE(finding.check, "self-intersection") << walk.name << ": " << finding.sentence;
      EXPECT_NE(finding.check, "joint-limit") << walk.name << ": " << finding.sentence;
      EXPECT_NE(finding.check, "foot-skate") << walk.name << ": " << finding.sentence;
    }
  }
}

TEST(ScriptedWalk, RefusesWhatCannotBeWalked) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<WalkSegment> nothing;
  EXPECT_THROW(scripted_walk(normal_and_sad(), nothing), Error);
  const std::vector<WalkSegment> back = {{.kind = Kind::walk, .seconds = 1.0, .pace = -1.0}};
  EXPECT_THROW(scripted_walk(normal_and_sad(), back), Error);
  const std::vector<WalkSegment> never = {{.kind = Kind::walk, .seconds = none}};
  EXPECT_THROW(scripted_walk(normal_and_sad(), never), Error);
  const std::vector<Vec3> point = {{1, 0, 1}, {1, 0, 1}};
  EXPECT_THROW(walk_along(normal_and_sad(), point), Error);
  const std::vector<Vec3> broken = {{0, 0, 0}, {none, 0, 1}};
  EXPECT_THROW(walk_along(normal_and_sad(), broken), Error);
}

TEST(FloorPath, KeepsItsEndsAndItsLength) {
  const std::vector<Vec3> points = {{0, 5, 0}, {0, 0, 2}, {1, -1, 2}};
  const FloorPath path = floor_path(points);
  EXPECT_LT((point_at(path, 0.0) - Vec3(0, 0, 0)).norm(), 1e-12);
  EXPECT_LT((point_at(path, path.length()) - Vec3(1, 0, 2)).norm(), 1e-12);
  EXPECT_NEAR(path.length(), 3.0, 1e-9);
  EXPECT_NEAR(heading_at(path, 0.5), 0.0, 1e-9);
  EXPECT_NEAR(heading_at(path, 2.9), 0.5 * pi, 0.01);
  EXPECT_LT(largest_curvature(path, 0.0, 1.0), 1e-6);
}

TEST(WalkerMotions, BeginAndEndWhereOthersGoOn) {
  const std::vector<Clip> clips = test::walker_motions(WalkStyle{}, 30.0, standard_body());
  EXPECT_EQ(clips.size(), 11U);
  for (const Clip& clip : clips) {
    EXPECT_FALSE(clip.loops);
    EXPECT_GT(clip.duration_seconds(), 1.0) << clip.name;
    EXPECT_LT(horizontal(clip.poses.front().root_position).norm(), 1e-9) << clip.name;
  }
}

}  // namespace
}  // namespace mien::motion
