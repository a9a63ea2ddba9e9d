#include "pipeline/manifest/ratings/simulated_raters/measured_profiles.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "motion/measures/features/motion_measures.h"

namespace mien::pipeline {

namespace {

using motion::motion_measure_count;

// Ours, after what is known of how walks look (Montepare et al. 1987; Michalak et al. 2009; Roether
// et al. 2009). The four primary impressions rest on different things: quickness on speed and
// cadence; clearness on limbs that are not held bent, an upright trunk and head and equal steps;
// activeness on how much of the pelvis's movement is up and down rather than from side to side,
// head up and shoulders turning; largeness on the length of the steps and the way of the hands.
// A row an impression; columns speed, tempo, travel, hand range, hand speed, hand spread, elbow
// flexion, trunk lean, head pitch, trunk turn, least knee flexion, bounce, sway, lift, asymmetry.
constexpr double loadings[style_impression_count][motion_measure_count] = {
    /* quickness  */ {0.45, 0.75, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0},
    /* clearness  */ {0, 0, 0, 0, 0, 0, -0.6, -0.3, -0.3, 0, -0.3, 0, 0, 0, -0.3},
    /* activeness */ {0, 0, 0, 0, 0, 0, 0, 0, -0.2, 0.2, 0, 0, -0.2, 0.8, 0},
    /* largeness  */ {0, 0, 0.55, 0.45, 0, 0.25, 0, 0, 0, 0, 0, 0, 0, 0, 0},
    /* valence    */ {0, 0, 0, 0, 0, 0, 0, -0.3, -0.6, 0, 0, 0, 0, 0.3, -0.2},
    /* arousal    */ {0.5, 0.3, 0, 0, 0.4, 0, 0.2, 0, 0, 0, 0, 0, 0, 0, 0},
    /* tension    */ {0, 0, 0, 0, 0, -0.4, 0.6, 0, 0, 0, 0.3, 0, 0, 0, 0},
    /* stability  */ {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -0.7, 0, -0.5},
};

// What an onlooker can tell apart: spreads below it count as if they were it, so that nothing is
// made of differences that cannot be seen.
constexpr double visible[motion_measure_count] = {0.05, 0.03, 0.05, 0.03,  0.05,  0.03, 0.05, 0.02,
                                                  0.03, 0.03, 0.03, 0.004, 0.004, 0.03, 0.02};

Eigen::MatrixXd standardised(Eigen::MatrixXd values) {
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    values.col(c).array() -= values.col(c).mean();
    const double deviation =
        std::sqrt(values.col(c).squaredNorm() / static_cast<double>(values.rows()));
    values.col(c) /= std::max(deviation, visible[c]);
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
    for (size_t a = 0; a < style_impression_count; ++a) {
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
