#include "motion/interpolation/statistical_model.h"

#include <gtest/gtest.h>

#include "motion/measures/distance/distance.h"
#include "motion/procedural/builtin_sets.h"
#include "motion/random_motion.h"
#include "motion/random_places.h"

namespace mien::motion {
namespace {

using test::random_places;

TEST(StatisticalModel, HasOrthonormalComponentsThatKeepTheAskedShare) {
  std::mt19937_64 random(61);
  const ExampleSet set = builtin_examples("walks-10");
  for (double share : {0.5, 0.8, 0.95}) {
    const StatisticalModel model =
        fit_statistical_model(set, random_places(random, 10, 2), {.variance_share = share});
    const Eigen::Index q = model.variances.size();
    EXPECT_LT(
        (model.components.transpose() * model.components - Eigen::MatrixXd::Identity(q, q)).norm(),
        1e-9);
    EXPECT_GE(model.kept_variance, share);
    // One component less would keep too little.
    const double without =
        model.kept_variance * (1.0 - model.variances[q - 1] / model.variances.sum());
    EXPECT_LT(without, share);
  }
}

TEST(StatisticalModel, WithAllComponentsHoldsEveryExample) {
  std::mt19937_64 random(62);
  const ExampleSet set = builtin_examples("walks-10");
  const StatisticalModel model =
      fit_statistical_model(set, random_places(random, 10, 2), {.variance_share = 1.0});
  for (Eigen::Index i = 0; i < 10; ++i) {
    const Example& example = set.examples[static_cast<size_t>(i)];
    const Example made =
        motion_of(model, model.example_coordinates.col(i), example.clip.frames_per_second);
    EXPECT_LT(distance(example, made).mean, 0.003) << example.name;
    EXPECT_NEAR(made.keytimes.back(), example.keytimes.back(), 0.02);
    EXPECT_LT((made.clip.cycle_displacement - example.clip.cycle_displacement).norm(), 1e-9);
    EXPECT_EQ(made.clip.frame_count(), example.clip.frame_count());
  }
}

TEST(StatisticalModel, ReproducesExamplesWhoseParametersAreTheirCoordinates) {
  // Motions that depend linearly on two parameters are what the regression can follow exactly.
  std::mt19937_64 random(63);
  const ExampleSet set = builtin_examples("walks-10");
  const StatisticalModel all =
      fit_statistical_model(set, random_places(random, 10, 2), {.variance_share = 1.0});
  const Eigen::MatrixXd coordinates = all.example_coordinates.transpose();
  const StatisticalModel model =
      fit_statistical_model(set, coordinates, {.variance_share = 1.0, .ridge = 1e-12});
  for (Eigen::Index i = 0; i < 10; ++i) {
    EXPECT_LT((coordinates_at(model, coordinates.row(i)) - model.example_coordinates.col(i)).norm(),
              1e-5 * model.example_coordinates.norm());
    EXPECT_LT((equivalent_weights(model, coordinates.row(i)) - Eigen::VectorXd::Unit(10, i)).norm(),
              1e-5);
  }
}

TEST(StatisticalModel, IsTheMeanMotionAtTheMeanParameters) {
  std::mt19937_64 random(64);
  const ExampleSet set = builtin_examples("walks-10");
  const Eigen::MatrixXd places = random_places(random, 10, 3);
  const StatisticalModel model = fit_statistical_model(set, places);
  const Eigen::RowVectorXd middle = places.colwise().mean();
  EXPECT_LT(coordinates_at(model, middle).norm(), 1e-12);
  EXPECT_LT((equivalent_weights(model, middle) - Eigen::VectorXd::Constant(10, 0.1)).norm(), 1e-12);
  const Example mean = motion_of(model, coordinates_at(model, middle), 30.0);
  const Example blended = blend(set, Eigen::VectorXd::Constant(10, 0.1),
                                {.rotations = RotationBlend::direction_vectors});
  EXPECT_LT(distance(blended, mean).mean, 0.005);
}

TEST(StatisticalModel, ClosesItsLoops) {
  std::mt19937_64 random(65);
  const ExampleSet set = test::random_loops(random, 8);
  const Eigen::MatrixXd places = random_places(random, 8, 2);
  const StatisticalModel model = fit_statistical_model(set, places);
  const Example made = motion_of(model, coordinates_at(model, places.row(2)), 120.0);
  const auto paths = joint_paths(repeated(made.clip, 2));
  const auto frames = static_cast<size_t>(made.clip.frame_count());
  double inside = 0.0;
  for (size_t f = 1; f < frames; ++f) {
    for (size_t j = 0; j < paths[f].size(); ++j) {
      inside = std::max(inside, (paths[f][j] - paths[f - 1][j]).norm());
    }
  }
  for (size_t j = 0; j < paths[frames].size(); ++j) {
    EXPECT_LT((paths[frames][j] - paths[frames - 1][j]).norm(), 1.5 * inside);
  }
}

TEST(StatisticalModel, FindsTheCoordinatesOfLeastPenaltyWhenAskedForTheMostLikely) {
  std::mt19937_64 random(65);
  const ExampleSet set = builtin_examples("walks-10");
  const Eigen::MatrixXd places = random_places(random, 10, 3);
  const StatisticalModelOptions options{.estimate = ModelEstimate::most_likely, .noise = 0.2};
  const StatisticalModel model = fit_statistical_model(set, places, options);
  // The regression of parameters on coordinates, by least squares over the examples.
  const Eigen::MatrixXd c = model.example_coordinates;
  const Eigen::MatrixXd centred = places.rowwise() - model.parameter_mean;
  const Eigen::MatrixXd measure =
      (c * c.transpose()).ldlt().solve(c * centred).transpose().eval();  // M × q
  const Eigen::RowVectorXd wanted = Eigen::RowVector3d(0.2, 0.7, 0.5);
  const Eigen::VectorXd asked = (wanted - model.parameter_mean).transpose();
  const auto penalty = [&](const Eigen::VectorXd& at) {
    return (measure * at - asked).squaredNorm() / (options.noise * options.noise) +
           at.cwiseAbs2().cwiseQuotient(model.variances).sum();
  };
  const Eigen::VectorXd found = coordinates_at(model, wanted);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    Eigen::VectorXd moved = found;
    for (Eigen::Index i = 0; i < moved.size(); ++i) {
      moved[i] += 0.01 * normal(random) * std::sqrt(model.variances[i]);
    }
    EXPECT_LT(penalty(found), penalty(moved));
  }
}

}  // namespace
}  // namespace mien::motion
