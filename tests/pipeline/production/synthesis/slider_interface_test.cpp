#include "pipeline/production/synthesis/slider_interface.h"

#include <gtest/gtest.h>

#include "motion/error.h"
#include "motion/measures/distance/distance.h"
#include "pipeline/production/synthesis/synthesis.h"
#include "pipeline/study/matching/simulated_evaluation.h"

namespace mien::pipeline {
namespace {

Repertoire rated_repertoire() {
  Manifest manifest;
  manifest.examples.builtin = "walks-10";
  manifest.ratings.source = Ratings::Source::builtin;
  return load_repertoire(manifest);
}

TEST(SliderInterface, IdealAdjectivesAndWeightsMakeTheTargetAgain) {
  const Repertoire repertoire = rated_repertoire();
  const auto interfaces = interfaces_of(repertoire);
  ASSERT_EQ(interfaces.size(), 3u);
  const Eigen::RowVectorXd place = repertoire.parameters.values.col(4).head(4).transpose();
  const motion::Example target =
      motion_of(fit_interface(interfaces[0], {}, repertoire), place, {}, repertoire);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(10);
  weights[4] = 1.0;  // an example's own adjectives
  for (const SliderInterface& interface : interfaces) {
    const auto ideal = ideal_settings(interface, target, weights, repertoire);
    const motion::Example made =
        motion_of(fit_interface(interface, {}, repertoire), ideal, {}, repertoire);
    EXPECT_LT(motion::distance(target, made).mean, 1e-6) << name_of(interface.kind);
  }
}

/// Both poses and places, exactly.
void expect_same(const motion::Clip& a, const motion::Clip& b) {
  ASSERT_EQ(a.frame_count(), b.frame_count());
  for (std::size_t f = 0; f < a.poses.size(); ++f) {
    EXPECT_EQ(a.poses[f].root_position, b.poses[f].root_position);
    for (std::size_t j = 0; j < a.poses[f].rotations.size(); ++j) {
      EXPECT_EQ(a.poses[f].rotations[j].coeffs(), b.poses[f].rotations[j].coeffs());
    }
  }
}

TEST(SliderInterface, MakesWhatAStimulusOfTheSameSettingsIs) {
  const Repertoire repertoire = rated_repertoire();
  Stimulus adjectives;
  adjectives.adjectives = {{"quickness", 0.8}, {"clearness", 0.3}};
  Stimulus features;
  features.features = {{repertoire.features.table.names[0], 0.7}};
  for (Stimulus stimulus : {adjectives, features}) {
    stimulus.id = "set";
    stimulus.output.fps = 48;
    stimulus.interpolation.foot_lock = false;
    // Features are requested again until they are met, which sliders leave to the hand on them.
    if (!stimulus.features.empty())
      stimulus.interpolation.weights.method = motion::InterpolationMethod::cardinal;
    SliderInterface sliders{InterfaceKind::adjectives, {}};
    NamedValues values = stimulus.adjectives;
    if (values.empty()) {
      sliders.kind = InterfaceKind::features;
      values = stimulus.features;
    }
    Eigen::RowVectorXd settings(static_cast<Eigen::Index>(values.size()));
    for (const auto& [name, value] : values) {
      settings[static_cast<Eigen::Index>(sliders.sliders.size())] = value;
      sliders.sliders.push_back(name);
    }
    const FittedInterface fitted = fit_interface(sliders, stimulus.interpolation, repertoire);
    expect_same(motion_of(fitted, settings, stimulus.interpolation, repertoire, 48.0).clip,
                synthesize(stimulus, repertoire).motion.clip);
  }
}

TEST(SliderInterface, RefusesAParameterThatTheExamplesLack) {
  const Repertoire repertoire = rated_repertoire();
  try {
    fit_interface({InterfaceKind::adjectives, {"brightness"}}, {}, repertoire);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no parameter \"brightness\""), std::string::npos);
  }
}

}  // namespace
}  // namespace mien::pipeline
