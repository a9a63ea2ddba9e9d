#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "pipeline/base/adaptive/psychometric_function.h"

namespace mien::pipeline {

/// The values that a parameter may have, and their prior probabilities, which need not sum to 1.
/// Without these all are equal.
struct QuestAxis {
  std::vector<double> values;
  std::vector<double> prior = {};
};

/// The probability of an outcome, from 0, to a stimulus, for values of the parameters in the order
/// of the axes. Those of all outcomes must have a sum of 1.
using OutcomeProbability =
    std::function<double(int outcome, double stimulus, const std::vector<double>& parameters)>;

/// What QUEST+ (Watson 2017) computes once: the probabilities of all outcomes of all stimuli for
/// all parameters of a grid. Points of the grid are numbered with the last axis varying fastest.
struct QuestPlus {
  std::vector<QuestAxis> axes;
  std::vector<double> stimuli;
  Eigen::VectorXd prior;                     ///< of each point, with a sum of 1
  std::vector<Eigen::MatrixXd> probability;  ///< of each outcome: rows are points, columns stimuli
  Eigen::MatrixXd outcome_entropy;  ///< −Σ p ln p over the outcomes; rows and columns as above
};

/// The tables of any model. Stimuli and axes must not be empty, priors must have the length of
/// their axis.
QuestPlus quest_plus(std::vector<double> stimuli, std::vector<QuestAxis> axes, int outcomes,
                     const OutcomeProbability& probability);

/// The tables of a psychometric function with the outcomes 0 (negative) and 1 (positive). The axes
/// are location, width, guess and lapse rate, in this order; one with a single value is fixed.
QuestPlus psychometric_quest(Sigmoid sigmoid, std::vector<double> stimuli, QuestAxis location,
                             QuestAxis width, QuestAxis guess, QuestAxis lapse);

struct QuestAnswer {
  std::size_t stimulus = 0;  ///< its place in `stimuli`
  int outcome = 0;
};

/// The posterior distribution over the points of the grid after one more answer (Bayes' rule).
/// Throws Error if no point with a probability above 0 permits the outcome.
Eigen::VectorXd updated(const QuestPlus& quest, const Eigen::VectorXd& posterior,
                        const QuestAnswer& answer);

/// The posterior distribution after these answers, in this order.
Eigen::VectorXd posterior_after(const QuestPlus& quest, const std::vector<QuestAnswer>& answers);

/// For each stimulus the expected entropy of the posterior distribution after its answer, in nats
/// (Watson 2017). It is the present entropy less the information that the answer is expected to
/// give about the parameters, which is the entropy of the outcome less its expected entropy if the
/// parameters were known.
Eigen::VectorXd expected_entropies(const QuestPlus& quest, const Eigen::VectorXd& posterior);

/// The place of the stimulus with the least expected entropy; the first of those that are equal to
/// within 1e-12 nats.
std::size_t next_stimulus(const QuestPlus& quest, const Eigen::VectorXd& posterior);

/// The marginal posterior distribution of a parameter.
struct QuestEstimate {
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation
  double mode = 0.0;       ///< the most probable value; of equal ones the first
  /// Ends of the credible interval: the first values up to which the probability is at least
  /// (1 − credibility)/2 and (1 + credibility)/2. The axis must ascend.
  double low = 0.0;
  double high = 0.0;
};

QuestEstimate quest_estimate(const QuestPlus& quest, const Eigen::VectorXd& posterior,
                             std::size_t axis, double credibility = 0.95);

/// The values of all parameters at the most probable point of the grid; of equal ones the first.
std::vector<double> most_probable(const QuestPlus& quest, const Eigen::VectorXd& posterior);

/// When to stop: after so many trials (0: without limit), or as soon as the standard deviation of a
/// parameter is at most `deviation` (0: never).
struct QuestStop {
  int most_trials = 0;
  std::size_t axis = 0;
  double deviation = 0.0;
};

bool is_finished(const QuestPlus& quest, const Eigen::VectorXd& posterior, int trials,
                 const QuestStop& stop);

}  // namespace mien::pipeline
