#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <Eigen/Core>

#include "motion/measures/distance/distance.h"

namespace mien::pipeline {

/// A model of a participant who compares the created motion with the target and moves one slider at
/// a time.
struct SimulatedUser {
  std::uint64_t seed = 0;
  std::string name;             ///< distinguishes random numbers of users with the same seed
  double reading_error = 0.15;  ///< SD of estimating a slider's value from the target
  double seeing_error = 0.1;    ///< SD of the perceived distance, relative to the true one
  int max_views = 100;          ///< number of views after which the user gives up
  double threshold = motion::distance_threshold_m;  ///< D below which the motion matches, metres
};

struct SimulatedTrial {
  Eigen::RowVectorXd first_guess;  ///< slider settings
  double first_distance = 0.0;     ///< D of the first guess, metres
  double distance = 0.0;           ///< D of the final motion, metres
  int views = 0;                   ///< number of motions viewed, including that of the first guess
  bool matched = false;            ///< the distance is below the threshold
};

/// D between the target and the motion at given slider settings, metres.
using SliderDistance = std::function<double(const Eigen::RowVectorXd&)>;

/// Simulates a trial. The first guess is the ideal settings plus the reading error, clamped to 0 …
/// 1 and rounded to 0.1. A coordinate-wise search follows, in rounds over the sliders in random
/// order: each slider is moved up by the step and, if the motion does not look better, down. A move
/// is kept if the perceived distance, true distance × (1 + error) with a new error for each view,
/// decreases. The step is 0.2 initially and is halved after a round without improvement. The search
/// stops if the step falls below 0.02, after max_views, or when the current motion matches (that of
/// the first guess or of the last kept move), which the experiment signals.
SimulatedTrial simulate_trial(const Eigen::RowVectorXd& ideal, const SimulatedUser& user,
                              const SliderDistance& distance_at);

}  // namespace mien::pipeline
