#pragma once

#include "motion/examples/settled_feet.h"
#include "motion/live/live_bundle.h"
#include "motion/measures/features/feature_scale.h"
#include "motion/procedural/builtin_sets.h"

namespace mien::test {

/// Four built-in walks, two adjectives and two groups of features that tell them apart, a target.
inline motion::LiveBundle small_bundle(bool foot_lock = true) {
  motion::LiveBundle bundle;
  bundle.info = R"({"fps": 30})";
  bundle.examples = motion::builtin_examples("walks-10");
  bundle.examples.examples.resize(4);
  bundle.how.foot_lock = foot_lock;
  if (foot_lock) bundle.examples = motion::with_settled_feet(bundle.examples);
  bundle.adjectives.names = {"quickness", "sadness"};
  bundle.adjectives.values = Eigen::MatrixXd(2, 4);
  bundle.adjectives.values << 0.4, 0.9, 0.1, 0.6, 0.5, 0.2, 0.7, 0.1;
  std::vector<motion::FeatureValues> values;
  for (const auto& e : bundle.examples.examples) values.push_back(motion::measure_features(e));
  bundle.feature_scale = motion::fit_feature_scale(values);
  bundle.features.names = {"lateral-swing", "step-length"};
  bundle.features.values = Eigen::MatrixXd(2, 4);
  for (int i = 0; i < 4; ++i) {
    const auto of_example =
        motion::scaled(bundle.feature_scale, values[static_cast<std::size_t>(i)]);
    for (int f = 0; f < 2; ++f) {
      const std::string& name = bundle.features.names[static_cast<std::size_t>(f)];
      bundle.features.values(f, i) = motion::feature_parameter(name, of_example).value();
    }
  }
  motion::LiveTarget target;
  target.name = "t1";
  target.motion = bundle.examples.examples[1];
  bundle.targets.push_back(target);
  return bundle;
}

}  // namespace mien::test
