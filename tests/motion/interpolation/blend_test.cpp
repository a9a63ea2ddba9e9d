#include "motion/interpolation/blend.h"

#include <random>

#include <gtest/gtest.h>

#include "motion/math/rotation.h"
#include "motion/random_motion.h"

namespace mien::motion {
namespace {

using test::random_loops;

double largest_difference(const Clip& a, const Clip& b) {
  double largest = 0.0;
  for (size_t f = 0; f < a.poses.size(); ++f) {
    largest = std::max(largest, (a.poses[f].root_position - b.poses[f].root_position).norm());
    for (size_t j = 0; j < a.poses[f].rotations.size(); ++j) {
      largest = std::max(largest, angle_between(a.poses[f].rotations[j], b.poses[f].rotations[j]));
    }
  }
  return largest;
}

Eigen::VectorXd random_weights(std::mt19937_64& random, int count) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Eigen::VectorXd w = Eigen::VectorXd::NullaryExpr(count, [&] { return uniform(random); });
  return w / w.sum();
}

class EveryRotationBlend : public testing::TestWithParam<RotationBlend> {};

TEST_P(EveryRotationBlend, OfOneExampleIsThatExample) {
  std::mt19937_64 random(41);
  const ExampleSet set = random_loops(random, 6);
  for (int i = 0; i < 6; ++i) {
    const Example result = blend(set, Eigen::VectorXd::Unit(6, i),
                                 {.frames_per_second = 30.0, .rotations = GetParam()});
    const Example& example = set.examples[static_cast<size_t>(i)];
    ASSERT_EQ(result.clip.frame_count(), example.clip.frame_count());
    EXPECT_LT(largest_difference(result.clip, example.clip), 1e-9);
    for (size_t k = 0; k < 7; ++k) EXPECT_NEAR(result.keytimes[k], example.keytimes[k], 1e-12);
  }
}

TEST_P(EveryRotationBlend, OfEqualExamplesIsThatExample) {
  std::mt19937_64 random(42);
  ExampleSet set = random_loops(random, 1);
  for (int i = 0; i < 4; ++i) set.examples.push_back(set.examples.front());
  const Example result = blend(set, random_weights(random, 5), {.rotations = GetParam()});
  EXPECT_LT(largest_difference(result.clip, set.examples.front().clip), 1e-9);
}

TEST_P(EveryRotationBlend, OrderOfExamplesChangesNothing) {
  std::mt19937_64 random(43);
  const ExampleSet set = random_loops(random, 5);
  const Eigen::VectorXd weights = random_weights(random, 5);
  ExampleSet turned = set;
  std::reverse(turned.examples.begin(), turned.examples.end());
  const Example one = blend(set, weights, {.rotations = GetParam()});
  const Example other = blend(turned, weights.reverse(), {.rotations = GetParam()});
  EXPECT_LT(largest_difference(one.clip, other.clip), 1e-9);
}

TEST_P(EveryRotationBlend, BonesKeepTheirLengths) {
  std::mt19937_64 random(44);
  const ExampleSet set = random_loops(random, 4);
  const Clip clip = blend(set, random_weights(random, 4), {.rotations = GetParam()}).clip;
  for (const Pose& pose : clip.poses) {
    const std::vector<Vec3> positions = world_positions(clip.body, pose);
    for (size_t j = 1; j < positions.size(); ++j) {
      const auto parent = static_cast<size_t>(body_parents[j]);
      EXPECT_NEAR((positions[j] - positions[parent]).norm(), clip.body.joints[j].offset.norm(),
                  1e-12);
    }
  }
}

TEST_P(EveryRotationBlend, LoopHasNoSeam) {
  std::mt19937_64 random(45);
  const ExampleSet set = random_loops(random, 4);
  const Clip clip =
      blend(set, random_weights(random, 4), {.frames_per_second = 240.0, .rotations = GetParam()})
          .clip;
  // The step over the seam is no larger than the steps beside it.
  const auto step = [&](int f) {
    const Pose a = pose_at(clip, f / clip.frames_per_second);
    const Pose b = pose_at(clip, (f + 1) / clip.frames_per_second);
    double largest = (a.root_position - b.root_position).norm();
    for (size_t j = 0; j < a.rotations.size(); ++j) {
      largest = std::max(largest, angle_between(a.rotations[j], b.rotations[j]));
    }
    return largest;
  };
  const int last = clip.frame_count() - 1;
  EXPECT_LT(step(last), 1.2 * std::max(step(last - 1), step(last + 1)));
}

INSTANTIATE_TEST_SUITE_P(Blend, EveryRotationBlend,
                         testing::Values(RotationBlend::karcher_mean,
                                         RotationBlend::direction_vectors,
                                         RotationBlend::markley_mean));

TEST(Blend, TimingIsTheWeightedMean) {
  std::mt19937_64 random(46);
  const ExampleSet set = random_loops(random, 3);
  const Eigen::VectorXd weights = random_weights(random, 3);
  const Example result = blend(set, weights, {.frames_per_second = 3000.0});
  for (size_t k = 0; k < 7; ++k) {
    double mean = 0.0;
    for (size_t i = 0; i < 3; ++i) {
      mean += weights[static_cast<Eigen::Index>(i)] * set.examples[i].keytimes[k];
    }
    EXPECT_NEAR(result.keytimes[k], mean, 1.0 / 3000.0);
  }
  EXPECT_NEAR(result.keytimes.back(), result.clip.duration_seconds(), 1e-12);
}

TEST(Blend, HalfwayBetweenTwoRotationsIsTheirMidpoint) {
  const Quat a(Eigen::AngleAxisd(0.2, Vec3::UnitX()));
  const Quat b(Eigen::AngleAxisd(1.4, Vec3::UnitX()));
  const std::array rotations = {a, Quat(-b.coeffs())};
  const std::array weights = {0.5, 0.5};
  for (const auto how : {RotationBlend::karcher_mean, RotationBlend::direction_vectors,
                         RotationBlend::markley_mean}) {
    EXPECT_LT(angle_between(blend_rotations(rotations, weights, how),
                            Quat(Eigen::AngleAxisd(0.8, Vec3::UnitX()))),
              1e-12);
  }
}

TEST(Blend, KarcherMeanHasNoResidual) {
  std::mt19937_64 random(47);
  std::uniform_real_distribution<double> small(-0.5, 0.5);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Quat> rotations;
    for (int i = 0; i < 6; ++i) {
      rotations.push_back(exp(Vec3(1, 2, -1) + Vec3(small(random), small(random), small(random))));
    }
    const Eigen::VectorXd w = random_weights(random, 6);
    const std::vector<double> weights(w.data(), w.data() + w.size());
    const Quat mean = blend_rotations(rotations, weights, RotationBlend::karcher_mean);
    Vec3 residual = Vec3::Zero();
    for (size_t i = 0; i < 6; ++i) residual += weights[i] * log(mean.conjugate() * rotations[i]);
    EXPECT_LT(residual.norm(), 1e-12);
  }
}

TEST(Blend, MarkleyMeanIsNearestAsQuaternions) {
  std::mt19937_64 random(48);
  std::uniform_real_distribution<double> small(-0.5, 0.5);
  const auto random_vector = [&] { return Vec3(small(random), small(random), small(random)); };
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Quat> rotations;
    for (int i = 0; i < 6; ++i) rotations.push_back(exp(Vec3(1, 2, -1) + random_vector()));
    const Eigen::VectorXd w = random_weights(random, 6);
    const std::vector<double> weights(w.data(), w.data() + w.size());
    const auto nearness = [&](const Quat& q) {
      double sum = 0.0;
      for (size_t i = 0; i < 6; ++i) sum += weights[i] * std::pow(q.dot(rotations[i]), 2.0);
      return sum;
    };
    const Quat mean = blend_rotations(rotations, weights, RotationBlend::markley_mean);
    for (int other = 0; other < 10; ++other) {
      EXPECT_GE(nearness(mean), nearness(mean * exp(0.1 * random_vector())) - 1e-15);
    }
    // Which end of a quaternion's axis stands for a rotation does not matter.
    rotations[2] = Quat(-rotations[2].coeffs());
    EXPECT_LT(angle_between(mean, blend_rotations(rotations, weights, RotationBlend::markley_mean)),
              1e-7);
  }
}

TEST(Blend, TheThreeMeansOfNearRotationsDifferByLessThanTwoDegrees) {
  std::mt19937_64 random(49);
  std::uniform_real_distribution<double> small(-0.3, 0.3);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Quat> rotations;
    for (int i = 0; i < 5; ++i) {
      rotations.push_back(exp(Vec3(1, 2, -1)) *
                          exp(Vec3(small(random), small(random), small(random))));
    }
    const Eigen::VectorXd w = random_weights(random, 5);
    const std::vector<double> weights(w.data(), w.data() + w.size());
    const Quat karcher = blend_rotations(rotations, weights, RotationBlend::karcher_mean);
    for (const auto how : {RotationBlend::direction_vectors, RotationBlend::markley_mean}) {
      EXPECT_LT(angle_between(karcher, blend_rotations(rotations, weights, how)),
                2.0 * radians_per_degree);
    }
  }
}

}  // namespace
}  // namespace mien::motion
