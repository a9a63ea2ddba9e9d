#include "motion/steered_walk/steered_walk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/math/random_number.h"
#include "motion/math/rotation.h"
#include "motion/procedural/expressive_walks.h"
#include "motion/procedural/walker.h"
#include "motion/skeleton/clip.h"
#include "motion/skeleton/sole.h"

namespace mien::motion {
namespace {

constexpr double film_fps = 60.0;

const WalkerGaits& three_moods() {
  static const WalkerGaits gaits =
      fit_walker(std::array<WalkStyle, 3>{WalkStyle{}, sad_walk(), angry_walk()}, standard_body());
  return gaits;
}

/// What a walker did, frame by frame.
struct Filmed {
  Clip clip;
  std::vector<SteeredWalk> walkers;
};

void film(Filmed& filmed, SteeredWalk& walker, const Steering& steering, double seconds) {
  filmed.clip.body = three_moods().body;
  filmed.clip.frames_per_second = film_fps;
  for (int i = 0; i < std::lround(seconds * film_fps); ++i) {
    advance(three_moods(), steering, 1.0 / film_fps, walker);
    filmed.clip.poses.push_back(pose_of(three_moods(), walker));
    filmed.walkers.push_back(walker);
  }
}

/// Steering as by somebody who hammers the keys.
Filmed randomly_steered(std::uint64_t seed, double seconds) {
  SteeredWalk walker = standing_walker(three_moods());
  Filmed filmed;
  std::uint64_t draw = 0;
  const auto share = [&] { return 0.5 + 0.5 * random_number(seed, "steering", draw++); };
  while (filmed.clip.poses.empty() || filmed.clip.duration_seconds() < seconds) {
    Steering steering;
    steering.pace = share() < 0.3 ? 0.0 : 1.2 * share();
    if (share() < 0.5)
      steering.heading = 2.0 * pi * share();
    else
      steering.turning = share() < 0.4 ? 0.0 : 4.0 * (share() - 0.5);
    steering.moods = {share(), share(), share() < 0.5 ? 0.0 : share()};
    film(filmed, walker, steering, share() < 0.3 ? 0.1 + 0.4 * share() : 0.5 + 2.0 * share());
  }
  return filmed;
}

/// Largest acceleration of a joint, m/s².
double largest_acceleration(const Clip& clip) {
  const std::vector<std::vector<Vec3>> paths = joint_paths(clip);
  double largest = 0.0;
  for (std::size_t i = 1; i + 1 < paths.size(); ++i) {
    for (std::size_t j = 0; j < paths[i].size(); ++j) {
      const Vec3 bend = paths[i + 1][j] - 2.0 * paths[i][j] + paths[i - 1][j];
      largest = std::max(largest, bend.norm() * clip.frames_per_second * clip.frames_per_second);
    }
  }
  return largest;
}

/// Farthest that the part of a standing foot on which it turns (heel's edge or toe joint) moves
/// from frame to frame, and over a whole stance.
double largest_slide(const Filmed& filmed) {
  const std::vector<std::vector<Vec3>> joints = joint_paths(filmed.clip);
  double largest = 0.0;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::vector<SolePoints> sole = sole_paths(filmed.clip, side == 0);
    const auto toe = static_cast<std::size_t>(side == 0 ? LeftToe : RightToe);
    double slid = 0.0;
    for (std::size_t i = 1; i < sole.size(); ++i) {
      const SteppingLeg& before = filmed.walkers[i - 1].legs[side];
      const SteppingLeg& now = filmed.walkers[i].legs[side];
      if (before.swinging || now.swinging || before.print != now.print) {
        slid = 0.0;
        continue;
      }
      slid += std::min((sole[i].heel - sole[i - 1].heel).norm(),
                       (joints[i][toe] - joints[i - 1][toe]).norm());
      largest = std::max(largest, slid);
    }
  }
  return largest;
}

TEST(SteeredWalk, StraightOnItIsTheWalkOfTheParametricWalker) {
  SteeredWalk walker = standing_walker(three_moods());
  Filmed filmed;
  Steering steering;
  steering.pace = 1.0;
  film(filmed, walker, steering, 8.0);
  const Example example = walk(WalkStyle{}, 240.0, standard_body());
  const double cycle = example.clip.duration_seconds();
  const double phase = walker.phase - std::floor(walker.phase);
  const Pose expected = pose_at(example.clip, phase * cycle);
  const std::vector<Vec3> a = world_positions(three_moods().body, filmed.clip.poses.back());
  const std::vector<Vec3> b = world_positions(example.clip.body, expected);
  for (std::size_t j = 0; j < a.size(); ++j) {
    const Vec3 away = (a[j] - a[Pelvis]) - (b[j] - b[Pelvis]);
    EXPECT_LT(away.norm(), 0.012) << name_of(BodyJoint(j));
  }
  EXPECT_NEAR(walker.root.speed.value, WalkStyle{}.speed_m_s * leg_length(standard_body()) / 0.85,
              0.01);
  EXPECT_NEAR(walker.root.place.x(), 0.0, 1e-9);
}

TEST(SteeredWalk, StandingFeetStayWhereTheyAreHoweverItIsSteered) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    EXPECT_LT(largest_slide(randomly_steered(seed, 40.0)), 0.003) << "seed " << seed;
  }
}

TEST(SteeredWalk, NothingJumpsHoweverItIsSteered) {
  // The source motions' own: the angry walk's knee as the weight comes onto it.
  const double source =
      largest_acceleration(repeated(walk(angry_walk(), film_fps, standard_body()).clip, 3));
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Filmed filmed = randomly_steered(seed, 40.0);
    EXPECT_LT(largest_acceleration(filmed.clip), 1.6 * source) << "seed " << seed;
    for (const SteeredWalk& walker : filmed.walkers) {
      ASSERT_TRUE(walker.root.place.allFinite());
    }
  }
}

TEST(SteeredWalk, NoSoleSinksAndNoKneeTurnsInside) {
  const Filmed filmed = randomly_steered(4, 40.0);
  for (const bool left : {true, false}) {
    for (const SolePoints& sole : sole_paths(filmed.clip, left)) {
      EXPECT_GT(std::min({sole.heel.y(), sole.ball.y(), sole.tip.y()}), -0.003);
    }
  }
  for (const Pose& pose : filmed.clip.poses) {
    for (const BodyJoint knee : {LeftKnee, RightKnee}) {
      const Vec3 shank = pose.rotations[static_cast<std::size_t>(knee)] * -Vec3::UnitY();
      EXPECT_LT(shank.z(), 0.01);  // behind the thigh
    }
  }
}

TEST(SteeredWalk, AChangeOfMoodShowsWithinATenthOfASecond) {
  for (const double pace : {0.0, 1.0}) {
    SteeredWalk walker = standing_walker(three_moods());
    Filmed filmed;
    Steering steering;
    steering.pace = pace;
    steering.moods = {1.0, 0.0, 0.0};
    film(filmed, walker, steering, 5.0);
    const double before = walker.moods[1].value;
    steering.moods = {0.0, 1.0, 0.0};
    film(filmed, walker, steering, 0.1);
    EXPECT_GT(walker.moods[1].value - before, 0.4);
    film(filmed, walker, steering, 0.4);
    EXPECT_GT(walker.moods[1].value, 0.97);
    // The head hangs with it.
    const auto pitch = [&](std::size_t frame) {
      const JointTransforms world = world_transforms(filmed.clip.body, filmed.clip.poses[frame]);
      return std::asin(-(world.rotations[Head] * Vec3::UnitZ()).y());
    };
    const std::size_t change = static_cast<std::size_t>(5.0 * film_fps) - 1;
    const double whole = pitch(filmed.clip.poses.size() - 1) - pitch(change);
    EXPECT_GT(whole, 0.15);
    EXPECT_GT(pitch(change + 6) - pitch(change), 0.3 * whole);
  }
}

TEST(SteeredWalk, TurnsOnTheSpotToTheHeadingAndStaysThere) {
  for (const double degrees : {90.0, -90.0, 175.0}) {
    SteeredWalk walker = standing_walker(three_moods());
    Filmed filmed;
    Steering steering;
    steering.heading = radians_per_degree * degrees;
    film(filmed, walker, steering, 6.0);
    EXPECT_TRUE(at_rest(walker));
    EXPECT_LT(std::abs(std::remainder(walker.root.heading - *steering.heading, 2.0 * pi)),
              radians_per_degree * 8.0);
    EXPECT_LT(walker.root.place.norm(), 0.12);
  }
}

TEST(SteeredWalk, StopsWithinAFewStepsFeetSideBySide) {
  for (const double pace : {0.4, 1.0, 1.2}) {
    SteeredWalk walker = standing_walker(three_moods());
    Filmed filmed;
    Steering steering;
    steering.pace = pace;
    film(filmed, walker, steering, 4.3);
    film(filmed, walker, {}, 4.0);
    EXPECT_TRUE(at_rest(walker));
    const Vec3 left = to_local(walker.root, walker.legs[0].print);
    const Vec3 right = to_local(walker.root, walker.legs[1].print);
    EXPECT_LT(std::abs(left.z() - right.z()), 0.12);
    EXPECT_GT(left.x() - right.x(), 0.08);
  }
}

TEST(SteeredWalk, IsTheSameEveryTime) {
  const Filmed a = randomly_steered(5, 10.0);
  const Filmed b = randomly_steered(5, 10.0);
  for (std::size_t i = 0; i < a.clip.poses.size(); ++i) {
    ASSERT_EQ(a.clip.poses[i].root_position, b.clip.poses[i].root_position);
  }
}

TEST(SteeredWalk, WalksOnAnyBody) {
  for (const Skeleton& body : {standard_female_body(1.5), standard_body(2.0)}) {
    const WalkerGaits gaits = fit_walker(std::array<WalkStyle, 1>{happy_walk()}, body);
    SteeredWalk walker = standing_walker(gaits, Vec3(1, 0, 2), 0.5);
    Steering steering;
    steering.pace = 1.0;
    steering.heading = 0.5;
    for (int i = 0; i < 240; ++i) advance(gaits, steering, 1.0 / film_fps, walker);
    const double speed = gaits.moods.front().speed_m_s;
    EXPECT_NEAR(walker.root.speed.value, speed, 0.02 * speed);
    EXPECT_GT((walker.root.place - Vec3(1, 0, 2)).norm(), 2.5 * speed);
  }
}

TEST(SteeredWalk, WithoutAMoodThereIsNoWalker) {
  EXPECT_THROW(fit_walker({}, standard_body()), Error);
}

}  // namespace
}  // namespace mien::motion
