#include "motion/style_transfer/fourier_style.h"

#include <random>

#include <gtest/gtest.h>

#include "motion/random_motion.h"
#include "motion/refusal.h"

#include "walk_pair.h"

namespace mien::motion {
namespace {

using namespace mien::test;

/// A loop whose curves hold `harmonics` harmonics of random amplitude and phase and nothing else.
Clip band_limited(unsigned seed, int frames, int harmonics) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0.0, 0.05);
  MotionCurves curves = to_curves(builtin_walk("normal").clip);
  curves.values = Eigen::MatrixXd::Zero(frames, curve_count);
  for (int c = 0; c < curve_count; ++c) {
    for (int n = 1; n <= harmonics; ++n) {
      const double a = normal(random);
      const double b = normal(random);
      for (int i = 0; i < frames; ++i) {
        const double angle = 2.0 * pi * n * i / frames;
        curves.values(i, c) += a * std::cos(angle) + b * std::sin(angle);
      }
    }
  }
  curves.values.col(1).array() += 0.9;
  return to_clip(curves);
}

FourierMotion first_harmonics(const Clip& loop, int harmonics) {
  FourierMotion motion = fourier_motion(loop, mean_rotations(loop));
  motion.amplitudes.conservativeResize(harmonics, Eigen::NoChange);
  motion.phases.conservativeResize(harmonics, Eigen::NoChange);
  return motion;
}

TEST(FourierMotion, OfSevenHarmonicsIsAWalkOfSevenHarmonics) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Clip walk = band_limited(seed, 30 + static_cast<int>(seed), 7);
    // The series is taken in the curves of the walk's own means, which exp and log bend: compare
    // the curves in which it was made.
    const std::vector<Quat> means = to_curves(builtin_walk("normal").clip).means;
    FourierMotion motion = fourier_motion(walk, means);
    motion.amplitudes.conservativeResize(7, Eigen::NoChange);
    motion.phases.conservativeResize(7, Eigen::NoChange);
    EXPECT_LT(largest_difference(to_clip(motion), walk), 1e-9) << seed;
  }
}

TEST(FourierMotion, OfSixHarmonicsIsNot) {
  const Clip walk = band_limited(3, 31, 7);
  EXPECT_GT(largest_difference(to_clip(first_harmonics(walk, 6)), walk), 0.01);
}

TEST(FourierMotion, OfAllHarmonicsIsTheMotion) {
  std::mt19937_64 random(7);
  for (const int frames : {24, 25, 39, 40}) {
    const Clip walk = random_loop(random, frames).clip;
    EXPECT_LT(largest_difference(to_clip(fourier_motion(walk, mean_rotations(walk))), walk), 1e-9);
  }
}

TEST(FourierMotion, OfSevenHarmonicsIsNearABuiltinWalk) {
  const Clip walk = builtin_walk("normal").clip;
  EXPECT_LT(largest_difference(to_clip(first_harmonics(walk, 7)), walk), 0.1);
}

TEST(FourierStyle, OfNoAmountIsTheMotion) {
  const Clip motion = builtin_walk("happy").clip;
  EXPECT_LT(largest_difference(fourier_styled(motion, builtin_walk("normal").clip,
                                              builtin_walk("sad").clip, {.amount = 0.0}),
                               motion),
            1e-9);
}

TEST(FourierStyle, OfAMotionToItselfChangesNothing) {
  const Clip motion = builtin_walk("happy").clip;
  const Clip sad = builtin_walk("sad").clip;
  EXPECT_LT(largest_difference(fourier_styled(motion, sad, sad, {.amount = 1.7}), motion), 1e-9);
}

TEST(FourierStyle, OfWholeAmountWithAllHarmonicsIsTheStyledMotion) {
  const Clip neutral = builtin_walk("normal").clip;
  const Clip styled = builtin_walk("sad").clip;
  // The neutral walk is shorter: it holds fewer harmonics than the styled one.
  const Clip result = fourier_styled(neutral, neutral, styled, {.amount = 1.0, .harmonics = 99});
  EXPECT_EQ(result.frame_count(), styled.frame_count());
  EXPECT_LT(largest_difference(result, styled), 0.05);
  EXPECT_GT(largest_difference(resampled(neutral, 30.0), styled), 0.2);
}

TEST(FourierStyle, InterpolatesTheFrequencyOfCycles) {
  const Clip slow = band_limited(1, 120, 3);
  const Clip quick = band_limited(1, 60, 3);  // the same twice as fast
  for (const double amount : {0.0, 0.25, 0.5, 1.0, 1.5}) {
    const Clip between = fourier_styled(slow, slow, quick, {.amount = amount});
    const double frequency = (1.0 + amount) / slow.duration_seconds();
    EXPECT_NEAR(between.duration_seconds(), 1.0 / frequency, 0.5 / 30.0 + 1e-9) << amount;
  }
}

TEST(FourierStyle, ExtrapolatesMonotonically) {
  const Clip neutral = builtin_walk("normal").clip;
  const Clip sad = builtin_walk("sad").clip;
  double bent = -1.0;
  double frames = 0.0;
  for (const double amount : {0.0, 0.5, 1.0, 1.5, 2.0}) {
    const Clip result = fourier_styled(neutral, neutral, sad, {.amount = amount});
    const Quat neck = mean_rotations(result)[Neck] * mean_rotations(result)[Head];
    EXPECT_GT(log(neck).x(), bent) << amount;
    EXPECT_GE(result.frame_count(), frames) << amount;
    bent = log(neck).x();
    frames = result.frame_count();
  }
}

TEST(FourierStyle, AddsAStyleToAnotherGait) {
  const Clip brisk = builtin_walk("brisk").clip;
  const Clip tired = fourier_styled(brisk, builtin_walk("normal").clip, builtin_walk("tired").clip);
  EXPECT_GT(tired.duration_seconds(), brisk.duration_seconds());
  EXPECT_LT(tired.cycle_displacement.z(), brisk.cycle_displacement.z());
  EXPECT_LT(largest_pop(tired), 2.0 * largest_pop(brisk));
}

TEST(FourierStyle, RefusesAPerformance) {
  Clip wave = builtin_walk("happy").clip;
  wave.loops = false;
  wave.name = "wave";
  const Clip normal = builtin_walk("normal").clip;
  EXPECT_NE(
      refusal_of([&] { fourier_styled(normal, normal, wave); }).find("\"wave\" is not cyclic"),
      std::string::npos);
}

}  // namespace
}  // namespace mien::motion
