#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

namespace mien::motion {

/// One click on a word: a parameter is to grow (+1) or shrink (−1) by one step.
struct Click {
  int parameter = 0;
  int sign = 1;

  friend bool operator==(const Click&, const Click&) = default;
};

/// Incremental control with words (after Förger and Takala 2012): each click moves the weights by
/// the least change that moves the named parameters by a step and keeps the sum, found with the
/// pseudo-inverse. The result depends on the path.
struct WordClicks {
  Eigen::MatrixXd standardised;  ///< M × N: parameters of examples, mean 0 and SD 1 a row
  Eigen::VectorXd mean;          ///< M
  Eigen::VectorXd deviation;     ///< M; 1 where all examples have the same value
  double step = 0.25;            ///< of a click, in standard deviations over the examples
};

/// `places`: one row an example (N × M). More examples than parameters are needed for every click
/// to be able to move its parameter alone.
WordClicks fit_word_clicks(const Eigen::MatrixXd& places, double step = 0.25);

/// The weights (≥ 0, sum 1) after one click on a word that names these parameters.
Eigen::VectorXd clicked(const WordClicks& words, const Eigen::VectorXd& weights,
                        std::span<const Click> word);

/// A sequence of clicks and its result.
struct ClickPath {
  std::vector<Click> clicks;
  Eigen::VectorXd weights;
  bool arrived = false;  ///< every parameter is within half a step of the request
};

/// Simulates a patient user: from equal weights, clicks on the parameter that is farthest from the
/// request as long as that reduces the total deviation.
ClickPath click_towards(const WordClicks& words, const Eigen::RowVectorXd& request);

}  // namespace mien::motion
