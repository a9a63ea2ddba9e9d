#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace mien::motion {

/// What a click on a word requests for one parameter: to increase (+1) or decrease (−1) it by one
/// step.
struct Click {
  int parameter = 0;
  int sign = 1;

  friend bool operator==(const Click&, const Click&) = default;
};

/// Incremental control by words (after Förger and Takala 2012). Each click applies the smallest
/// change of weights that changes the named parameters by one step and preserves the sum of the
/// weights, computed with the pseudo-inverse; the weights are then clipped to [0, 1] and
/// normalised. The result depends on the sequence of clicks.
struct WordClicks {
  Eigen::MatrixXd standardised;  ///< M × N: parameters of examples, mean 0 and SD 1 per row
  Eigen::VectorXd mean;          ///< M: means of the parameters
  Eigen::VectorXd deviation;  ///< M: standard deviations; 1 where all examples have the same value
  double step = 0.25;         ///< change per click, in standard deviations over the examples
};

/// Fits the method. `places` has one row per example (N × M). Not every combination of parameter
/// changes is attainable unless there are more examples than parameters.
WordClicks fit_word_clicks(const Eigen::MatrixXd& places, double step = 0.25);

/// The weights (≥ 0, sum 1) after a click on a word that names the given parameters.
Eigen::VectorXd clicked(const WordClicks& words, const Eigen::VectorXd& weights,
                        std::span<const Click> word);

/// A sequence of clicks and its result.
struct ClickPath {
  std::vector<Click> clicks;
  Eigen::VectorXd weights;
  bool arrived = false;  ///< whether every parameter is within half a step of the request
};

/// Simulates a patient user who starts from equal weights and repeatedly clicks on the parameter
/// farthest from the request, passing over parameters whose click would not reduce the total
/// deviation. Ends when every parameter is within half a step of the request, when no click helps,
/// or after 400 clicks.
ClickPath click_towards(const WordClicks& words, const Eigen::RowVectorXd& request);

}  // namespace mien::motion
