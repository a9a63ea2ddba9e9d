#include "motion/dynamics/tempo_forces.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/biomechanics/body_dynamics.h"
#include "motion/biomechanics/lint_motion.h"
#include "motion/gait/contact.h"
#include "motion/gait/foot_lock.h"
#include "motion/gait/gait_plants.h"
#include "motion/gait/loop.h"
#include "motion/jumping_figure.h"
#include "motion/modify/modification.h"
#include "motion/modify/path_measures.h"
#include "motion/procedural/walker.h"
#include "motion/skeleton/straighten.h"
#include "motion/synthetic_run.h"

namespace mien::motion {
namespace {

using namespace mien::test;

Modification in_gravity(const Tempo& tempo) {
  Modification m;
  m.tempo = tempo;
  m.gravity = TempoGravity::kept;
  return m;
}

/// Frames of the longest stretch in which the centre of mass falls freely, and how high it rises
/// in it above its ends.
struct Fall {
  int frames = 0;
  double rise = 0.0;
};

std::vector<Fall> falls(const Clip& clip) {
  const std::vector<double> heights = body_heights(clip);
  const double rate = clip.frames_per_second;
  std::vector<Fall> found;
  size_t first = 0;
  for (size_t f = 1; f + 1 < heights.size(); ++f) {
    const double bend = (heights[f + 1] - 2.0 * heights[f] + heights[f - 1]) * rate * rate;
    if (std::abs(bend + gravity) < 0.01) {
      if (first == 0) first = f;
      continue;
    }
    if (first != 0 && f - first > 4) {
      const double top = *std::max_element(heights.begin() + static_cast<long>(first),
                                           heights.begin() + static_cast<long>(f));
      found.push_back(
          {static_cast<int>(f - first) + 1, top - 0.5 * (heights[first - 1] + heights[f])});
    }
    first = 0;
  }
  return found;
}

double range_of(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

/// A figure that stands and bobs.
Clip bobbing(double amplitude, double hertz) {
  Clip clip;
  clip.body = standard_body();
  clip.frames_per_second = 100.0;
  clip.loops = true;
  const Pose standing = standing_pose(clip.body);
  const std::vector<Vec3> places = world_positions(clip.body, standing);
  const int frames = static_cast<int>(std::lround(4.0 * 100.0 / hertz));
  for (int f = 0; f < frames; ++f) {
    Pose pose = standing;
    pose.root_position.y() += amplitude * std::cos(2.0 * pi * hertz * f / 100.0) - 0.08;
    for (const BodyJoint hip : {LeftHip, RightHip})
      put_leg(pose, clip.body, hip, {places[static_cast<size_t>(hip + 2)], 0.0});
    clip.poses.push_back(pose);
  }
  return clip;
}

TEST(TempoForces, JumpAsHighAsTheSquareOfTheDuration) {
  const Clip clip = jumping({}, false);
  const std::vector<Fall> before = falls(modified(clip, in_gravity(1.0001)));
  ASSERT_GE(before.size(), 2U);
  for (const double tempo : {0.8, 0.9, 1.25, 1.5}) {
    const std::vector<Fall> after = falls(modified(clip, in_gravity(tempo)));
    ASSERT_GE(after.size(), 2U) << tempo;
    // Two frames of uncertainty of the contacts on either side of a flight of 36 frames.
    EXPECT_NEAR(after.front().frames * tempo, before.front().frames, 5.0 * tempo) << tempo;
    const double seconds = after.front().frames / 100.0;
    EXPECT_NEAR(after.front().rise, gravity * seconds * seconds / 8.0, 0.004) << tempo;
  }
}

TEST(TempoForces, PlayedLikeAFilmDoNotFallWithGravity) {
  Modification film;
  film.tempo = 0.8;
  EXPECT_TRUE(falls(modified(jumping({}, false), film)).empty());
}

TEST(TempoForces, BounceAsTheSquareOfTheDuration) {
  const Clip clip = bobbing(0.02, 2.0);
  const double own = range_of(body_heights(clip));
  for (const double tempo : {0.75, 0.9, 1.2, 2.0}) {
    const Clip other = modified(clip, in_gravity(tempo));
    EXPECT_NEAR(range_of(body_heights(other)) * tempo * tempo / own, 1.0, 0.05) << tempo;
    Modification film;
    film.tempo = tempo;
    EXPECT_NEAR(range_of(body_heights(modified(clip, film))) / own, 1.0, 0.02) << tempo;
  }
}

TEST(TempoForces, FlyBallisticallyInRuns) {
  SyntheticRun run;
  const Clip take = steady_run(run, 2.0 * run.stride, 2.5);
  for (const Clip& clip : {take, straightened(closed_loop(take, 100, 150))}) {
    for (const double tempo : {0.85, 1.2}) {
      const Clip other = modified(clip, in_gravity(tempo));
      const Clip unrolled = other.loops ? repeated(other, 2) : other;
      EXPECT_GE(falls(unrolled).size(), clip.loops ? 2U : 5U) << tempo;
    }
  }
}

TEST(TempoForces, WalkFasterWithLongerStepsAndShorterContact) {
  const Clip clip = walk({}, 100.0, standard_body()).clip;
  const std::vector<FootPlant> plants = foot_plants(clip);
  const double way = clip.cycle_displacement.norm();
  const Carriage carriage = carriage_of(clip, plants, way);
  EXPECT_TRUE(carriage.walks());
  double last_share = 2.0;  // of both feet
  for (const double tempo : {0.75, 0.9, 1.15, 1.3}) {
    const ModifiedClip other = modify(clip, in_gravity(tempo));
    const double longer = other.clip.cycle_displacement.norm() / way;
    EXPECT_NEAR(longer, step_factor(tempo, carriage), 0.06) << tempo;
    const std::vector<FootPlant> now = foot_plants(other.clip);
    EXPECT_LT(planted_drift(other.clip, now), 0.012) << tempo;
    double stands = 0.0;
    for (const FootPlant& plant : now) stands += plant.last - plant.first;
    const double share = stands / other.clip.frame_count();
    EXPECT_LT(share, last_share) << tempo;
    last_share = share;
  }
}

TEST(TempoForces, PressTheFloorWithNoMoreThanBodiesCan) {
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  for (const double tempo : {0.6, 0.8, 1.2, 1.5, 2.0}) {
    const std::vector<BodyDynamics> moments =
        body_dynamics(lint_motion(modified(clip, in_gravity(tempo))));
    for (size_t f = moments.size() / 3; f < 2 * moments.size() / 3; ++f) {
      const double press = moments[f].ground_reaction.y() / gravity;
      EXPECT_GT(press, 0.1) << tempo;
      EXPECT_LT(press, 2.5) << tempo;
    }
  }
}

TEST(TempoForces, StayBelowTheFroudeNumberOfRunning) {
  Carriage carriage{.travels = true, .speed = 1.4, .leg = 0.9};
  EXPECT_NEAR(step_factor(1.2, carriage), std::pow(1.2, 0.42 / 0.58), 1e-12);
  EXPECT_NEAR(step_factor(0.7, carriage), std::pow(0.7, 0.42 / 0.58), 1e-12);
  for (const double tempo : {1.3, 1.5, 3.0}) {
    const double speed = 1.4 * tempo * step_factor(tempo, carriage);
    EXPECT_LE(speed, std::max(1.4 * tempo, std::sqrt(0.5 * gravity * 0.9)) + 1e-12);
  }
  // As speed to the power of 0.42: the step of the law at the new speed.
  const double f = step_factor(1.1, carriage);
  EXPECT_NEAR(f, std::pow(1.1 * f, 0.42), 1e-12);
  carriage.travels = false;
  EXPECT_EQ(step_factor(1.2, carriage), 1.0);
}

TEST(TempoForces, CloseInLoops) {
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  Tempo curve;
  curve.curve = {{0.0, 0.9}, {0.5, 1.3}};
  for (const Tempo& tempo : {Tempo(1.25), curve}) {
    const Clip other = modified(clip, in_gravity(tempo));
    EXPECT_LT(largest_second_difference(other), 4.0 * largest_second_difference(clip));
  }
}

TEST(TempoForces, AreTheSameAtEveryFrameRate) {
  std::vector<double> heights[3], ways;
  for (int i = 0; i < 3; ++i) {
    const Clip clip = modified(walk({}, 30.0 * (1 << i), standard_body()).clip, in_gravity(1.2));
    for (int f = 0; f < 20; ++f)
      heights[i].push_back(pose_at(clip, clip.duration_seconds() * f / 20.0).root_position.y());
    ways.push_back(clip.cycle_displacement.norm());
  }
  EXPECT_NEAR(ways[0], ways[2], 0.02);
  EXPECT_NEAR(ways[1], ways[2], 0.01);
  for (size_t f = 0; f < heights[0].size(); ++f) {
    EXPECT_NEAR(heights[0][f], heights[2][f], 0.007);
    EXPECT_NEAR(heights[1][f], heights[2][f], 0.004);
  }
}

TEST(TempoForces, ChangeNothingWithoutAChangeOfTempo) {
  const Clip clip = walk({}, 60.0, standard_body()).clip;
  EXPECT_TRUE(is_identity(in_gravity(1.0)));
  EXPECT_EQ(largest_distance(modified(clip, in_gravity(1.0)), clip), 0.0);
  Modification m = in_gravity(1.0);
  m.paths = 1.3;
  Modification same = m;
  same.gravity = TempoGravity::scaled;
  EXPECT_EQ(largest_distance(modified(clip, m), modified(clip, same)), 0.0);
}

}  // namespace
}  // namespace mien::motion
