#include "pipeline/measured_profiles.h"

#include <cmath>

#include <Eigen/Core>

#include "motion/measured_style.h"

namespace mien::pipeline {

namespace {

using motion::motion_measure_count;

// Ours, after what is known of how walks look (Montepare et al. 1987, Roether et al. 2009): a row
// an impression; columns speed, tempo, travel, hand range, hand speed, hand spread, elbow flexion,
// trunk lean, head pitch, bounce, sway, asymmetry.
constexpr double loadings[motion::style_impression_count][motion_measure_count] = {
    /* quickness  */ {0.6, 0.6, 0.1, 0, 0.2, 0, 0, 0, 0, 0, 0, 0},
    /* clearness  */ {0.1, 0, 0.2, 0.1, 0, 0, 0, -0.4, -0.5, 0, -0.2, -0.6},
    /* activeness */ {0.3, 0.2, 0, 0.4, 0.5, 0, 0.1, -0.1, -0.2, 0.4, 0, 0},
    /* largeness  */ {0, -0.1, 0.5, 0.5, 0, 0.4, 0, -0.1, 0, 0.2, 0.2, 0},
    /* valence    */ {0.1, 0, 0.1, 0.2, 0, 0, -0.1, -0.4, -0.6, 0.3, 0, -0.2},
    /* arousal    */ {0.5, 0.5, 0, 0.2, 0.5, 0, 0.3, 0, 0, 0.2, 0, 0},
    /* tension    */ {0, 0.3, -0.1, -0.3, 0, -0.2, 0.6, 0.2, 0, 0, -0.2, 0},
    /* stability  */ {0, 0, 0, 0, 0, 0, 0, -0.2, 0, -0.2, -0.4, -0.6},
};

Eigen::MatrixXd standardised(Eigen::MatrixXd values) {
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    const double mean = values.col(c).mean();
    values.col(c).array() -= mean;
    const double deviation =
        std::sqrt(values.col(c).squaredNorm() / static_cast<double>(values.rows()));
    if (deviation > 1e-9 * (1.0 + std::abs(mean))) {
      values.col(c) /= deviation;
    } else {
      values.col(c).setZero();
    }
  }
  return values;
}

}  // namespace

std::vector<StyledStimulus> measured_profiles(const motion::ExampleSet& set) {
  Eigen::MatrixXd values(static_cast<Eigen::Index>(set.examples.size()), motion_measure_count);
  for (size_t i = 0; i < set.examples.size(); ++i) {
    const auto measures = motion::values_of(motion::measure(set.examples[i]));
    for (size_t m = 0; m < measures.size(); ++m) {
      values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(m)) = measures[m];
    }
  }
  values = standardised(std::move(values));

  std::vector<StyledStimulus> stimuli;
  for (size_t i = 0; i < set.examples.size(); ++i) {
    StyledStimulus stimulus{set.examples[i].name, {}};
    for (size_t a = 0; a < motion::style_impression_count; ++a) {
      double sum = 0.0;
      for (size_t m = 0; m < motion_measure_count; ++m) {
        sum += loadings[a][m] * values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(m));
      }
      stimulus.profile[a] = std::tanh(0.6 * sum);
    }
    stimuli.push_back(std::move(stimulus));
  }
  return stimuli;
}

}  // namespace mien::pipeline
