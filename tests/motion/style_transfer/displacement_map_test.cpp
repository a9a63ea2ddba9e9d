#include "motion/style_transfer/displacement_map.h"

#include <gtest/gtest.h>

#include "motion/refusal.h"
#include "motion/style_transfer/motion_curves.h"

#include "reach.h"
#include "walk_pair.h"

namespace mien::motion {
namespace {

using namespace mien::test;

const Vec3 nod(0.3, 0, 0);

TEST(DisplacementMap, PassesThroughItsKeysAndIsNothingOutsideItsWindow) {
  const Clip motion = reach(2.0, 0.8);
  const std::vector<DisplacementKey> keys = {
      {0.75, Head, nod}, {1.25, Head, -0.5 * nod}, {1.0, Pelvis, Vec3::Zero(), Vec3(0, -0.1, 0)}};
  const Clip result = displaced(motion, keys, {.start_seconds = 0.5, .end_seconds = 1.5});
  const auto head = [&](double seconds) {
    const auto i = static_cast<size_t>(std::lround(seconds * 60.0));
    return log(result.poses[i].rotations[Head] * motion.poses[i].rotations[Head].conjugate());
  };
  EXPECT_LT((head(0.75) - nod).norm(), 1e-12);
  EXPECT_LT((head(1.25) + 0.5 * nod).norm(), 1e-12);
  EXPECT_NEAR(result.poses[60].root_position.y(), motion.poses[60].root_position.y() - 0.1, 1e-12);
  for (int i = 0; i < motion.frame_count(); ++i) {
    if (i > 30 && i < 90) continue;
    EXPECT_EQ(result.poses[i].rotations[Head].coeffs(), motion.poses[i].rotations[Head].coeffs());
    EXPECT_EQ(result.poses[i].root_position, motion.poses[i].root_position);
  }
  EXPECT_LT(largest_pop(result), 0.01);
}

TEST(DisplacementMap, OfNoAmountIsTheMotion) {
  const Clip motion = reach(2.0, 0.8);
  EXPECT_LT(largest_difference(displaced(motion, {{0.75, Head, nod}},
                                         {.amount = 0.0, .start_seconds = 0.5, .end_seconds = 1.5}),
                               motion),
            1e-9);
}

TEST(DisplacementMap, CrossesTheSeamOfALoop) {
  const Clip walk = builtin_walk("normal").clip;
  const double cycle = walk.duration_seconds();
  const Clip result = displaced(walk, {{cycle, Head, nod}},
                                {.start_seconds = 0.75 * cycle, .end_seconds = 1.25 * cycle});
  EXPECT_NEAR(log(result.poses[0].rotations[Head] * walk.poses[0].rotations[Head].conjugate()).x(),
              0.3, 1e-9);
  const auto half = static_cast<size_t>(walk.frame_count() / 2);
  EXPECT_EQ(result.poses[half].rotations[Head].coeffs(), walk.poses[half].rotations[Head].coeffs());
  EXPECT_LT(largest_pop(result), largest_pop(walk) + 0.05);
}

TEST(DisplacementMap, BringsAMeanPostureForAWhile) {
  const Clip walk = builtin_walk("normal").clip;
  const Clip sad = builtin_walk("sad").clip;
  DisplacementMapOptions window{.start_seconds = 0.0, .end_seconds = walk.duration_seconds()};
  const auto keys = displacements_between(walk, sad, window);
  const Quat wanted = mean_rotations(sad)[Neck] * mean_rotations(walk)[Neck].conjugate();
  double previous = -1.0;
  for (const double amount : {0.0, 0.5, 1.0, 1.5}) {
    window.amount = amount;
    const Clip result = displaced(walk, keys, window);
    const auto half = static_cast<size_t>(walk.frame_count() / 2);
    const double turned =
        angle_between(walk.poses[half].rotations[Neck], result.poses[half].rotations[Neck]);
    EXPECT_GT(turned, previous - (amount == 0.0 ? 0.0 : -1e-6));
    if (amount == 1.0) {
      EXPECT_NEAR(turned, log(wanted).norm(), 0.02);
    }
    previous = turned;
  }
}

TEST(DisplacementMap, RefusesKeysOutsideItsWindow) {
  const Clip motion = reach(2.0, 0.8);
  const DisplacementMapOptions window{.start_seconds = 0.5, .end_seconds = 1.5};
  EXPECT_NE(refusal_of([&] {
              displaced(motion, {{0.5, Head, nod}}, window);
            }).find("Head at 500 ms is not inside its window"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] {
              displaced(motion, {{0.7, Head, nod}, {0.7, Head, nod}}, window);
            }).find("two displacements of Head"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] {
              displaced(motion, {{0.7, Head, nod}}, {.start_seconds = 0.5, .end_seconds = 2.5});
            }).find("which lasts 2000 ms"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] {
              displaced(motion, {{0.7, Head, nod, nod}}, window);
            }).find("has a shift"),
            std::string::npos);
}

}  // namespace
}  // namespace mien::motion
