#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <Eigen/Core>

#include "motion/measures/distance/distance.h"

namespace mien::pipeline {

/// A model of a participant who compares the target with the created motion and moves one slider at
/// a time.
struct SimulatedUser {
  std::uint64_t seed = 0;
  std::string name;             ///< part of the names of the random numbers
  double reading_error = 0.15;  ///< SD of reading a slider's value off the target
  double seeing_error = 0.1;    ///< SD of the distance as seen, share of it
  int max_views = 100;          ///< after so many tries the user gives up
  double threshold = motion::distance_threshold_m;  ///< D below which the motion matches, metres
};

struct SimulatedTrial {
  Eigen::RowVectorXd first_guess;  ///< slider settings
  double first_distance = 0.0;     ///< D of it, metres
  double distance = 0.0;           ///< D of the motion left when the user stopped
  int views = 0;                   ///< motions viewed
  bool matched = false;            ///< the distance is below the threshold
};

/// Distance from the target of the motion at slider settings, metres.
using SliderDistance = std::function<double(const Eigen::RowVectorXd&)>;

/// First guess: the ideal settings with the reading error, to the nearest 0.1. Then coordinate-wise
/// search: in rounds, over the sliders in a random order, each is moved up and, if that seems no
/// better, down by the step; a move that seems better (seen distance = true one × (1 + error),
/// drawn anew at each look) is kept. A round without any improvement halves the step, from 0.2;
/// below 0.02 the user stops. The user also stops when the motion matches, which the experiment
/// signals.
SimulatedTrial simulate_trial(const Eigen::RowVectorXd& ideal, const SimulatedUser& user,
                              const SliderDistance& distance_at);

}  // namespace mien::pipeline
